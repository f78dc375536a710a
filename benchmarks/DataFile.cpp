#include "DataFile.h"

#include <kernels/core/Error.h>

#include <vtkAlgorithm.h>
#include <vtkDoubleArray.h>
#include <vtkMoteReaderTable.h>

namespace mote::bench
{

namespace
{

ArrayView::Type typeOf(vtkDataArray* array)
{
  if (!array->HasStandardMemoryLayout())
    return ArrayView::Type::None;
  switch (array->GetDataType())
  {
  case VTK_FLOAT:
    return ArrayView::Type::Float32;
  case VTK_DOUBLE:
    return ArrayView::Type::Float64;
  case VTK_UNSIGNED_CHAR:
    return ArrayView::Type::UInt8;
  case VTK_ID_TYPE:
  case VTK_LONG:
  case VTK_LONG_LONG:
    return array->GetDataTypeSize() == 8 ? ArrayView::Type::Int64 : ArrayView::Type::None;
  default:
    return ArrayView::Type::None;
  }
}

} // namespace

vtkSmartPointer<vtkDataObject> readLastStep(const std::string& name)
{
  std::string error;
  const vtkSmartPointer<vtkAlgorithm> reader = vtkMoteReaderTable::MakeReader(name, error);
  if (!reader)
    throw Error(error);
  const std::vector<double> times = vtkMoteReaderTable::GetTimeSteps(reader, error);
  if (!error.empty())
    throw Error(error);
  const vtkSmartPointer<vtkDataObject> data =
    times.empty() ? vtkMoteReaderTable::Read(reader, error)
                  : vtkMoteReaderTable::Read(reader, times.back(), error);
  if (!data)
    throw Error(error);
  return data;
}

ArrayView ArrayViews::of(vtkDataArray* array)
{
  kept_.emplace_back(array);
  ArrayView::Type type = typeOf(array);
  if (type == ArrayView::Type::None)
  {
    kept_.back() = vtkSmartPointer<vtkDoubleArray>::New();
    kept_.back()->DeepCopy(array);
    type = ArrayView::Type::Float64;
  }
  return {kept_.back()->GetVoidPointer(0), type,
    static_cast<std::size_t>(array->GetNumberOfTuples()), array->GetNumberOfComponents()};
}

} // namespace mote::bench
