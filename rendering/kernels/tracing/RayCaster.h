#pragma once

#include "../core/Camera.h"
#include "../core/Film.h"
#include "../core/Progress.h"
#include "../scene/Scene.h"
#include "Tiles.h"

namespace mote
{

/// Traces a scene into a film, tile by tile, in parallel.
///
/// One call of addSample() traces one ray a pixel and averages its colour into the film. The first
/// sample goes through the pixel centres; further ones are spread evenly over the pixel, so that
/// any number of them is a fair estimate of the pixel's mean.
class RayCaster
{
public:
  /// The scene must outlive the caster and stay unchanged.
  explicit RayCaster(const Scene& scene)
    : scene_(scene)
  {
  }

  /// 0 (default): all the threads that TBB's present arena allows.
  void setThreads(int threads) { threads_ = threads; }

  /// Side in pixels of the bundles of rays that are traced together: 2, 4, 8 or 16, or 0 (default)
  /// for what the structures suggest, tile by tile. The image is the same within rounding. Throws
  /// Error for other sides.
  void setBundleSide(int side);

  /// How far rays go: along the view axis, in world units, one value a pixel of the film, row after
  /// row from the bottom; infinity where nothing stands in the way. Rays end there, in surfaces and
  /// in volumes. The values must outlive the caster; null (default): no limit.
  void setLimits(const float* limits) { limits_ = limits; }

  /// Adds one sample to every pixel of the film. Returns false where `progress` asked to stop; it
  /// is called between tiles with the share done, on any of the tracing threads but on one at a
  /// time.
  ///
  /// A sample that was stopped is in some tiles of the film. `tiles` tells which, and with the same
  /// film, scene and camera another call goes on with the others; `tiles` is empty before a sample
  /// and after it. Without `tiles` the film's samples are reset to 0.
  bool addSample(const Camera& camera, Film& film, const Progress& progress = {},
    TilesDone* tiles = nullptr) const;

  /// Position of a sample in its pixel, in pixels from the centre, in [-1/2, 1/2); sample 0 is the
  /// centre. The R2 sequence: any prefix of it is spread evenly.
  static void sampleOffset(int sample, double& x, double& y);

private:
  const Scene& scene_;
  const float* limits_ = nullptr;
  int threads_ = 0;
  int bundleSide_ = 0;
};

} // namespace mote
