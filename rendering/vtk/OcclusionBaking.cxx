#include "OcclusionBaking.h"

#include "MapperOcclusion.h"
#include "vtkMoteShading.h"

#include <algorithm>
#include <bit>

namespace mote
{

namespace
{

constexpr double castingShare = 0.05; ///< of the progress, until it is known what is seen

/// A view of whose particles a lesser share is baked shows no maps.
constexpr double leastShown = 0.5;

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
  blank_.resize(maps_.size());
  bool complete = true;
  for (std::size_t i = 0; i < maps_.size(); ++i)
  {
    const auto known = maps_[i] ? maps_[i]->maps() : nullptr;
    const bool isShown = isShown_ || !known || maps_[i]->complete();
    if (!isShown && (!blank_[i] || blank_[i]->size() != known->size()))
      blank_[i] = std::make_shared<const OcclusionMaps>(known->size(), known->sky());
    scene.surfaces[i].occlusion = isShown ? known : blank_[i];
    // Maps are of particles: nothing stands for these.
    if (const auto* particles = std::get_if<ParticleSurface>(&scene.surfaces[i].surface);
        maps_[i] && particles)
      scene.surfaces[i].surface = ParticleSurface(particles->structure());
    complete = complete && maps_[i] && maps_[i]->complete();
    times_.push_back(!isShown ? -1.0 : known ? static_cast<double>(maps_[i]->time()) : 0.0);
  }
  if (complete)
    scene.occlusion.rays = 0;
}

double OcclusionBaking::shareOfSeen() const
{
  std::size_t seen = 0, baked = 0;
  for (std::size_t i = 0; i < maps_.size() && i < seen_.size(); ++i)
  {
    const auto maps = maps_[i] ? maps_[i]->maps() : nullptr;
    for (std::size_t word = 0; maps && word < seen_[i].size(); ++word)
      for (std::uint64_t bits = seen_[i][word]; bits != 0; bits &= bits - 1)
      {
        const std::size_t slot = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
        ++seen;
        baked += slot < maps->size() && maps->isBaked(slot) ? 1 : 0;
      }
  }
  return seen > 0 ? static_cast<double>(baked) / static_cast<double>(seen) : 0.0;
}

bool OcclusionBaking::bake(Scene& scene, const Camera& camera, const SeenView& view,
  std::uint64_t number, const Progress& progress)
{
  const auto has = [](MapperOcclusion* maps) { return !maps || maps->complete(); };
  share_ = 1.0;
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
    share_ = 0.0;
    if (!findSeenParticles(scene, camera, view, seen_, part(0.0, castingShare)))
      return false;
    seenIn_ = number;
    isShown_ = isShown_ && this->shareOfSeen() >= leastShown;
  }
  bool finished = true;
  const double share = (1.0 - castingShare) / static_cast<double>(maps_.size());
  for (std::size_t i = 0; i < maps_.size() && finished; ++i)
    if (const auto* particles = std::get_if<ParticleSurface>(&scene.surfaces[i].surface);
        particles && maps_[i] && !maps_[i]->complete())
      finished = maps_[i]->bake(*particles->structure(), seen_[i],
        part(castingShare + share * static_cast<double>(i), share));
  isShown_ = isShown_ || finished;
  this->give(scene);
  share_ = finished ? 1.0 : this->shareOfSeen();
  if (finished)
  {
    completeIn_ = number;
    completeTimes_ = times_;
  }
  return finished;
}

} // namespace mote
