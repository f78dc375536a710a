#include "VolumePeers.h"

#include <kernels/core/Error.h>

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkProjectedTetrahedraMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnstructuredGridVolumeRayCastMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <chrono>
#include <cmath>

namespace mote::bench
{

namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

vtkSmartPointer<vtkUnstructuredGridVolumeMapper> makeMapper(
  const std::string& name, const VolumeTask& task)
{
  if (name == "vtk-projected")
    return vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
  if (name != "vtk-raycast")
    throw Error("VTK has no mapper " + name + ".");
  auto mapper = vtkSmartPointer<vtkUnstructuredGridVolumeRayCastMapper>::New();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetImageSampleDistance(1.0f);
  mapper->SetNumberOfThreads(task.threads);
  return mapper;
}

/// VTK's opacity is an extinction: per ScalarOpacityUnitDistance, and at most 1. With that distance
/// a 32nd of the diagonal the greatest extinction of the tasks becomes 0.75.
vtkSmartPointer<vtkVolumeProperty> makeProperty(const VolumeTask& task)
{
  const double unit = glm::length(task.input.mesh->bounds().size()) / 32.0;
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const TransferFunction::Knot& knot : task.transfer.knots)
  {
    const Vec4d c(knot.color);
    colors->AddRGBPoint(knot.value, c.r, c.g, c.b);
    opacities->AddPoint(knot.value, -std::log1p(-c.a) * unit / task.transfer.unitDistance);
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(unit);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

vtkSmartPointer<vtkRenderWindow> makeWindow(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(width, height);
  return window;
}

/// X servers may start anew when their last client leaves, and refuse others meanwhile: one small
/// window stays open.
void keepServer()
{
  static const vtkSmartPointer<vtkRenderWindow> window = makeWindow(8, 8);
  window->Render();
}

void place(vtkCamera* to, const Camera& camera)
{
  const Vec3d focus = camera.position + camera.forward;
  to->SetPosition(camera.position.x, camera.position.y, camera.position.z);
  to->SetFocalPoint(focus.x, focus.y, focus.z);
  to->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
  to->SetViewAngle(camera.viewAngle);
}

} // namespace

struct VolumePeer::Pipeline
{
  int width, height;
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkVolume> volume;
};

const std::vector<Named>& volumePeers()
{
  static const std::vector<Named> all = {
    {"vtk-raycast", "vtkUnstructuredGridVolumeRayCastMapper on tetrahedra"},
    {"vtk-projected", "vtkProjectedTetrahedraMapper on tetrahedra"}};
  return all;
}

Tetrahedra makeTetrahedra(const HexInput& input)
{
  vtkNew<vtkDataSetTriangleFilter> filter;
  filter->SetInputData(input.grid);
  filter->TetrahedraOnlyOn();
  Tetrahedra made;
  progress("dividing the cells into tetrahedra");
  const Clock::time_point begin = Clock::now();
  filter->Update();
  made.seconds = secondsSince(begin);
  made.grid = filter->GetOutput();
  made.megabytes = 1.024e-3 * static_cast<double>(made.grid->GetActualMemorySize());
  return made;
}

VolumePeer::VolumePeer(
  const std::string& name, const VolumeTask& task, const Tetrahedra& tetrahedra)
  : pipeline_(std::make_unique<Pipeline>())
{
  keepServer();
  pipeline_->width = task.width;
  pipeline_->height = task.height;
  pipeline_->window = makeWindow(task.width, task.height);
  const vtkSmartPointer<vtkUnstructuredGridVolumeMapper> mapper = makeMapper(name, task);
  mapper->SetInputData(tetrahedra.grid);
  pipeline_->volume->SetMapper(mapper);
  pipeline_->volume->SetProperty(makeProperty(task));
  vtkRenderer* renderer = pipeline_->renderer;
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->SetBackgroundAlpha(0.0);
  renderer->AddVolume(pipeline_->volume);
  place(renderer->GetActiveCamera(), task.camera);
  if (name ==
      "vtk-raycast") // whose rays go through the pixels' corners: half a pixel is made up for
    renderer->GetActiveCamera()->SetWindowCenter(1.0 / task.width, 1.0 / task.height);
  renderer->ResetCameraClippingRange();
  pipeline_->window->AddRenderer(renderer);
}

VolumePeer::~VolumePeer() = default;

double VolumePeer::draw()
{
  const Clock::time_point begin = Clock::now();
  pipeline_->window->Render();
  pipeline_->window->WaitForCompletion();
  return secondsSince(begin);
}

std::vector<float> VolumePeer::colors() const
{
  vtkNew<vtkFloatArray> pixels;
  pipeline_->window->GetRGBAPixelData(0, 0, pipeline_->width - 1, pipeline_->height - 1, 0, pixels);
  const float* begin = pixels->GetPointer(0);
  return {begin, begin + pixels->GetNumberOfValues()};
}

} // namespace mote::bench
