#include "Render.h"

#include "AllSteps.h"
#include "Bake.h"
#include "Film.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"
#include "stage/Advice.h"
#include "stage/Picture.h"
#include "stage/Silhouettes.h"
#include "table/Session.h"

#include <vtkTimerLog.h>

#include <cstdio>
#include <filesystem>
#include <numeric>

namespace mote::app
{

namespace
{

/// The line on standard output that tells of a finished picture.
void report(const std::string& file, const Stage& stage, const Picture& picture,
  const std::array<int, 2>& size, double readTime)
{
  std::printf("%s: %dx%d, %s; read in %s, built in %s, traced in %s, %s\n", file.c_str(), size[0],
    size[1], stage.contents().c_str(), asDuration(readTime).c_str(),
    asDuration(stage.buildTime()).c_str(), asDuration(picture.traceTime()).c_str(),
    picture.quality().c_str());
  std::fflush(stdout);
}

} // namespace

void requireTraced(const Stage& stage)
{
  if (stage.parts().empty())
    throw Failure("there is nothing to draw in the input");
}

namespace
{

/// Gives all time steps one range of colours, where it is not given.
void includeAllColors(Stage& stage, Input& input, ProgressRelay& progress)
{
  const ColorSettings& colors = stage.settings().color;
  if (!colors.range.empty() || colors.array == "none")
    return;
  std::vector<int> others(static_cast<std::size_t>(input.numberOfSteps() - 1));
  std::iota(others.begin(), others.end(), 0);
  includeColors(stage, input, others, progress);
}

} // namespace

Settings asSaved(Settings settings, const std::array<int, 2>& usual)
{
  const OutputSettings& output = settings.output;
  std::array<int, 2>& size = settings.picture.size;
  if (output.fitsView && output.size[0] > 0)
    size = output.size;
  else if (size[0] == 0)
    size = usual;
  if (output.seenHeight > 0)
    settings.silhouettes = scaled(settings.silhouettes, double(size[1]) / output.seenHeight);
  return settings;
}

void render(const Settings& given)
{
  const Settings settings = asSaved(given, {1280, 960});
  const OutputSettings& output = given.output;
  const std::array<int, 2> size = settings.picture.size;
  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  Stage stage(settings);
  Picture picture(stage, size);
  Input input(settings.data.files);
  refuseFilm(output.file); // by the name that was given
  picture.aim(output.allSteps ? numbered(output.file, 1, 1) : output.file);
  const double start = vtkTimerLog::GetUniversalTime();
  input.open(progress);
  const double openTime = vtkTimerLog::GetUniversalTime() - start;

  const auto show = [&](int step)
  {
    const double start = vtkTimerLog::GetUniversalTime();
    readStep(stage, input, step, progress);
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
      Messages::warn("the ranges to show leave no particle in " + file);
    else if (stage.numberOfCellsShown() == 0 &&
             stage.numberOfTriangles(true) + stage.numberOfLines(true) == 0 &&
             stage.numberOfCells() + stage.numberOfLines(false) > 0)
      Messages::warn("the ranges to show leave no cell in " + file);
    picture.write(captionOf(input, step, stage.contents()), progress);
    report(file, stage, picture, size, readTime);
  };

  // A sequence has one frame and radius, those of its last step, and one range of colours.
  const int last = input.numberOfSteps() - 1;
  const int chosen = output.allSteps ? last : input.chosenStep(settings);
  const double readTime = show(chosen);
  stage.look(picture.aspect(), picture.margins());
  for (const std::string& sentence : adviceOn(stage))
    Messages::warn(sentence);
  const auto paths = ParticlePaths::whole(settings, input, progress);
  picture.setPaths(paths.get());
  if (!output.allSteps)
    trace(chosen, output.file, openTime + readTime);
  else
  {
    includeAllColors(stage, input, progress);
    for (int step = 0; step <= last; ++step)
      trace(step, numbered(output.file, step + 1, last + 1), show(step));
  }
  if (!output.session.empty())
    writeSession(stage.settingsInForce(), output.session);
}

} // namespace mote::app
