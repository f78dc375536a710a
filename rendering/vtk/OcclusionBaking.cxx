#include "OcclusionBaking.h"

#include "MapperOcclusion.h"
#include "vtkMoteShading.h"

#include <algorithm>

namespace mote
{

namespace
{

constexpr double castingShare = 0.05; ///< of the progress, until it is known what is seen

} // namespace

bool OcclusionBaking::isAskedFor(vtkMoteShading* shading)
{
  return shading && shading->GetMode() == vtkMoteShading::LOCAL &&
         shading->GetAmbientOcclusion() == vtkMoteShading::OCCLUSION_BAKED;
}

void OcclusionBaking::take(
  Scene& scene, const MoteProps& props, vtkMoteShading* shading, bool update)
{
  maps_.clear();
  times_.clear();
  if (!isAskedFor(shading))
    return;
  OcclusionRequest request;
  request.options.side = shading->GetBakeSide();
  request.options.samples = shading->GetBakeSamples();
  request.options.adaptive = shading->GetBakeAdaptive() != 0;
  request.options.tolerance = shading->GetBakeTolerance();
  request.reachChosen = shading->GetAmbientOcclusionReach() > 0.0;
  request.isMoving = !update;
  const double reach = scene.surfaces.empty() ? 0.0 : occlusionReach(scene);
  for (const SurfaceObject& object : scene.surfaces)
  {
    const double scale = scaleOf(object.toWorld);
    request.options.reach = reach / scale;
    const MoteProp& prop = *props[static_cast<std::size_t>(object.id)];
    maps_.push_back(scale > 0.0 ? prop.occlusion(&request) : nullptr);
  }
  this->give(scene);
}

void OcclusionBaking::give(Scene& scene)
{
  times_.clear();
  bool complete = true;
  for (std::size_t i = 0; i < maps_.size(); ++i)
  {
    scene.surfaces[i].occlusion = maps_[i] ? maps_[i]->maps() : nullptr;
    // Maps are of particles: nothing stands for these.
    if (const auto* particles = std::get_if<ParticleSurface>(&scene.surfaces[i].surface);
        maps_[i] && particles)
      scene.surfaces[i].surface = ParticleSurface(particles->structure());
    complete = complete && maps_[i] && maps_[i]->complete();
    times_.push_back(maps_[i] ? static_cast<double>(maps_[i]->time()) : 0.0);
  }
  if (complete)
    scene.occlusion.rays = 0;
}

bool OcclusionBaking::bake(Scene& scene, const Camera& camera, const SeenView& view,
  std::uint64_t number, const Progress& progress)
{
  const auto has = [](MapperOcclusion* maps) { return !maps || maps->complete(); };
  if (std::all_of(maps_.begin(), maps_.end(), has) ||
      (completeIn_ == number && completeTimes_ == times_))
    return true;
  const auto part = [&](double begin, double share)
  {
    return [&progress, begin, share](double done)
    { return !progress || progress(begin + share * done); };
  };
  if (seenIn_ != number)
  {
    seenIn_ = 0;
    if (!findSeenParticles(scene, camera, view, seen_, part(0.0, castingShare)))
      return false;
    seenIn_ = number;
  }
  bool finished = true;
  const double share = (1.0 - castingShare) / static_cast<double>(maps_.size());
  for (std::size_t i = 0; i < maps_.size() && finished; ++i)
    if (const auto* particles = std::get_if<ParticleSurface>(&scene.surfaces[i].surface);
        particles && maps_[i] && !maps_[i]->complete())
      finished = maps_[i]->bake(*particles->structure(), seen_[i],
        part(castingShare + share * static_cast<double>(i), share));
  this->give(scene);
  if (finished)
  {
    completeIn_ = number;
    completeTimes_ = times_;
  }
  return finished;
}

} // namespace mote
