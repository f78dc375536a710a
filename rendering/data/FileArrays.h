#ifndef MoteFileArrays_h
#define MoteFileArrays_h

#include "MoteRenderingDataModule.h" // For export macro

#include "kernels/core/FileArray.h"

#include <memory>

class vtkDataArray;

namespace mote
{

/// An array that views values of any type, which are there as long as `keeper`, not null, lives,
/// and keeps it. It must not be written to. The caller owns the reference.
MOTERENDERINGDATA_EXPORT vtkDataArray* newArrayOf(
  const ArrayView& values, const std::shared_ptr<const void>& keeper);

/// The same of a file's array, with name, components' names and ranges.
MOTERENDERINGDATA_EXPORT vtkDataArray* newArrayOf(
  const FileArray& array, const std::shared_ptr<const void>& keeper);

} // namespace mote

#endif
