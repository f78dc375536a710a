#pragma once

#include "MoteProp.h"

#include "kernels/core/Camera.h"
#include "kernels/core/Progress.h"
#include "kernels/scene/Scene.h"
#include "kernels/tracing/SeenParticles.h"

#include <cstdint>
#include <vector>

class vtkMoteShading;

namespace mote
{

/// The occlusion maps of a scene's particles: gives the scene those that the mappers have, and
/// bakes those that a view lacks. Does nothing where the shading asks for no maps.
///
/// Half-baked particles would look like data. So maps are shown once the view has all of them; till
/// then all particles have the light of those that no map knows. Where a view shows some more
/// than the one before, these alone look so.
class OcclusionBaking
{
public:
  /// Whether the shading asks for maps.
  static bool isAskedFor(vtkMoteShading* shading);

  /// Gives the objects of the scene, which are those of `props`, the maps that there are: brought
  /// up to date with particles and shading where `update`, else of particles that are as they were,
  /// or that come with maps of their own.
  /// Where all particles have one the scene needs no more rays for its ambient light.
  void take(Scene& scene, const MoteProps& props, vtkMoteShading* shading, bool update);

  /// Bakes what the view shows and no map knows, after take() with an update, and gives it to the
  /// scene. False where `progress` stopped it; what was baked until then stays, and counts.
  /// `number`, above 0, tells views apart that differ in more than maps: what has been found to be
  /// complete is not looked at again.
  bool bake(Scene& scene, const Camera& camera, const SeenView& view, std::uint64_t number,
    const Progress& progress);

  /// The share of the particles that the view shows, as bake() last found them, that maps know.
  double share() const { return share_; }
  /// Whether it is known what this view shows.
  bool hasSeen(std::uint64_t number) const { return seenIn_ == number; }

  /// Changes with the maps of the scene.
  const std::vector<double>& times() const { return times_; }

private:
  void give(Scene& scene);
  double shareOfSeen() const;

  std::vector<MapperOcclusion*> maps_; ///< a surface of the scene each, or null
  std::vector<double> times_;
  std::uint64_t seenIn_ = 0; ///< view that seen_ was found in
  SeenParticles seen_;
  std::uint64_t completeIn_ = 0; ///< view that maps of completeTimes_ had all of
  std::vector<double> completeTimes_;
  double share_ = 1.0;
  bool isShown_ = false; ///< what is baked, where more is to come
  std::vector<std::shared_ptr<const OcclusionMaps>> blank_; ///< in place of maps not shown
};

} // namespace mote
