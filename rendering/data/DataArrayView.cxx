#include "DataArrayView.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"

namespace mote
{

ArrayView::Type viewTypeOf(int vtkType)
{
  using Type = ArrayView::Type;
  if (vtkType == VTK_FLOAT || vtkType == VTK_DOUBLE)
    return vtkType == VTK_FLOAT ? Type::Float32 : Type::Float64;
  const bool isSigned = vtkDataArray::GetDataTypeMin(vtkType) < 0.0;
  switch (vtkAbstractArray::GetDataTypeSize(vtkType))
  {
  case 1:
    return isSigned ? Type::Int8 : Type::UInt8;
  case 2:
    return isSigned ? Type::Int16 : Type::UInt16;
  case 4:
    return isSigned ? Type::Int32 : Type::UInt32;
  case 8:
    return isSigned ? Type::Int64 : Type::UInt64;
  default:
    return Type::None;
  }
}

DataArrayView::DataArrayView(vtkDataArray* array)
{
  if (!array)
    return;
  owner = array;
  if (!array->HasStandardMemoryLayout() ||
      viewTypeOf(array->GetDataType()) == ArrayView::Type::None)
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(array);
    owner = copy;
  }
  view = ArrayView(owner->GetVoidPointer(0), viewTypeOf(owner->GetDataType()),
    static_cast<std::size_t>(owner->GetNumberOfTuples()), owner->GetNumberOfComponents());
}

} // namespace mote
