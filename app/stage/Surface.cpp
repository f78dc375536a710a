#include "Surface.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkIdTypeArray.h>
#include <vtkMoteMeshFilePoints.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

#include <numeric>

namespace mote::app
{

namespace
{

/// Cells of a mesh that is smoothed, at most: of more each is small, and normals would take longer
/// than the rest and as much memory.
constexpr vtkIdType mostSmoothed = 4'000'000;

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
  makesNormals_ = polygons && !polygons->GetPointData()->GetNormals() &&
                  polygons->GetNumberOfCells() <= mostSmoothed &&
                  !vtkMoteMeshFilePoints::FileOf(polygons); // whose tree is built
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

vtkSmartPointer<vtkPointSet> Surface::drawn() const
{
  vtkSmartPointer<vtkPointSet> copy;
  vtkPointSet* input = mapper_->GetInput();
  if (!input || (!makesNormals_ && !takesFaces_))
    return copy;
  copy.TakeReference(input->NewInstance());
  copy->ShallowCopy(input);
  return copy;
}

void Surface::takeDrawn(vtkPointSet* drawn)
{
  if (makesNormals_ || takesFaces_)
    mapper_->SetInputData(drawn);
}

void Surface::followArrays(vtkDataSet* data)
{
  if ((makesNormals_ || takesFaces_) && data->GetMTime() != taken_)
    this->setData(data);
}

void Surface::nameCellsForFile()
{
  constexpr const char* inFiles = "vtkOriginalCellIds";
  vtkPointSet* drawn = mapper_->GetInput();
  vtkDataArray* numbers = drawn ? drawn->GetCellData()->GetArray(cellNumbers) : nullptr;
  if (numbers && drawn->GetCellData()->HasArray(inFiles)) // the data's own
    drawn->GetCellData()->RemoveArray(cellNumbers);
  else if (numbers)
    numbers->SetName(inFiles);
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
