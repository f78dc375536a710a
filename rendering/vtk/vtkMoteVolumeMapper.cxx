#include "vtkMoteVolumeMapper.h"

#include "BuildEvents.h"
#include "InputTimeStep.h"
#include "Names.h"
#include "RendererImage.h"
#include "RotatedCopies.h"
#include "SceneBridge.h"
#include "TransferBridge.h"
#include "VolumeMapperInternals.h"

#include "kernels/core/Error.h"
#include "kernels/scene/Scene.h"

#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <utility>

vtkStandardNewMacro(vtkMoteVolumeMapper);

vtkMoteVolumeMapper::vtkMoteVolumeMapper()
  : Impl(std::make_unique<Internals>())
{
  this->SetStructureName(GetStructureNames().back().c_str());
  this->SetIntegratorName(GetIntegratorNames().back().c_str());
}

vtkMoteVolumeMapper::~vtkMoteVolumeMapper()
{
  this->SetStructureName(nullptr);
  this->SetIntegratorName(nullptr);
}

int vtkMoteVolumeMapper::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGridBase");
  return 1;
}

vtkMTimeType vtkMoteVolumeMapper::GetPictureMTime()
{
  vtkMTimeType time = std::max({this->GetMTime(), this->Impl->changedAt.GetMTime(),
    this->Impl->visible.time(), this->Impl->clip.time(this), this->Impl->slices.time()});
  if (this->GetNumberOfInputConnections(0) > 0)
    if (vtkDataObject* input = this->GetExecutive()->GetInputData(0, 0))
      time = std::max(time, input->GetMTime());
  return time;
}

int vtkMoteVolumeMapper::UpdateTimeStep(
  double time, int piece, int pieces, int ghostLevels, const int extents[6])
{
  const bool done = mote::updateInputTimeStep(this, time, piece, pieces, ghostLevels, extents);
  this->Update();
  return done && this->Impl->field ? 1 : 0;
}

//------------------------------------------------------------------------------------------------
// Building

void vtkMoteVolumeMapper::Update(int vtkNotUsed(port))
{
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->Impl->geometry.forget();
    this->Impl->forgetField();
    return;
  }
  // The executive's own way would tell of an execution, with its events, where nothing is built.
  int output = 0;
  this->GetInputAlgorithm(0, 0, output)->Update(output);
  this->UpdateVolume();
}

void vtkMoteVolumeMapper::UpdateVolume()
{
  Internals& impl = *this->Impl;
  if (impl.failedAt != 0 && impl.failedAt == this->GetPictureMTime())
    return;
  std::string problem;
  try
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(this->GetExecutive()->GetInputData(0, 0));
    if (!grid)
      throw mote::Error("The input is not a vtkUnstructuredGrid.");
    if (this->UpdateGeometry(grid))
    {
      this->UpdateField(grid);
      this->UpdateFollowed(grid);
    }
    else
      impl.forgetField();
  }
  catch (const std::exception& error)
  {
    impl.forgetField();
    problem = error.what();
  }
  impl.failedAt = problem.empty() ? 0 : this->GetPictureMTime();
  if (!problem.empty() && impl.reported != problem)
    vtkErrorMacro(<< problem);
  impl.reported = problem;
}

bool vtkMoteVolumeMapper::UpdateGeometry(vtkUnstructuredGrid* grid)
{
  Internals& impl = *this->Impl;
  const mote::HexStructureOptions options =
    this->StructureOptions(); // says what is wrong with them
  const mote::HexStructureOptions* needed = this->NeedsStructure() ? &options : nullptr;
  const auto start = std::chrono::steady_clock::now();
  impl.takeOffer(grid, needed);
  if (Internals::fits(impl.geometry, grid, needed))
    return true;
  const mote::BuildEvents events(this);
  const auto stopped = [&](double done)
  {
    this->UpdateProgress(done);
    if (this->GetAbortExecute())
    {
      impl.geometry.forget();
      impl.forgetField();
    }
    return this->GetAbortExecute() != 0;
  };
  impl.changedAt.Modified();
  if (stopped(0.0))
    return false;
  if (!impl.geometry.hasCellsOf(grid))
  {
    impl.forgetField();
    impl.geometry.takeCells(grid);
    const std::string report = this->GetReport();
    if (!report.empty())
      vtkWarningMacro(<< report);
  }
  if (stopped(0.3))
    return false;
  impl.forgetFollowed();
  if (needed)
    impl.geometry.build(options);
  else
    impl.geometry.findNeighbours();
  if (needed && impl.field)
    impl.geometry.setRanges(*impl.field);
  impl.buildTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ++impl.builds;
  return !stopped(1.0);
}

/// Which component is drawn of the array.
int vtkMoteVolumeMapper::ChosenComponent(vtkDataArray* array)
{
  if (array->GetNumberOfComponents() == 1)
    return 0; // of one number there is nothing to choose
  return this->VectorMode == COMPONENT ? this->VectorComponent : mote::ArrayView::magnitude;
}

/// What rays need of a copy that is placed so: what was built, but for components of vectors that
/// turn.
mote::BuiltVolume& vtkMoteVolumeMapper::UpdateTurned(const mote::CloudObject& placed)
{
  Internals& impl = *this->Impl;
  mote::HexScalar scalar;
  vtkDataArray* array = nullptr;
  if (this->TurnVectors)
    array = this->FindArray(
      vtkUnstructuredGrid::SafeDownCast(this->GetExecutive()->GetInputData(0, 0)), scalar.ofCells);
  if (array && array->GetNumberOfComponents() == 3)
    scalar.along = mote::componentAlong(placed.toWorld, this->ChosenComponent(array));
  if (scalar.along == mote::Vec3d(0.0))
    return impl;
  Internals::Turned& turned = impl.turnedAlong(scalar.along);
  if (turned.isOf(impl))
    return turned;
  const mote::DataArrayView values(array);
  scalar.values = values.view;
  turned.take(impl, std::make_shared<mote::HexField>(*impl.geometry.mesh(), scalar));
  return turned;
}

void vtkMoteVolumeMapper::UpdateField(vtkUnstructuredGrid* grid)
{
  Internals& impl = *this->Impl;
  mote::HexScalar scalar;
  vtkDataArray* array = this->FindArray(grid, scalar.ofCells);
  scalar.component = this->ChosenComponent(array);
  mote::InputKey key = {double(scalar.component), double(scalar.ofCells)};
  mote::addArray(key, array);
  if (impl.field && key == impl.fieldKey)
    return;
  const mote::DataArrayView values(array);
  scalar.values = values.view;
  impl.field = std::make_shared<mote::HexField>(*impl.geometry.mesh(), scalar);
  impl.walk = nullptr;
  if (!this->NeedsStructure())
    impl.geometry.forgetStructure();
  impl.geometry.setRanges(*impl.field);
  impl.fieldKey = std::move(key);
  impl.changedAt.Modified();
  ++impl.fieldUpdates;
}

/// The array that isosurfaces follow, and which scalar of it, in place of the one that colours.
/// Null where this one does as it is: where it has values of points.
vtkDataArray* vtkMoteVolumeMapper::FindFollowed(vtkUnstructuredGrid* grid, mote::HexScalar& scalar)
{
  if (!this->ShowIsoSurfaces)
    return nullptr;
  if (this->IsoArrayName.empty())
  {
    vtkDataArray* own = this->FindArray(grid, scalar.ofCells);
    scalar.component = this->ChosenComponent(own);
    return scalar.ofCells ? own : nullptr;
  }
  vtkDataSetAttributes* arrays = this->IsoArrayOfCells
                                   ? static_cast<vtkDataSetAttributes*>(grid->GetCellData())
                                   : grid->GetPointData();
  vtkDataArray* array = arrays->GetArray(this->IsoArrayName.c_str());
  if (!array)
    throw mote::Error("The input has no array '" + this->IsoArrayName + "' of " +
                      (this->IsoArrayOfCells ? "cells" : "points") + " for isosurfaces.");
  scalar.ofCells = this->IsoArrayOfCells;
  scalar.component = array->GetNumberOfComponents() == 1 ? 0
                     : this->IsoArrayComponent < 0       ? mote::ArrayView::magnitude
                                                         : this->IsoArrayComponent;
  return array;
}

void vtkMoteVolumeMapper::UpdateFollowed(vtkUnstructuredGrid* grid)
{
  Internals& impl = *this->Impl;
  mote::HexScalar scalar;
  vtkDataArray* array = this->FindFollowed(grid, scalar);
  if (!array)
    return impl.forgetFollowed();
  const bool isOwn = this->IsoArrayName.empty();
  mote::InputKey key = {double(scalar.component), double(scalar.ofCells), double(isOwn)};
  mote::addArray(key, array);
  if (impl.followed.field && key == impl.followedKey)
    return;
  const mote::DataArrayView values(array);
  scalar.values = values.view;
  const mote::HexMesh& mesh = *impl.geometry.mesh();
  impl.followed.field = isOwn ? impl.field : std::make_shared<mote::HexField>(mesh, scalar);
  if (scalar.ofCells)
    impl.followed.field = std::make_shared<mote::HexField>(
      mote::HexField::atPoints(mesh, *impl.followed.field, impl.geometry.hangingPoints()));
  impl.followed.isOwn = isOwn;
  const auto structure = std::make_shared<mote::HexStructure>(*impl.geometry.structure());
  mote::setRanges(*structure, *impl.followed.field);
  impl.followed.structure = structure;
  impl.followedKey = std::move(key);
  impl.changedAt.Modified();
}

void vtkMoteVolumeMapper::UpdateWalk()
{
  Internals& impl = *this->Impl;
  if (!impl.walk)
    impl.walk = impl.geometry.makeWalk(*impl.field);
}

std::shared_ptr<const mote::BuiltVolume> vtkMoteVolumeMapper::GetBuilt(bool forPicture)
{
  Internals& impl = *this->Impl;
  if (!impl.field)
    return nullptr;
  if (forPicture && this->ShowCloud && this->Walks())
    this->UpdateWalk();
  return std::make_shared<mote::BuiltVolume>(impl);
}

void vtkMoteVolumeMapper::OfferBuilt(std::shared_ptr<const mote::BuiltVolume> built)
{
  this->Impl->offered = std::move(built);
}

//------------------------------------------------------------------------------------------------
// Drawing

namespace
{

/// What is seen of a volume beside its cloud.
struct SurfacesShown
{
  std::vector<double> isoValues;
  mote::OtherField followed;
  const mote::MapperSlices& slices;
  mote::EdgeLook edges;
  bool castsShadows;

  /// Adds it, of a cloud whose data are drawn turned.
  void addTo(mote::Scene& scene, const mote::CloudObject& cloud, const mote::Mat4d& turn) const
  {
    const auto add = [&](mote::SurfaceObject surface)
    {
      surface.castsShadows = castsShadows;
      scene.surfaces.push_back(std::move(surface));
    };
    if (!isoValues.empty())
      add(mote::isoSurfacesOf(cloud, isoValues, followed));
    if (slices.count() > 0)
      add(mote::slicesOf(cloud, slices.shapes(turn), edges, slices.ranges()));
  }
};

} // namespace

bool vtkMoteVolumeMapper::DescribeTo(mote::Scene& scene, vtkVolume* volume, int id)
{
  Internals& impl = *this->Impl;
  this->Update();
  if (!impl.field)
    return false;
  vtkVolumeProperty* property = volume->GetProperty();
  vtkContourValues* surfaces = property->GetIsoSurfaceValues();
  const int values = this->ShowIsoSurfaces ? surfaces->GetNumberOfContours() : 0;
  std::string problem;
  try
  {
    mote::CloudObject cloud;
    this->DescribeLook(cloud, property);
    cloud.hidden = impl.hidden.of(impl.geometry.mesh(), impl.visible);
    cloud.id = id;
    cloud.revision = this->GetPictureMTime();
    cloud.toWorld = mote::placementOf(volume);
    cloud.clip = impl.clip.region(this, *this->GetInput(), cloud.toWorld);
    const double* c = this->EdgeColor;
    const SurfacesShown shown = {{surfaces->GetValues(), surfaces->GetValues() + values},
      impl.followed, impl.slices, {this->EdgeWidth, mote::Vec4f(c[0], c[1], c[2], 1.0)},
      this->CastsShadows};
    const mote::Mat4d placed = cloud.toWorld;
    for (const mote::Mat4d& turn :
      mote::rotatedCopies(this->Repetitions, this->RepetitionCenter, this->RepetitionAxis))
    {
      cloud.toWorld = placed * turn;
      mote::BuiltVolume& seen = this->UpdateTurned(cloud);
      cloud.structure = seen.geometry.structure();
      cloud.field = seen.field;
      if (this->ShowCloud && mote::walkServes(cloud.sampling))
      {
        if (!seen.walk)
          seen.walk = seen.geometry.makeWalk(*seen.field);
        cloud.walk = seen.walk;
      }
      shown.addTo(scene, cloud, turn);
      if (this->ShowCloud)
        scene.clouds.push_back(cloud);
    }
    impl.dropTurned();
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  if (!problem.empty() && problem != impl.reportedLook)
    vtkErrorMacro(<< problem);
  impl.reportedLook = problem;
  return problem.empty() && (values > 0 || impl.slices.count() > 0 || this->ShowCloud);
}

void vtkMoteVolumeMapper::DescribeLook(mote::CloudObject& cloud, vtkVolumeProperty* property)
{
  Internals& impl = *this->Impl;
  if (this->BlendMode != COMPOSITE_BLEND)
    throw mote::Error("Volumes are drawn in the composite blend mode only.");
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
    throw mote::Error("Volumes are drawn with one-dimensional transfer functions only.");
  this->WarnOfUnused(property);
  cloud.transfer = impl.colors.describe(property);
  const auto real = [](double v) { return static_cast<float>(v); };
  cloud.transfer.nan = {real(this->NanColor[0]), real(this->NanColor[1]), real(this->NanColor[2]),
    real(this->NanOpacity)};
  cloud.sampling.integrator = static_cast<mote::VolumeIntegrator>(
    mote::findName(GetIntegratorNames(), this->IntegratorName, "integrator"));
  cloud.sampling.step = this->SampleDistance;
  cloud.sampling.tolerance = this->Tolerance;
  cloud.sampling.saturation = this->Saturation;
  cloud.shade = property->GetShade() != 0;
  cloud.material = mote::materialOf(property);
}

void vtkMoteVolumeMapper::WarnOfUnused(vtkVolumeProperty* property)
{
  const std::string unused = mote::unusedOf(property);
  if (!unused.empty() && unused != this->Impl->reportedUnused)
    vtkWarningMacro(<< unused);
  this->Impl->reportedUnused = unused;
}

void vtkMoteVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  mote::RendererImage& image = this->Impl->images.of(renderer);
  this->Impl->shading->SetCloudTolerance(this->CloudTolerance);
  mote::FrameSettings settings{mote::Refinement{this->SamplesPerPixel}};
  settings.shading = this->Impl->shading;
  image.render(this, renderer, {mote::motePropOf(volume)}, settings);
  this->TimeToDraw = image.time();
}

void vtkMoteVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->images.release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
