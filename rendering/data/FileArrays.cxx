#include "FileArrays.h"

#include "DataArrayView.h"
#include "ForeignMemory.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

namespace mote
{

namespace
{

int dataTypeOf(ArrayView::Type type)
{
  for (const int vtkType : {VTK_FLOAT, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG})
    if (viewTypeOf(vtkType) == type)
      return vtkType;
  return VTK_DOUBLE;
}

/// Tells an array what it would else look through all its values for.
void setRanges(vtkDataArray* array, const FileArray& from)
{
  const int components = array->GetNumberOfComponents();
  const auto set = [&](vtkInformationInformationVectorKey* each, vtkInformationDoubleVectorKey* all)
  {
    vtkNew<vtkInformationVector> ranges;
    ranges->SetNumberOfInformationObjects(components);
    for (int k = 0; k < components; ++k)
      ranges->GetInformationObject(k)->Set(
        vtkDataArray::COMPONENT_RANGE(), from.ranges[static_cast<std::size_t>(k)].data(), 2);
    array->GetInformation()->Set(each, ranges);
    array->GetInformation()->Set(all, from.ranges.back().data(), 2);
  };
  set(vtkAbstractArray::PER_FINITE_COMPONENT(), vtkDataArray::L2_NORM_FINITE_RANGE());
  if (from.finite)
    set(vtkAbstractArray::PER_COMPONENT(), vtkDataArray::L2_NORM_RANGE());
}

} // namespace

vtkDataArray* newArrayOf(const ArrayView& values, const std::shared_ptr<const void>& keeper)
{
  vtkDataArray* array = vtkDataArray::CreateDataArray(dataTypeOf(values.type()));
  array->SetNumberOfComponents(values.components());
  if (values.count() > 0)
    viewMemory(array, const_cast<void*>(values.data()),
      static_cast<vtkIdType>(values.count()) * values.components(), keeper);
  return array;
}

vtkDataArray* newArrayOf(const FileArray& from, const std::shared_ptr<const void>& keeper)
{
  vtkDataArray* array = newArrayOf(from.values, keeper);
  array->SetName(from.name.c_str());
  for (std::size_t k = 0; k < from.components.size(); ++k)
    array->SetComponentName(static_cast<vtkIdType>(k), from.components[k].c_str());
  setRanges(array, from);
  return array;
}

} // namespace mote
