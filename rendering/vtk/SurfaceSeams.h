#pragma once

#include "kernels/core/Vec.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

class vtkPoints;
class vtkUnstructuredGrid;

namespace mote
{

class PointSets;
class SurfaceCover;
class SurfaceFaces;
struct SurfaceTriangles;

/// How often a sector is drawn, evenly around an axis.
struct SectorCopies
{
  int count = 1;
  Vec3d center{0.0};
  Vec3d axis{0.0, 0.0, 1.0};

  bool operator==(const SectorCopies&) const = default;
};

/// A surface whose faces may cover those of others, and be covered: where both look at one another.
/// A face is covered by one that has just its corners, which agree up to a millionth of the
/// surface's extent, or by any number of them that lie where it lies (see SurfaceCover). May be
/// used by several threads.
class SeamSurface
{
public:
  SeamSurface(const SurfaceTriangles& surface, vtkPoints* points);
  ~SeamSurface();

  const SurfaceFaces& faces() const { return *faces_; }
  const SurfaceCover& cover() const; ///< made when it is asked for

private:
  std::unique_ptr<const SurfaceFaces> faces_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const SurfaceCover> cover_;
};

/// Which triangles of a sector's surface its copies cover. 1 for them; empty for none.
std::vector<std::uint8_t> coveredByCopies(
  const SurfaceTriangles& surface, vtkPoints* points, const SectorCopies& copies);

/// Likewise which triangles of a surface another one covers.
std::vector<std::uint8_t> coveredByOther(const SeamSurface& surface, const SeamSurface& other);

/// Likewise which triangles of the surface of a grid's cells are covered by cells of other parts of
/// the grid, such as a rotor in its stator: cells that share a point, by any number of others
/// between, are of one part.
std::vector<std::uint8_t> coveredByParts(
  const SurfaceTriangles& surface, vtkPoints* points, PointSets& parts);

/// Likewise which triangles of flat cells have a face of a cell with a volume just there, with the
/// same corners: meshes of finite elements list the cells of their boundary so, whichever way these
/// look.
std::vector<std::uint8_t> flatOnFaces(const SurfaceTriangles& surface, vtkUnstructuredGrid* grid);

} // namespace mote
