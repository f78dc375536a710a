#include "PolyDataParts.h"

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
vtkSmartPointer<vtkAbstractArray> makeArray(int components, vtkIdType tuples, void*& data)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data = tuples > 0 ? array->GetPointer(0) : nullptr;
  return array;
}

} // namespace

vtkSmartPointer<vtkAbstractArray> makeColumnArray(
  ColumnType type, int components, vtkIdType tuples, void*& data)
{
  switch (type)
  {
  case ColumnType::Int32:
    return makeArray<vtkIntArray>(components, tuples, data);
  case ColumnType::Int64:
    return makeArray<vtkIdTypeArray>(components, tuples, data);
  case ColumnType::Float32:
    return makeArray<vtkFloatArray>(components, tuples, data);
  case ColumnType::String:
  {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    data = tuples > 0 ? static_cast<std::string*>(array->GetPointer(0)) : nullptr;
    return array;
  }
  default:
    return makeArray<vtkDoubleArray>(components, tuples, data);
  }
}

std::size_t bytesOf(ColumnType type)
{
  return type == ColumnType::String                                 ? sizeof(std::string)
         : type == ColumnType::Int32 || type == ColumnType::Float32 ? 4
                                                                    : 8;
}

double* makePositions(vtkPoints* points, vtkIdType count)
{
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  return count > 0 ? static_cast<double*>(points->GetVoidPointer(0)) : nullptr;
}

void setVertices(vtkPolyData* output, vtkIdType points)
{
  if (points < VTK_INT_MAX)
  {
    setVerticesOf<vtkTypeInt32Array>(output, points);
  }
  else
  {
    setVerticesOf<vtkTypeInt64Array>(output, points);
  }
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
