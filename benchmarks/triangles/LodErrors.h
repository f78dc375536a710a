#pragma once

#include <kernels/core/Camera.h>
#include <kernels/meshes/RlodTree.h>

#include <cstdint>
#include <limits>

namespace mote::bench
{

class RlodPaperTree;

/// What R-LODs make wrong in a picture. Displacements are in pixels where the hit is: how far a hit
/// on an R-LOD lies from the nearest of the triangles that it stands for, so that to the surface
/// it is no farther. Hits on triangles are displaced by 0.
struct LodErrors
{
  double rms = unknown;        ///< root mean square of the displacements
  double mostOfMany = unknown; ///< 99.9 % of the hits are displaced by less
  double most = unknown;
  double lods = unknown;  ///< share of the hits that are on R-LODs
  std::int64_t holes = 0; ///< pixels that miss where the exact picture hits
  std::int64_t extra = 0; ///< pixels that hit where the exact picture misses

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
};

/// Casts a picture exactly and with `poe` pixels of error; displacements are those of every hit, or
/// of every n-th where there are more than 60,000.
LodErrors measureLods(
  const RlodTree& tree, const CameraRays& rays, int width, int height, double poe);
LodErrors measureLods(
  const RlodPaperTree& tree, const CameraRays& rays, int width, int height, double poe);

} // namespace mote::bench
