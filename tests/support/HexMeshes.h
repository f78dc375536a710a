#pragma once

#include <kernels/hexahedra/HexMesh.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace mote::testing
{

/// Cells in memory of their own, to be viewed as a HexMeshInput.
struct HexCells
{
  std::vector<double> points;
  std::vector<std::uint8_t> types;
  std::vector<std::int64_t> offsets = {0};
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> faces, faceLocations; ///< of polyhedra; -1 for other cells

  std::size_t addPoint(const Vec3d& p);
  void addCell(HexCellType type, const std::vector<std::int64_t>& ids);
  /// A cell with points of its own.
  void addCell(HexCellType type, const std::vector<Vec3d>& corners);
  /// A polyhedron by its faces.
  void addPolyhedron(const std::vector<std::vector<std::int64_t>>& faces);
  /// Moves all points by a function of the point's place.
  void move(const std::function<Vec3d(const Vec3d&)>& to);

  HexMeshInput input() const;
  std::shared_ptr<const HexMesh> mesh() const { return std::make_shared<HexMesh>(input()); }
};

/// nx x ny x nz hexahedra that fill the box from 0 to (nx, ny, nz); points inside are moved by up
/// to `jitter` along each axis, those on the box's sides stay.
HexCells hexBlock(int nx, int ny, int nz, double jitter = 0.0, unsigned seed = 1);

/// The same cells, with each group of hexahedra as one polyhedron of all faces that only one of
/// them has, in the first one's place.
HexCells merged(const HexCells& cells, const std::vector<std::vector<std::size_t>>& groups);

/// Points that are the same where they are at the same place.
struct SharedPoints
{
  HexCells& cells;
  std::map<std::tuple<long, long, long>, std::int64_t> known;

  std::int64_t at(const Vec3d& p)
  {
    const std::tuple key(std::lround(p.x * 1e6), std::lround(p.y * 1e6), std::lround(p.z * 1e6));
    const auto [it, isNew] = known.insert({key, 0});
    if (isNew)
      it->second = static_cast<std::int64_t>(cells.addPoint(p));
    return it->second;
  }
};

/// 2 x 2 x 2 boxes of size 1, of which the last one is 4 x 4 x 4, and one of these 2 x 2 x 2:
/// coarse cells have finer ones on their faces.
HexCells refinedBlock();

/// Truncated octahedra, of 6 squares and 8 hexagons, which fill space about the points of a
/// body-centred lattice: 2 n^3 of them. Of each the points p with normal . (p - middle) <= reach.
HexCells foam(int n);
std::vector<Vec3d> foamMiddles(int n);
std::vector<Vec3d> foamNormals();
inline double foamReach(const Vec3d& normal)
{
  return glm::dot(normal, normal) > 1.5 ? 1.5 : 1.0;
}

/// What a ring of cells looks like. The axis is z, through the origin.
struct RingShape
{
  int radial = 8, around = 32, axial = 8;
  double inner = 1.0, outer = 2.0, height = 1.0;
  double twist = 0.0; ///< radians from the bottom to the top, and from inside to outside
  double bulge = 0.0; ///< how much the radius changes with the height
  int blades = 0;     ///< cells are narrow at so many places around
  double turn = 6.283185307179586; ///< the angle that is covered
};
HexCells hexRing(const RingShape& shape);

/// Meshes of plane, warped, folded, far, extruded, twisted and collapsed cells.
std::vector<HexCells> unevenMeshes();

/// Points in a box, from a fixed sequence.
std::vector<Vec3d> randomPoints(
  std::size_t count, const Vec3d& lower, const Vec3d& upper, unsigned seed);

} // namespace mote::testing
