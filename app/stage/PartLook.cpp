// How a part looks, and what of it is shown.

#include "Part.h"

#include "Slices.h"
#include "base/Messages.h"
#include "settings/Colors.h"

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkProperty.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolume.h>

namespace mote::app
{

/// How often cells are drawn around the axis of the cuts.
void Part::followRepetitions()
{
  const CutAxis axis = cutAxisOf(settings_.cuts.axis);
  const auto set = [&](auto* mapper)
  {
    mapper->SetRepetitions(settings_.volume.repeatAround);
    mapper->SetRepetitionCenter(axis.point.data());
    mapper->SetRepetitionAxis(axis.direction.data());
    mapper->TurnVectorsOn();
  };
  if (surface_)
    set(surface_->mapper());
  if (!volume_)
    return;
  set(volume_->mapper());
  set(walls_.Get());
}

void Part::setTurn(const Turn& turn)
{
  if (turn == turn_ || particles_)
    return;
  turn_ = turn;
  const auto moved = transformOf(turn_);
  for (vtkProp3D* prop : this->props())
    prop->SetUserTransform(turn_.degrees == 0.0 ? nullptr : moved.Get());
  this->placeSlices();
}

/// Where they are in the world: they do not turn with the part.
void Part::placeSlices()
{
  if (!volume_)
    return;
  const auto slices = slicesOf(settings_, data_->GetLength());
  if (turn_.degrees != 0.0)
    moveSlices(slices, transformOf(turn_)->GetLinearInverse());
  volume_->setSlices(slices);
}

std::vector<vtkSmartPointer<vtkTransform>> Part::placements() const
{
  std::vector<vtkSmartPointer<vtkTransform>> all = {transformOf(turn_)};
  const int count = particles_ ? 1 : settings_.volume.repeatAround;
  for (int k = 1; k < count; ++k)
  {
    all.push_back(transformOf({cutAxisOf(settings_.cuts.axis), 360.0 * k / count}));
    all.back()->PostMultiply();
    all.back()->Concatenate(all.front());
  }
  return all;
}

/// How often it is drawn, and the lines on surfaces; of a volume the look of its walls.
void Part::followLook()
{
  this->followRepetitions();
  vtkProperty* look = actor_->GetProperty();
  look->SetEdgeVisibility(settings_.volume.edges > 0.0);
  look->SetLineWidth(static_cast<float>(settings_.volume.edges));
  look->SetEdgeColor(0.05, 0.05, 0.05);
  if (!volume_)
    return;
  Color color{};
  const bool isPlain = parseColor(settings_.volume.wallColor, color);
  if (isPlain)
    look->SetColor(color.data());
  const double walls = settings_.volume.walls.value_or(0.0);
  const double nearWalls = settings_.volume.nearWalls.value_or(walls);
  look->SetOpacity(nearWalls);
  if (nearWalls == walls)
    actor_->SetBackfaceProperty(nullptr);
  else
  {
    // The same object again: what has not changed is not traced anew.
    if (!actor_->GetBackfaceProperty())
      actor_->SetBackfaceProperty(vtkNew<vtkProperty>());
    actor_->GetBackfaceProperty()->SetOpacity(walls);
  }
  // What is looked through keeps no light from what is within.
  walls_->SetCastsShadows(nearWalls == walls && walls >= 1.0);
  walls_->SetScalarVisibility(!isPlain && arrayOf(data_, colored_) != nullptr);
  this->placeProp();
}

namespace
{

void colorBy(vtkMapper* mapper, const ArrayChoice& choice, vtkLookupTable* table)
{
  if (choice.ofCells)
    mapper->SetScalarModeToUseCellFieldData();
  else
    mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(choice.name.c_str());
  mapper->SetLookupTable(table);
  mapper->UseLookupTableScalarRangeOn();
}

} // namespace

void Part::setColors(
  const ArrayChoice& choice, vtkLookupTable* table, const std::vector<OpacityPoint>& opacity)
{
  const bool hadColors = colored_ == choice && mapper_ && mapper_->GetScalarVisibility();
  colored_ = choice;
  if (volume_)
  {
    volume_->setColors(data_, choice, table, opacity, sceneSize_);
    colorBy(walls_, choice, table);
    return this->followLook();
  }
  if (surface_)
    surface_->followArrays(data_);
  mapper_->SetScalarVisibility(arrayOf(data_, choice) != nullptr);
  if (!mapper_->GetScalarVisibility())
  {
    if (hadColors && choice && !(missed_ == choice))
    {
      missed_ = choice;
      Messages::warn(
        "a time step has no array '" + choice.name + "', so it is shown in one colour");
    }
    return;
  }
  colorBy(mapper_, choice, table);
}

void Part::limitCells(const std::vector<CellLimit>& limits)
{
  const ArrayChoice within = volume_ ? colored_ : ArrayChoice();
  cells_.update(data_, limits, within);
  if (surface_)
    surface_->setVisible(data_, cells_.mask());
  if (!volume_)
    return;
  volume_->mapper()->SetVisibleCells(cells_.mask());
  walls_->SetVisibleCells(cells_.mask());
  volume_->showAll();
  for (const CellLimit& limit : limits)
    if (limit.place < 0 && limit.choice == within)
      volume_->limit(limit.intervals);
}

void Part::setCuts(const Cuts& cuts)
{
  const auto set = [&](auto* mapper)
  {
    mapper->SetClippingPlanes(cuts.planes());
    mapper->SetClipCylinder(cuts.cylinder());
  };
  if (particles_)
    set(particles_);
  if (surface_)
    set(surface_->mapper());
  if (volume_)
  {
    set(volume_->mapper());
    set(walls_.Get());
  }
}

void Part::showAll()
{
  if (!particles_)
    return;
  particles_->RemoveAllRanges();
  particles_->UseVisibilityRangeOff();
}

void Part::limit(const ArrayChoice& choice, const std::vector<Interval>& intervals)
{
  if (particles_)
    for (const auto& [low, high] : intervals)
      particles_->AddToRange(choice.name.c_str(), choice.component, low, high);
}

void Part::limitPlace(int place, double low, double high)
{
  if (!particles_)
    return;
  if (place < 3)
    particles_->SetCenterRange(place, low, high);
  else
    particles_->SetRadiusRange(low, high);
}

void Part::setVisible(const ArrayChoice& choice, const double range[2])
{
  if (!particles_)
    return;
  particles_->SetUseVisibilityRange(arrayOf(data_, choice) != nullptr);
  if (!particles_->GetUseVisibilityRange())
    return;
  particles_->SetVisibilityArrayName(choice.name.c_str());
  particles_->SetVisibilityComponent(choice.component);
  particles_->SetVisibilityRange(range[0], range[1]);
}

} // namespace mote::app
