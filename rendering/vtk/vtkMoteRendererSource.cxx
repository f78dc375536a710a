#include "vtkMoteRendererSource.h"

#include "FrameTracer.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettes.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <chrono>

vtkStandardNewMacro(vtkMoteRendererSource);
vtkCxxSetSmartPointerMacro(vtkMoteRendererSource, Renderer, vtkRenderer);
vtkCxxSetSmartPointerMacro(vtkMoteRendererSource, Shading, vtkMoteShading);
vtkCxxSetSmartPointerMacro(vtkMoteRendererSource, Silhouettes, vtkMoteSilhouettes);

vtkMoteRendererSource::vtkMoteRendererSource()
  : Shading(vtkSmartPointer<vtkMoteShading>::New())
  , Silhouettes(vtkSmartPointer<vtkMoteSilhouettes>::New())
{
  this->SetNumberOfInputPorts(0);
}

vtkMoteRendererSource::~vtkMoteRendererSource() = default;

vtkRenderer* vtkMoteRendererSource::GetRenderer()
{
  return this->Renderer;
}

vtkMoteShading* vtkMoteRendererSource::GetShading()
{
  return this->Shading;
}

vtkMoteSilhouettes* vtkMoteRendererSource::GetSilhouettes()
{
  return this->Silhouettes;
}

int vtkMoteRendererSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(input), vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  const int extent[6] = {
    0, std::clamp(this->Size[0], 1, 65536) - 1, 0, std::clamp(this->Size[1], 1, 65536) - 1, 0, 0};
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), 1.0, 1.0, 1.0);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 4);
  return 1;
}

namespace
{

template <typename Array>
typename Array::ValueType* addArray(
  vtkImageData* image, const char* name, int components, bool active = false)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  if (active)
    image->GetPointData()->SetScalars(array);
  else
    image->GetPointData()->AddArray(array);
  return array->GetPointer(0);
}

/// Puts the background, even or a vertical gradient, behind premultiplied colours.
void putBackground(vtkRenderer* renderer, int width, int height, float* colors)
{
  double bottom[3], top[3];
  renderer->GetBackground(bottom);
  renderer->GetBackground(top);
  if (renderer->GetGradientBackground())
    renderer->GetBackground2(top);
  for (int y = 0; y < height; ++y)
  {
    const double share = (y + 0.5) / height;
    for (int x = 0; x < width; ++x)
    {
      float* c = colors + 4 * (static_cast<std::size_t>(y) * width + x);
      for (int k = 0; k < 3; ++k)
        c[k] += (1.0f - c[3]) * static_cast<float>(bottom[k] + share * (top[k] - bottom[k]));
      c[3] = 1.0f;
    }
  }
}

void copyIds(const mote::Film& film, vtkImageData* image)
{
  auto* particle = addArray<vtkTypeInt64Array>(image, "particle", 1);
  auto* object = addArray<vtkIntArray>(image, "object", 1);
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    particle[i] = film.id()[i] == mote::Film::noId ? -1 : static_cast<vtkTypeInt64>(film.id()[i]);
    object[i] = film.object()[i];
  }
}

} // namespace

std::vector<std::shared_ptr<mote::MoteProp>> vtkMoteRendererSource::CollectProps()
{
  mote::MoteProps ours;
  this->NumberOfIgnoredProps = 0;
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
  {
    if (!prop->GetVisibility())
      continue;
    if (auto found = mote::motePropOf(prop))
      ours.push_back(std::move(found));
    else
      ++this->NumberOfIgnoredProps;
  }
  if (this->NumberOfIgnoredProps > 0 && !this->WarnedOfIgnoredProps)
    vtkWarningMacro(<< this->NumberOfIgnoredProps
                    << " visible props have no Mote mapper and are not in the image.");
  this->WarnedOfIgnoredProps = this->NumberOfIgnoredProps > 0;
  return ours;
}

bool vtkMoteRendererSource::Trace(mote::FrameTracer& tracer)
{
  mote::MoteProps props = this->CollectProps();
  std::erase_if(props, [](const auto& prop) { return !prop->finish(); });
  if (!this->Renderer->IsActiveCameraCreated())
    this->Renderer->ResetCamera(); // makes one and shows everything, as a window would
  if (this->ResetClippingRange)
    this->Renderer->ResetCameraClippingRange();
  this->Renderer->UpdateLightsGeometryToFollowCamera();
  mote::FrameSettings settings;
  settings.refinement = {this->SamplesPerPixel, this->NoiseLevel};
  settings.channels = (this->Ids ? mote::Film::Id : 0u) |
                      (this->Normals ? mote::Film::Normal : 0u) |
                      (this->Variance ? mote::Film::Variance : 0u);
  settings.threads = this->NumberOfThreads;
  settings.shading = this->Shading;
  settings.silhouettes = this->Silhouettes;
  tracer.trace(this->Renderer, props, this->Size[0], this->Size[1], settings,
    [&](double done)
    {
      this->UpdateProgress(done);
      return this->GetAbortExecute() == 0;
    });
  return tracer.converged() || props.empty();
}

int vtkMoteRendererSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(input), vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(output);
  if (!this->Renderer)
  {
    vtkErrorMacro("There is no renderer to trace.");
    return 0;
  }
  if (this->Size[0] < 1 || this->Size[1] < 1 || this->Size[0] > 65536 || this->Size[1] > 65536)
  {
    vtkErrorMacro("An image of " << this->Size[0] << " by " << this->Size[1]
                                 << " pixels cannot be made: 1 to 65536 are, each way.");
    return 0;
  }
  const auto start = std::chrono::steady_clock::now();
  mote::FrameTracer tracer;
  try
  {
    if (!this->Trace(tracer))
      return 1; // aborted: no image
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  this->TraceTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  this->SilhouetteTime = tracer.silhouetteSeconds();
  this->NumberOfSamples = tracer.samples();
  this->Noise = tracer.noise();

  this->FillImage(tracer, image);
  return 1;
}

void vtkMoteRendererSource::FillImage(const mote::FrameTracer& tracer, vtkImageData* image)
{
  const mote::Film& film = tracer.film();
  image->SetDimensions(film.width(), film.height(), 1);
  float* colors = addArray<vtkFloatArray>(image, "color", 4, true);
  std::copy_n(film.color(), 4 * film.pixels(), colors);
  const mote::SilhouetteLayer lines = tracer.silhouettes();
  lines.drawOver(film.height(), colors);
  const mote::GhostPixels& ghosts = tracer.ghosts();
  for (std::size_t i = 0; i < film.pixels() && !ghosts.empty(); ++i)
    if (ghosts[i])
      std::fill_n(colors + 4 * i, 4, 0.0f);
  if (!this->TransparentBackground)
    putBackground(this->Renderer, film.width(), film.height(), colors);
  if (this->Depth)
    std::copy_n(film.depth(), film.pixels(), addArray<vtkFloatArray>(image, "depth", 1));
  if (this->Normals)
    std::copy_n(film.normal(), 3 * film.pixels(), addArray<vtkFloatArray>(image, "normal", 3));
  if (this->Variance)
  {
    float* variance = addArray<vtkFloatArray>(image, "variance", 1);
    for (std::size_t i = 0; i < film.pixels(); ++i)
      variance[i] = film.variance(i);
  }
  if (this->Ids)
    copyIds(film, image);
  if (this->SilhouetteCoverage)
  {
    float* coverage = addArray<vtkFloatArray>(image, "silhouettes", 1);
    std::fill_n(coverage, film.pixels(), 0.0f);
    lines.forCovered(0, film.height(), [&](std::size_t i, float share) { coverage[i] = share; });
  }
}

vtkMTimeType vtkMoteRendererSource::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Shading)
    time = std::max(time, this->Shading->GetMTime());
  if (this->Silhouettes)
    time = std::max(time, this->Silhouettes->GetMTime());
  if (!this->Renderer)
    return time;
  // The renderer's own time knows its camera, but not what is added, removed or lit by others.
  vtkLightCollection* lights = this->Renderer->GetLights();
  vtkPropCollection* props = this->Renderer->GetViewProps();
  time = std::max({time, this->Renderer->GetMTime(), lights->GetMTime(), props->GetMTime()});
  vtkCollectionSimpleIterator next;
  lights->InitTraversal(next);
  while (vtkLight* light = lights->GetNextLight(next))
    time = std::max(time, light->GetMTime());
  props->InitTraversal(next);
  mote::MoteProps ours;
  while (vtkProp* prop = props->GetNextProp(next))
  {
    time = std::max(time, prop->GetRedrawMTime());
    if (auto found = mote::motePropOf(prop))
      ours.push_back(std::move(found));
  }
  for (const vtkMTimeType part : mote::timesOf(ours))
    time = std::max(time, part);
  return time;
}

void vtkMoteRendererSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](vtkTypeBool on) { return on ? "On" : "Off"; };
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "NoiseLevel: " << this->NoiseLevel << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Depth: " << onOff(this->Depth) << "\n";
  os << indent << "Normals: " << onOff(this->Normals) << "\n";
  os << indent << "Variance: " << onOff(this->Variance) << "\n";
  os << indent << "Ids: " << onOff(this->Ids) << "\n";
  os << indent << "SilhouetteCoverage: " << onOff(this->SilhouetteCoverage) << "\n";
  os << indent << "TransparentBackground: " << onOff(this->TransparentBackground) << "\n";
  os << indent << "ResetClippingRange: " << onOff(this->ResetClippingRange) << "\n";
  os << indent << "NumberOfIgnoredProps: " << this->NumberOfIgnoredProps << "\n";
  os << indent << "Shading: " << this->Shading.Get() << "\n";
  os << indent << "Silhouettes: " << this->Silhouettes.Get() << "\n";
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
}
