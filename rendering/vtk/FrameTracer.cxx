#include "FrameTracer.h"

#include "SceneBridge.h"

#include "kernels/core/FilmFill.h"
#include "kernels/tracing/RayCaster.h"

#include "vtkRenderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

namespace mote
{

namespace
{

/// What a cloud's colour may be wrong by in a draft, between traced pixels and along a ray.
constexpr double draftTolerance = 0.02, draftRayTolerance = 0.005;

/// Samples of a film whose rays find what a view shows: few particles first show up later.
constexpr int seenSamples = 4;

/// Seconds that a frame of a progressive picture bakes, once it is known what is seen.
constexpr double leastBakingTime = 0.25;

/// A first film that takes so many times as long as it should is given up.
constexpr double patience = 3.0;

/// How much finer each film of a progressive picture is than the one before, each way, at least:
/// nine times the rays, so that all before the last take an eighth of its time.
constexpr double finerBy = 3.0;

/// How much finer a film must be to be traced in place of one that is there.
constexpr double leastFiner = 1.5;

/// Distances of rays, in pixels.
constexpr double distances[] = {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0};
constexpr double coarsest = 32.0;

/// From one distance of a moving picture to the next coarser one: 84 % of the rays.
constexpr double finerStep = 1.0905077; // 32 in 40 steps

constexpr double forever = std::numeric_limits<double>::infinity();

/// Share of the progress that baking takes where there is any.
constexpr double bakingShare = 0.5;

/// Seconds after which a progressive frame at rest shows what there is.
double restingTime(const FrameSettings& settings)
{
  return std::max(settings.frameTime, settings.stillTime);
}

/// How far apart rays may be, in pixels.
double mostDistance(const FrameSettings& settings)
{
  return settings.interactive ? std::min(settings.mostDistance, coarsest) : coarsest;
}

/// Whether there is much work for each of the camera's rays.
bool takesLong(const Scene& scene)
{
  return !scene.clouds.empty() || scene.occlusion.rays > 0 || scene.paths.bounces > 0 ||
         std::any_of(scene.lights.begin(), scene.lights.end(),
           [](const Light& light) { return light.shadows && light.samples > 1; });
}

/// Leaves local shading with one ray a light, and clouds, where they may be rough, as they are good
/// enough to move in.
void makeDraft(Scene& scene, bool rough)
{
  if (rough)
    scene.cloudTolerance = std::max(scene.cloudTolerance, draftTolerance);
  for (CloudObject& cloud : scene.clouds)
    if (rough)
      cloud.sampling.tolerance = std::max(cloud.sampling.tolerance, draftRayTolerance);
  scene.occlusion.isAssumed = scene.occlusion.rays > 0; // or it would be brighter than the last
  scene.occlusion.rays = scene.paths.bounces = 0;
  for (Light& light : scene.lights)
    light.samples = 1;
}

} // namespace

std::vector<vtkMTimeType> timesOf(const MoteProps& props)
{
  std::vector<vtkMTimeType> times;
  for (const auto& prop : props)
  {
    const std::vector<vtkMTimeType> own = prop->times();
    times.insert(times.end(), own.begin(), own.end());
  }
  return times;
}

/// One call of trace(): what it works on, and how long.
struct FrameTracer::Frame
{
  using Clock = std::chrono::steady_clock;

  vtkRenderer* renderer;
  const MoteProps& props;
  const int width, height;
  const FrameSettings& settings;
  const Progress& progress;
  Scene scene{};
  bool slow = false;
  double baked = 0.0;   ///< share of the progress that baking took
  double end = forever; ///< seconds() at which tracing stops between two tiles
  bool canStop = true;  ///< where `progress` wants it
  std::atomic<bool> stopped{false};

  // Of the film that is traced, once aimed.
  bool aimed = false;
  Camera camera{};
  Scene traced{}; ///< the scene, or a draft of it
  std::vector<float> limits{};
  std::vector<float> spared{}; ///< the limits, and where rays are spared for ghosts

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
  void startClock() { start = Clock::now(); }

  /// To be asked between tiles, on any thread.
  bool goesOn(double done)
  {
    if (canStop && progress && std::this_thread::get_id() == caller && !progress(done))
      stopped = true;
    return !stopped && seconds() < end;
  }

  Camera cameraFor(int columns, int rows) const
  {
    return cameraOf(renderer, double(width) / height, columns, rows);
  }

  /// The distances at which rays of an image end, or null; valid until the next call.
  const float* limitsFor(int columns, int rows)
  {
    if (!settings.others)
      return nullptr;
    limits = settings.others->resampled(columns, rows);
    return limits.data();
  }

  void aim(const Film& film, bool draft)
  {
    if (aimed)
      return;
    aimed = true;
    camera = cameraFor(film.width(), film.height());
    limitsFor(film.width(), film.height());
    traced = scene;
    if (draft)
      makeDraft(traced, settings.roughDrafts);
  }
  const float* ends() const { return settings.others ? limits.data() : nullptr; }

  const std::thread::id caller = std::this_thread::get_id();
  Clock::time_point start = Clock::now();
};

int FrameTracer::samples() const
{
  return film_.samples() > 0 ? film_.samples() : int(shows_);
}

double FrameTracer::finerShare() const
{
  if (film_.samples() > 0 || !shows_)
    return 0.0;
  return double(pixelsDone(tiles_, film_.width(), film_.height())) / double(film_.pixels());
}

double FrameTracer::noise() const
{
  return film_.has(Film::Variance) ? standardError(film_) : std::numeric_limits<double>::infinity();
}

/// The least distance of rays at which a film takes no longer than so many seconds, most likely.
double FrameTracer::distanceFor(const Frame& frame, double seconds) const
{
  if (!frame.settings.autoAdjust)
    return 1.0;
  const double full = double(frame.width) * frame.height, rays = cost_.raysFor(seconds);
  const double most = mostDistance(frame.settings);
  double distance = 1.0;
  // Steps as fine as a frame's time is to be met.
  while (distance < most && full / (distance * distance) > rays)
    distance *= finerStep;
  return std::min(distance, most);
}

bool FrameTracer::lacksChannels(const FrameSettings& settings) const
{
  return isLast() && ((settings.refinement.channels() | settings.channels) & ~channels_) != 0;
}

/// Whether the film has all that is wanted of it, silhouettes apart.
bool FrameTracer::isDone(const FrameSettings& settings) const
{
  return isLast() && !lacksChannels(settings) && settings.refinement.isDone(film_);
}

/// Makes the film show nothing.
bool FrameTracer::forget(int width, int height, const FrameSettings& settings)
{
  film_.resize(std::max(1, width), std::max(1, height), settings.channels);
  fillWithNothing(film_);
  silhouettes_.clear();
  ghosts_ = {};
  distance_ = shownDistance_ = 1.0;
  shows_ = false;
  return false;
}

bool FrameTracer::trace(vtkRenderer* renderer, MoteProps& props, int width, int height,
  const FrameSettings& settings, const Progress& progress)
{
  seconds_ = 0.0;
  rays_ = 0;
  converged_ = false;
  if (!settings.interactive)
    bakedShare_ = 1.0;
  const auto before = std::exchange(shown_, {}); // where something throws nothing counts
  Frame frame{renderer, props, width, height, settings, progress};
  frame.scene = sceneOf(renderer, props, settings.shading);
  preview_ =
    std::any_of(props.begin(), props.end(), [](const auto& prop) { return prop->isPreview(); });
  if (props.empty() || width < 1 || height < 1)
    return forget(width, height, settings);
  const Camera viewed = frame.cameraFor(width, height);
  const bool moving = settings.interactive;
  const bool isSame = this->takeView({width, height, viewed, frame.scene.unowned(),
    settings.others ? settings.others->hash : ContentHash()});
  const bool rested = !settings.progressive || isSame;
  const bool refines = settings.refines || !settings.progressive || !shows_ || !isSame;
  baking_.take(frame.scene, props, settings.shading, !moving);
  const auto hadMaps = baking_.times();
  bool complete = moving || !OcclusionBaking::isAskedFor(settings.shading);
  if (!complete && rested && refines && !bake(frame, viewed, complete))
  {
    shown_ = before;
    return shows_ && before.view == view_;
  }
  const Shown shown{view_, baking_.times()};
  const bool changed = shown != before;
  // Where only maps are new, the film is shown on, and gone over.
  const bool onlyBaked = before.view == view_ && (complete ? hadMaps != baking_.times() : !moving);
  shows_ = shows_ && (!changed || onlyBaked);
  frame.slow = takesLong(frame.scene) || !complete;
  frame.startClock();
  silhouettes_.startFrame();
  silhouettes_.prepare(settings.silhouettes, props, frame.scene, distance_);
  const bool coarse =
    moving && distanceFor(frame, settings.frameTime) * leastFiner <= shownDistance_;
  if ((moving || settings.progressive) && (!shows_ || coarse))
    traceFirst(frame);
  else if (!moving && complete && (refines || changed))
    sharpen(frame, changed);
  else if (!moving && refines)
    keepUp(frame, changed);
  if (refines || changed)
    addSilhouettes(frame, film_.samples());
  converged_ = complete && !preview_ && isDone(settings) && !silhouettes_.isBehind(film_.samples());
  shown_ = shown;
  ghosts_.find(seen_.samples() > 0 ? seen_ : film_, film_, silhouettes_.layer(), props);
  return shows_;
}

/// Counts the views that differ; answers whether this is the last one again.
bool FrameTracer::takeView(View view)
{
  const bool isSame = viewed_ && *viewed_ == view;
  if (!isSame)
    ++view_;
  viewed_ = std::move(view);
  return isSame;
}

/// Bakes what the view lacks; for a moment where the picture is progressive. `complete` tells
/// whether nothing is left; false where `progress` stopped it.
bool FrameTracer::bake(Frame& frame, const Camera& camera, bool& complete)
{
  const FrameSettings& settings = frame.settings;
  SeenView view{frame.width, frame.height, std::min(settings.refinement.samples, seenSamples)};
  view.threads = settings.threads;
  view.limits = frame.limitsFor(frame.width, frame.height);
  bakingTime_ = std::max(bakingTime_, leastBakingTime);
  frame.end = settings.progressive ? frame.seconds() + bakingTime_ : forever;
  frame.baked = bakingShare;
  complete = baking_.bake(frame.scene, camera, view, view_,
    [&](double done) { return frame.goesOn(bakingShare * done); });
  bakedShare_ = complete ? 1.0 : baking_.share();
  // What is seen is looked for anew where the time was too short for it.
  bakingTime_ = complete || frame.stopped || baking_.hasSeen(view_) ? 0.0 : 2.0 * bakingTime_;
  return !frame.stopped;
}

/// Begins a film of rays at this distance, as an enlarged copy of what is shown, if anything is.
void FrameTracer::begin(Frame& frame, double distance, bool draft)
{
  const FrameSettings& settings = frame.settings;
  Film before;
  if (shows_)
  {
    silhouettes_.layer().drawOver(film_.height(), film_.color());
    std::swap(before, film_);
    ++version_;
  }
  silhouettes_.clear();
  silhouettes_.prepare(settings.silhouettes, frame.props, frame.scene, distance);
  channels_ = draft ? 0u : settings.refinement.channels() | settings.channels;
  film_.resize(std::max(1, int(std::ceil(frame.width / distance))),
    std::max(1, int(std::ceil(frame.height / distance))),
    channels_ | silhouettes_.channels() | GhostPixels::channels(frame.props));
  if (shows_)
    fillFrom(before, film_);
  tiles_.clear();
  seen_ = {};
  distance_ = distance;
  draft_ = draft;
  frame.aimed = false;
}

/// The distance of the film that comes after one that is not the last.
double FrameTracer::nextDistance() const
{
  double finer = 1.0;
  for (const double distance : distances)
    if (distance * finerBy <= distance_)
      finer = distance;
  return finer;
}

/// Begins the film that comes after the present one.
void FrameTracer::beginNext(Frame& frame, bool last)
{
  const double finer = last ? 1.0 : nextDistance();
  begin(frame, finer, finer > 1.0 && frame.slow);
}

/// Traces the first film of what has changed, as fine as the time allows.
void FrameTracer::traceFirst(Frame& frame)
{
  const FrameSettings& settings = frame.settings;
  const double time = settings.interactive ? settings.frameTime : restingTime(settings);
  frame.canStop = false;
  double distance = distanceFor(frame, time);
  for (;;)
  {
    shows_ = false;
    rays_ = 0;
    begin(frame, distance, frame.slow);
    const double start = frame.seconds();
    frame.end =
      settings.autoAdjust && distance < mostDistance(settings) ? start + patience * time : forever;
    const bool complete = addSample(frame);
    cost_.learn(frame.seconds() - start, double(std::max(1LL, rays_)), complete);
    const double next = distanceFor(frame, time - frame.seconds());
    if (complete && next * leastFiner > distance)
      return;
    distance = complete ? next : std::min(std::max(next, 2.0 * distance), mostDistance(settings));
  }
}

/// Traces what the film at rest lacks: finer ones, samples. `anew`: the film itself does not count.
void FrameTracer::sharpen(Frame& frame, bool anew)
{
  const FrameSettings& settings = frame.settings;
  const bool bits = settings.progressive;
  frame.end = bits ? restingTime(settings) : forever;
  while (!frame.stopped && (anew || !isDone(settings)))
  {
    if (anew || lacksChannels(settings) || (film_.samples() > 0 && !isLast()))
      beginNext(frame, anew || !bits);
    anew = false;
    // Lines first: they must not vanish tile by tile until the sample is complete.
    if (bits && film_.samples() == 0 && !addSilhouettes(frame, 1))
      return;
    const double start = frame.seconds();
    if (!addSample(frame) || (bits && 2.0 * frame.seconds() - start > settings.frameTime))
      return;
  }
}

/// Goes over what is shown while more is baked: finer where it is coarse, and with the maps of now
/// where these have `changed`.
void FrameTracer::keepUp(Frame& frame, bool changed)
{
  if (film_.samples() > 0 && distance_ == 1.0 && !changed)
    return;
  frame.end = restingTime(frame.settings);
  do
  {
    if (film_.samples() > 0)
      begin(frame, nextDistance(), frame.slow);
    if (!addSilhouettes(frame, 1))
      return;
  } while (addSample(frame) && distance_ > 1.0);
}

/// Ends rays at once through pixels of ghosts where rays take long; false where it has not.
bool FrameTracer::spareGhosts(Frame& frame)
{
  frame.spared.clear();
  if (GhostPixels::channels(frame.props) == 0 || !takesLong(frame.traced))
    return false;
  if (seen_.samples() == 0)
  {
    seen_.resize(film_.width(), film_.height(), GhostPixels::channels(frame.props));
    const Scene bare = withoutLight(frame.traced);
    RayCaster caster(bare);
    caster.setThreads(frame.settings.threads);
    caster.setLimits(frame.ends());
    caster.addSample(frame.camera, seen_);
  }
  ghosts_.find(seen_, seen_, {}, frame.props);
  frame.spared = ghosts_.spared(seen_, frame.ends(), silhouettes_.reach());
  return true;
}

/// Traces the film's next sample, or the rest of it. False where it is not complete.
bool FrameTracer::addSample(Frame& frame)
{
  frame.aim(film_, draft_);
  const FrameSettings& settings = frame.settings;
  const Refinement refinement = isLast() ? settings.refinement : Refinement{1};
  const double done = refinement.progress(film_);
  const double step = (1.0 - done) / std::max(1, refinement.samples - film_.samples());
  const auto pixels = [&] { return pixelsDone(tiles_, film_.width(), film_.height()); };
  const double start = frame.seconds();
  const std::size_t had = pixels();
  const bool areSpared = this->spareGhosts(frame);
  RayCaster caster(frame.traced);
  caster.setThreads(settings.threads);
  caster.setLimits(areSpared ? frame.spared.data() : frame.ends());
  const bool complete = caster.addSample(
    frame.camera, film_,
    [&](double part)
    { return frame.goesOn(frame.baked + (1.0 - frame.baked) * (done + part * step)); },
    &tiles_);
  rays_ += static_cast<long long>((complete ? film_.pixels() : pixels()) - had);
  ++version_;
  if (complete)
  {
    if (!areSpared) // whose film lacks depths; addSilhouettes() casts rays for them
      silhouettes_.add(film_, frame.camera, frame.ends(), settings.threads);
    shows_ = true;
    shownDistance_ = distance_;
  }
  seconds_ += frame.seconds() - start;
  return complete;
}

/// Finds the silhouettes of the film's first samples where they are not found yet. False where some
/// are left.
bool FrameTracer::addSilhouettes(Frame& frame, int samples)
{
  const FrameSettings& settings = frame.settings;
  while (silhouettes_.isBehind(samples))
  {
    frame.aim(film_, draft_);
    const double start = frame.seconds();
    const bool complete = silhouettes_.catchUp(frame.traced, film_, frame.camera, frame.ends(),
      settings.threads, [&](double part) { return frame.goesOn(part); });
    seconds_ += frame.seconds() - start;
    if (!complete)
      return false;
    rays_ += static_cast<long long>(film_.pixels());
    ++version_;
    if (settings.progressive && frame.seconds() > settings.frameTime)
      break;
  }
  return !silhouettes_.isBehind(samples);
}

} // namespace mote
