#pragma once

#include "kernels/core/Vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPoints;

namespace mote
{

struct SurfaceTriangles;

/// How often a sector is drawn, evenly around an axis.
struct SectorCopies
{
  int count = 1;
  Vec3d center{0.0};
  Vec3d axis{0.0, 0.0, 1.0};

  bool operator==(const SectorCopies&) const = default;
};

/// Which triangles of a sector's surface its copies cover: those whose corners, turned to the next
/// copy, are points of a surface that faces them, and these. 1 for those; empty for none. Points
/// agree up to a millionth of the surface's extent.
std::vector<std::uint8_t> coveredByCopies(
  const SurfaceTriangles& surface, vtkPoints* points, const SectorCopies& copies);

} // namespace mote
