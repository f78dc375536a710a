#pragma once

#include <kernels/core/RawVector.h>
#include <kernels/particles/ParticleSet.h>

#include <cstddef>
#include <cstdint>

namespace mote::bench
{

/// Edge of cubic cells, about `cells` of which fill a box; directions thinner than one cell do not
/// count. 0 for a point.
double cellEdge(const Vec3d& size, double cells);

/// A plain uniform grid of cubic cells, each with the particles whose centres lie in it: what the
/// baselines are made of. Its cells are as large as those of Mote's grid.
struct CellGrid
{
  /// Centre relative to the grid's origin, and radius, in its unit.
  struct Record
  {
    float x, y, z, r;
  };
  static constexpr std::size_t paddingRecords = 16; ///< what a SIMD load may read past the end

  Vec3d origin{0.0};
  double unit = 1.0; ///< a power of two near the size of a cell
  Vec3f lower{0.0f}; ///< corner of cell (0, 0, 0)
  Vec3i resolution{0};
  float cellSize = 1.0f;
  float largestRadius = 0.0f;
  Vec3f boxLower{0.0f}, boxUpper{0.0f}; ///< of the spheres
  std::size_t count = 0;
  RawVector<Record> records; ///< in cell order, x fastest
  /// First particle of every cell relative to its row's; resolution.x + 1 entries a row.
  RawVector<std::uint32_t> cellStart;
  RawVector<std::uint64_t> rowStart; ///< of row (y, z) at y + z * resolution.y

  /// Builds in parallel with about `lambda` cells a particle; there must be a valid one.
  void build(const ParticleSet& particles, double lambda);

  std::size_t bytes() const;

  int cellAlong(float local, int axis) const
  {
    const int cell = static_cast<int>((local - lower[axis]) / cellSize);
    return glm::clamp(cell, 0, resolution[axis] - 1);
  }
};

} // namespace mote::bench
