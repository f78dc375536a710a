#ifndef MoteFieldVector_h
#define MoteFieldVector_h

#include "kernels/core/Vec.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkVariant.h"

namespace mote
{

/// Reads three numbers that a data set's field array has; false where it has no such array.
inline bool readVector(vtkDataSet* data, const char* name, Vec3d& value)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() * array->GetNumberOfTuples() != 3)
    return false;
  for (int k = 0; k < 3; ++k)
    value[k] = array->GetVariantValue(k).ToDouble();
  return true;
}

} // namespace mote

#endif
