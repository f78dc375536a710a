#include "ImageSilhouettes.h"

#include "base/Checks.h"
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

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace mote::app
{

namespace
{

void addDepthOptions(CLI::App& app, ImageSilhouetteOptions& o)
{
  const std::string group = "Depth";
  app
    .add_option("--depth", o.depth,
      "Channel of the depths, as vtkMoteImageReader names it. By default depth, which is Z in the "
      "file, or the only channel")
    ->type_name("NAME")
    ->group(group);
  const auto positive = CLI::PositiveNumber.description("");
  auto* angle =
    app.add_option("--view-angle", o.viewAngle, "Angle between bottom and top, in degrees")
      ->check(isNumber())
      ->check(CLI::Range(1e-6, 179.0).description(""))
      ->capture_default_str()
      ->type_name("A")
      ->group(group);
  auto* rays = app.add_flag(
    "--along-rays", o.alongRays, "Depths are distances from the eye, and not along the view axis");
  rays->group(group);
  app
    .add_option(
      "--orthographic", o.orthographic, "The view is orthographic and so high, in world units")
    ->check(isNumber())
    ->check(positive)
    ->excludes(angle)
    ->excludes(rays)
    ->type_name("HEIGHT")
    ->group(group);
  app
    .add_option("--far", o.farDepth,
      "Depths from here on are background, as those that are not finite are anyway")
    ->check(isNumber())
    ->check(positive)
    ->type_name("D")
    ->group(group);
}

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

void setOptions(vtkMoteSilhouetteFilter* filter, const ImageSilhouetteOptions& options)
{
  choose(options.given.settings.silhouettes, vtkMoteSilhouettes::WORLD, filter->GetSilhouettes());
  filter->SetReductionFactor(options.reduction);
  filter->SetDepthArrayName(options.depth);
  filter->SetDepthMode(options.orthographic ? vtkMoteSilhouetteFilter::ORTHOGRAPHIC
                       : options.alongRays  ? vtkMoteSilhouetteFilter::ALONG_RAYS
                                            : vtkMoteSilhouetteFilter::ALONG_AXIS);
  filter->SetViewAngle(options.viewAngle);
  if (options.orthographic)
    filter->SetParallelScale(0.5 * *options.orthographic);
  filter->SetBackgroundDepth(options.farDepth);
  filter->SetOutputModeToOverlay();
  if (options.given.settings.data.threads > 0)
    filter->SetNumberOfThreads(options.given.settings.data.threads);
}

/// Why the text is no length nor percentage; empty where it is.
std::string checkLength(const std::string& text)
{
  const bool isWord = text == "on" || text == "off" || text == "auto";
  if (!isWord && checkLines(text).empty())
    return {};
  return "'" + text + "' is neither a length such as 2.5 nor a percentage such as 1%";
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

ImageSilhouetteOptions::ImageSilhouetteOptions()
{
  given.settings.silhouettes.lines = "1%";
  given.settings.silhouettes.thickness = "1";
  given.settings.silhouettes.opacity = 0.3;
}

void addImageSilhouetteOptions(CLI::App& app, ImageSilhouetteOptions& options)
{
  app.add_option("IMAGE", options.image, "Image with depths, such as an .exr from any program")
    ->required()
    ->type_name("");
  app
    .add_option(
      "--output,-o", options.output, "Picture to write: .png, .jpg, .tif or .exr; with lines drawn")
    ->required()
    ->type_name("FILE");
  app
    .add_option("--threshold", options.given.settings.silhouettes.lines,
      "Least step of depth that is drawn: a length in world units, or with % a share of the "
      "diagonal of what the image shows")
    ->check(CLI::Validator([](std::string& text) { return checkLength(text); }, "", "threshold"))
    ->capture_default_str()
    ->group("Silhouettes")
    ->type_name("STEP");
  addSettings(app, options.given,
    {"silhouette-thickness", "silhouette-opacity", "silhouette-color", "silhouette-on-pixels",
      "silhouette-step-pixels", "silhouette-groups", "silhouette-no-hulls", "threads"},
    "silhouette-");
  app
    .add_option("--reduce", options.reduction,
      "Make one pixel of a square of N times N, for smooth lines from a larger image")
    ->check(CLI::Range(1, 64).description(""))
    ->capture_default_str()
    ->type_name("N");
  app.add_flag(
    "--lines-only", options.linesAlone, "Draw on white, and not over the image's colours");
  addDepthOptions(app, options);
}

void drawImageSilhouettes(const ImageSilhouetteOptions& options)
{
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetFileName(options.output.c_str());
  if (!writer->CheckFileName())
    throw Failure(writer->GetErrorMessage());
  checkOutput(options.output, {options.image});
  vtkNew<vtkMoteImageReader> reader;
  reader->SetFileName(options.image.c_str());
  auto start = std::chrono::steady_clock::now();
  reader->Update();
  const double reading = secondsSince(start);
  Messages::takeError(); // the reader keeps it, and the filter and the writer keep theirs
  if (!reader->GetErrorMessage().empty())
    throw Failure(reader->GetErrorMessage());
  vtkImageData* image = reader->GetOutput();
  nameDepths(image);
  if (options.linesAlone || !image->GetPointData()->HasArray("color"))
    whiten(image);
  vtkNew<vtkMoteSilhouetteFilter> filter;
  filter->SetInputData(image);
  setOptions(filter, options);
  start = std::chrono::steady_clock::now();
  filter->Update();
  const double finding = secondsSince(start);
  Messages::takeError();
  if (!filter->GetErrorMessage().empty())
    throw Failure(options.image + ": " + filter->GetErrorMessage());
  writer->SetInputConnection(filter->GetOutputPort());
  const bool isWritten = writer->Write();
  Messages::takeError();
  if (!isWritten)
    throw Failure(writer->GetErrorMessage());
  const int* size = filter->GetOutput()->GetDimensions();
  std::printf("%s: %dx%d, silhouettes at steps from %s; read in %s, drawn in %s\n",
    options.output.c_str(), size[0], size[1], asNumber(filter->GetStep(), 4).c_str(),
    asDuration(reading).c_str(), asDuration(finding).c_str());
}

} // namespace mote::app
