#include "vtkMoteParticleMapper.h"

#include "ArrayColors.h"
#include "Bounds.h"
#include "InputTimeStep.h"
#include "MapperClip.h"
#include "News.h"
#include "ParticleModel.h"
#include "PeriodicImages.h"
#include "RendererImage.h"
#include "SceneBridge.h"

#include "kernels/core/Error.h"
#include "kernels/scene/ColorMeans.h"
#include "kernels/scene/Scene.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

vtkStandardNewMacro(vtkMoteParticleMapper);

static_assert(
  static_cast<int>(mote::RadiusMode::FromSpacing) == vtkMoteParticleMapper::RADIUS_FROM_SPACING,
  "the modes stand in the same order");

/// What the mapper keeps between frames.
class vtkMoteParticleMapper::Internals
{
public:
  mote::ParticleModel model;
  mote::ArrayColors colors;
  mote::RendererImages images; ///< for renderers that have no vtkMoteRayCastPass
  mote::ColorMeans means;      ///< of levels of detail
  mote::InputKey meansKey;
  bool exactOnly = false; ///< somebody waits for the exact structure

  // The last of each kind of message, so that it is told once and not every frame.
  std::string reported, reportedColors;
  mote::MapperClip clip;

  explicit Internals(vtkMoteParticleMapper* self)
    : model(self, true)
  {
    model.previewSize = [self, this]
    { return self->GetPreview() && !exactOnly ? self->GetPreviewSize() : 0; };
  }
};

namespace
{

/// Makes a change that says whether it was any; false after an error.
template <typename Change>
bool tryChange(vtkMoteParticleMapper* self, const Change& change)
{
  try
  {
    if (change())
      self->Modified();
    return true;
  }
  catch (const mote::Error& error)
  {
    vtkErrorWithObjectMacro(self, << error.what());
    return false;
  }
}

std::string textOf(const char* text)
{
  return text ? text : "";
}

} // namespace

vtkMoteParticleMapper::vtkMoteParticleMapper()
  : Impl(std::make_unique<Internals>(this))
{
  this->SetTypeArrayName("type");
  this->SetStructureName(mote::particleStructureNames().front().c_str());
  this->SetStructureForm(mote::structureFormNames().front().c_str());
}

vtkMoteParticleMapper::~vtkMoteParticleMapper()
{
  this->SetRadiusArrayName(nullptr);
  this->SetTypeArrayName(nullptr);
  this->SetVisibilityArrayName(nullptr);
  this->SetStructureName(nullptr);
  this->SetStructureForm(nullptr);
}

mote::ParticleModel& vtkMoteParticleMapper::GetModel()
{
  return this->Impl->model;
}

int vtkMoteParticleMapper::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMoteParticleMapper::SetInputData(vtkPointSet* input)
{
  this->SetInputDataInternal(0, input);
}

vtkUnsignedCharArray* vtkMoteParticleMapper::GetGhosts()
{
  return this->MeetsGhosts ? mote::ghostMarksOf(this->GetInput()) : nullptr;
}

vtkPointSet* vtkMoteParticleMapper::GetInput()
{
  if (this->GetNumberOfInputConnections(0) < 1)
    return nullptr;
  return vtkPointSet::SafeDownCast(this->GetExecutive()->GetInputData(0, 0));
}

void vtkMoteParticleMapper::Update(int port)
{
  Internals& impl = *this->Impl;
  mote::ParticleModel& model = impl.model;
  if (!this->Static)
  {
    if (this->GetNumberOfInputConnections(0) < 1)
    {
      model.clear();
      return;
    }
    this->UpdateInformation();
    this->Superclass::Update(port);
  }
  mote::takeRadiusProperties(this, model.radii);
  model.structureName = textOf(this->StructureName);
  model.structureForm = textOf(this->StructureForm);
  // Of the structures that the name leaves open one has levels of detail.
  if (this->PixelsOfError > 0.0 && model.structureName == mote::particleStructureNames().front())
    model.structureName = mote::PkdTree::name();
  model.keepPointIds = this->KeepPointIds;
  std::string problem;
  try
  {
    model.update(this->GetInput());
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  if (mote::isNews(problem, impl.reported))
    vtkErrorMacro(<< problem);

  std::vector<mote::ArrayRange> visibility;
  if (this->UseVisibilityRange)
  {
    mote::ArrayRange range = {textOf(this->VisibilityArrayName), this->VisibilityComponent,
      this->VisibilityRange[0], this->VisibilityRange[1], "the visibility range"};
    range.array = range.name.empty() ? this->GetColorArray() : nullptr;
    if (range.array)
      range.component = mote::ArrayColors::componentOf(this, range.array);
    visibility.push_back(range);
  }
  model.meetsGhosts = this->MeetsGhosts;
  for (const std::string& message : model.updateRanges(visibility))
    vtkErrorMacro(<< message);
}

int vtkMoteParticleMapper::UpdateTimeStep(
  double time, int piece, int pieces, int ghostLevels, const int extents[6])
{
  const bool done = mote::updateInputTimeStep(this, time, piece, pieces, ghostLevels, extents);
  this->Update();
  return done && this->Impl->model.structure() ? 1 : 0;
}

bool vtkMoteParticleMapper::FinishBuild()
{
  this->Impl->exactOnly = true;
  this->Update();
  this->Impl->exactOnly = false;
  return this->Impl->model.structure() && !this->IsPreview();
}

std::shared_ptr<mote::ScratchSpace> vtkMoteParticleMapper::GetScratchSpace() const
{
  return this->Impl->model.space;
}

void vtkMoteParticleMapper::SetTypeRadius(int type, double radius)
{
  auto& table = this->Impl->model.radii.typeRadii;
  const auto found = table.find(type);
  if (found != table.end() && found->second == radius)
    return;
  table[type] = radius;
  this->Modified();
}

double vtkMoteParticleMapper::GetTypeRadius(int type)
{
  const auto& table = this->Impl->model.radii.typeRadii;
  const auto found = table.find(type);
  return found == table.end() ? this->Radius : found->second;
}

void vtkMoteParticleMapper::RemoveAllTypeRadii()
{
  this->Impl->model.radii.typeRadii.clear();
  this->Modified();
}

bool vtkMoteParticleMapper::AddRange(const char* array, int component, double low, double high)
{
  return tryChange(this,
    [&] {
      return this->Impl->model.addRange({textOf(array), component, low, high});
    });
}

bool vtkMoteParticleMapper::AddToRange(const char* array, int component, double low, double high)
{
  return tryChange(this,
    [&] {
      return this->Impl->model.addToRange({textOf(array), component, low, high});
    });
}

void vtkMoteParticleMapper::RemoveRange(const char* array, int component)
{
  if (this->Impl->model.removeRange(textOf(array), component))
    this->Modified();
}

int vtkMoteParticleMapper::GetNumberOfRanges()
{
  return static_cast<int>(this->Impl->model.ranges().size());
}

bool vtkMoteParticleMapper::SetCenterRange(int axis, double low, double high)
{
  if (axis < 0 || axis > 2)
  {
    vtkErrorMacro("Axes are 0, 1 and 2 for x, y and z; there is no axis " << axis << ".");
    return false;
  }
  return tryChange(this, [&] { return this->Impl->model.setPlaceRange(axis, low, high); });
}

void vtkMoteParticleMapper::GetCenterRange(int axis, double range[2])
{
  const mote::PlaceRanges& places = this->Impl->model.places();
  range[0] = places.low[std::clamp(axis, 0, 2)];
  range[1] = places.high[std::clamp(axis, 0, 2)];
}

bool vtkMoteParticleMapper::SetRadiusRange(double low, double high)
{
  return tryChange(this, [&] { return this->Impl->model.setPlaceRange(3, low, high); });
}

void vtkMoteParticleMapper::GetRadiusRange(double range[2])
{
  range[0] = this->Impl->model.places().low[3];
  range[1] = this->Impl->model.places().high[3];
}

void vtkMoteParticleMapper::RemoveAllRanges()
{
  if (this->Impl->model.removeAllRanges())
    this->Modified();
}

vtkIdType vtkMoteParticleMapper::GetNumberOfVisibleParticles()
{
  return static_cast<vtkIdType>(this->Impl->model.visible());
}

void vtkMoteParticleMapper::GetVisibleBounds(double bounds[6])
{
  const mote::Box box = this->Impl->model.visibleBounds();
  mote::copyBounds(mote::withImages(box, this->Replication, this->ReplicationVectors), bounds);
}

void vtkMoteParticleMapper::SetClipCylinder(vtkMoteClipCylinder* cylinder)
{
  if (this->Impl->clip.set(cylinder))
    this->Modified();
}

vtkMoteClipCylinder* vtkMoteParticleMapper::GetClipCylinder()
{
  return this->Impl->clip.cylinder();
}

double* vtkMoteParticleMapper::GetBounds()
{
  const bool any = this->GetNumberOfInputConnections(0) > 0;
  if (any && !this->Static)
    this->Update();
  const mote::Box box = any ? this->Impl->model.statistics().bounds : mote::Box();
  mote::copyBounds(
    mote::withImages(box, this->Replication, this->ReplicationVectors), this->Bounds);
  return this->Bounds;
}

vtkIdType vtkMoteParticleMapper::GetNumberOfParticles()
{
  return static_cast<vtkIdType>(this->Impl->model.statistics().valid);
}

vtkIdType vtkMoteParticleMapper::GetNumberOfUnfitParticles()
{
  const mote::ParticleStatistics s = this->Impl->model.statistics();
  return static_cast<vtkIdType>(s.badPositions + s.badRadii);
}

vtkTypeInt64 vtkMoteParticleMapper::GetStructureBytes()
{
  return static_cast<vtkTypeInt64>(this->Impl->model.bytes());
}

double vtkMoteParticleMapper::GetBuildTime()
{
  return this->Impl->model.buildTime();
}

int vtkMoteParticleMapper::GetNumberOfBuilds()
{
  return this->Impl->model.builds();
}

double vtkMoteParticleMapper::GetRadiusInUse()
{
  return this->Impl->model.commonRadius();
}

std::vector<std::string> vtkMoteParticleMapper::GetStructureNames()
{
  return mote::particleStructureNames();
}

std::vector<std::string> vtkMoteParticleMapper::GetStructureForms()
{
  return mote::structureFormNames();
}

double vtkMoteParticleMapper::EstimateSpacing(vtkPointSet* points)
{
  return mote::spacingOf(points);
}

mote::MapperOcclusion* vtkMoteParticleMapper::UpdateOcclusion(const mote::OcclusionRequest* request)
{
  return this->Impl->model.occlusion(request);
}

vtkIdType vtkMoteParticleMapper::GetNumberOfBakedParticles()
{
  const auto* occlusion = this->UpdateOcclusion(nullptr);
  const std::shared_ptr<const mote::OcclusionMaps> maps = occlusion ? occlusion->maps() : nullptr;
  vtkIdType count = 0;
  for (std::size_t slot = 0; maps && slot < maps->size(); ++slot)
    count += maps->isBaked(slot);
  return count;
}

vtkTypeInt64 vtkMoteParticleMapper::GetOcclusionBytes()
{
  const auto* occlusion = this->UpdateOcclusion(nullptr);
  return occlusion ? static_cast<vtkTypeInt64>(occlusion->maps()->bytes()) : 0;
}

vtkDataArray* vtkMoteParticleMapper::GetColorArray()
{
  return mote::ArrayColors::arrayOf(this, this->GetInput());
}

double vtkMoteParticleMapper::GetParticleValue(vtkIdType id)
{
  return mote::ArrayColors::valueOf(this, this->GetColorArray(), id);
}

void vtkMoteParticleMapper::GetColorArrayRange(double range[2])
{
  range[0] = 1.0;
  range[1] = 0.0;
  if (vtkDataArray* array = this->GetColorArray())
    array->GetFiniteRange(range, mote::ArrayColors::componentOf(this, array));
}

vtkMTimeType vtkMoteParticleMapper::GetPictureMTime()
{
  vtkMTimeType time =
    std::max({this->GetMTime(), this->Impl->model.time(), this->Impl->clip.time(this)});
  if (vtkPointSet* input = this->GetInput())
    time = std::max(time, input->GetMTime());
  return time;
}

bool vtkMoteParticleMapper::DescribeTo(mote::SurfaceObject& object, vtkActor* actor)
{
  Internals& impl = *this->Impl;
  this->Update();
  if (!impl.model.structure() || this->GetNumberOfParticles() == 0)
    return false;
  object.surface = mote::ParticleSurface(impl.model.structure());
  object.castsShadows = this->CastsShadows;
  mote::describeActor(actor, object);
  object.clip = impl.clip.region(this);
  const std::string problem = impl.colors.describe(this, this->GetInput(), object.coloring);
  if (mote::isNews(problem, impl.reportedColors))
    vtkErrorMacro(<< problem);
  this->AllowError(object);
  return true;
}

/// Makes levels of detail and their colours, where an error is allowed and they were not made
/// before.
void vtkMoteParticleMapper::AllowError(mote::SurfaceObject& object)
{
  Internals& impl = *this->Impl;
  mote::SurfaceColoring& coloring = object.coloring;
  // Boxes cannot be closed where they are cut.
  if (!(this->PixelsOfError > 0.0) || object.mayBeTransparent() || !object.clip.isAll() ||
      !impl.model.makeLods())
    return;
  object.surface = mote::ParticleSurface(impl.model.structure(), this->PixelsOfError);
  const mote::ArrayView& array = coloring.direct.empty() ? coloring.values : coloring.direct;
  if (array.empty())
    return;
  mote::InputKey key = {double(impl.model.structureTime()), double(coloring.component),
    double(coloring.direct.empty())};
  mote::addArray(key, this->GetColorArray());
  if (!coloring.direct.empty())
    key.push_back(double(this->GetLookupTable()->GetMTime()));
  if (key != impl.meansKey)
  {
    impl.means = mote::meansOf(*impl.model.tree(), coloring);
    impl.meansKey = std::move(key);
  }
  coloring.means = impl.means.view();
}

void vtkMoteParticleMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  mote::RendererImage& image = this->Impl->images.of(renderer);
  image.render(this, renderer, {mote::motePropOf(actor)},
    mote::FrameSettings{mote::Refinement{this->SamplesPerPixel}}, {}, !actor->HasOpaqueGeometry());
  this->TimeToDraw = image.time();
}

void vtkMoteParticleMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->images.release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkMoteParticleMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  const mote::ParticleModel& model = this->Impl->model;
  const auto print = [&](const char* name, const auto& value)
  { os << indent << name << ": " << value << "\n"; };
  const auto onOff = [](bool is) { return is ? "On" : "Off"; };
  const auto text = [](const char* s) { return s ? s : "(none)"; };
  this->Superclass::PrintSelf(os, indent);
  mote::RadiusChoice radii = model.radii;
  mote::takeRadiusProperties(this, radii);
  mote::printRadii(radii, os, indent);
  print("UseVisibilityRange", onOff(this->UseVisibilityRange));
  os << indent << "VisibilityRange: " << this->VisibilityRange[0] << " " << this->VisibilityRange[1]
     << "\n";
  print("VisibilityArrayName", text(this->VisibilityArrayName));
  print("VisibilityComponent", this->VisibilityComponent);
  print("MeetsGhosts", onOff(this->MeetsGhosts));
  model.printRanges(os, indent);
  print("StructureName", text(this->StructureName));
  print("StructureForm", text(this->StructureForm));
  print("Preview", onOff(this->Preview));
  print("PreviewSize", this->PreviewSize);
  print("IsPreview", this->IsPreview() ? "Yes" : "No");
  print("KeepPointIds", onOff(this->KeepPointIds));
  print("CastsShadows", onOff(this->CastsShadows));
  print("PixelsOfError", this->PixelsOfError);
  for (int v = 0; v < 3; ++v)
    os << indent << "Replication " << v << ": " << this->Replication[v] << " by "
       << this->ReplicationVectors[3 * v] << " " << this->ReplicationVectors[3 * v + 1] << " "
       << this->ReplicationVectors[3 * v + 2] << "\n";
  print("NumberOfParticles", this->GetNumberOfParticles());
  print("NumberOfUnfitParticles", this->GetNumberOfUnfitParticles());
  print("StructureBytes", this->GetStructureBytes());
}
