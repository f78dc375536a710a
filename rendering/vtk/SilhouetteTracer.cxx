#include "SilhouetteTracer.h"

#include "vtkMoteSilhouettes.h"

#include "kernels/tracing/RayCaster.h"

#include <algorithm>
#include <chrono>

namespace mote
{

namespace
{

using Clock = std::chrono::steady_clock;

/// Two planes side by side may be off either way, and are seen aslant.
constexpr double stepsPerError = 4.0;

double secondsSince(const Clock::time_point& start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

Scene withoutLight(const Scene& scene)
{
  Scene bare = scene;
  bare.clouds.clear();
  bare.lights.clear();
  bare.occlusion.rays = bare.paths.bounces = 0;
  return bare;
}

double stepOf(vtkMoteSilhouettes* silhouettes, const Scene& particles, double diagonal)
{
  constexpr double radiusOfNone = 1e-3; // of the diagonal
  const double threshold = silhouettes->GetThreshold();
  if (silhouettes->GetThresholdMode() == vtkMoteSilhouettes::WORLD)
    return threshold;
  if (silhouettes->GetThresholdMode() == vtkMoteSilhouettes::SCENE_SIZE)
    return threshold * diagonal;
  const double radius = typicalRadius(particles);
  return threshold * (radius > 0.0 ? radius : radiusOfNone * diagonal);
}

/// False where the name stands for nothing.
bool SilhouetteTracer::takeGroups(const std::string& name, const MoteProps& props)
{
  groups_ = {};
  std::vector<vtkDataArray*> arrays;
  for (const auto& prop : props)
    arrays.push_back(name.empty() ? nullptr : prop->particleArray(name.c_str()));
  const bool found =
    std::any_of(arrays.begin(), arrays.end(), [](vtkDataArray* array) { return array; });
  if (found)
    groups_.by = SilhouetteGroups::By::Value;
  else if (name == "object")
    groups_.by = SilhouetteGroups::By::Object;
  else if (name == "particle")
    groups_.by = SilhouetteGroups::By::Particle;
  if (!found)
    arrays.clear();
  values_.resize(arrays.size());
  viewed_.resize(arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    // Arrays that are not one piece of memory are copied: once, not every frame. MTimes tell arrays
    // apart, too.
    const vtkMTimeType time = arrays[i] ? arrays[i]->GetMTime() : 0;
    if (viewed_[i] != time)
      values_[i] = arrays[i] ? DataArrayView(arrays[i]) : DataArrayView();
    viewed_[i] = time;
    groups_.values.push_back(values_[i].view);
  }
  return found || name.empty() || groups_.by != SilhouetteGroups::By::Nothing;
}

void SilhouetteTracer::prepare(
  vtkMoteSilhouettes* silhouettes, const MoteProps& props, const Scene& scene, double distance)
{
  wanted_ = silhouettes && silhouettes->GetEnabled();
  if (!wanted_)
    return;
  const double* color = silhouettes->GetColor();
  color_ = {float(color[0]), float(color[1]), float(color[2])};
  const Box bounds = scene.bounds();
  const double diagonal = bounds.empty() ? 0.0 : glm::length(bounds.size());
  SilhouetteOptions options = silhouettes->MakeOptions(stepOf(silhouettes, scene, diagonal));
  options.thickness /= distance;
  // Steps between the planes that stand for triangles are none of the surface.
  options.stepInPixels = std::max(options.stepInPixels, stepsPerError * pixelsOfError(scene));
  const auto groupedBy = groups_.by;
  const auto viewed = viewed_;
  const std::string name = silhouettes->GetGroupArrayName();
  const std::string missed = this->takeGroups(name, props) ? std::string() : name;
  if (!missed.empty() && missed != reported_)
    vtkErrorWithObjectMacro(silhouettes,
      "There is no point array \"" << missed << "\" to draw silhouettes between its values.");
  reported_ = missed;
  if (options != options_ || groups_.by != groupedBy || viewed_ != viewed)
    this->clear();
  options_ = options;
}

void SilhouetteTracer::clear()
{
  silhouettes_.clear();
  tiles_.clear();
}

bool SilhouetteTracer::isBehind(int samples) const
{
  return wanted_ && silhouettes_.samples() < std::min(samples, SilhouetteFilm::mostSamples);
}

void SilhouetteTracer::add(const Film& film, const Camera& camera, const float* limits, int threads)
{
  const bool kept = (channels() & ~Film::LatestDepth) == 0 || film.has(Film::LatestId);
  const bool latest = film.samples() == 1 || film.has(Film::LatestDepth);
  if (!this->isBehind(film.samples()) || silhouettes_.samples() != film.samples() - 1 || !kept ||
      !latest)
    return;
  const auto start = Clock::now();
  silhouettes_.add(film, camera, options_, groups_, limits, threads);
  tiles_.clear();
  seconds_ += secondsSince(start);
}

bool SilhouetteTracer::catchUp(const Scene& scene, const Film& film, const Camera& camera,
  const float* limits, int threads, const Progress& progress)
{
  const auto start = Clock::now();
  if (tiles_.empty())
  {
    again_.resize(film.width(), film.height(), this->channels());
    again_.setSamples(silhouettes_.samples());
  }
  const Scene bare = withoutLight(scene);
  RayCaster caster(bare);
  caster.setThreads(threads);
  caster.setLimits(limits);
  const bool done = caster.addSample(camera, again_, progress, &tiles_);
  if (done)
    silhouettes_.add(again_, camera, options_, groups_, limits, threads);
  seconds_ += secondsSince(start);
  return done;
}

} // namespace mote
