#pragma once

#include <kernels/occlusion/OcclusionBake.h>

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
  bool embree = false;     ///< answers the rays of the bake
  int samples = 0;         ///< rays a texel; 0: what all others have
  double tolerance = -1.0; ///< of adaptive maps; below 0: likewise

  bool isLive() const { return rays > 0; }
  /// How it bakes; `like` has what all have in common.
  OcclusionBakeOptions baking(OcclusionBakeOptions like) const;
};

/// All of them.
const std::vector<AmbientMethod>& ambientMethods();

/// Methods that are compared with one another alone.
struct AmbientTable
{
  std::string name;
  std::string title;
  std::vector<AmbientMethod> methods;
};

const std::vector<AmbientTable>& ambientTables();

} // namespace mote::bench
