#include "PolyDataParts.h"

#include "ForeignMemory.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <numeric>

namespace mote
{
namespace
{

template <class Array>
void setVerticesOf(vtkPolyData* output, vtkIdType atoms)
{
  vtkNew<Array> offsets;
  vtkNew<Array> connectivity;
  offsets->SetNumberOfValues(atoms + 1);
  connectivity->SetNumberOfValues(atoms);
  std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + atoms + 1, 0);
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + atoms, 0);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetVerts(cells);
}

static_assert(sizeof(vtkStdString) == sizeof(std::string), "rows are stored as std::string");
static_assert(sizeof(vtkIdType) == sizeof(std::int64_t), "Int64 columns become vtkIdTypeArray");

template <class Array>
vtkSmartPointer<Array> makeArray(
  int components, vtkIdType tuples, void*& data, const ColumnSpace& space)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  const vtkIdType values = components * tuples;
  if (space.space && values > 0)
  {
    const auto memory = space.space->allocate(
      static_cast<std::uint64_t>(values) * array->GetDataTypeSize(), space.inFile);
    viewMemory(array, memory.get(), values, memory);
  }
  else
  {
    array->SetNumberOfTuples(tuples);
  }
  data = tuples > 0 ? array->GetPointer(0) : nullptr;
  return array;
}

} // namespace

vtkSmartPointer<vtkAbstractArray> makeColumnArray(
  ColumnType type, int components, vtkIdType tuples, void*& data, const ColumnSpace& space)
{
  switch (type)
  {
  case ColumnType::Int32:
  case ColumnType::Word:
    return makeArray<vtkIntArray>(components, tuples, data, space);
  case ColumnType::Int64:
    return makeArray<vtkIdTypeArray>(components, tuples, data, space);
  case ColumnType::Float32:
    return makeArray<vtkFloatArray>(components, tuples, data, space);
  case ColumnType::String:
  {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    data = tuples > 0 ? static_cast<std::string*>(array->GetPointer(0)) : nullptr;
    return array;
  }
  default:
    return makeArray<vtkDoubleArray>(components, tuples, data, space);
  }
}

std::size_t bytesOf(ColumnType type)
{
  switch (type)
  {
  case ColumnType::String:
    return sizeof(std::string);
  case ColumnType::Int32:
  case ColumnType::Float32:
  case ColumnType::Word:
    return 4;
  default:
    return 8;
  }
}

double* makePositions(vtkPoints* points, vtkIdType count, const ColumnSpace& space)
{
  void* data = nullptr;
  points->SetData(makeArray<vtkDoubleArray>(3, count, data, space));
  return static_cast<double*>(data);
}

void setVertices(vtkPolyData* output, vtkIdType points)
{
  if (points < VTK_INT_MAX)
    setVerticesOf<vtkTypeInt32Array>(output, points);
  else
    setVerticesOf<vtkTypeInt64Array>(output, points);
}

void addNumbers(vtkFieldData* fields, const char* name, const double* values, int count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(count);
  array->InsertNextTuple(values);
  fields->AddArray(array);
}

void addText(vtkFieldData* fields, const char* name, const std::string& text)
{
  if (!text.empty())
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    fields->AddArray(array);
  }
}

} // namespace mote
