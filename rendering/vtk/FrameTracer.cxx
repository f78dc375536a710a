#include "FrameTracer.h"

#include "SceneBridge.h"

#include "kernels/tracing/RayCaster.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace mote
{

namespace
{

void add(std::vector<double>& s, const Vec3d& v)
{
  s.insert(s.end(), {v.x, v.y, v.z});
}

/// Everything that the picture depends on but its resolution. MTimes are exact in a double.
std::vector<double> signatureOf(const MoteProps& props, const Camera& camera, const Scene& scene,
  const WindowDepth* others, int width, int height)
{
  std::vector<double> s = {double(width), double(height), double(camera.projection),
    camera.viewAngle, camera.parallelScale, camera.centerX, camera.centerY, camera.nearDistance,
    camera.farDistance};
  add(s, camera.position);
  add(s, camera.forward);
  add(s, camera.up);
  for (const Light& light : scene.lights)
  {
    s.push_back(double(light.kind));
    add(s, light.vector);
    add(s, Vec3d(light.color));
    s.insert(s.end(), {double(light.shadows), double(light.samples), light.size});
  }
  s.insert(s.end(), {double(scene.occlusion.rays), scene.occlusion.reach,
                      double(scene.paths.bounces), scene.cloudTolerance});
  add(s, Vec3d(scene.sky.top));
  add(s, Vec3d(scene.sky.bottom));
  add(s, scene.sky.up);
  for (const auto& prop : props)
  {
    s.push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop->prop())));
    for (const vtkMTimeType time : prop->times())
      s.push_back(static_cast<double>(time));
    const Mat4d toWorld = placementOf(prop->prop());
    for (int column = 0; column < 4; ++column)
      add(s, Vec3d(toWorld[column]));
  }
  if (others)
    for (const std::uint64_t half : {others->hash.low, others->hash.high})
      s.insert(s.end(), {double(half >> 32U), double(half & 0xffffffffU)});
  return s;
}

/// What a cloud's colour may be wrong by while the view moves.
constexpr double draftTolerance = 0.02;

/// Samples of a film whose rays find what a view shows: few particles first show up later.
constexpr int seenSamples = 4;

/// Seconds that a frame of a progressive picture bakes.
constexpr double bakingTime = 0.25;

/// Whether there is much work for each of the camera's rays.
bool takesLong(const Scene& scene)
{
  return !scene.clouds.empty() || scene.occlusion.rays > 0 || scene.paths.bounces > 0 ||
         std::any_of(scene.lights.begin(), scene.lights.end(),
           [](const Light& light) { return light.shadows && light.samples > 1; });
}

/// Leaves local shading with one ray a light, and clouds as they are good enough to move in.
void makeDraft(Scene& scene)
{
  scene.cloudTolerance = std::max(scene.cloudTolerance, draftTolerance);
  scene.occlusion.rays = scene.paths.bounces = 0;
  for (Light& light : scene.lights)
    light.samples = 1;
}

} // namespace

double FrameTracer::distanceFor(int width, int height, const FrameSettings& settings) const
{
  if (!settings.interactive || !settings.autoAdjust)
    return 1.0;
  const double full = secondsPerRay_ * width * height;
  for (const double distance : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0})
    if (full / (distance * distance) <= settings.frameTime)
      return distance;
  return 8.0;
}

double FrameTracer::noise() const
{
  return film_.has(Film::Variance) ? standardError(film_) : std::numeric_limits<double>::infinity();
}

void FrameTracer::begin(const std::vector<double>& signature, double distance, bool draft,
  const Refinement& refinement, int width, int height)
{
  signature_ = signature;
  distance_ = distance;
  draft_ = draft;
  film_.resize(std::max(1, int(std::ceil(width / distance))),
    std::max(1, int(std::ceil(height / distance))),
    (draft ? 0u : refinement.channels()) | edges_.channels());
  edges_.clear();
}

bool FrameTracer::trace(vtkRenderer* renderer, MoteProps& props, int width, int height,
  const FrameSettings& settings, const Progress& progress)
{
  seconds_ = 0.0;
  rays_ = 0;
  Scene scene = sceneOf(renderer, props, settings.shading);
  preview_ =
    std::any_of(props.begin(), props.end(), [](const auto& prop) { return prop->isPreview(); });
  if (props.empty() || width < 1 || height < 1)
  {
    signature_.clear();
    return false;
  }
  const double aspect = double(width) / height;
  const Camera viewed = cameraOf(renderer, aspect, width, height);
  const auto view = signatureOf(props, viewed, scene, settings.others, width, height);
  const bool moving = settings.interactive;
  const bool rested = !settings.progressive || view == view_;
  view_ = view;
  baking_.take(scene, props, settings.shading, !moving);
  const auto hadMaps = baking_.times();
  bool complete = moving || !OcclusionBaking::isAskedFor(settings.shading);
  if (!complete && rested && !bake(scene, viewed, width, height, settings, progress, complete))
  {
    signature_.clear();
    return false;
  }
  auto signature = view;
  signature.insert(signature.end(), baking_.times().begin(), baking_.times().end());
  const double wanted = distanceFor(width, height, settings);
  const bool slow = takesLong(scene) || !complete;
  const bool justBaked = complete && hadMaps != baking_.times();
  const bool changed = signature != signature_ || distance_ > wanted;
  const bool worse =
    !moving && complete && film_.samples() > 0 &&
    (draft_ || (settings.refinement.channels() != 0 && !film_.has(Film::Variance)));
  edges_.prepare(settings.silhouettes, props, scene, changed || worse ? wanted : distance_);
  if (changed || worse)
    begin(signature, wanted, changed && slow && !justBaked && (moving || settings.progressive),
      settings.refinement, width, height);
  if (draft_)
    makeDraft(scene);

  const Camera camera = cameraOf(renderer, aspect, film_.width(), film_.height());
  std::vector<float> limits;
  if (settings.others)
    limits = settings.others->resampled(film_.width(), film_.height());
  const float* ends = settings.others ? limits.data() : nullptr;
  if (!addSamples(scene, camera, settings, ends, progress))
  {
    signature_.clear();
    return false;
  }
  // A still picture with all its rays says nothing about the next that moves.
  if (rays_ > 0 && (draft_ || !slow))
    secondsPerRay_ = seconds_ / static_cast<double>(rays_);
  const bool finished = addEdges(scene, camera, settings, ends, progress);
  converged_ = distance_ == 1.0 && !draft_ && !preview_ && complete &&
               settings.refinement.isDone(film_) && !edges_.isBehind(film_);
  return finished;
}

/// Bakes what the view lacks; for a moment where the picture is progressive. `complete` tells
/// whether nothing is left; false where `progress` stopped it.
bool FrameTracer::bake(Scene& scene, const Camera& camera, int width, int height,
  const FrameSettings& settings, const Progress& progress, bool& complete)
{
  std::vector<float> limits;
  SeenView view{width, height, std::min(settings.refinement.samples, seenSamples)};
  view.threads = settings.threads;
  if (settings.others)
  {
    limits = settings.others->resampled(width, height);
    view.limits = limits.data();
  }
  const auto caller = std::this_thread::get_id();
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(bakingTime);
  std::atomic<bool> stopped{false};
  complete = baking_.bake(scene, camera, view, view_,
    [&](double done)
    {
      if (progress && std::this_thread::get_id() == caller && !progress(done))
        stopped = true;
      return !stopped && (!settings.progressive || Clock::now() < end);
    });
  return !stopped;
}

bool FrameTracer::addSamples(const Scene& scene, const Camera& camera,
  const FrameSettings& settings, const float* limits, const Progress& progress)
{
  Refinement refinement = settings.refinement;
  if (settings.interactive || draft_)
    refinement = {1};
  const auto caller = std::this_thread::get_id();
  RayCaster caster(scene);
  caster.setThreads(settings.threads);
  caster.setLimits(limits);
  const auto start = std::chrono::steady_clock::now();
  while (!refinement.isDone(film_))
  {
    const double done = refinement.progress(film_);
    const double step = (1.0 - done) / std::max(1, refinement.samples - film_.samples());
    const bool complete = caster.addSample(camera, film_,
      [&](double part) {
        return !progress || std::this_thread::get_id() != caller || progress(done + part * step);
      });
    if (!complete)
      return false;
    edges_.add(film_, camera, limits, settings.threads);
    rays_ += static_cast<long long>(film_.pixels());
    ++version_;
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (settings.progressive &&
        seconds_ + seconds_ / std::max(1, film_.samples()) > settings.frameTime)
      break;
  }
  return true;
}

/// Finds the edges of the film's samples where they are not found yet.
bool FrameTracer::addEdges(const Scene& scene, const Camera& camera, const FrameSettings& settings,
  const float* limits, const Progress& progress)
{
  const auto caller = std::this_thread::get_id();
  const double before = seconds_;
  const auto start = std::chrono::steady_clock::now();
  while (edges_.isBehind(film_))
  {
    const bool complete = edges_.catchUp(scene, film_, camera, limits, settings.threads,
      [&](double part)
      { return !progress || std::this_thread::get_id() != caller || progress(part); });
    if (!complete)
      return false;
    rays_ += static_cast<long long>(film_.pixels());
    ++version_;
    seconds_ =
      before + std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (settings.progressive && seconds_ > settings.frameTime)
      break;
  }
  return true;
}

} // namespace mote
