#pragma once

#include "../CoherentGrid.h"
#include "StoredRanges.h"

namespace mote
{

/// What the traversal needs of a grid, without the vectors that own it.
struct CoherentGridView
{
  /// The same of one layer.
  struct Layer
  {
    const std::uint32_t* cellStart;
    const std::uint64_t* rowStart;
    const std::uint8_t* macrocellShown;
    Vec3f lower;
    Vec3i resolution;
    Vec3i macroResolution;
    float cellSize;
    float reach; ///< largest radius and a margin for rounding of coordinates and cells
  };

  const CoherentGrid& grid;
  const CoherentGrid::Record* records;
  const std::uint64_t* shown; ///< null: all are
  const float* values;        ///< four a particle, or null
  StoredRanges ranges;
  bool selects; ///< whether a particle may be hidden

  explicit CoherentGridView(const CoherentGrid& g)
    : grid(g)
    , records(g.records_.data())
    , shown(g.shown_.empty() ? nullptr : g.shown_.data())
    , values(g.values_.empty() ? nullptr : g.values_.front().data())
    , ranges(g.ranges_, g.origin_, g.unit_, values != nullptr)
    , selects(shown != nullptr || ranges.limits > 0)
  {
  }

  int layers() const { return static_cast<int>(grid.layers_.size()); }

  Layer layer(int i) const
  {
    const CoherentGrid::Layer& from = grid.layers_[static_cast<std::size_t>(i)];
    Layer l;
    l.cellStart = grid.cellStart_.data() + from.firstCell;
    l.rowStart = grid.rowStart_.data() + from.firstRow;
    l.macrocellShown = grid.macrocellShown_.data() + from.firstMacrocell;
    l.lower = from.lower;
    l.resolution = from.resolution;
    l.macroResolution = from.macroResolution;
    l.cellSize = from.cellSize;
    const Vec3f extent = Vec3f(l.resolution) * l.cellSize;
    const float longest = glm::max(extent.x, glm::max(extent.y, extent.z));
    const Vec3f farthest = glm::max(glm::abs(l.lower), glm::abs(l.lower + extent));
    const float size = glm::max(longest, glm::max(farthest.x, glm::max(farthest.y, farthest.z)));
    l.reach = from.largestRadius * 1.00001f + size * 1e-6f;
    return l;
  }

  static constexpr bool hasTies = false; ///< coincident particles are met in their order

  bool isShown(std::uint64_t slot) const
  {
    if (shown != nullptr && ((shown[slot / 64] >> (slot % 64)) & 1) == 0)
      return false;
    return ranges.limits == 0 ||
           ranges.contain(&records[slot].x, values == nullptr ? nullptr : values + 4 * slot);
  }
};

} // namespace mote
