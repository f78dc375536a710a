#include "Animate.h"

#include "Bake.h"
#include "Film.h"
#include "FilmPlan.h"
#include "Render.h"
#include "VideoFile.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"
#include "stage/Advice.h"
#include "stage/Silhouettes.h"
#include "table/Session.h"

#include <vtkTimerLog.h>

#include <cstdio>
#include <filesystem>

namespace mote::app
{

namespace
{

bool areSameFiles(const std::vector<std::string>& a, const std::vector<std::string>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const std::string& x, const std::string& y)
    {
      std::error_code error;
      return x == y || std::filesystem::equivalent(x, y, error);
    });
}

/// A key frame whose lines are as thick, as a share of the picture, as where it was seen.
Settings scaledTo(Settings key, const Settings& first)
{
  if (const int seen = key.picture.size[1]; seen > 0)
    key.silhouettes = scaled(key.silhouettes, double(first.picture.size[1]) / seen);
  return key;
}

/// The settings of a session that a film goes on to.
Settings keyOf(const std::string& file, const Settings& first)
{
  Settings key = readSession(file);
  if (!areSameFiles(key.data.files, first.data.files))
    throw Failure("--key-frames: " + file + " shows other data, " + joined(key.data.files, ", ") +
                  ", and a film is of the same data throughout");
  key.data.files = first.data.files;
  key.data.threads = first.data.threads;
  return scaledTo(key, first);
}

} // namespace

std::vector<Settings> framesOf(
  const Stage& stage, const Input& input, const std::vector<Settings>& keys)
{
  const Settings& first = keys.front();
  FilmScene scene;
  scene.name = input.name();
  scene.steps = input.numberOfSteps();
  // The window chooses a video where no name is given.
  const std::string& file = stage.settings().output.file;
  scene.isVideo = file.empty() || isVideoName(file);
  stage.shownBounds(scene.bounds.data());
  for (Settings key : keys)
  {
    if (key.camera.camera.empty())
      key.camera.camera = first.camera.camera;
    if (key.camera.orthographic != first.camera.orthographic)
      throw Failure("one key frame of the film is seen in perspective and another one is not");
    key.film = stage.settings().film;
    key.output = stage.settings().output;
    key.picture.size = stage.settings().picture.size;
    scene.keySteps.push_back(input.chosenStep(key));
    scene.keys.push_back(key);
  }
  return planFilm(scene, stage.settings().film);
}

std::string filmText(const std::string& file, const std::array<int, 2>& size, int written,
  std::size_t planned, int rate)
{
  const bool isAll = static_cast<std::size_t>(written) == planned;
  return file + ": " + std::to_string(size[0]) + "x" + std::to_string(size[1]) + ", " +
         (isAll ? "" : std::to_string(written) + " of ") +
         counted(static_cast<std::int64_t>(planned), "frame") + ", " +
         asDuration(static_cast<double>(written) / rate) + " at " + std::to_string(rate) +
         " frames a second";
}

void animate(const Settings& given)
{
  const Settings settings = asSaved(given, {1280, 720});
  const std::string& file = given.output.file;
  const std::array<int, 2> size = settings.picture.size;
  checkFilmName(file, settings.data.files);
  std::vector<Settings> keys;
  for (const std::string& session : settings.film.keyFrames)
    keys.push_back(keyOf(session, settings));
  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  Stage stage(settings);
  Picture picture(stage, size);
  Input input(settings.data.files);
  const double start = vtkTimerLog::GetUniversalTime();
  input.open(progress);
  int step = input.chosenStep(settings);
  readStep(stage, input, step, progress);
  requireTraced(stage);
  stage.build(progress);
  stage.applyColors();
  stage.look(picture.aspect(), picture.margins());
  for (const std::string& sentence : adviceOn(stage))
    Messages::warn(sentence);
  if (keys.empty() && !settings.keyFrames.empty()) // of a session: all that its film goes through
    for (const Settings& key : settings.keyFrames)
      keys.push_back(scaledTo(key, settings));
  else
    keys.insert(keys.begin(), stage.settingsInForce());
  const std::vector<Settings> frames = framesOf(stage, input, keys);
  step = includeColorsOf(frames, stage, input, step, progress);
  const FilmResult result = makeFilm(stage, input, step, frames, file, size, terminal);
  std::printf("%s; made in %s\n",
    filmText(file, size, result.frames, frames.size(), settings.film.rate).c_str(),
    asDuration(vtkTimerLog::GetUniversalTime() - start).c_str());
  if (const std::string one = onlyStepOf(frames, input.numberOfSteps()); !one.empty())
    std::printf("%s: %s\n", file.c_str(), one.c_str());
  std::fflush(stdout);
  if (result.isStopped)
    throw Interrupted();
}

} // namespace mote::app
