#pragma once

#include "MoteProp.h"

#include "kernels/core/Camera.h"
#include "kernels/core/Progress.h"
#include "kernels/scene/Scene.h"
#include "kernels/tracing/SeenParticles.h"

#include <optional>
#include <vector>

class vtkMoteShading;

namespace mote
{

/// The occlusion maps of a scene's particles: gives the scene those that the mappers have, and
/// bakes those that a view lacks. Does nothing where the shading asks for no maps.
class OcclusionBaking
{
public:
  /// Whether the shading asks for maps.
  static bool isAskedFor(vtkMoteShading* shading);

  /// Gives the objects of the scene, which are those of `props`, the maps that there are: brought
  /// up to date with particles and shading where `update`, else of particles that are as they were.
  /// Where all particles have one the scene needs no more rays for its ambient light.
  void take(Scene& scene, const MoteProps& props, vtkMoteShading* shading, bool update);

  /// Bakes what the view shows and no map knows, after take() with an update, and gives it to the
  /// scene. False where `progress` stopped it; what was baked until then stays, and counts. `key`
  /// is all that the view depends on but maps: what has been found to be complete is not looked at
  /// again.
  bool bake(Scene& scene, const Camera& camera, const SeenView& view,
    const std::vector<double>& key, const Progress& progress);

  /// Changes with the maps of the scene.
  const std::vector<double>& times() const { return times_; }

private:
  void give(Scene& scene);

  std::vector<MapperOcclusion*> maps_; ///< a surface of the scene each, or null
  std::vector<double> times_;
  std::optional<std::vector<double>> seenKey_; ///< of seen_
  SeenParticles seen_;
  std::optional<std::vector<double>>
    completeKey_; ///< of a view, and the times of maps that had all of it
};

} // namespace mote
