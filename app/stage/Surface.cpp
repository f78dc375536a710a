#include "Surface.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

#include <numeric>

namespace mote::app
{

namespace
{

// Filters carry the cells' numbers along.
const char* const cellNumbers = "MoteInputCells";

vtkSmartPointer<vtkDataSet> withCellNumbers(vtkDataSet* data)
{
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(data->NewInstance());
  copy->ShallowCopy(data);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(cellNumbers);
  numbers->SetNumberOfValues(data->GetNumberOfCells());
  std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + data->GetNumberOfCells(), 0);
  copy->GetCellData()->AddArray(numbers);
  return copy;
}

} // namespace

void Surface::setData(vtkDataSet* data)
{
  taken_ = data->GetMTime();
  auto* polygons = vtkPolyData::SafeDownCast(data);
  auto* points = vtkPointSet::SafeDownCast(data);
  makesNormals_ = polygons && !polygons->GetPointData()->GetNormals();
  takesFaces_ = !points;
  if (makesNormals_)
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(withCellNumbers(data));
    mapper_->SetInputConnection(normals->GetOutputPort());
  }
  else if (takesFaces_)
  {
    vtkNew<vtkDataSetSurfaceFilter> faces;
    faces->SetInputData(withCellNumbers(data));
    mapper_->SetInputConnection(faces->GetOutputPort());
  }
  else
    mapper_->SetInputData(points);
}

void Surface::followArrays(vtkDataSet* data)
{
  if ((makesNormals_ || takesFaces_) && data->GetMTime() != taken_)
    this->setData(data);
}

vtkIdType Surface::cellOf(vtkIdType cell) const
{
  vtkPointSet* drawn = mapper_->GetInput();
  auto* numbers = drawn && (makesNormals_ || takesFaces_)
                    ? vtkIdTypeArray::SafeDownCast(drawn->GetCellData()->GetArray(cellNumbers))
                    : nullptr;
  return numbers && cell >= 0 && cell < numbers->GetNumberOfValues() ? numbers->GetValue(cell)
                                                                     : cell;
}

} // namespace mote::app
