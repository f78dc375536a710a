#include "vtkMoteParticleMapper.h"

#include "BuildEvents.h"
#include "InputTimeStep.h"
#include "ParticleMapperInternals.h"
#include "SceneBridge.h"

#include "kernels/core/Error.h"
#include "kernels/particles/PkdTreeFile.h"
#include "kernels/scene/Scene.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkMoteParticleMapper);

vtkMoteParticleMapper::vtkMoteParticleMapper()
  : Impl(std::make_unique<Internals>())
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

int vtkMoteParticleMapper::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMoteParticleMapper::SetInputData(vtkPointSet* input)
{
  this->SetInputDataInternal(0, input);
}

vtkPointSet* vtkMoteParticleMapper::GetInput()
{
  if (this->GetNumberOfInputConnections(0) < 1)
    return nullptr;
  return vtkPointSet::SafeDownCast(this->GetExecutive()->GetInputData(0, 0));
}

void vtkMoteParticleMapper::SetTypeRadius(int type, double radius)
{
  auto& table = this->Impl->choice.typeRadii;
  const auto found = table.find(type);
  if (found != table.end() && found->second == radius)
    return;
  table[type] = radius;
  this->Modified();
}

double vtkMoteParticleMapper::GetTypeRadius(int type)
{
  const auto& table = this->Impl->choice.typeRadii;
  const auto found = table.find(type);
  return found == table.end() ? this->Radius : found->second;
}

void vtkMoteParticleMapper::RemoveAllTypeRadii()
{
  this->Impl->choice.typeRadii.clear();
  this->Modified();
}

double* vtkMoteParticleMapper::GetBounds()
{
  if (!this->GetInput() && this->GetNumberOfInputConnections(0) < 1)
  {
    vtkMath::UninitializeBounds(this->Bounds);
    return this->Bounds;
  }
  if (!this->Static)
    this->Update();
  const mote::Box box = this->Impl->statistics().bounds;
  vtkMath::UninitializeBounds(this->Bounds);
  for (int axis = 0; axis < 3 && !box.empty(); ++axis)
  {
    this->Bounds[2 * axis] = box.lower[axis];
    this->Bounds[2 * axis + 1] = box.upper[axis];
  }
  return this->Bounds;
}

vtkIdType vtkMoteParticleMapper::GetNumberOfParticles()
{
  return static_cast<vtkIdType>(this->Impl->statistics().valid);
}

vtkIdType vtkMoteParticleMapper::GetNumberOfUnfitParticles()
{
  const mote::ParticleStatistics s = this->Impl->statistics();
  return static_cast<vtkIdType>(s.badPositions + s.badRadii);
}

vtkTypeInt64 vtkMoteParticleMapper::GetStructureBytes()
{
  return this->Impl->fromStructure(
    [](const auto& s) { return static_cast<vtkTypeInt64>(s.bytes()); }, vtkTypeInt64{0});
}

double vtkMoteParticleMapper::GetBuildTime()
{
  return this->Impl->buildTime;
}

int vtkMoteParticleMapper::GetNumberOfBuilds()
{
  return this->Impl->builds;
}

double vtkMoteParticleMapper::GetRadiusInUse()
{
  return this->Impl->commonRadius;
}

std::vector<std::string> vtkMoteParticleMapper::GetStructureNames()
{
  return mote::particleStructureNames();
}

std::vector<std::string> vtkMoteParticleMapper::GetStructureForms()
{
  return mote::structureFormNames();
}

std::shared_ptr<const mote::PkdTree> vtkMoteParticleMapper::GetTree()
{
  const auto& structure = this->Impl->structure;
  auto* tree = structure ? std::get_if<mote::PkdTree>(structure.get()) : nullptr;
  return tree ? std::shared_ptr<const mote::PkdTree>(structure, tree) : nullptr;
}

void vtkMoteParticleMapper::SetScratchSpace(std::shared_ptr<mote::ScratchSpace> space)
{
  this->Impl->space = std::move(space);
}

std::shared_ptr<mote::ScratchSpace> vtkMoteParticleMapper::GetScratchSpace() const
{
  return this->Impl->space;
}

double vtkMoteParticleMapper::EstimateSpacing(vtkPointSet* points)
{
  return mote::spacingOf(points);
}

vtkMTimeType vtkMoteParticleMapper::GetPictureMTime()
{
  vtkMTimeType time = std::max(this->GetMTime(), this->Impl->builtAt.GetMTime());
  if (vtkPointSet* input = this->GetInput())
    time = std::max(time, input->GetMTime());
  return time;
}

int vtkMoteParticleMapper::UpdateTimeStep(
  double time, int piece, int pieces, int ghostLevels, const int extents[6])
{
  const bool done = mote::updateInputTimeStep(this, time, piece, pieces, ghostLevels, extents);
  this->Update();
  return done && this->Impl->structure ? 1 : 0;
}

//------------------------------------------------------------------------------------------------
// Building

void vtkMoteParticleMapper::Update(int port)
{
  if (!this->Static)
  {
    if (this->GetNumberOfInputConnections(0) < 1)
    {
      this->StopBuild();
      this->Impl->structure = nullptr;
      this->Impl->structureKey.clear();
      return;
    }
    this->UpdateInformation();
    this->Superclass::Update(port);
  }
  this->UpdateStructure();
  this->UpdateRanges();
}

static_assert(
  static_cast<int>(mote::RadiusMode::FromSpacing) == vtkMoteParticleMapper::RADIUS_FROM_SPACING,
  "the modes stand in the same order");

void vtkMoteParticleMapper::UpdateStructure()
{
  Internals& impl = *this->Impl;
  vtkPointSet* input = this->GetInput();
  mote::RadiusChoice& choice = impl.choice;
  choice.mode = static_cast<mote::RadiusMode>(this->RadiusMode);
  choice.radius = this->Radius;
  choice.scale = this->RadiusScale;
  choice.radiusArray = this->RadiusArrayName ? this->RadiusArrayName : "";
  choice.typeArray = this->TypeArrayName ? this->TypeArrayName : "";
  try
  {
    if (!input)
      throw mote::Error("The input is not a data set of points.");
    bool half = false;
    vtkDataArray* radii = mote::findRadiusArray(input, choice, half);
    const mote::StructureChoice structure =
      mote::structureOf(this->StructureName, this->StructureForm);
    mote::InputKey key = {double(structure.kind), structure.form ? double(*structure.form) : -1.0,
      double(this->KeepPointIds)};
    mote::addArray(key, input->GetPoints() ? input->GetPoints()->GetData() : nullptr);
    mote::addChoice(key, choice, radii, half);
    const bool failed = impl.preview && !impl.build;
    if (impl.structure && key == impl.structureKey && (!failed || this->UsesPreview()))
    {
      this->ContinueBuild();
      return;
    }
    this->StopBuild();
    impl.structureKey.clear();
    if (mote::drawsFile(input, choice, structure))
      this->TakeStructure(input);
    else if (this->UsesPreview())
      this->BeginPreview(input);
    else
      this->BuildStructure(input);
    if (impl.structure)
      impl.structureKey = key;
    impl.reported.clear();
  }
  catch (const std::exception& error)
  {
    this->StopBuild();
    impl.structure = nullptr;
    impl.structureKey.clear();
    if (impl.reported != error.what())
      vtkErrorMacro(<< error.what());
    impl.reported = error.what();
  }
}

void vtkMoteParticleMapper::BuildStructure(vtkPointSet* input)
{
  Internals& impl = *this->Impl;
  const auto start = std::chrono::steady_clock::now();
  mote::ParticleStructureOptions options =
    mote::structureOf(this->StructureName, this->StructureForm).options();
  options.pkdTree.keepIndices = this->KeepPointIds;
  options.pkdTree.space = impl.space;
  const mote::BuildEvents events(this);
  const mote::ParticleInput particles =
    mote::makeParticleInput(input, impl.choice, impl.space.get());
  impl.selection.forget();
  mote::buildStructure(impl.structure, particles.set, options,
    [this](double done)
    {
      this->UpdateProgress(done);
      return this->GetAbortExecute() == 0;
    });
  impl.buildTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  impl.commonRadius = particles.commonRadius;
  impl.builtAt.Modified();
  ++impl.builds;
  if (impl.structure)
    this->WarnOfLeftOut(impl.statistics());
}

void vtkMoteParticleMapper::WarnOfLeftOut(const mote::ParticleStatistics& statistics)
{
  const std::string leftOut = mote::leftOutSentence(statistics);
  if (!leftOut.empty())
    vtkWarningMacro(<< "Particles left out: " << leftOut << ".");
}

void vtkMoteParticleMapper::TakeStructure(vtkPointSet* input)
{
  Internals& impl = *this->Impl;
  const auto file = mote::fileOf(input);
  impl.selection.forget();
  // A tree of its own, for ranges of its own.
  impl.structure = std::make_shared<mote::ParticleStructure>(file->tree());
  impl.buildTime = 0.0;
  const mote::ParticleStatistics& s = file->statistics();
  impl.commonRadius = s.smallestRadius == s.largestRadius ? s.largestRadius : 0.0;
  impl.builtAt.Modified();
}

bool vtkMoteParticleMapper::DescribeTo(mote::SurfaceObject& object, vtkActor* actor)
{
  this->Update();
  if (!this->Impl->structure || this->GetNumberOfParticles() == 0)
    return false;
  object.surface = mote::ParticleSurface(this->Impl->structure);
  mote::describeActor(actor, object);
  this->DescribeColors(object.coloring);
  const bool clipped = this->ClippingPlanes && this->ClippingPlanes->GetNumberOfItems() > 0;
  if (clipped && !this->Impl->reportedClipping)
    vtkWarningMacro(
      "Clipping planes do not cut particles; use the visibility range or the camera's "
      "clipping range.");
  this->Impl->reportedClipping = clipped;
  return true;
}

//------------------------------------------------------------------------------------------------

void vtkMoteParticleMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  mote::RendererImage& image = this->Impl->images.of(renderer);
  image.render(this, renderer, {mote::motePropOf(actor)}, mote::FrameSettings{}, {},
    !actor->HasOpaqueGeometry());
  this->TimeToDraw = image.time();
}

void vtkMoteParticleMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->images.release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkMoteParticleMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const modes[] = {
    "Automatic", "Constant", "By array", "By type", "From spacing"};
  const auto text = [](const char* s) { return s ? s : "(none)"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RadiusMode: " << modes[this->RadiusMode] << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "RadiusArrayName: " << text(this->RadiusArrayName) << "\n";
  os << indent << "TypeArrayName: " << text(this->TypeArrayName) << "\n";
  for (const auto& [type, radius] : this->Impl->choice.typeRadii)
    os << indent << "TypeRadius of " << type << ": " << radius << "\n";
  os << indent << "UseVisibilityRange: " << (this->UseVisibilityRange ? "On" : "Off") << "\n";
  os << indent << "VisibilityRange: " << this->VisibilityRange[0] << " " << this->VisibilityRange[1]
     << "\n";
  os << indent << "VisibilityArrayName: " << text(this->VisibilityArrayName) << "\n";
  os << indent << "VisibilityComponent: " << this->VisibilityComponent << "\n";
  this->PrintRanges(os, indent);
  os << indent << "StructureName: " << text(this->StructureName) << "\n";
  os << indent << "StructureForm: " << text(this->StructureForm) << "\n";
  os << indent << "Preview: " << (this->Preview ? "On" : "Off") << "\n";
  os << indent << "PreviewSize: " << this->PreviewSize << "\n";
  os << indent << "IsPreview: " << (this->IsPreview() ? "Yes" : "No") << "\n";
  os << indent << "KeepPointIds: " << (this->KeepPointIds ? "On" : "Off") << "\n";
  os << indent << "NumberOfParticles: " << this->GetNumberOfParticles() << "\n";
  os << indent << "NumberOfUnfitParticles: " << this->GetNumberOfUnfitParticles() << "\n";
  os << indent << "StructureBytes: " << this->GetStructureBytes() << "\n";
}
