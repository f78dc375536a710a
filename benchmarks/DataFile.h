#pragma once

#include <kernels/core/ArrayView.h>

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace mote::bench
{

/// Reads what Mote's or VTK's readers make of a name, its last step where it has several. Throws
/// Error.
vtkSmartPointer<vtkDataObject> readLastStep(const std::string& name);

/// VTK's arrays as the kernels see them, and what keeps their memory alive.
class ArrayViews
{
public:
  /// Float, double, bytes without sign and 64-bit integers as they are, other types as a copy in
  /// double.
  ArrayView of(vtkDataArray* array);

private:
  std::vector<vtkSmartPointer<vtkDataArray>> kept_;
};

} // namespace mote::bench
