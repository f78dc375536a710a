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
#include <vtkThreshold.h>
#include <vtkUnsignedCharArray.h>

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
const char* const visibleCells = "MoteShownCells";

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

/// The cells that are shown, as a grid.
vtkSmartPointer<vtkThreshold> shownOf(vtkDataSet* data, vtkUnsignedCharArray* isVisible)
{
  const vtkSmartPointer<vtkDataSet> marked = withCellNumbers(data);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->ShallowCopy(isVisible);
  marks->SetName(visibleCells);
  marked->GetCellData()->AddArray(marks);
  auto shown = vtkSmartPointer<vtkThreshold>::New();
  shown->SetInputData(marked);
  shown->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, visibleCells);
  shown->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  shown->SetUpperThreshold(1.0);
  return shown;
}

} // namespace

void Surface::setData(vtkDataSet* data)
{
  taken_ = data->GetMTime();
  isVisible_ = nullptr;
  mapper_->SetVisibleCells(nullptr);
  auto* polygons = vtkPolyData::SafeDownCast(data);
  auto* points = vtkPointSet::SafeDownCast(data);
  tubes_ = nullptr;
  makesNormals_ = takesFaces_ = false;
  if (vtkMoteLineTubes::IsOfLines(data))
  {
    tubes_ = vtkSmartPointer<vtkMoteLineTubes>::New();
    tubes_->SetInputData(withCellNumbers(data));
    return this->connectTubes();
  }
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

void Surface::setTubeRadius(const TubeRadius& radius)
{
  const bool isOther = radius != tubeRadius_;
  tubeRadius_ = radius;
  if (tubes_ && isOther)
    this->connectTubes();
}

void Surface::connectTubes()
{
  tubes_->SetRadius(tubeRadius_.radius);
  tubes_->SetRadiusArrayName(tubeRadius_.array);
  tubes_->SetRadiusScale(tubeRadius_.scale);
  mapper_->SetInputConnection(tubes_->GetOutputPort());
}

void Surface::setVisible(vtkDataSet* data, vtkUnsignedCharArray* isVisible)
{
  if (isVisible == isVisible_)
    return;
  if (takesFaces_)
  {
    // Faces between cells that are shown and cells that are not come to light.
    if (!isVisible)
      return this->setData(data);
    mapper_->SetInputConnection(shownOf(data, isVisible)->GetOutputPort());
    isVisible_ = isVisible;
    return;
  }
  isVisible_ = isVisible;
  if (!isVisible || !this->isMade())
    return mapper_->SetVisibleCells(isVisible);
  // Cells have another order there.
  mapper_->GetInputAlgorithm()->Update();
  const vtkIdType count = mapper_->GetInput()->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> ofDrawn;
  ofDrawn->SetNumberOfValues(count);
  for (vtkIdType cell = 0; cell < count; ++cell)
    ofDrawn->SetValue(cell, isVisible->GetValue(this->cellOf(cell)));
  mapper_->SetVisibleCells(ofDrawn);
}

vtkSmartPointer<vtkPointSet> Surface::drawn() const
{
  vtkSmartPointer<vtkPointSet> copy;
  vtkPointSet* input = mapper_->GetInput();
  if (!input || !this->isMade() || this->hasCutFaces())
    return copy;
  copy.TakeReference(input->NewInstance());
  copy->ShallowCopy(input);
  return copy;
}

void Surface::takeDrawn(vtkPointSet* drawn)
{
  if (this->isMade() && !this->hasCutFaces())
    mapper_->SetInputData(drawn);
}

void Surface::followArrays(vtkDataSet* data)
{
  if (!this->isMade() || data->GetMTime() == taken_)
    return;
  const vtkSmartPointer<vtkUnsignedCharArray> isVisible = isVisible_;
  this->setData(data);
  this->setVisible(data, isVisible);
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
  auto* numbers = drawn && this->isMade()
                    ? vtkIdTypeArray::SafeDownCast(drawn->GetCellData()->GetArray(cellNumbers))
                    : nullptr;
  return numbers && cell >= 0 && cell < numbers->GetNumberOfValues() ? numbers->GetValue(cell)
                                                                     : cell;
}

} // namespace mote::app
