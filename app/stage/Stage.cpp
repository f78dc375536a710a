#include "Stage.h"

#include "Silhouettes.h"
#include "SimulationBox.h"
#include "VolumeLook.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"
#include "settings/Colors.h"
#include "settings/ErrorBudget.h"
#include "settings/Values.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkDataSet.h>
#include <vtkMath.h>
#include <vtkMoteParticleMapper.h>
#include <vtkProp3D.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace mote::app
{

Stage::Stage(const Settings& settings)
  : asked_(settings)
  , settings_(settings)
  , lighting_(renderer_, settings_)
  , coloring_(settings_)
  , selection_(settings_)
  , flow_(settings_)
{
  for (vtkActor* actor : flow_.actors())
    renderer_->AddViewProp(actor);
  flow_.setAmbient(lighting_.ambient());
  setBackground(renderer_, settings.picture.background);
  choose(settings.silhouettes, vtkMoteSilhouettes::RADII, silhouettes_);
  renderer_->GetActiveCamera()->SetParallelProjection(settings.camera.orthographic);
  this->chooseLook();
}

void Stage::chooseLook()
{
  settings_ = asked_;
  if (usualSlice_)
    settings_.volume = lookInForce(asked_, *usualSlice_, hidesCells_);
}

/// Where volumes are sliced the first ones tell: slices stay in place over time steps.
void Stage::placeSlice(const std::vector<NamedData>& data)
{
  std::vector<vtkUnstructuredGrid*> volumes;
  for (const NamedData& one : data)
    if (!usualSlice_ && Part::kindOf(one.data, settings_) == Part::Kind::Volume)
      volumes.push_back(vtkUnstructuredGrid::SafeDownCast(one.data));
  if (volumes.empty())
    return;
  // What is flat has none; whatever is chosen then, all else follows from it.
  usualSlice_ = fullestSlice(volumes, asked_.cuts.axis).value_or(ShowRange{"z", {{0.0, 0.0}}});
  this->chooseLook();
}

bool Stage::apply(const Settings& settings)
{
  const Settings before = settings_;
  asked_ = settings;
  this->chooseLook();
  if (before.picture.background != settings_.picture.background)
    setBackground(renderer_, settings_.picture.background);
  lighting_.update(); // which knows samples and tolerances, too
  if (before.silhouettes != settings_.silhouettes)
    choose(settings_.silhouettes, vtkMoteSilhouettes::RADII, silhouettes_);
  const bool otherKinds = std::any_of(parts_.begin(), parts_.end(),
    [&](const auto& part) { return part->kind() != Part::kindOf(part->data(), settings_); });
  if (before.volume.turns != settings_.volume.turns || before.cuts.axis != settings_.cuts.axis)
    this->turnParts();
  const bool otherData = otherKinds || areOtherCalculations(before, settings_);
  if (otherData)
    this->setData(std::vector<NamedData>(data_));
  for (const auto& part : parts_)
  {
    part->setAmbient(lighting_.ambient());
    // Where nothing changes nothing is touched: a mapper that is told of types builds anew.
    if (before.particles != settings_.particles || before.volume != settings_.volume ||
        before.picture.error != settings_.picture.error ||
        before.cuts.axis != settings_.cuts.axis ||
        // Slices on the faces of cuts lie a little within.
        (part->kind() == Part::Kind::Volume && before.cuts != settings_.cuts))
      part->followSettings();
    part->followLodError();
  }
  flow_.setAmbient(lighting_.ambient());
  if (before.particles.replicate != settings_.particles.replicate)
    this->checkImages();
  if (otherData || before.color != settings_.color || before.selection != settings_.selection ||
      before.volume != settings_.volume)
    this->applyColors();
  else if (before.cuts != settings_.cuts)
    this->applyCuts();
  const auto allowsError = [](const Settings& s) { return errorShares(s).lodError > 0.0; };
  return otherData || before.particles != settings_.particles ||
         Flow::areOther(before, settings_) ||
         allowsError(before) != allowsError(settings_) || // which automatic structures depend on
         before.volume.structure != settings_.volume.structure;
}

Settings Stage::settingsInForce() const
{
  Settings all = asked_; // from which all of the look of volumes follows, but for one slice
  if (usualSlice_ && settings_.volume.slices == std::vector{*usualSlice_})
    all.volume.slices = settings_.volume.slices;
  all.color = coloring_.inForce(parts_);
  vtkCamera* camera = renderer_->GetActiveCamera();
  all.camera.orthographic = camera->GetParallelProjection() != 0;
  all.camera.camera = cameraOf(camera);
  if (parts_.size() == 1 && parts_.front()->keptRadius() > 0.0)
    all.particles.radius = exactText(parts_.front()->keptRadius());
  return all;
}

void Stage::setData(const std::vector<NamedData>& original, const ReadyStep* ready)
{
  const bool isReady = ready && ready->data.size() == original.size() &&
                       ready->parts.size() == original.size() &&
                       ready->plan.fitsCalculations(settings_);
  const std::vector<NamedData> data =
    isReady ? ready->data : withCalculated(original, settings_, known_);
  if (isReady)
    noteCalculated(settings_, known_);
  data_ = original;
  flow_.offer(isReady ? ready->flow : BuiltFlow());
  this->placeSlice(data);
  bool sameKinds = parts_.size() == data.size();
  for (std::size_t i = 0; sameKinds && i < data.size(); ++i)
    sameKinds = parts_[i]->kind() == Part::kindOf(data[i].data, settings_);
  if (sameKinds)
  {
    for (std::size_t i = 0; i < data.size(); ++i)
    {
      parts_[i]->setData(data[i].name, data[i].data);
      parts_[i]->offer(isReady ? ready->parts[i] : BuiltPart());
    }
    if (isReady && ready->opacity.choice)
      coloring_.offer(parts_, ready->opacity);
    this->turnParts();
    this->checkImages();
    return this->setSizes();
  }
  for (const auto& part : parts_)
    for (vtkProp3D* prop : part->props())
      renderer_->RemoveViewProp(prop);
  parts_.clear();
  for (const NamedData& one : data)
  {
    parts_.push_back(std::make_unique<Part>(one.name, one.data, settings_, lighting_.ambient()));
    parts_.back()->setPreview(preview_);
    for (vtkProp3D* prop : parts_.back()->props())
      renderer_->AddViewProp(prop);
  }
  this->turnParts();
  this->setSizes();
  const bool anyRadii =
    std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->hasRadius(); });
  if (!parts_.empty() && !anyRadii &&
      (settings_.particles.radius != "auto" || !settings_.particles.typeRadius.empty()))
    throw Failure("--radius and --type-radius are for particles, and " + parts_.front()->name() +
                  " holds cells alone");
  this->checkImages();
}

/// Turns what --turn names, by the time of its step.
void Stage::turnParts()
{
  for (std::size_t i = 0; i < parts_.size() && i < data_.size(); ++i)
    parts_[i]->setTurn(turnOf(data_[i], settings_));
  if (const std::string idle = idleTurns(data_, settings_);
      !parts_.empty() && std::exchange(toldTurns_, idle) != idle && !idle.empty())
    Messages::warn(idle);
}

void Stage::checkImages() const
{
  const bool hasBox = std::any_of(parts_.begin(), parts_.end(),
    [](const auto& part) { return part->particles() && simulationBoxOf(part->data()); });
  if (!parts_.empty() && !settings_.particles.replicate.empty() && !hasBox)
    throw Failure("--replicate needs particles with a simulation box, and " +
                  parts_.front()->name() + " has none");
}

void Stage::clear()
{
  for (const auto& part : parts_)
    for (vtkProp3D* prop : part->props())
      renderer_->RemoveViewProp(prop);
  parts_.clear();
  data_.clear();
  known_.clear();
  flow_.clear();
  usualSlice_.reset();
  hidesCells_ = false;
  this->chooseLook();
  coloring_.startAnew();
  selection_.startAnew();
}

ReadyStep Stage::ready() const
{
  ReadyStep ready;
  ready.plan = this->readyPlan();
  ready.original = data_;
  ready.flow = flow_.built();
  ready.opacity = coloring_.usualOpacity(parts_);
  for (const auto& part : parts_)
  {
    ready.parts.push_back(part->built());
    ready.data.push_back({part->name(), part->data(), {}});
  }
  // What is not all there, or was built before there was a radius to keep, is built anew.
  if (std::any_of(
        parts_.begin(), parts_.end(), [](const auto& part) { return part->isProvisional(); }))
  {
    ready.parts.clear();
    ready.plan = {};
    ready.flow = {};
  }
  ready.count();
  return ready;
}

ReadyPlan Stage::readyPlan() const
{
  ReadyPlan plan;
  plan.settings = settings_;
  plan.colored = coloring_.choice();
  for (const auto& part : parts_)
    plan.kept.push_back({part->kind(), part->keptRadius(),
      part->kind() == Part::Kind::Volume ? part->colored() : ArrayChoice()});
  return plan;
}

void Stage::setSizes()
{
  vtkBoundingBox all;
  for (const auto& part : parts_)
    if (part->data()->GetNumberOfPoints() > 0)
      all.AddBounds(part->data()->GetBounds());
  for (const auto& part : parts_)
    part->setSceneSize(
      all.IsValid() && all.GetDiagonalLength() > 0.0 ? all.GetDiagonalLength() : 1.0);
}

void Stage::build(ProgressRelay& progress)
{
  // Triangles of hidden cells are not built; what is wrong with limits applyColors() tells.
  for (const auto& part : parts_)
    if (part->surface())
      part->limitCells(cellLimitsOf(part->data(), settings_.selection, coloring_.choice()));
  joinWalls(parts_);
  for (const auto& part : parts_)
    part->build(progress);
  if (Flow::isAny(settings_))
  {
    coloring_.include(parts_); // adds the coordinate that colours, which lines take along
    prepareFlow(parts_, data_, settings_, coloring_.choice());
  }
  flow_.build(parts_, progress.runner());
}

void Stage::setPreview(bool on)
{
  preview_ = on;
  for (const auto& part : parts_)
    part->setPreview(on);
}

std::string Stage::update()
{
  std::string error;
  for (const auto& part : parts_)
    if (const std::string own = part->update(); error.empty())
      error = own;
  return error;
}

void Stage::finishBuild(ProgressRelay& progress)
{
  for (const auto& part : parts_)
    part->finishBuild(progress);
}

void Stage::stopBuild()
{
  for (const auto& part : parts_)
    part->stopBuild();
}

bool Stage::isBuilding() const
{
  return std::any_of(parts_.begin(), parts_.end(),
    [](const auto& part) { return part->particles() && part->particles()->IsBuilding(); });
}

void Stage::applyColors()
{
  coloring_.apply(parts_);
  flow_.setColors(coloring_.choice(), coloring_.table());
  selection_.apply(parts_, coloring_.choice(), data_);
  const bool hidesCells = std::any_of(parts_.begin(), parts_.end(),
    [](const auto& part) { return part->kind() == Part::Kind::Volume && part->cells().mask(); });
  if (hidesCells != hidesCells_)
  {
    hidesCells_ = hidesCells;
    const VolumeSettings before = settings_.volume;
    this->chooseLook();
    for (const auto& part : parts_)
      if (before != settings_.volume)
        part->followSettings();
    return this->applyColors(); // which the look has a part in, and which hides the same
  }
  this->applyCuts();
}

void Stage::applyCuts()
{
  cuts_.follow(settings_.cuts);
  for (const auto& part : parts_)
    part->setCuts(cuts_);
  flow_.setCuts(cuts_);
}

void Stage::look(double aspect, const Margins& margins)
{
  const CameraSettings& wanted = settings_.camera;
  double box[6], shown[6];
  this->bounds(box);
  this->shownBounds(shown);
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetParallelProjection(wanted.orthographic);
  if (!wanted.camera.empty())
    setCamera(camera, wanted.camera);
  else
  {
    camera->SetViewAngle(usualViewAngle);
    lookFrom(camera, wanted.view == "auto" ? this->automaticSide() : wanted.view);
    camera->Azimuth(wanted.azimuth);
    camera->Elevation(wanted.elevation);
    frame(camera, shown, aspect, margins);
    camera->Zoom(wanted.zoom);
  }
  renderer_->ResetCameraClippingRange(box);
}

std::string Stage::automaticSide() const
{
  vtkBoundingBox positions;
  bool surfaces = !parts_.empty();
  for (const auto& part : parts_)
  {
    if (part->data()->GetNumberOfPoints() > 0)
      positions.AddBounds(part->data()->GetBounds());
    surfaces = surfaces && !part->particles() && part->data()->IsA("vtkPolyData");
  }
  double bounds[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  if (settings_.volume.unroll)
    this->shownBounds(bounds); // what is rolled out lies where no position is
  else if (positions.IsValid())
    positions.GetBounds(bounds);
  const std::string side = automaticView(bounds);
  // Modellers of surfaces have y up, simulations z.
  return side == "iso" && surfaces ? "iso-y" : side;
}

std::vector<std::vector<std::size_t>> Stage::views() const
{
  std::vector<std::size_t> all(parts_.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<std::size_t>> views;
  if (!settings_.views.sideBySide || data_.size() != parts_.size())
    return {all};
  const bool isOneFile = std::all_of(
    data_.begin(), data_.end(), [&](const NamedData& one) { return one.file == data_[0].file; });
  for (const std::size_t i : all)
  {
    if (parts_[i]->isHidden())
      continue;
    const auto same = std::find_if(views.begin(), views.end(),
      [&](const auto& view) { return !isOneFile && data_[view.front()].file == data_[i].file; });
    if (same != views.end())
      same->push_back(i);
    else if (views.size() < mostViews)
      views.push_back({i});
    else
      views.back().push_back(i);
  }
  if (views.size() < 2)
    return {all};
  return views;
}

std::vector<vtkProp3D*> Stage::propsOf(const std::vector<std::size_t>& view) const
{
  std::vector<vtkProp3D*> props;
  for (const std::size_t part : view)
    for (vtkProp3D* prop : parts_[part]->props())
      props.push_back(prop);
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (parts_[i]->kind() == Part::Kind::Volume && !parts_[i]->isHidden() &&
        std::find(view.begin(), view.end(), i) == view.end())
      return props;
  for (vtkActor* actor : flow_.actors())
    props.push_back(actor);
  return props;
}

std::string Stage::viewName(const std::vector<std::size_t>& view) const
{
  std::vector<std::string> names;
  for (const std::size_t part : view)
  {
    const std::string& file = data_[part].fileName;
    const std::string name = view.size() > 1 && !file.empty() ? file : parts_[part]->name();
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  }
  const NamedData& first = data_[view.front()];
  return joined(names, ", ") + (first.isOwnStep ? ", step " + std::to_string(first.step + 1) + "/" +
                                                    std::to_string(first.steps)
                                                : "");
}

void Stage::bounds(double bounds[6]) const
{
  vtkBoundingBox box;
  for (const auto& part : parts_)
    if (const double* own = part->prop()->GetVisibility() ? part->prop()->GetBounds() : nullptr)
      if (vtkMath::AreBoundsInitialized(own))
        box.AddBounds(own);
  // Without particles the box that they will come into.
  for (const auto& part : parts_)
    if (const auto own = simulationBoxOf(part->data()); own && !box.IsValid())
      for (int corner = 0; corner < 8; ++corner)
        box.AddPoint(cornerOf(*own, corner).data());
  if (!box.IsValid())
    box.SetBounds(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
  box.GetBounds(bounds);
}

std::array<double, 3> Stage::asideOf(const std::vector<std::size_t>& view) const
{
  const auto boxOf = [this](const std::vector<std::size_t>& numbers)
  {
    vtkBoundingBox box;
    for (const std::size_t part : numbers)
      if (const double* own = parts_[part]->prop()->GetBounds();
          own && vtkMath::AreBoundsInitialized(own))
        box.AddBounds(own);
    return box;
  };
  std::array<double, 3> aside{};
  const auto views = this->views();
  if (view.empty() || views.size() < 2)
    return aside;
  vtkBoundingBox first = boxOf(views.front());
  const vtkBoundingBox own = boxOf(view);
  if (!first.IsValid() || !own.IsValid() || first.Intersects(own))
    return aside;
  double there[3], here[3];
  own.GetCenter(there);
  first.GetCenter(here);
  vtkMath::Subtract(there, here, aside.data());
  return aside;
}

void Stage::shownBounds(double bounds[6]) const
{
  vtkBoundingBox box;
  for (const auto& view : this->views())
  {
    const std::array<double, 3> aside = this->asideOf(view);
    for (const std::size_t part : view)
    {
      double own[6];
      parts_[part]->shownBounds(own);
      for (std::size_t axis = 0; axis < 6; ++axis)
        own[axis] -= vtkMath::AreBoundsInitialized(own) ? aside[axis / 2] : 0.0;
      if (vtkMath::AreBoundsInitialized(own))
        box.AddBounds(own);
    }
  }
  if (box.IsValid())
    box.GetBounds(bounds);
  else
    this->bounds(bounds);
}

} // namespace mote::app
