#pragma once

#include "CoherentGrid.h"

namespace mote
{

/// What the traversal needs of a grid, without the vectors that own it.
struct CoherentGridView
{
  const CoherentGrid::Record* records;
  const std::uint32_t* cellStart;
  const std::uint64_t* rowStart;
  const std::uint8_t* macrocellShown;
  const std::uint64_t* shown; ///< null: all are
  const std::uint32_t* index32;
  const std::uint64_t* index64;
  Vec3d origin;
  double unit, perUnit; ///< world length of one unit of the grid's coordinates, and its inverse
  Vec3f lower;
  Vec3i resolution;
  Vec3i macroResolution;
  float cellSize;
  float reach; ///< largest radius and a margin for rounding of coordinates and cells

  explicit CoherentGridView(const CoherentGrid& grid)
    : records(grid.records_.data())
    , cellStart(grid.cellStart_.data())
    , rowStart(grid.rowStart_.data())
    , macrocellShown(grid.macrocellShown_.data())
    , shown(grid.shown_.empty() ? nullptr : grid.shown_.data())
    , index32(grid.index32_.empty() ? nullptr : grid.index32_.data())
    , index64(grid.index64_.empty() ? nullptr : grid.index64_.data())
    , origin(grid.origin_)
    , unit(grid.unit_)
    , perUnit(1.0 / grid.unit_)
    , lower(grid.lower_)
    , resolution(grid.resolution_)
    , macroResolution(grid.macroResolution_)
    , cellSize(grid.cellSize_)
  {
    const Vec3f extent = Vec3f(resolution) * cellSize;
    const float longest = glm::max(extent.x, glm::max(extent.y, extent.z));
    reach = grid.largestRadius_ * 1.00001f + longest * 1e-6f;
  }

  bool isShown(std::uint64_t slot) const
  {
    return shown == nullptr || ((shown[slot / 64] >> (slot % 64)) & 1) != 0;
  }
};

} // namespace mote
