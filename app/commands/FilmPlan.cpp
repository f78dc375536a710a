#include "FilmPlan.h"

#include "KeyFrames.h"
#include "base/Failure.h"
#include "base/Text.h"
#include "table/Row.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr double secondsOfTurn = 10.0, secondsOfKey = 2.0, secondsOfSteps = 2.0;

/// The steps to show, from 0; none where the film stays at those of its keys.
std::vector<int> stepsOf(const FilmScene& scene, const FilmSettings& film)
{
  std::vector<int> steps;
  const bool moves = film.orbit != 0.0 || scene.keys.size() > 1;
  if (film.steps.empty() && (moves || scene.steps == 1))
    return steps;
  const StepRange range = stepRange(film.steps).value_or(StepRange());
  const int last = range.last > 0 ? range.last : scene.steps;
  if (range.first > scene.steps || last > scene.steps)
    throw Failure(scene.name + " has " + counted(scene.steps, "time step") +
                  ", so there is no --steps " + film.steps);
  for (int step = range.first; step <= last; step += range.stride)
    steps.push_back(step - 1);
  return steps;
}

bool isStill(const FilmScene& scene, const FilmSettings& film, const std::vector<int>& steps)
{
  return steps.size() < 2 && film.orbit == 0.0 && scene.keys.size() < 2;
}

int framesOf(const FilmScene& scene, const FilmSettings& film, int steps)
{
  if (film.frames)
    return *film.frames;
  const auto keys = static_cast<double>(scene.keys.size() - 1);
  const double seconds =
    std::max(keys * secondsOfKey, std::abs(film.orbit) / 360.0 * secondsOfTurn);
  if (steps == 0)
    return std::max(2, static_cast<int>(std::lround(seconds * film.rate)));
  // A few steps would be over before anybody has looked.
  const double least = scene.isVideo ? std::max(seconds, secondsOfSteps) * film.rate : 0.0;
  const int needed = std::max(1, static_cast<int>(std::ceil(least / steps)));
  return steps * film.framesPerStep.value_or(needed);
}

} // namespace

std::vector<double> turned(
  const std::vector<double>& camera, const std::array<double, 6>& bounds, double degrees)
{
  const double *eye = camera.data(), *focus = camera.data() + 3, *up = camera.data() + 6;
  double middle[3], size = 0.0, away = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    size += std::pow(bounds[2 * i + 1] - bounds[2 * i], 2);
    away += std::pow(focus[i] - middle[i], 2);
  }
  const bool isAll = away < 0.0225 * size; // 15 % of the diagonal: legends move the view aside
  const double* pivot = isAll ? middle : focus;
  // Of simulations the floor is level: the axis nearest to the view's own up.
  int upright = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(up[i]) > std::abs(up[upright]))
      upright = i;
  const double sign = up[upright] < 0.0 ? -1.0 : 1.0;
  const double angle = vtkMath::RadiansFromDegrees(sign * degrees);
  const double c = std::cos(angle), s = std::sin(angle);
  const int u = (upright + 1) % 3, v = (upright + 2) % 3;
  const auto turn = [&](const double from[3], const double center[3], double to[3])
  {
    const double x = from[u] - center[u], y = from[v] - center[v];
    to[u] = center[u] + c * x - s * y;
    to[v] = center[v] + s * x + c * y;
    to[upright] = from[upright];
  };
  std::vector<double> result = camera;
  const double origin[3] = {0.0, 0.0, 0.0};
  turn(eye, pivot, result.data());
  turn(focus, pivot, result.data() + 3);
  turn(up, origin, result.data() + 6);
  return result;
}

FilmForecast forecast(
  const std::vector<Settings>& keys, int steps, const FilmSettings& film, bool isVideo)
{
  FilmScene scene;
  scene.keys = keys;
  scene.keys.resize(std::max<std::size_t>(1, keys.size()));
  scene.steps = steps;
  scene.name = "the series";
  scene.isVideo = isVideo;
  try
  {
    const std::vector<int> shown = stepsOf(scene, film);
    if (isStill(scene, film, shown))
      return {"nothing moves in this film", ""};
    const int frames = framesOf(scene, film, static_cast<int>(shown.size()));
    const std::string length = counted(frames, "frame") + ", " +
                               asDuration(static_cast<double>(frames) / std::max(1, film.rate));
    return {length, shown.empty() ? onlyStepOf(scene.keys, steps) : ""};
  }
  catch (const Failure& failure)
  {
    return {failure.what(), ""};
  }
}

std::string onlyStepOf(const std::vector<Settings>& frames, int steps)
{
  const auto& first = frames.front().data;
  const bool isOne = std::all_of(frames.begin(), frames.end(),
    [&](const Settings& one)
    { return one.data.step == first.step && one.data.time == first.time; });
  return steps < 2 || !isOne ? ""
                             : "all frames show one of " + std::to_string(steps) +
                                 " time steps; --steps all plays them, or 'all' at time steps";
}

std::vector<Settings> planFilm(const FilmScene& scene, const FilmSettings& film)
{
  const std::vector<int> steps = stepsOf(scene, film);
  if (isStill(scene, film, steps))
    throw Failure("nothing moves in this film: " + scene.name + " has " +
                  (scene.steps == 1 ? "one time step" : "one of its time steps shown") +
                  "; turn the camera by --orbit 360, or give --key-frames");
  const int frames = framesOf(scene, film, static_cast<int>(steps.size()));
  std::vector<Settings> all;
  for (int i = 0; i < frames; ++i)
  {
    const double share = frames > 1 ? static_cast<double>(i) / (frames - 1) : 0.0;
    Settings frame = between(scene.keys, share);
    const double place = share * static_cast<double>(scene.keys.size() - 1);
    const auto before = static_cast<std::size_t>(place);
    const std::size_t after = std::min(before + 1, scene.keys.size() - 1);
    int step = static_cast<int>(
      std::lround(scene.keySteps[before] + (place - static_cast<double>(before)) *
                                             (scene.keySteps[after] - scene.keySteps[before])));
    if (!steps.empty())
      step = steps[static_cast<std::size_t>(i) * steps.size() / static_cast<std::size_t>(frames)];
    frame.data.time.reset();
    frame.data.step = std::to_string(step + 1);
    // A full turn comes back to its first frame with the next one, when the film is repeated.
    if (film.orbit != 0.0)
      frame.camera.camera = turned(frame.camera.camera, scene.bounds, film.orbit * i / frames);
    all.push_back(std::move(frame));
  }
  return all;
}

} // namespace mote::app
