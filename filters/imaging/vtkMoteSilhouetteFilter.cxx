#include "vtkMoteSilhouetteFilter.h"

#include "SilhouetteInput.h"

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
  mote::imaging::LineColors overlay;
};

vtkStandardNewMacro(vtkMoteSilhouetteFilter);

vtkMoteSilhouetteFilter::vtkMoteSilhouetteFilter() = default;

vtkMoteSilhouetteFilter::~vtkMoteSilhouetteFilter() = default;

mote::SilhouetteOptions vtkMoteSilhouetteFilter::MakeOptions() const
{
  mote::SilhouetteOptions options;
  options.stepInPixels = this->StepInPixels;
  options.hulls = this->Hulls != 0;
  options.thickness = this->Thickness;
  options.leastThickness = this->LeastThickness > 0.0 ? this->LeastThickness : this->Thickness;
  options.leastOpacity = this->LeastOpacity;
  options.fullStep = this->FullStep;
  options.centered = this->Centered != 0;
  options.reduction = this->ReductionFactor;
  return options;
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
  const bool needsAll = this->ThresholdMode == SCENE_SIZE && this->SceneSize <= 0.0;
  const int factor = this->ReductionFactor, margin = mote::silhouetteMargin(this->MakeOptions());
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
    run->options = this->MakeOptions();
    this->Describe(*run, image, inputVector[0]->GetInformationObject(0));
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = error.what();
    vtkErrorMacro(<< this->ErrorMessage);
    output->Initialize();
    return 0;
  }
  this->Step = run->options.step;
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
  if (!this->GroupArrayName.empty())
    input.takeGroups(mote::imaging::findNumbers(image, this->GroupArrayName));
  input.background = this->BackgroundDepth < VTK_FLOAT_MAX
                       ? static_cast<float>(this->BackgroundDepth)
                       : std::numeric_limits<float>::infinity();
  input.setView(this->DepthMode != ORTHOGRAPHIC, this->ViewAngle, 2.0 * this->ParallelScale,
    this->DepthMode == ALONG_RAYS);
  const double unit = this->ThresholdMode == WORLD   ? 1.0
                      : this->ThresholdMode == RADII ? this->ParticleRadius
                      : this->SceneSize > 0.0        ? this->SceneSize
                                                     : input.sceneSize();
  run.options.step = this->Threshold * unit;
  if (this->OutputMode == OVERLAY)
    run.overlay = mote::imaging::LineColors(image, this->ColorArrayName, this->EdgeColor);
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
  os << indent << "DepthArrayName: " << this->DepthArrayName << "\n";
  os << indent << "GroupArrayName: " << this->GroupArrayName << "\n";
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  os << indent << "DepthMode: " << this->DepthMode << "\n";
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "ParallelScale: " << this->ParallelScale << "\n";
  os << indent << "BackgroundDepth: " << this->BackgroundDepth << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "ThresholdMode: " << this->ThresholdMode << "\n";
  os << indent << "ParticleRadius: " << this->ParticleRadius << "\n";
  os << indent << "SceneSize: " << this->SceneSize << "\n";
  os << indent << "StepInPixels: " << this->StepInPixels << "\n";
  os << indent << "Hulls: " << this->Hulls << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "LeastThickness: " << this->LeastThickness << "\n";
  os << indent << "LeastOpacity: " << this->LeastOpacity << "\n";
  os << indent << "FullStep: " << this->FullStep << "\n";
  os << indent << "Centered: " << this->Centered << "\n";
  os << indent << "ReductionFactor: " << this->ReductionFactor << "\n";
  os << indent << "OutputMode: " << this->OutputMode << "\n";
  os << indent << "EdgeColor: " << this->EdgeColor[0] << " " << this->EdgeColor[1] << " "
     << this->EdgeColor[2] << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
