#include "ImageSilhouettes.h"

#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "stage/Silhouettes.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMoteImageReader.h>
#include <vtkMoteImageWriter.h>
#include <vtkMoteSilhouetteFilter.h>
#include <vtkMoteSilhouettes.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace mote::app
{

namespace
{

/// Where depths are an image of grey levels, they get the name of depths.
void nameDepths(vtkImageData* image)
{
  vtkPointData* points = image->GetPointData();
  vtkDataArray* grey = points->GetArray("color");
  if (grey && grey->GetNumberOfComponents() == 1 && !points->HasArray("depth"))
    grey->SetName("depth");
}

/// Gives the image white in place of its colours.
void whiten(vtkImageData* image)
{
  vtkNew<vtkFloatArray> white;
  white->SetName("color");
  white->SetNumberOfComponents(3);
  white->SetNumberOfTuples(image->GetNumberOfPoints());
  white->Fill(1.0);
  image->GetPointData()->RemoveArray("color");
  image->GetPointData()->SetScalars(white);
}

void setOptions(vtkMoteSilhouetteFilter* filter, const Settings& settings)
{
  const DepthImageSettings& image = settings.depthImage;
  choose(settings.silhouettes, vtkMoteSilhouettes::WORLD, filter->GetSilhouettes());
  filter->SetReductionFactor(image.reduction);
  filter->SetDepthArrayName(image.depth);
  filter->SetDepthMode(image.height      ? vtkMoteSilhouetteFilter::ORTHOGRAPHIC
                       : image.alongRays ? vtkMoteSilhouetteFilter::ALONG_RAYS
                                         : vtkMoteSilhouetteFilter::ALONG_AXIS);
  filter->SetViewAngle(image.viewAngle);
  if (image.height)
    filter->SetParallelScale(0.5 * *image.height);
  filter->SetBackgroundDepth(image.farDepth.value_or(HUGE_VAL));
  filter->SetOutputModeToOverlay();
  if (settings.data.threads > 0)
    filter->SetNumberOfThreads(settings.data.threads);
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

void drawImageSilhouettes(const Settings& settings)
{
  const std::string& file = settings.data.files.front();
  const std::string& output = settings.output.file;
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetFileName(output.c_str());
  if (!writer->CheckFileName())
    throw Failure(writer->GetErrorMessage());
  checkOutput(output, {file});
  vtkNew<vtkMoteImageReader> reader;
  reader->SetFileName(file.c_str());
  auto start = std::chrono::steady_clock::now();
  reader->Update();
  const double reading = secondsSince(start);
  Messages::takeError(); // the reader keeps it, and the filter and the writer keep theirs
  if (!reader->GetErrorMessage().empty())
    throw Failure(reader->GetErrorMessage());
  vtkImageData* image = reader->GetOutput();
  nameDepths(image);
  if (settings.depthImage.linesAlone || !image->GetPointData()->HasArray("color"))
    whiten(image);
  vtkNew<vtkMoteSilhouetteFilter> filter;
  filter->SetInputData(image);
  setOptions(filter, settings);
  start = std::chrono::steady_clock::now();
  filter->Update();
  const double finding = secondsSince(start);
  Messages::takeError();
  if (!filter->GetErrorMessage().empty())
    throw Failure(file + ": " + filter->GetErrorMessage());
  writer->SetInputConnection(filter->GetOutputPort());
  const bool isWritten = writer->Write();
  Messages::takeError();
  if (!isWritten)
    throw Failure(writer->GetErrorMessage());
  const int* size = filter->GetOutput()->GetDimensions();
  std::printf("%s: %dx%d, silhouettes at steps from %s; read in %s, drawn in %s\n", output.c_str(),
    size[0], size[1], asNumber(filter->GetStep(), 4).c_str(), asDuration(reading).c_str(),
    asDuration(finding).c_str());
}

} // namespace mote::app
