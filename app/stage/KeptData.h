#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace mote::app
{

/// Data that are in no file, as of a Python program that opens a window on them: while it lives an
/// Input reads them by the names that keep() gives, which stand among those of files.
class KeptData
{
public:
  KeptData() = default;
  ~KeptData();
  KeptData(const KeptData&) = delete;
  KeptData& operator=(const KeptData&) = delete;

  /// "memory:1:NAME".
  std::string keep(const std::string& name, vtkDataObject* data);

private:
  std::vector<std::string> files_;
};

/// Whether the name is one that keep() gave.
bool isKeptData(const std::string& file);

/// The name that was given to keep().
std::string nameOfKept(const std::string& file);

/// What gives the data as a reader does; data objects of its own, which share the arrays.
vtkSmartPointer<vtkAlgorithm> producerOfKept(const std::string& file);

} // namespace mote::app
