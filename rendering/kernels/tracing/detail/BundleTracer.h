#pragma once

#include "../../core/Camera.h"
#include "../../core/Film.h"
#include "BundleClouds.h"
#include "CameraCasts.h"
#include "HitsBehind.h"
#include "PathTracer.h"

#include <vector>

namespace mote
{

/// Traces one sample of a film, a bundle of rays at a time: finds the hits, shades them, and writes
/// them into the film. Made once before the tiles; threads may trace different tiles at a time.
class BundleTracer
{
public:
  /// Scene and film must outlive the tracer. `side` of the bundles in pixels is 2, 4, 8 or 16, or
  /// 0 to take, in each tile, the smallest that the surfaces of the scene suggest. `limits` as in
  /// RayCaster::setLimits().
  BundleTracer(
    const Scene& scene, const Camera& camera, Film& film, int side, const float* limits = nullptr);

  /// Traces the pixels of the square of `size` (a multiple of 16) at (x0, y0) that are in the film.
  void traceTile(int x0, int y0, int size) const;

private:
  struct Bundle;

  void traceBundle(Bundle& bundle, int side, int x0, int y0) const;
  void shadeBundle(Bundle& bundle, int side, int x0, int y0) const;
  template <typename Take>
  void shadeHits(Bundle& bundle, RayBundle& rays, int side, int x0, int y0, const Take& take) const;
  void addBehind(Bundle& bundle, int side, int x0, int y0) const;
  std::vector<PassingRay> passingRays(const Bundle& bundle, int x0, int y0) const;
  BundleClouds::Place placeOf(const Bundle& bundle, int i, int x0, int y0) const;
  void addClouds(Bundle& bundle, int side, int x0, int y0) const;
  void addCloudsBetween(Bundle& bundle, int side, int x0, int y0) const;
  void addCloudsBehind(Bundle& bundle, const std::vector<PassingRay>& rays,
    const std::vector<double>& from, int x0, int y0) const;
  void limitRays(Bundle& bundle, int x0, int y0) const;
  void takeFirst(Bundle& bundle) const;
  void takeBehind(Bundle& bundle) const;
  void seed(Bundle& bundle, int x0, int y0) const;
  template <typename Visit>
  void forPixels(const Bundle& bundle, int x0, int y0, const Visit& visit) const;
  void keep(const Bundle& bundle, int x0, int y0) const;
  void keepFirst(const Bundle& bundle, int x0, int y0) const;
  void keepIds(const Bundle& bundle, int x0, int y0, std::uint64_t* id, std::int32_t* object) const;
  bool wantsIds() const;
  bool wantsNormals() const;
  double footprint(const RayBundle& rays, int side) const;

  const Scene& scene_;
  Film& film_;
  int side_;
  const float* limits_;
  CameraRays rays_;
  CameraCasts casts_;
  double jitterX_ = 0.0, jitterY_ = 0.0;
  std::vector<SurfaceShader> shaders_;
  std::optional<SceneLighting> lighting_; ///< of local shading, and of clouds
  std::optional<BundleClouds> clouds_;    ///< where there are any
  std::optional<SceneRays> sceneRays_;    ///< for paths, and for what is behind transparent things
  std::optional<PathTracer> paths_;       ///< instead of local shading
  bool isTransparent_ = false;            ///< something may be
  bool mayErr_ = false;                   ///< a surface, by some pixels
};

} // namespace mote
