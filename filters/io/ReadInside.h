#ifndef MoteReadInside_h
#define MoteReadInside_h

#include "vtkSmartPointer.h"

#include <optional>
#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace mote
{

/// Reads as vtkMoteReaderTable::Read() does, at a time where one is given, on behalf of another
/// algorithm: that tells the reader's progress, and its abort stops the reader. Null with a
/// sentence in `error`. An abort is no error; the caller looks for it.
vtkSmartPointer<vtkDataObject> readInside(vtkAlgorithm* self, vtkAlgorithm* reader,
  std::optional<double> time, std::string& error, std::string& warnings);

} // namespace mote

#endif
