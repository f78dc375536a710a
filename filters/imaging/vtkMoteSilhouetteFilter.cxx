#include "vtkMoteSilhouetteFilter.h"

#include "SilhouetteInput.h"
#include "vtkMoteSilhouettes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <limits>
#include <vector>

/// What the threads share.
struct vtkMoteSilhouetteFilter::Run
{
  mote::imaging::SilhouetteInput input;
  mote::SilhouetteOptions options;
  bool enabled = false;
  mote::imaging::LineColors overlay;
};

vtkStandardNewMacro(vtkMoteSilhouetteFilter);

vtkCxxSetSmartPointerMacro(vtkMoteSilhouetteFilter, Silhouettes, vtkMoteSilhouettes);

vtkMoteSilhouetteFilter::vtkMoteSilhouetteFilter()
  : Silhouettes(vtkSmartPointer<vtkMoteSilhouettes>::New())
{
  this->Silhouettes->EnabledOn();
  this->Silhouettes->SetThresholdModeToSceneSize();
  this->Silhouettes->SetThreshold(0.01);
}

vtkMoteSilhouetteFilter::~vtkMoteSilhouetteFilter() = default;

vtkMoteSilhouettes* vtkMoteSilhouetteFilter::GetSilhouettes()
{
  return this->Silhouettes;
}

vtkMTimeType vtkMoteSilhouetteFilter::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Silhouettes ? std::max(time, this->Silhouettes->GetMTime()) : time;
}

int vtkMoteSilhouetteFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* in = inputVector[0]->GetInformationObject(0);
  vtkInformation* out = outputVector->GetInformationObject(0);
  int extent[6];
  double spacing[3] = {1.0, 1.0, 1.0}, origin[3] = {0.0, 0.0, 0.0};
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  if (in->Has(vtkDataObject::SPACING()))
    in->Get(vtkDataObject::SPACING(), spacing);
  if (in->Has(vtkDataObject::ORIGIN()))
    in->Get(vtkDataObject::ORIGIN(), origin);
  const int factor = this->ReductionFactor;
  for (int axis = 0; axis < 2; ++axis)
  {
    // A pixel of the output lies in the middle of those that it stands for.
    const int first = extent[2 * axis];
    origin[axis] += spacing[axis] * (first * (1 - factor) + 0.5 * (factor - 1));
    spacing[axis] *= factor;
    extent[2 * axis + 1] = first - 1 + mote::reducedSize(extent[2 * axis + 1] - first + 1, factor);
  }
  out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  out->Set(vtkDataObject::SPACING(), spacing, 3);
  out->Set(vtkDataObject::ORIGIN(), origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(out, VTK_FLOAT, this->OutputMode == OVERLAY ? 4 : 1);
  return 1;
}

int vtkMoteSilhouetteFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* in = inputVector[0]->GetInformationObject(0);
  int whole[6], extent[6];
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  outputVector->GetInformationObject(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  // The scene's size is found in the whole image.
  const bool enabled = this->Silhouettes && this->Silhouettes->GetEnabled();
  const bool needsAll = enabled && this->SceneSize <= 0.0 &&
                        this->Silhouettes->GetThresholdMode() == vtkMoteSilhouettes::SCENE_SIZE;
  mote::SilhouetteOptions options;
  if (enabled)
    options = this->Silhouettes->MakeOptions(0.0);
  options.reduction = this->ReductionFactor;
  const int factor = this->ReductionFactor, margin = mote::silhouetteMargin(options);
  for (int axis = 0; axis < 2; ++axis)
  {
    int* range = extent + 2 * axis;
    const int first = whole[2 * axis], last = whole[2 * axis + 1];
    range[0] = needsAll ? first : std::max(first, first + (range[0] - first - margin) * factor);
    range[1] =
      needsAll ? last : std::min(last, first - 1 + (range[1] - first + margin + 1) * factor);
  }
  in->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

void vtkMoteSilhouetteFilter::CopyAttributeData(
  vtkImageData* vtkNotUsed(input), vtkImageData* vtkNotUsed(output), vtkInformationVector**)
{
  // The output has silhouettes alone.
}

int vtkMoteSilhouetteFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ErrorMessage.clear();
  this->Step = 0.0;
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  auto run = std::make_unique<Run>();
  try
  {
    this->Describe(*run, image, inputVector[0]->GetInformationObject(0));
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = error.what();
    vtkErrorMacro(<< this->ErrorMessage);
    output->Initialize();
    return 0;
  }
  this->Present = std::move(run);
  const int success = this->Superclass::RequestData(request, inputVector, outputVector);
  this->Present.reset();
  if (vtkDataArray* scalars = output->GetPointData()->GetScalars())
    scalars->SetName(this->OutputMode == OVERLAY ? "color" : "silhouettes");
  return success;
}

void vtkMoteSilhouetteFilter::Describe(Run& run, vtkImageData* image, vtkInformation* information)
{
  mote::imaging::SilhouetteInput& input = run.input;
  int whole[6];
  information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  input.setExtents(whole, image->GetExtent(), this->ReductionFactor);
  input.takeDepths(mote::imaging::findDepths(image, this->DepthArrayName));
  input.background = this->BackgroundDepth < VTK_FLOAT_MAX
                       ? static_cast<float>(this->BackgroundDepth)
                       : std::numeric_limits<float>::infinity();
  input.setView(this->DepthMode != ORTHOGRAPHIC, this->ViewAngle, 2.0 * this->ParallelScale,
    this->DepthMode == ALONG_RAYS);
  vtkMoteSilhouettes* silhouettes = this->Silhouettes;
  run.enabled = silhouettes && silhouettes->GetEnabled();
  if (run.enabled)
  {
    const std::string groups = silhouettes->GetGroupArrayName();
    if (!groups.empty())
      input.takeGroups(mote::imaging::findNumbers(image, groups));
    const int mode = silhouettes->GetThresholdMode();
    const double unit = mode == vtkMoteSilhouettes::WORLD   ? 1.0
                        : mode == vtkMoteSilhouettes::RADII ? this->ParticleRadius
                        : this->SceneSize > 0.0             ? this->SceneSize
                                                            : input.sceneSize();
    this->Step = silhouettes->GetThreshold() * unit;
    run.options = silhouettes->MakeOptions(this->Step);
  }
  run.options.reduction = this->ReductionFactor;
  static const double black[3] = {};
  if (this->OutputMode == OVERLAY)
    run.overlay = mote::imaging::LineColors(
      image, this->ColorArrayName, silhouettes ? silhouettes->GetColor() : black);
}

void vtkMoteSilhouetteFilter::ThreadedRequestData(vtkInformation*, vtkInformationVector**,
  vtkInformationVector*, vtkImageData***, vtkImageData** outData, int extent[6], int)
{
  const Run& run = *this->Present;
  const int width = extent[1] - extent[0] + 1, height = extent[3] - extent[2] + 1;
  std::vector<float> coverage(static_cast<std::size_t>(width) * height);
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    std::fill(coverage.begin(), coverage.end(), 0.0f);
    mote::PixelBox box;
    const mote::DepthImage image = run.input.slice(z, extent, box);
    if (run.enabled)
      mote::findSilhouettes(image, run.options, box, coverage.data(), width);
    for (int y = 0; y < height; ++y)
    {
      auto* out = static_cast<float*>(outData[0]->GetScalarPointer(extent[0], extent[2] + y, z));
      const float* row = coverage.data() + static_cast<std::size_t>(y) * width;
      if (this->OutputMode == SILHOUETTES)
      {
        std::copy(row, row + width, out);
        continue;
      }
      for (int x = 0; x < width; ++x)
        run.overlay.mix(run.input.square(extent[0] + x, extent[2] + y, z), row[x], out + 4 * x);
    }
  }
}

void vtkMoteSilhouetteFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Silhouettes: " << this->Silhouettes.Get() << "\n";
  os << indent << "DepthArrayName: " << this->DepthArrayName << "\n";
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  os << indent << "DepthMode: " << this->DepthMode << "\n";
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "ParallelScale: " << this->ParallelScale << "\n";
  os << indent << "BackgroundDepth: " << this->BackgroundDepth << "\n";
  os << indent << "ParticleRadius: " << this->ParticleRadius << "\n";
  os << indent << "SceneSize: " << this->SceneSize << "\n";
  os << indent << "ReductionFactor: " << this->ReductionFactor << "\n";
  os << indent << "OutputMode: " << this->OutputMode << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
