#include "DataArrayView.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"

namespace mote
{

namespace
{

ArrayView::Type typeOf(vtkDataArray* array)
{
  using Type = ArrayView::Type;
  const int size = array->GetDataTypeSize();
  const auto bySize = [size](Type one, Type two, Type four, Type eight) {
    return size == 1 ? one : size == 2 ? two : size == 4 ? four : eight;
  };
  switch (array->GetDataType())
  {
  case VTK_FLOAT:
    return Type::Float32;
  case VTK_DOUBLE:
    return Type::Float64;
  case VTK_UNSIGNED_CHAR:
  case VTK_UNSIGNED_SHORT:
  case VTK_UNSIGNED_INT:
  case VTK_UNSIGNED_LONG:
  case VTK_UNSIGNED_LONG_LONG:
    return bySize(Type::UInt8, Type::UInt16, Type::UInt32, Type::UInt64);
  case VTK_CHAR:
  case VTK_SIGNED_CHAR:
  case VTK_SHORT:
  case VTK_INT:
  case VTK_LONG:
  case VTK_LONG_LONG:
  case VTK_ID_TYPE:
    return bySize(Type::Int8, Type::Int16, Type::Int32, Type::Int64);
  default:
    return Type::None;
  }
}

} // namespace

DataArrayView::DataArrayView(vtkDataArray* array)
{
  if (!array)
    return;
  owner = array;
  if (!array->HasStandardMemoryLayout() || typeOf(array) == ArrayView::Type::None)
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(array);
    owner = copy;
  }
  view = ArrayView(owner->GetVoidPointer(0), typeOf(owner),
    static_cast<std::size_t>(owner->GetNumberOfTuples()), owner->GetNumberOfComponents());
}

} // namespace mote
