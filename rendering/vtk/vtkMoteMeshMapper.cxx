#include "vtkMoteMeshMapper.h"

#include "ArrayColors.h"
#include "Bounds.h"
#include "BuildEvents.h"
#include "InputTimeStep.h"
#include "MapperClip.h"
#include "MeshGeometry.h"
#include "News.h"
#include "RendererImage.h"
#include "RotatedCopies.h"
#include "SceneBridge.h"
#include "VisibleCells.h"

#include "kernels/core/Error.h"
#include "kernels/scene/ColorMeans.h"
#include "kernels/scene/Scene.h"
#include "kernels/tracing/Picking.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMoteMeshMapper);

/// What the mapper keeps between frames.
class vtkMoteMeshMapper::Internals : public mote::BuiltMesh
{
public:
  std::shared_ptr<const mote::BuiltMesh> offered; ///< by another mapper
  vtkTimeStamp changedAt;                         ///< when the geometry last did
  vtkTimeStamp builtAt;                           ///< when it did by more than what is hidden
  int builds = 0, refits = 0;

  mote::VisibleCells visible;
  mote::MapperClip clip;
  std::vector<vtkWeakPointer<vtkMoteMeshMapper>> neighbors;

  mote::ArrayColors colors;
  mote::DataArrayView normals; ///< copied once where they are not one piece of memory
  mote::InputKey normalsKey;

  mote::ColorMeans means; ///< of R-LODs
  mote::InputKey meansKey;

  vtkMTimeType failedAt = 0; ///< of the picture that could not be made: not tried again

  // The last of each kind of message, so that it is told once and not every frame.
  std::string reported, reportedColors;

  mote::RendererImages images; ///< for renderers that have no vtkMoteRayCastPass

  /// Takes what is offered where it is of this input, or where there is nothing yet: of an input
  /// with the same content it will do, too.
  void takeOffer(vtkPointSet* input, const mote::SurfaceChoice& choice)
  {
    const auto from = std::exchange(offered, nullptr);
    if (!from || (geometry.whole() && !from->geometry.holds(input, choice)))
      return;
    static_cast<mote::BuiltMesh&>(*this) = *from;
    changedAt.Modified();
    builtAt.Modified();
  }

  const mote::ArrayView& viewOf(vtkDataArray* array)
  {
    mote::InputKey key;
    mote::addArray(key, array);
    if (key != normalsKey)
    {
      normals = mote::DataArrayView(array);
      normalsKey = std::move(key);
    }
    return normals.view;
  }
};

vtkMoteMeshMapper::vtkMoteMeshMapper()
  : Impl(std::make_unique<Internals>())
{
}

vtkMoteMeshMapper::~vtkMoteMeshMapper() = default;

int vtkMoteMeshMapper::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMoteMeshMapper::SetInputData(vtkPointSet* input)
{
  this->SetInputDataInternal(0, input);
}

vtkPointSet* vtkMoteMeshMapper::GetInput()
{
  if (this->GetNumberOfInputConnections(0) < 1)
    return nullptr;
  return vtkPointSet::SafeDownCast(this->GetExecutive()->GetInputData(0, 0));
}

void vtkMoteMeshMapper::SetVisibleCells(vtkUnsignedCharArray* isVisible)
{
  if (this->Impl->visible.set(isVisible))
    this->Modified();
}

vtkUnsignedCharArray* vtkMoteMeshMapper::GetVisibleCells()
{
  return this->Impl->visible.get();
}

void vtkMoteMeshMapper::SetClipCylinder(vtkMoteClipCylinder* cylinder)
{
  if (this->Impl->clip.set(cylinder))
    this->Modified();
}

vtkMoteClipCylinder* vtkMoteMeshMapper::GetClipCylinder()
{
  return this->Impl->clip.cylinder();
}

vtkUnsignedCharArray* vtkMoteMeshMapper::GetGhosts()
{
  auto* surface = vtkPolyData::SafeDownCast(this->MeetsGhosts ? this->GetInput() : nullptr);
  vtkUnsignedCharArray* marks = surface ? surface->GetCellGhostArray() : nullptr;
  return marks && marks->GetNumberOfValues() == surface->GetNumberOfCells() ? marks : nullptr;
}

double* vtkMoteMeshMapper::GetBounds()
{
  if (!this->Static)
    this->Update();
  const auto& tree = this->Impl->geometry.tree();
  mote::copyBounds(mote::withRotatedCopies(tree ? tree->bounds() : mote::Box(), this->Repetitions,
                     this->RepetitionCenter, this->RepetitionAxis),
    this->Bounds);
  return this->Bounds;
}

vtkIdType vtkMoteMeshMapper::GetNumberOfTriangles()
{
  const auto& tree = this->Impl->geometry.tree();
  return tree ? static_cast<vtkIdType>(tree->size()) : 0;
}

vtkIdType vtkMoteMeshMapper::GetNumberOfCellsLeftOut()
{
  const mote::MeshGeometry& geometry = this->Impl->geometry;
  return geometry.linesAndVertices() + geometry.cellsWithoutTriangles();
}

vtkIdType vtkMoteMeshMapper::GetNumberOfUnfitTriangles()
{
  return this->Impl->geometry.invalidTriangles();
}

std::string vtkMoteMeshMapper::GetReport()
{
  return this->Impl->geometry.report();
}

vtkTypeInt64 vtkMoteMeshMapper::GetStructureBytes()
{
  const mote::MeshGeometry& geometry = this->Impl->geometry;
  return static_cast<vtkTypeInt64>(geometry.bytes() + geometry.bytesOfPart());
}

std::vector<std::pair<const void*, std::size_t>> vtkMoteMeshMapper::GetMemory()
{
  const mote::MeshGeometry& geometry = this->Impl->geometry;
  if (!geometry.whole())
    return {};
  std::vector<std::pair<const void*, std::size_t>> memory = {
    {geometry.whole().get(), geometry.bytes()}};
  if (geometry.tree() != geometry.whole())
    memory.emplace_back(geometry.tree().get(), geometry.bytesOfPart());
  return memory;
}

double vtkMoteMeshMapper::GetBuildTime()
{
  return this->Impl->buildTime;
}

int vtkMoteMeshMapper::GetNumberOfBuilds()
{
  return this->Impl->builds;
}

int vtkMoteMeshMapper::GetNumberOfRefits()
{
  return this->Impl->refits;
}

vtkDataArray* vtkMoteMeshMapper::GetColorArray()
{
  bool ofCells = false;
  return mote::ArrayColors::arrayOf(this, this->GetInput(), &ofCells);
}

bool vtkMoteMeshMapper::IsColoredByCells()
{
  bool ofCells = false;
  return mote::ArrayColors::arrayOf(this, this->GetInput(), &ofCells) && ofCells;
}

void vtkMoteMeshMapper::GetColorArrayRange(double range[2])
{
  range[0] = 1.0;
  range[1] = 0.0;
  if (vtkDataArray* array = this->GetColorArray())
    array->GetFiniteRange(range, mote::ArrayColors::componentOf(this, array));
}

double vtkMoteMeshMapper::ValueOf(const mote::ScenePick& pick)
{
  vtkDataArray* array = this->GetColorArray();
  double value = array ? 0.0 : vtkMath::Nan();
  const auto valueOf = [&](vtkIdType tuple)
  {
    double sum = 0.0;
    for (int k = 0; k < 3 && pick.along != mote::Vec3d(0.0); ++k)
      sum += pick.along[k] * array->GetComponent(tuple, k);
    return pick.along == mote::Vec3d(0.0) ? mote::ArrayColors::valueOf(this, array, tuple) : sum;
  };
  for (const auto& [index, share] : pick.colorShares)
    if (array && share > 0.0)
      value += share * valueOf(static_cast<vtkIdType>(index));
  return value;
}

void vtkMoteMeshMapper::TurnColors(mote::SurfaceObject& placed)
{
  vtkDataArray* array = this->TurnVectors ? this->GetColorArray() : nullptr;
  mote::SurfaceColoring& coloring = placed.coloring;
  coloring.along = mote::Vec3d(0.0);
  if (array && array->GetNumberOfComponents() == 3)
    coloring.along =
      mote::componentAlong(placed.toWorld, mote::ArrayColors::componentOf(this, array));
  if (coloring.along != mote::Vec3d(0.0))
    coloring.means = {}; // which are of the component
}

vtkMTimeType vtkMoteMeshMapper::GetPictureMTime()
{
  vtkMTimeType time = std::max({this->GetMTime(), this->Impl->changedAt.GetMTime(),
    this->Impl->visible.time(), this->Impl->clip.time(this)});
  if (vtkPointSet* input = this->GetInput())
    time = std::max(time, input->GetMTime());
  for (vtkMoteMeshMapper* other : this->Impl->neighbors)
    if (vtkPointSet* input = other ? other->GetInput() : nullptr)
      time = std::max({time, input->GetMTime(), other->Impl->visible.time()});
  return time;
}

void vtkMoteMeshMapper::AddNeighbor(vtkMoteMeshMapper* other)
{
  const auto& all = this->Impl->neighbors;
  if (!other || other == this || std::find(all.begin(), all.end(), other) != all.end())
    return;
  this->Impl->neighbors.emplace_back(other);
  this->Modified();
}

void vtkMoteMeshMapper::RemoveAllNeighbors()
{
  if (this->Impl->neighbors.empty())
    return;
  this->Impl->neighbors.clear();
  this->Modified();
}

int vtkMoteMeshMapper::GetNumberOfNeighbors()
{
  return static_cast<int>(this->Impl->neighbors.size());
}

int vtkMoteMeshMapper::UpdateTimeStep(
  double time, int piece, int pieces, int ghostLevels, const int extents[6])
{
  const bool done = mote::updateInputTimeStep(this, time, piece, pieces, ghostLevels, extents);
  this->Update();
  return done && this->Impl->geometry.whole() ? 1 : 0;
}

//------------------------------------------------------------------------------------------------
// Building

void vtkMoteMeshMapper::Update(int vtkNotUsed(port))
{
  if (this->GetNumberOfInputConnections(0) < 1)
    return this->Impl->geometry.forget();
  if (!this->Static)
  {
    // The executive's own way would tell of an execution, with its events, where nothing is built.
    int output = 0;
    this->GetInputAlgorithm(0, 0, output)->Update(output);
  }
  this->UpdateMesh();
}

void vtkMoteMeshMapper::UpdateMesh()
{
  Internals& impl = *this->Impl;
  if (impl.failedAt != 0 && impl.failedAt == this->GetPictureMTime())
    return;
  std::string problem;
  try
  {
    if (vtkPointSet* input = this->GetInput())
      this->UpdateGeometry(input);
    else
      throw mote::Error("The input is not a vtkPointSet.");
  }
  catch (const std::exception& error)
  {
    impl.geometry.forget();
    problem = error.what();
  }
  impl.failedAt = problem.empty() ? 0 : this->GetPictureMTime();
  if (mote::isNews(problem, impl.reported))
    vtkErrorMacro(<< problem);
}

void vtkMoteMeshMapper::UpdateGeometry(vtkPointSet* input)
{
  using Change = mote::MeshGeometry::Change;
  Internals& impl = *this->Impl;
  mote::SurfaceChoice choice = {impl.visible.get(), impl.visible.key(input->GetNumberOfCells()),
    {this->Repetitions, glm::make_vec3(this->RepetitionCenter),
      glm::make_vec3(this->RepetitionAxis)},
    this->MeetsGhosts, this->TwoSidedSheets, {}};
  for (vtkMoteMeshMapper* other : impl.neighbors)
    if (vtkPointSet* data = other ? other->GetInput() : nullptr; data && data != input)
      choice.neighbors.push_back(
        {data, other->Impl->visible.get(), other->Impl->visible.key(data->GetNumberOfCells())});
  impl.takeOffer(input, choice);
  if (impl.geometry.fits(input, choice))
    return;
  const auto start = std::chrono::steady_clock::now();
  const mote::BuildEvents events(this);
  const auto goesOn = [&](double done)
  {
    this->UpdateProgress(done);
    return this->GetAbortExecute() == 0;
  };
  impl.changedAt.Modified();
  if (!goesOn(0.0))
    return impl.geometry.forget();
  const Change change = impl.geometry.update(input, choice, goesOn);
  if (change == Change::None || change == Change::Hidden)
    return;
  impl.builtAt.Modified();
  impl.buildTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  (change == Change::Built ? impl.builds : impl.refits) += 1;
  const std::string report = this->GetReport();
  if (change == Change::Built && !report.empty())
    vtkWarningMacro(<< report);
}

std::shared_ptr<const mote::BuiltMesh> vtkMoteMeshMapper::GetBuilt()
{
  if (!this->Impl->geometry.whole())
    return nullptr;
  return std::make_shared<mote::BuiltMesh>(*this->Impl);
}

void vtkMoteMeshMapper::OfferBuilt(std::shared_ptr<const mote::BuiltMesh> built)
{
  this->Impl->offered = std::move(built);
}

//------------------------------------------------------------------------------------------------
// Drawing

bool vtkMoteMeshMapper::DescribeTo(mote::SurfaceObject& object, vtkActor* actor)
{
  Internals& impl = *this->Impl;
  this->Update();
  if (!impl.geometry.tree() || impl.geometry.tree()->size() == 0)
    return false;
  vtkPointSet* input = this->GetInput();
  mote::describeActor(actor, object);
  bool ofCells = false;
  const std::string problem = impl.colors.describe(this, input, object.coloring, &ofCells);
  if (mote::isNews(problem, impl.reportedColors))
    vtkErrorMacro(<< problem);

  mote::MeshLook look;
  look.corners = impl.geometry.corners();
  look.cells = impl.geometry.cells();
  look.edges = impl.geometry.edges();
  look.mixesColors = !ofCells;
  vtkDataArray* normals = input->GetPointData()->GetNormals();
  if (normals && normals->GetNumberOfTuples() == input->GetNumberOfPoints() &&
      actor->GetProperty()->GetInterpolation() != VTK_FLAT)
    look.normals = impl.viewOf(normals);
  // What is wholly transparent from outside is not met at all: that is faster, and walls without
  // thickness are met from the side that is seen.
  if (object.backOpacity && object.material.opacity == 0.0f)
  {
    look.isInner = true;
    object.material.opacity = *object.backOpacity;
    object.backOpacity.reset();
  }
  this->AllowError(object, look, ofCells);
  object.surface =
    mote::MeshSurface(look.isInner ? impl.geometry.innerTree() : impl.geometry.tree(), look);
  object.castsShadows = this->CastsShadows;
  object.clip = impl.clip.region(this, *input, object.toWorld);
  return true;
}

/// Makes R-LODs and their colours, where an error is allowed and they were not made before.
void vtkMoteMeshMapper::AllowError(mote::SurfaceObject& object, mote::MeshLook& look, bool ofCells)
{
  if (!(this->PixelsOfError > 0.0) || object.mayBeTransparent() || look.isInner)
    return;
  Internals& impl = *this->Impl;
  look.poe = this->PixelsOfError;
  impl.geometry.makeLods();
  mote::SurfaceColoring& coloring = object.coloring;
  const mote::ArrayView& array = coloring.direct.empty() ? coloring.values : coloring.direct;
  if (array.empty())
    return;
  mote::InputKey key = {double(impl.builtAt.GetMTime()), double(ofCells),
    double(coloring.component), double(coloring.direct.empty())};
  mote::addArray(key, this->GetColorArray());
  if (!coloring.direct.empty())
    key.push_back(double(this->GetLookupTable()->GetMTime()));
  if (key != impl.meansKey)
  {
    impl.means = mote::meansOf(*impl.geometry.whole(), look, coloring);
    impl.meansKey = std::move(key);
  }
  coloring.means = impl.means.view();
}

void vtkMoteMeshMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  mote::RendererImage& image = this->Impl->images.of(renderer);
  image.render(this, renderer, {mote::motePropOf(actor)},
    mote::FrameSettings{mote::Refinement{this->SamplesPerPixel}}, {}, !actor->HasOpaqueGeometry());
  this->TimeToDraw = image.time();
}

void vtkMoteMeshMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->images.release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkMoteMeshMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Neighbors: " << this->Impl->neighbors.size() << "\n";
  os << indent << "Repetitions: " << this->Repetitions << "\n";
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "CastsShadows: " << (this->CastsShadows ? "On" : "Off") << "\n";
  os << indent << "PixelsOfError: " << this->PixelsOfError << "\n";
  os << indent << "TwoSidedSheets: " << (this->TwoSidedSheets ? "On" : "Off") << "\n";
  os << indent << "MeetsGhosts: " << (this->MeetsGhosts ? "On" : "Off") << "\n";
  os << indent << "NumberOfTriangles: " << this->GetNumberOfTriangles() << "\n";
  os << indent << "NumberOfCellsLeftOut: " << this->GetNumberOfCellsLeftOut() << "\n";
  os << indent << "NumberOfUnfitTriangles: " << this->GetNumberOfUnfitTriangles() << "\n";
  os << indent << "NumberOfBuilds: " << this->GetNumberOfBuilds() << "\n";
  os << indent << "NumberOfRefits: " << this->GetNumberOfRefits() << "\n";
  os << indent << "StructureBytes: " << this->GetStructureBytes() << "\n";
}
