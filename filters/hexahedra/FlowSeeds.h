#ifndef MoteFlowSeeds_h
#define MoteFlowSeeds_h

#include "LocatorStructure.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace mote
{

/// So many places within the cells of some meshes: each stands for as much volume, and they lie as
/// evenly as the order of the cells allows. The same ones every time.
std::vector<Vec3d> seedsWithin(
  const std::vector<std::shared_ptr<const LocatorStructure>>& meshes, std::size_t count);

/// On a line, both ends included; in the middle where there is but one.
std::vector<Vec3d> seedsAlong(const Vec3d& from, const Vec3d& to, std::size_t count);

} // namespace mote

#endif
