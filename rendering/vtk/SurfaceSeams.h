#pragma once

#include "kernels/core/Vec.h"

#include <cstddef>
#include <cstdint>
#include <memory>
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

/// Which triangles of a sector's surface its copies cover: those of faces that, turned to the next
/// copy, have just the corners of a face that looks at them, and those of these. 1 for them; empty
/// for none. Points agree up to a millionth of the surface's extent.
std::vector<std::uint8_t> coveredByCopies(
  const SurfaceTriangles& surface, vtkPoints* points, const SectorCopies& copies);

/// A surface whose faces are looked for by their corners.
class SeamSurface
{
public:
  SeamSurface(const SurfaceTriangles& surface, vtkPoints* points);
  ~SeamSurface();

  class Faces;
  const Faces& faces() const { return *faces_; }

private:
  std::unique_ptr<const Faces> faces_;
};

/// Likewise which triangles of a surface another one covers, however the two cut their faces into
/// triangles.
std::vector<std::uint8_t> coveredByOther(const SeamSurface& surface, const SeamSurface& other);

} // namespace mote
