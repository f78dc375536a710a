#include "Render.h"

#include "Bake.h"
#include "Failure.h"
#include "Messages.h"
#include "OutputFile.h"
#include "Stage.h"
#include "Text.h"

#include <kernels/core/ScratchSpace.h>

#include <vtkLookupTable.h>
#include <vtkMoteColorLegend.h>
#include <vtkMoteImageWriter.h>
#include <vtkMoteRendererSource.h>
#include <vtkMoteShading.h>
#include <vtkMoteSilhouettes.h>
#include <vtkTimerLog.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <new>

namespace mote::app
{

namespace
{

/// The pipeline from a scene to a file.
class Picture
{
public:
  Picture(Stage& stage, const ViewOptions& options)
    : stage_(stage)
    , options_(options)
  {
    source_->SetRenderer(stage.renderer());
    source_->SetSize(options.size[0], options.size[1]);
    source_->SetSamplesPerPixel(options.mostSamples(options.pathTrace));
    source_->SetNoiseLevel(options.noise);
    source_->SetShading(stage.lighting().shading());
    source_->SetSilhouettes(stage.silhouettes());
    legend_->SetInputConnection(source_->GetOutputPort());
  }

  /// Throws Failure if the file could not be written, as far as can be told beforehand.
  void aim(const std::string& file)
  {
    writer_->SetFileName(file.c_str());
    if (!writer_->CheckFileName())
      throw Failure(writer_->GetErrorMessage());
    checkOutput(file, options_.files);
    const bool exr = lowerCase(std::filesystem::path(file).extension().string()) == ".exr";
    // An EXR is for further work: everything there is, and nothing drawn over it.
    source_->SetDepth(exr);
    source_->SetNormals(exr);
    source_->SetIds(exr);
    source_->SetVariance(exr && options_.noise > 0.0);
    source_->SetSilhouetteCoverage(exr && stage_.silhouettes()->GetEnabled());
    source_->SetTransparentBackground(exr);
    labelled_ = !exr;
    this->requireMemory();
    writer_->SetInputConnection(labelled_ ? legend_->GetOutputPort() : source_->GetOutputPort());
  }

  bool labelled() const { return labelled_; }

  void write(const std::string& caption, ProgressRelay& progress)
  {
    vtkScalarsToColors* table = stage_.coloring().legendTable();
    legend_->SetLookupTable(options_.legend ? table : nullptr);
    legend_->SetTitle(options_.title.value_or(stage_.coloring().title()));
    legend_->SetCaption(options_.caption.value_or(caption));
    Messages::takeError();
    source_->Modified(); // parts and camera may have changed
    try
    {
      {
        ProgressRelay::Work work(progress, "Tracing", source_);
        source_->Update();
        work.finish();
      }
      if (const std::string error = Messages::takeError(); error == std::bad_alloc().what())
        throw std::bad_alloc(); // VTK's pipeline lets no exception through
      else if (!error.empty())
        throw Failure(error);
      if (!writer_->Write())
        throw Failure(writer_->GetErrorMessage());
    }
    catch (const std::bad_alloc&)
    {
      throw Failure("there is not enough memory: " + this->needs());
    }
  }

  double traceTime() const { return source_->GetTraceTime(); }

  /// "16 rays a pixel", and with --noise what came of it.
  std::string quality() const
  {
    std::string text = counted(source_->GetNumberOfSamples(), "ray") + " a pixel";
    if (options_.noise > 0.0)
      text += ", noise " + asNumber(source_->GetNoise(), 3);
    return text;
  }

private:
  /// Throws Failure for a picture that the machine has no memory for.
  void requireMemory() const
  {
    const auto there = static_cast<double>(physicalMemory());
    if (this->bytes() > there)
      throw Failure(this->needs() + ", and this machine has " + asBytes(there));
  }

  /// About what a picture takes: colour and depth, twice over with the legend, and in an EXR's
  /// layers normals, ids, variance and silhouettes.
  double bytes() const { return (labelled_ ? 60.0 : 130.0) * options_.size[0] * options_.size[1]; }

  std::string needs() const
  {
    return "a picture of " + std::to_string(options_.size[0]) + "x" +
           std::to_string(options_.size[1]) + " pixels needs about " + asBytes(this->bytes());
  }

  Stage& stage_;
  const ViewOptions& options_;
  vtkNew<vtkMoteRendererSource> source_;
  vtkNew<vtkMoteColorLegend> legend_;
  vtkNew<vtkMoteImageWriter> writer_;
  bool labelled_ = true;
};

/// "picture.png" to "picture.0012.png"; steps count from 1.
std::string numbered(const std::string& file, int step, int steps)
{
  const int digits = std::max(4, static_cast<int>(std::to_string(steps).size()));
  std::string number = std::to_string(step);
  number.insert(0, std::max(0, digits - static_cast<int>(number.size())), '0');
  std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "." + number)).string() +
         path.extension().string();
}

/// The line on standard output that tells of a finished picture.
void report(const std::string& file, const Stage& stage, const Picture& picture,
  const ViewOptions& options, double readTime)
{
  std::printf("%s: %dx%d, %s; read in %s, built in %s, traced in %s, %s\n", file.c_str(),
    options.size[0], options.size[1], stage.contents().c_str(), asDuration(readTime).c_str(),
    asDuration(stage.buildTime()).c_str(), asDuration(picture.traceTime()).c_str(),
    picture.quality().c_str());
  std::fflush(stdout);
}

/// Lets the colours' range and types take in the first `steps` time steps.
void includeColors(Stage& stage, Input& input, int steps, ProgressRelay& progress)
{
  for (int step = 0; step < steps; ++step)
  {
    stage.setData(input.read(step, progress));
    stage.coloring().include(stage.parts());
  }
}

void requireTraced(const Stage& stage)
{
  for (const auto& part : stage.parts())
    if (part->kind() != Part::Kind::Surface)
      return;
  const std::string name = stage.parts().empty() ? "the input" : stage.parts().front()->name();
  throw Failure(name + " holds faces, or cells without numbers on them, and mote render draws "
                       "particles and volumes only; see its surface in a window with: mote FILE");
}

/// Room for the legend at the right and for the caption below.
Margins marginsFor(const Picture& picture, Stage& stage, const ViewOptions& options)
{
  Margins margins;
  if (picture.labelled() && options.legend && stage.coloring().legendTable())
    margins.right += 0.13 * options.size[1] / options.size[0];
  if (picture.labelled())
    margins.bottom += 0.03;
  return margins;
}

} // namespace

void addRenderOptions(CLI::App& app, RenderOptions& options)
{
  app
    .add_option("--output,-o", options.output,
      "Picture to write: .png, .jpg or .tif; or .exr with colour, depth, normal and particle id, "
      "the background transparent")
    ->required()
    ->type_name("FILE");
  addViewOptions(app, options.view);
  app
    .add_option("--caption", options.view.caption,
      "Line at the lower left. By default file, particles and time")
    ->type_name("TEXT")
    ->group("Picture");
  app
    .add_flag("--all-steps", options.allSteps,
      "A picture of every time step: out.png gives out.0001.png, out.0002.png ... All have the "
      "last step's frame and one range of colours, for which the steps are read twice unless "
      "--range gives it")
    ->excludes(app.get_option("--step"))
    ->excludes(app.get_option("--time"))
    ->group("Data");
}

void render(const RenderOptions& given)
{
  ViewOptions options = given.view;
  if (options.size[0] == 0)
    options.size = {1280, 960};
  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  Stage stage(options);
  Picture picture(stage, options);
  Input input(options.files);
  picture.aim(given.allSteps ? numbered(given.output, 1, 1) : given.output);
  const double start = vtkTimerLog::GetUniversalTime();
  input.open(progress);
  const double openTime = vtkTimerLog::GetUniversalTime() - start;

  const auto show = [&](int step)
  {
    const double start = vtkTimerLog::GetUniversalTime();
    const auto data = input.read(step, progress);
    if (options.ambientOcclusion == "baked")
      addOcclusionMaps(data);
    stage.setData(data);
    const double seconds = vtkTimerLog::GetUniversalTime() - start;
    requireTraced(stage);
    stage.build(progress);
    stage.applyColors();
    return seconds;
  };
  const auto trace = [&](int step, const std::string& file, double readTime)
  {
    picture.aim(file);
    if (stage.numberShown() == 0 && stage.numberOfParticles() > 0)
      std::fprintf(
        stderr, "mote: warning: the ranges to show leave no particle in %s\n", file.c_str());
    std::string caption = input.name() + "   " + stage.contents();
    if (!input.times().empty())
      caption += "   t = " + asNumber(input.times()[step], 10);
    picture.write(caption, progress);
    report(file, stage, picture, options, readTime);
  };

  // A sequence has one frame and radius, those of its last step, and one range of colours.
  const int last = input.numberOfSteps() - 1;
  const int chosen = given.allSteps ? last : input.chosenStep(options);
  const double readTime = show(chosen);
  stage.look(
    options.view, double(options.size[0]) / options.size[1], marginsFor(picture, stage, options));
  if (!given.allSteps)
    trace(chosen, given.output, openTime + readTime);
  else
  {
    if (options.range.empty() && options.colorBy != "none")
      includeColors(stage, input, last, progress);
    for (int step = 0; step <= last; ++step)
      trace(step, numbered(given.output, step + 1, last + 1), show(step));
  }
}

} // namespace mote::app
