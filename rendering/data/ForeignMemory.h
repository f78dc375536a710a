#ifndef MoteForeignMemory_h
#define MoteForeignMemory_h

#include "MoteRenderingDataModule.h" // For export macro
#include "vtkType.h"

#include <memory>

class vtkDataArray;

namespace mote
{

/// Has an array, whose number of components is set, view `values` numbers of its type at `memory`,
/// which are there as long as `keeper`, not null, lives; the array keeps it.
MOTERENDERINGDATA_EXPORT void viewMemory(
  vtkDataArray* array, void* memory, vtkIdType values, std::shared_ptr<const void> keeper);

} // namespace mote

#endif
