#include "Flow.h"

#include "base/Failure.h"
#include "base/Messages.h"
#include "settings/Colors.h"

#include <vtkArrowSource.h>
#include <vtkBoundingBox.h>
#include <vtkDataSet.h>
#include <vtkLookupTable.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

Flow::Flow(const Settings& settings)
  : settings_(settings)
{
  tubes_->SetNumberOfSides(8);
  tubes_->CappingOn();
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(12);
  arrow->SetShaftResolution(8);
  glyphs_->SetSourceConnection(arrow->GetOutputPort());
  glyphs_->SetVectorModeToUseVector();
  glyphs_->SetScaleModeToScaleByVector();
  for (Drawn* drawn : {&lines_, &arrows_})
  {
    drawn->actor->SetMapper(drawn->mapper);
    drawn->actor->PickableOff(); // else its triangles would be taken for cells
    drawn->actor->VisibilityOff();
  }
}

bool Flow::areOther(const Settings& a, const Settings& b)
{
  const bool isAny = a.flow.lines > 0 || b.flow.lines > 0 || a.flow.arrows > 0 || b.flow.arrows > 0;
  return isAny && (a.flow != b.flow || a.selection.hiddenData != b.selection.hiddenData ||
                    a.selection.hiddenParts != b.selection.hiddenParts ||
                    a.selection.shownParts != b.selection.shownParts);
}

void Flow::clear()
{
  built_ = {};
  data_.clear();
  for (Drawn* drawn : {&lines_, &arrows_})
    draw(*drawn, nullptr);
}

namespace
{

/// The places with their active vectors once more, which glyphs take away, and the mean length of
/// these.
double takeVectors(vtkPolyData* found, vtkPolyData* places)
{
  places->ShallowCopy(found);
  vtkDataArray* vectors = places->GetPointData()->GetVectors();
  if (!vectors || vectors->GetNumberOfTuples() == 0)
    return 0.0;
  const auto arrows = vtk::TakeSmartPointer(vectors->NewInstance());
  arrows->DeepCopy(vectors);
  arrows->SetName("arrow");
  places->GetPointData()->AddArray(arrows);
  places->GetPointData()->SetActiveVectors("arrow");
  double sum = 0.0;
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double v[3];
    vectors->GetTuple(i, v);
    if (const double length = std::hypot(v[0], v[1], v[2]); std::isfinite(length))
      sum += length, ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

} // namespace

void Flow::build(const std::vector<std::unique_ptr<Part>>& parts, const Runner& runner)
{
  const FlowSettings& flow = settings_.flow;
  std::vector<std::pair<vtkDataSet*, vtkMTimeType>> data;
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkBoundingBox bounds;
  for (const auto& part : parts)
    if (part->kind() == Part::Kind::Volume && !part->isHidden())
    {
      blocks->SetBlock(static_cast<unsigned>(data.size()), part->data());
      data.emplace_back(part->data(), part->data()->GetMTime());
      bounds.AddBounds(part->data()->GetBounds());
    }
  if (flow == built_ && data == data_)
    return;
  this->clear();
  if (data.empty() || (flow.lines == 0 && flow.arrows == 0))
    return;
  const double size = bounds.GetDiagonalLength();
  Messages::takeError();
  const auto find = [&](int seeds, bool lines)
  {
    found_->SetInputDataObject(blocks);
    found_->SetComputeLines(lines);
    found_->SetNumberOfSeeds(seeds);
    found_->SetSeedsOnLine(flow.from.size() == 6);
    if (flow.from.size() == 6)
    {
      found_->SetPoint1(flow.from.data());
      found_->SetPoint2(flow.from.data() + 3);
    }
    found_->SetMaximumLength(flow.length.value_or(size));
    if (flow.array.empty())
      found_->GetInformation()->Remove(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
    else
      found_->SetInputArrayToProcess(
        0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, flow.array.c_str());
    runner("Finding streamlines", found_, [&] { found_->Update(); });
    if (const std::string error = Messages::takeError(); !error.empty())
      throw Failure("--streamlines, --arrows: " + error);
  };
  if (flow.arrows > 0)
  {
    find(flow.arrows, false);
    vtkNew<vtkPolyData> places;
    const double mean = takeVectors(found_->GetOutput(1), places);
    const double room = bounds.GetLength(0) * bounds.GetLength(1) * bounds.GetLength(2);
    glyphs_->SetScaleFactor(
      mean > 0.0 ? flow.arrowScale * std::cbrt(room / flow.arrows) / mean : 0.0);
    glyphs_->SetInputData(places);
    glyphs_->Update();
    this->draw(arrows_, glyphs_->GetOutput());
  }
  if (flow.lines > 0)
  {
    find(flow.lines, true);
    tubes_->SetInputData(found_->GetOutput(0));
    tubes_->SetRadius(0.5 * flow.width.value_or(0.003 * size));
    tubes_->Update();
    this->draw(lines_, tubes_->GetOutput());
  }
  built_ = flow;
  data_ = data;
}

/// Null: nothing.
void Flow::draw(Drawn& drawn, vtkPolyData* triangles)
{
  vtkNew<vtkPolyData> own;
  if (triangles)
    own->ShallowCopy(triangles);
  drawn.mapper->SetInputData(own);
  drawn.actor->SetVisibility(own->GetNumberOfCells() > 0);
  this->color(drawn);
}

void Flow::color(Drawn& drawn)
{
  Color plain{};
  parseColor(settings_.color.plain, plain);
  vtkProperty* look = drawn.actor->GetProperty();
  look->SetColor(plain.data());
  look->SetAmbient(ambient_);
  look->SetDiffuse(0.75);
  look->SetSpecular(0.0);
  const bool isColored = choice_ && drawn.mapper->GetInput() &&
                         drawn.mapper->GetInput()->GetPointData()->GetArray(choice_.name.c_str());
  drawn.mapper->SetScalarVisibility(isColored);
  if (!isColored)
    return;
  drawn.mapper->SetScalarModeToUsePointFieldData();
  drawn.mapper->SelectColorArray(choice_.name.c_str());
  drawn.mapper->SetLookupTable(table_);
  drawn.mapper->UseLookupTableScalarRangeOn();
}

void Flow::setAmbient(double ambient)
{
  ambient_ = ambient;
  for (Drawn* drawn : {&lines_, &arrows_})
    drawn->actor->GetProperty()->SetAmbient(ambient);
}

void Flow::setColors(const ArrayChoice& choice, vtkLookupTable* table)
{
  choice_ = choice;
  table_ = table;
  for (Drawn* drawn : {&lines_, &arrows_})
    this->color(*drawn);
}

void Flow::setCuts(const Cuts& cuts)
{
  const CutAxis axis = cutAxisOf(settings_.cuts.axis);
  for (Drawn* drawn : {&lines_, &arrows_})
  {
    drawn->mapper->SetClippingPlanes(cuts.planes());
    drawn->mapper->SetClipCylinder(cuts.cylinder());
    drawn->mapper->SetRepetitions(settings_.volume.repeatAround);
    drawn->mapper->SetRepetitionCenter(axis.point.data());
    drawn->mapper->SetRepetitionAxis(axis.direction.data());
  }
}

vtkIdType Flow::numberOfLines() const
{
  return lines_.actor->GetVisibility() ? found_->GetOutput(1)->GetNumberOfPoints() : 0;
}

} // namespace mote::app
