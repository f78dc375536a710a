#include "Part.h"

#include "SimulationBox.h"
#include "Slices.h"
#include "VolumeLook.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"
#include "settings/Colors.h"
#include "settings/ErrorBudget.h"

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolume.h>

#include <algorithm>
#include <set>
#include <string>

namespace mote::app
{

namespace
{

/// Particles from which on an error budget is used for levels of detail. Fewer are seldom smaller
/// than pixels together, and the structure that it takes is not the fastest for them.
constexpr vtkIdType leastForLods = 4'000'000;

/// In one text, each once and in their order.
std::string namesOfArrays(vtkDataSet* data)
{
  std::set<std::string> names;
  for (vtkDataSetAttributes* of : {static_cast<vtkDataSetAttributes*>(data->GetPointData()),
         static_cast<vtkDataSetAttributes*>(data->GetCellData())})
    for (int i = 0; i < of->GetNumberOfArrays(); ++i)
      if (const char* name = of->GetArrayName(i))
        names.insert(name);
  std::string all;
  for (const std::string& name : names)
    all += name + '\n';
  return all;
}

vtkPoints* pointsOf(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  return points ? points->GetPoints() : nullptr;
}

void shade(vtkProperty* property, const std::string& plain, double ambient)
{
  Color color{};
  parseColor(plain, color);
  property->SetColor(color.data());
  property->SetAmbient(ambient);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.0);
  property->SetSpecularPower(30.0);
}

} // namespace

Part::Part(const std::string& name, vtkDataSet* data, const Settings& settings, double ambient)
  : settings_(settings)
  , kind_(kindOf(data, settings))
{
  if (kind_ == Kind::Volume)
  {
    volume_ = std::make_unique<Volume>(settings_.volume, errorShares(settings_).tolerance);
    walls_ = vtkSmartPointer<vtkMoteMeshMapper>::New();
    walls_->TwoSidedSheetsOn();
    actor_->SetMapper(walls_);
  }
  if (kind_ == Kind::Particles)
  {
    auto mapper = vtkSmartPointer<vtkMoteParticleMapper>::New();
    particles_ = mapper;
    mapper_ = mapper;
  }
  if (kind_ == Kind::Surface)
  {
    surface_ = std::make_unique<Surface>();
    mapper_ = surface_->mapper();
  }
  this->setAmbient(ambient);
  this->setData(name, data);
}

void Part::setAmbient(double ambient)
{
  shade(actor_->GetProperty(), settings_.color.plain, ambient);
  if (volume_)
    volume_->setAmbient(ambient);
  this->followLook();
}

void Part::followSettings()
{
  this->setRadius();
  if (particles_)
    this->setImages();
  if (volume_)
  {
    volume_->update(errorShares(settings_).tolerance);
    this->placeSlices();
  }
  this->followLook();
}

double Part::lodError() const
{
  if (settings_.picture.lodError > 0.0 && !volume_)
    return settings_.picture.lodError;
  if (surface_ || (particles_ && data_->GetNumberOfPoints() >= leastForLods))
    return errorShares(settings_).lodError;
  return 0.0;
}

void Part::followLodError()
{
  if (particles_)
    particles_->SetPixelsOfError(this->lodError());
  if (surface_)
    surface_->mapper()->SetPixelsOfError(this->lodError());
}

vtkProp3D* Part::prop() const
{
  return volume_ ? static_cast<vtkProp3D*>(volume_->volume()) : actor_;
}

vtkAlgorithm* Part::worker() const
{
  return volume_ ? static_cast<vtkAlgorithm*>(volume_->mapper()) : mapper_;
}

vtkTypeInt64 Part::structureBytes() const
{
  return particles_ ? particles_->GetStructureBytes()
         : volume_  ? volume_->mapper()->GetStructureBytes() +
                       (this->hasWalls() ? walls_->GetStructureBytes() : 0)
                   : surface_->mapper()->GetStructureBytes();
}

double Part::buildTime() const
{
  return particles_ ? particles_->GetBuildTime()
         : volume_  ? volume_->mapper()->GetBuildTime()
                    : surface_->mapper()->GetBuildTime();
}

void Part::setData(const std::string& name, vtkDataSet* data)
{
  const bool isFirst = !data_;
  name_ = name;
  data_ = data;
  cells_ = {};
  this->followLodError();
  if (particles_)
  {
    if (spaced_ && spaced_ != pointsOf(data))
      spaced_ = nullptr;
    this->showAll(); // other data may lack the arrays
    this->setRadius();
    this->setImages();
    particles_->SetInputData(vtkPointSet::SafeDownCast(data));
  }
  else if (volume_)
  {
    volume_->setData(vtkUnstructuredGrid::SafeDownCast(data));
    walls_->SetInputData(vtkUnstructuredGrid::SafeDownCast(data));
    arrays_ = namesOfArrays(data);
    if (isFirst)
      this->placeSlices();
  }
  else
  {
    this->setRadius();
    surface_->setData(data);
  }
  actor_->SetMapper(volume_ ? static_cast<vtkMapper*>(walls_) : mapper_.Get());
  this->followLook();
  isWhole_ = true;
  this->placeProp();
}

/// Into the picture, or out of it.
void Part::placeProp()
{
  const bool isShown = isWhole_ && !isHidden_ && (!volume_ || volume_->isColored());
  this->prop()->SetVisibility(isShown);
  if (volume_)
    actor_->SetVisibility(isShown && this->hasWalls());
}

std::vector<vtkProp3D*> Part::props() const
{
  if (volume_)
    return {volume_->volume(), actor_};
  return {actor_};
}

bool Part::draws(const vtkProp* prop) const
{
  const std::vector<vtkProp3D*> own = this->props();
  return std::find(own.begin(), own.end(), prop) != own.end();
}

void Part::setHidden(bool on)
{
  isHidden_ = on;
  this->placeProp();
}

/// Without a box there is one image.
void Part::setImages()
{
  const auto box = simulationBoxOf(data_);
  std::vector<int> counts = settings_.particles.replicate;
  if (!box || counts.empty())
    counts = {1, 1, 1};
  particles_->SetReplication(counts[0], counts[1], counts[2]);
  if (box)
    particles_->SetReplicationVectors(&box->vectors[0][0]);
}

int Part::images() const
{
  if (!particles_)
    return 1;
  const int* counts = particles_->GetReplication();
  return counts[0] * counts[1] * counts[2];
}

void Part::setPreview(bool on)
{
  if (particles_)
    particles_->SetPreview(on);
}

bool Part::isPreview() const
{
  return particles_ && particles_->IsPreview();
}

std::string Part::update()
{
  // One that could not be built stays away, and is told of already.
  if (!particles_ || !isWhole_)
    return {};
  Messages::takeError();
  particles_->Update();
  return Messages::takeError();
}

void Part::work(const Runner& runner, const std::function<void()>& build)
{
  Messages::takeError();
  runner("Building structure", this->worker(), build);
  Messages::throwError();
}

void Part::stopBuild()
{
  if (particles_)
    particles_->StopBuild();
}

void Part::finishBuild(ProgressRelay& progress)
{
  if (particles_)
    this->work(progress.runner(), [this] { particles_->FinishBuild(); });
}

void Part::build(ProgressRelay& progress)
{
  this->build(progress.runner());
}

void Part::build(const Runner& runner)
{
  isWhole_ = false; // whatever happens, nothing half built is drawn
  this->placeProp();
  this->work(runner, [this] { this->worker()->Update(); });
  if (this->hasWalls())
    this->work(runner, [this] { walls_->Update(); });
  isWhole_ = true;
  this->placeProp();
  if (particles_ && particles_->GetRadiusMode() == vtkMoteParticleMapper::RADIUS_FROM_SPACING &&
      particles_->GetNumberOfParticles() > 1)
  {
    keptRadius_ = particles_->GetRadiusInUse() / settings_.particles.radiusScale;
    spaced_ = pointsOf(data_);
  }
}

BuiltPart Part::built(bool forPicture) const
{
  BuiltPart built;
  if (particles_)
    built.particles = particles_->GetBuilt();
  if (volume_)
    built.volume = volume_->mapper()->GetBuilt(forPicture);
  if (this->hasWalls())
    built.mesh = walls_->GetBuilt();
  if (surface_)
  {
    built.mesh = surface_->mapper()->GetBuilt();
    built.drawn = surface_->drawn();
  }
  if (built.particles)
    built.memory = {{built.particles.get(), static_cast<std::size_t>(this->structureBytes())}};
  else if (surface_)
    built.memory = surface_->mapper()->GetMemory();
  else if (volume_)
  {
    built.memory = volume_->mapper()->GetMemory();
    if (built.mesh)
      for (const auto& piece : walls_->GetMemory())
        built.memory.push_back(piece);
  }
  return built;
}

bool Part::isProvisional() const
{
  return particles_ &&
         (this->isPreview() || (keptRadius_ > 0.0 && particles_->GetRadiusMode() ==
                                                       vtkMoteParticleMapper::RADIUS_FROM_SPACING));
}

void Part::offer(const BuiltPart& built)
{
  if (particles_)
    particles_->OfferBuilt(built.particles);
  if (volume_)
  {
    volume_->mapper()->OfferBuilt(built.volume);
    walls_->OfferBuilt(built.mesh);
  }
  if (surface_)
  {
    surface_->mapper()->OfferBuilt(built.mesh);
    if (built.drawn)
      surface_->takeDrawn(built.drawn);
  }
}

void Part::keep(double radius, const ArrayChoice& colored)
{
  keptRadius_ = radius;
  colored_ = colored;
  if (volume_ && arrayOf(data_, colored))
    volume_->select(colored);
  if (particles_)
    this->setRadius();
}

void Part::applyRanges()
{
  if (particles_)
    particles_->Update();
}

void Part::shownBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  if (!this->prop()->GetVisibility())
    return;
  if (particles_)
    particles_->GetVisibleBounds(bounds);
  else if (volume_)
  {
    volume_->shownBounds(vtkUnstructuredGrid::SafeDownCast(data_), cells_.mask(), bounds);
    addRepetitions(settings_, bounds);
    moveBounds(transformOf(turn_), bounds);
  }
  else if (const double* own = this->prop()->GetBounds())
    std::copy_n(own, 6, bounds);
}

vtkIdType Part::numberLeftOut() const
{
  if (surface_)
    return surface_->mapper()->GetNumberOfCellsLeftOut() +
           surface_->mapper()->GetNumberOfUnfitTriangles() +
           (surface_->tubes() ? surface_->tubes()->GetNumberOfLinesLeftOut() : 0);
  if (!volume_)
    return 0;
  vtkMoteVolumeMapper* const mapper = volume_->mapper(); // walls show what is flat
  return mapper->GetNumberOfCellsLeftOut() -
         mapper->GetNumberOfCellsLeftOut(vtkMoteVolumeMapper::FLAT);
}

vtkIdType Part::numberShown() const
{
  return particles_ && !isHidden_ ? particles_->GetNumberOfVisibleParticles() : 0;
}

vtkIdType Part::numberOfCellsShown() const
{
  return particles_ || isHidden_ ? 0
         : cells_.isUpToDate()   ? cells_.count()
                                 : data_->GetNumberOfCells();
}

} // namespace mote::app
