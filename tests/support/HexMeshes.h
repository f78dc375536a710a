#pragma once

#include <kernels/hexahedra/HexMesh.h>

#include <cstdint>
#include <functional>
#include <memory>
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

  std::size_t addPoint(const Vec3d& p);
  void addCell(HexCellType type, const std::vector<std::int64_t>& ids);
  /// A cell with points of its own.
  void addCell(HexCellType type, const std::vector<Vec3d>& corners);
  /// Moves all points by a function of the point's place.
  void move(const std::function<Vec3d(const Vec3d&)>& to);

  HexMeshInput input() const;
  std::shared_ptr<const HexMesh> mesh() const { return std::make_shared<HexMesh>(input()); }
};

/// nx x ny x nz hexahedra that fill the box from 0 to (nx, ny, nz); points inside are moved by up
/// to `jitter` along each axis, those on the box's sides stay.
HexCells hexBlock(int nx, int ny, int nz, double jitter = 0.0, unsigned seed = 1);

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
