#include "Volume.h"

#include "base/Messages.h"
#include "settings/Colors.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellType.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

bool isVolume(int type)
{
  return type == VTK_TETRA || type == VTK_VOXEL || type == VTK_HEXAHEDRON || type == VTK_WEDGE ||
         type == VTK_PYRAMID || type == VTK_POLYHEDRON;
}

/// The value at a share of a table's range; between the ends by logarithm where the table is.
double valueAt(vtkLookupTable* table, double share)
{
  const double* range = table->GetRange();
  return table->UsingLogScale() ? range[0] * std::pow(range[1] / range[0], share)
                                : range[0] + share * (range[1] - range[0]);
}

vtkSmartPointer<vtkColorTransferFunction> colorsOf(vtkLookupTable* table)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  const auto entries = table->GetNumberOfTableValues();
  for (vtkIdType i = 0; i < entries; ++i)
  {
    const double* c = table->GetTableValue(i);
    colors->AddRGBPoint(
      valueAt(table, (static_cast<double>(i) + 0.5) / static_cast<double>(entries)), c[0], c[1],
      c[2]);
  }
  return colors;
}

} // namespace

Volume::Volume(const VolumeSettings& settings, double tolerance)
  : settings_(settings)
{
  volume_->GetProperty()->SetSpecular(0.0);
  volume_->SetMapper(mapper_);
  this->update(tolerance);
  this->showAll();
}

void Volume::update(double tolerance)
{
  mapper_->SetStructureName(settings_.structure.empty() ? nullptr : settings_.structure.c_str());
  mapper_->SetIntegratorName(settings_.integrator.c_str());
  mapper_->SetSampleDistance(settings_.sampleDistance.value_or(0.0));
  mapper_->SetTolerance(tolerance);
  mapper_->SetShowCloud(settings_.cloud == "on");
  mapper_->SetEdgeWidth(settings_.edges);
  this->followIsoArray(mapper_->GetInputConnection(0, 0)
                         ? vtkUnstructuredGrid::SafeDownCast(mapper_->GetInput())
                         : nullptr);
  Color nan = {0.0, 0.0, 0.0};
  const bool colored = parseColor(settings_.nanColor, nan);
  mapper_->SetNanColor(nan.data());
  mapper_->SetNanOpacity(colored ? 0.5 : 0.0);
  vtkVolumeProperty* look = volume_->GetProperty();
  look->SetShade(settings_.lit);
  vtkContourValues* values = look->GetIsoSurfaceValues();
  if (values->GetNumberOfContours() != static_cast<int>(settings_.isoValues.size()))
    values->SetNumberOfContours(static_cast<int>(settings_.isoValues.size()));
  for (std::size_t i = 0; i < settings_.isoValues.size(); ++i)
    values->SetValue(static_cast<int>(i), settings_.isoValues[i]);
}

/// Data without the array have no isosurfaces.
void Volume::followIsoArray(vtkUnstructuredGrid* data)
{
  const ArrayChoice choice =
    data && !settings_.isoArray.empty() ? findArray(data, settings_.isoArray) : ArrayChoice();
  mapper_->SetIsoArray(choice.name.c_str(), choice.ofCells,
    choice.component == ArrayChoice::magnitude ? -1 : choice.component);
  mapper_->SetShowIsoSurfaces(
    !settings_.isoValues.empty() && (settings_.isoArray.empty() || arrayOf(data, choice)));
}

void Volume::setSlices(const std::vector<vtkSmartPointer<vtkMoteSlice>>& slices)
{
  mapper_->RemoveAllSlices();
  for (const auto& slice : slices)
    mapper_->AddSlice(slice);
}

bool Volume::canShow(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid || rankedArrays(grid).empty())
    return false;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    if (isVolume(grid->GetCellType(i)))
      return true;
  return false;
}

void Volume::setData(vtkUnstructuredGrid* data)
{
  mapper_->SetInputData(data);
  this->followIsoArray(data);
  if (arrayOf(data, choice_))
    return this->select(choice_);
  if (table_ && !warned_)
    Messages::warn("a time step has no array '" + choice_.name + "', so its cells are not shown");
  warned_ = warned_ || table_;
  if (const auto arrays = rankedArrays(data); !arrays.empty())
    this->select(arrays.front()); // something to build with, until colours come
}

void Volume::select(const ArrayChoice& choice)
{
  if (choice.ofCells)
    mapper_->SetScalarModeToUseCellFieldData();
  else
    mapper_->SetScalarModeToUsePointFieldData();
  mapper_->SelectScalarArray(choice.name.c_str());
  mapper_->SetVectorMode(choice.component == ArrayChoice::magnitude
                           ? vtkMoteVolumeMapper::MAGNITUDE
                           : vtkMoteVolumeMapper::COMPONENT);
  mapper_->SetVectorComponent(std::max(0, choice.component));
}

void Volume::setColors(vtkDataSet* data, const ArrayChoice& choice, vtkLookupTable* table,
  const std::vector<OpacityPoint>& opacity, double diagonal)
{
  isColored_ = arrayOf(data, choice) != nullptr;
  if (!isColored_)
    return;
  choice_ = choice;
  this->select(choice);
  table_ = table;
  opacity_ = opacity;
  vtkVolumeProperty* look = volume_->GetProperty();
  look->SetColor(colorsOf(table));
  look->SetScalarOpacityUnitDistance(settings_.opacityUnit.value_or(0.1 * diagonal));
  this->setOpacity();
}

void Volume::limit(const std::vector<Interval>& intervals)
{
  std::vector<Interval> left;
  for (const Interval& a : shown_)
    for (const Interval& b : intervals)
      if (const Interval both = {std::max(a.low, b.low), std::min(a.high, b.high)};
          both.low <= both.high)
        left.push_back(both);
  shown_ = left;
  this->setOpacity();
}

void Volume::showAll()
{
  shown_ = {{-HUGE_VAL, HUGE_VAL}};
  this->setOpacity();
}

namespace
{

/// Adds what lies in an interval of an opacity function to another one, and clear ends. Intervals
/// must not touch.
void addPart(vtkPiecewiseFunction* part, vtkPiecewiseFunction* whole, const Interval& interval)
{
  // The next number outside is clear: what is hidden ends at once.
  if (std::isfinite(interval.low))
  {
    part->AddPoint(std::nextafter(interval.low, -HUGE_VAL), 0.0);
    part->AddPoint(interval.low, whole->GetValue(interval.low));
  }
  for (int i = 0; i < whole->GetSize(); ++i)
  {
    double node[4];
    whole->GetNodeValue(i, node);
    if (node[0] > interval.low && node[0] < interval.high)
      part->AddPoint(node[0], node[1]);
  }
  if (std::isfinite(interval.high))
  {
    part->AddPoint(interval.high, whole->GetValue(interval.high));
    part->AddPoint(std::nextafter(interval.high, HUGE_VAL), 0.0);
  }
}

} // namespace

void Volume::setOpacity()
{
  if (!table_)
    return;
  vtkNew<vtkPiecewiseFunction> whole, part;
  whole->AllowDuplicateScalarsOn(); // two points of one value are a step
  for (const OpacityPoint& point : opacity_)
    whole->AddPoint(
      point.isShare ? valueAt(table_, 0.01 * point.value) : point.value, point.opacity);
  vtkVolumeProperty* look = volume_->GetProperty();
  mapper_->RemoveAllSliceRanges();
  if (shown_ == std::vector<Interval>{{-HUGE_VAL, HUGE_VAL}})
  {
    look->SetScalarOpacity(whole);
    return;
  }
  for (const auto& [low, high] : shown_)
    mapper_->AddSliceRange(low, high);
  if (shown_.empty())
    mapper_->AddSliceRange(HUGE_VAL, -HUGE_VAL);
  if (shown_.empty())
    part->AddPoint(0.0, 0.0);
  for (const Interval& interval : shown_)
    addPart(part, whole, interval);
  look->SetScalarOpacity(part);
}

namespace
{

/// The least and greatest value in a cell; false where one is no number.
bool rangeIn(const ArrayChoice& choice, vtkDataArray* array, vtkIdType cell, vtkIdType points,
  const vtkIdType* ids, double range[2])
{
  range[0] = HUGE_VAL, range[1] = -HUGE_VAL;
  for (vtkIdType i = 0; i < (choice.ofCells ? 1 : points); ++i)
  {
    const double value = valueOf(array, choice.component, choice.ofCells ? cell : ids[i]);
    if (!std::isfinite(value))
      return false;
    range[0] = std::min(range[0], value);
    range[1] = std::max(range[1], value);
  }
  return true;
}

} // namespace

void Volume::shownBounds(
  vtkUnstructuredGrid* data, vtkUnsignedCharArray* isVisible, double bounds[6]) const
{
  const std::vector<Interval> everything = {{-HUGE_VAL, HUGE_VAL}};
  const bool hasCloud = settings_.cloud == "on", hasWalls = settings_.walls.value_or(0.0) > 0.0;
  const bool hasSlices = settings_.slices && !settings_.slices->empty();
  if (hasSlices && !hasCloud && !hasWalls && settings_.isoValues.empty())
  {
    mapper_->Update();
    return mapper_->GetSliceBounds(bounds);
  }
  std::vector<Interval> shown = hasSlices || hasWalls ? everything
                                : hasCloud            ? shown_
                                                      : std::vector<Interval>();
  for (const double value : settings_.isoValues)
    shown.push_back({value, value});
  vtkDataArray* array = arrayOf(data, choice_);
  const bool hasOthers = !settings_.isoValues.empty() && !settings_.isoArray.empty();
  if (!array || hasOthers || (!shown.empty() && shown.front() == everything.front() && !isVisible))
    return data->GetBounds(bounds);
  vtkBoundingBox box;
  const auto cells = vtk::TakeSmartPointer(data->GetCells()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType points = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(points, ids);
    if (isVisible && isVisible->GetValue(cells->GetCurrentCellId()) == 0)
      continue;
    double range[2];
    if (!rangeIn(choice_, array, cells->GetCurrentCellId(), points, ids, range) ||
        std::none_of(shown.begin(), shown.end(),
          [&](const Interval& i) { return i.low <= range[1] && i.high >= range[0]; }))
      continue;
    for (vtkIdType i = 0; i < points; ++i)
      box.AddPoint(data->GetPoint(ids[i]));
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
    box.GetBounds(bounds);
}

void Volume::setAmbient(double ambient)
{
  vtkVolumeProperty* look = volume_->GetProperty();
  look->SetAmbient(std::max(0.25, ambient));
  look->SetDiffuse(0.75);
}

} // namespace mote::app
