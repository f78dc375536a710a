#include "PLYReader.h"

#include "FileError.h"
#include "FloatPlaces.h"
#include "PLYColumns.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

namespace mote
{

namespace
{

int typeOf(const PLYHeader::Number& number)
{
  const bool isUnsigned = number.type == PLYHeader::Type::Unsigned;
  if (number.type == PLYHeader::Type::Float)
    return number.bytes == sizeof(double) ? VTK_DOUBLE : VTK_FLOAT;
  switch (number.bytes)
  {
  case 1:
    return isUnsigned ? VTK_UNSIGNED_CHAR : VTK_SIGNED_CHAR;
  case 2:
    return isUnsigned ? VTK_UNSIGNED_SHORT : VTK_SHORT;
  default:
    return isUnsigned ? VTK_UNSIGNED_INT : VTK_INT;
  }
}

/// Adds a column to the vertices or faces that it is of, where VTK has not made others of them.
void add(const PLYColumn& column, vtkPolyData* output)
{
  const bool ofPoints = column.element == "vertex";
  const vtkIdType count = ofPoints ? output->GetNumberOfPoints() : output->GetNumberOfCells();
  vtkDataSetAttributes* arrays = output->GetPointData();
  if (!ofPoints)
    arrays = output->GetCellData();
  if (static_cast<vtkIdType>(column.values.size()) != count || count == 0 ||
      arrays->HasArray(column.name.c_str()))
    return;
  const auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(typeOf(column.number)));
  array->SetName(column.name.c_str());
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
    array->SetComponent(i, 0, column.values[static_cast<std::size_t>(i)]);
  arrays->AddArray(array);
}

/// Puts points where the file has them, where VTK's float is too coarse.
void addPlaces(const std::array<const PLYColumn*, 3>& places, vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfPoints();
  std::vector<double> all;
  for (vtkIdType i = 0; i < count; ++i)
    for (const PLYColumn* column : places)
    {
      if (!column || static_cast<vtkIdType>(column->values.size()) != count)
        return;
      all.push_back(column->values[static_cast<std::size_t>(i)]);
    }
  if (!needDouble(all))
    return;
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
    points->SetPoint(i, &all[static_cast<std::size_t>(3 * i)]);
  output->SetPoints(points);
}

} // namespace

vtkStandardNewMacro(PLYReader);

int PLYReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const std::vector<PLYColumn> columns = readPLYColumns(this->FileName ? this->FileName : "");
    if (!this->vtkPLYReader::RequestData(request, inputVector, outputVector))
      return 0;
    std::array<const PLYColumn*, 3> places = {};
    for (const PLYColumn& column : columns)
    {
      const bool isPlace = column.name == "x" || column.name == "y" || column.name == "z";
      if (column.element == "vertex" && isPlace)
        places[static_cast<std::size_t>(column.name[0] - 'x')] = &column;
      else
        add(column, output);
    }
    addPlaces(places, output);
  }
  catch (const FileError& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
  }
  return 1; // a failed request would leave old data downstream
}

} // namespace mote
