#include "ImageSilhouettes.h"

#include "Checks.h"
#include "Colors.h"
#include "Failure.h"
#include "Messages.h"
#include "OutputFile.h"
#include "Text.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMoteImageReader.h>
#include <vtkMoteImageWriter.h>
#include <vtkMoteSilhouetteFilter.h>
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

/// "2" or "1.5%": the number, and whether it is a percentage.
bool parseThreshold(const std::string& text, double& value, bool& isShare)
{
  isShare = !text.empty() && text.back() == '%';
  return parseNumber(isShare ? text.substr(0, text.size() - 1) : text, value) && value >= 0.0;
}

std::string checkThreshold(std::string& text)
{
  double value;
  bool isShare;
  return parseThreshold(text, value, isShare)
           ? ""
           : "'" + text + "' is neither a length such as 2.5 nor a percentage such as 1%";
}

/// "2" or "1:3": widths of the weakest and of the strongest lines.
bool parseThickness(const std::string& text, double& least, double& most)
{
  const std::size_t colon = text.find(':');
  const bool isRange = colon != std::string::npos;
  return parseNumber(text.substr(0, colon), least) &&
         parseNumber(isRange ? text.substr(colon + 1) : text, most) && least > 0.0 &&
         most >= least && most <= 100.0;
}

std::string checkThickness(std::string& text)
{
  double least, most;
  return parseThickness(text, least, most)
           ? ""
           : "'" + text +
               "' is neither a width in pixels above 0 such as 2 nor a range such as 1:3";
}

void addLineOptions(CLI::App& app, ImageSilhouetteOptions& o)
{
  const std::string group = "Lines";
  app
    .add_option("--thickness", o.thickness,
      "Width of the lines in pixels, or LEAST:MOST to have it grow with the step")
    ->check(CLI::Validator([](std::string& t) { return checkThickness(t); }, "", "thickness"))
    ->capture_default_str()
    ->type_name("W")
    ->group(group);
  app
    .add_option("--opacity", o.leastOpacity,
      "Opacity of the least steps, 0 to 1, that grows with the step: grey levels")
    ->check(isNumber())
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->capture_default_str()
    ->type_name("A")
    ->group(group);
  app
    .add_option_function<std::string>(
      "--color",
      [&o](const std::string& text)
      {
        if (!parseColor(text, o.color))
          throw CLI::ValidationError(
            "--color", "'" + text + "' is no colour: give a name (white, navy) or #rrggbb");
      },
      "Colour of the lines, by name or as #rrggbb. By default nearly black")
    ->type_name("COLOR")
    ->group(group);
  app
    .add_flag("--on-pixels", o.onPixels,
      "Draw on the farther pixels alone, crisply, and not about the border itself")
    ->group(group);
  app
    .add_option("--reduce", o.reduction,
      "Make one pixel of a square of N times N, for smooth lines from a larger image")
    ->check(CLI::Range(1, 64).description(""))
    ->capture_default_str()
    ->type_name("N")
    ->group(group);
  app.add_flag("--lines-only", o.linesAlone, "Draw on white, and not over the image's colours")
    ->group(group);
}

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
  double threshold, least, most;
  bool isShare;
  parseThreshold(options.threshold, threshold, isShare);
  parseThickness(options.thickness, least, most);
  filter->SetThreshold(isShare ? threshold / 100.0 : threshold);
  filter->SetThresholdMode(
    isShare ? vtkMoteSilhouetteFilter::SCENE_SIZE : vtkMoteSilhouetteFilter::WORLD);
  filter->SetStepInPixels(options.stepInPixels);
  filter->SetThickness(most);
  filter->SetLeastThickness(least);
  filter->SetLeastOpacity(options.leastOpacity);
  filter->SetHulls(options.hulls);
  filter->SetCentered(!options.onPixels);
  filter->SetReductionFactor(options.reduction);
  filter->SetDepthArrayName(options.depth);
  filter->SetGroupArrayName(options.groups);
  filter->SetDepthMode(options.orthographic ? vtkMoteSilhouetteFilter::ORTHOGRAPHIC
                       : options.alongRays  ? vtkMoteSilhouetteFilter::ALONG_RAYS
                                            : vtkMoteSilhouetteFilter::ALONG_AXIS);
  filter->SetViewAngle(options.viewAngle);
  if (options.orthographic)
    filter->SetParallelScale(0.5 * *options.orthographic);
  filter->SetBackgroundDepth(options.farDepth);
  filter->SetEdgeColor(options.color[0], options.color[1], options.color[2]);
  filter->SetOutputModeToOverlay();
  if (options.threads > 0)
    filter->SetNumberOfThreads(options.threads);
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

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
    .add_option("--threshold", options.threshold,
      "Least step of depth that is drawn: a length in world units, or with % a share of the "
      "diagonal of what the image shows")
    ->check(CLI::Validator([](std::string& t) { return checkThreshold(t); }, "", "threshold"))
    ->capture_default_str()
    ->type_name("STEP");
  app
    .add_option("--step-pixels", options.stepInPixels,
      "No step is drawn that is less than the width of so many pixels at its distance")
    ->check(isNumber())
    ->check(CLI::NonNegativeNumber.description(""))
    ->capture_default_str()
    ->type_name("N");
  app
    .add_option("--groups", options.groups,
      "Channel, such as particle or object, with lines also between its values")
    ->type_name("NAME");
  app.add_flag("!--no-hulls", options.hulls, "No lines against the background");
  app.add_option("--threads", options.threads, "Threads to work with. By default all")
    ->check(CLI::Range(0, 4096).description(""))
    ->type_name("N");
  addLineOptions(app, options);
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
