#pragma once

#include <kernels/shading/OcclusionBake.h>

#include <string>
#include <vector>

namespace mote::bench
{

/// One way to the open share of what a picture shows.
struct AmbientMethod
{
  std::string name;
  std::string summary;
  int rays = 0; ///< a hit, cast for every picture; 0: maps are baked
  int side = 16;
  bool adaptive = false;
  bool dilate = true;
  bool embree = false; ///< answers the rays of the bake

  bool isLive() const { return rays > 0; }
  /// How it bakes; `like` has what all have in common.
  OcclusionBakeOptions baking(OcclusionBakeOptions like) const;
};

/// All of them.
const std::vector<AmbientMethod>& ambientMethods();

} // namespace mote::bench
