#pragma once

#include "../CoherentGrid.h"
#include "StoredRanges.h"

#include <algorithm>
#include <bit>

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
  const std::uint64_t* shown;      ///< null: all are
  const std::uint64_t* shownWords; ///< where `skips`: words of `shown` that are not 0, a bit each
  const float* values;             ///< four a particle, or null
  StoredRanges ranges;
  bool selects; ///< whether a particle may be hidden
  bool skips;   ///< whether most particles of some cells are, by `shown`

  /// Of what rays may meet, or with `repeats`, of all that is shown.
  explicit CoherentGridView(const CoherentGrid& g, bool repeats = false)
    : grid(g)
    , records(g.records_.data())
    , shown(g.shown_.empty() ? nullptr : g.shown_.data())
    , shownWords(nullptr)
    , values(g.values_.empty() ? nullptr : g.values_.front().data())
    , ranges(g.ranges_, g.origin_, g.unit_, values != nullptr)
    , selects(shown != nullptr || ranges.limits > 0)
    , skips(!repeats && !g.met_.empty())
  {
    if (!skips)
      return;
    shown = g.met_.data();
    shownWords = g.metWords_.data();
    ranges.limits = 0; // what is met is in range
    selects = true;
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

  /// Where `skips`: calls visit(slot) for the slots from `first` to before `last` that rays may
  /// meet, and passes over those that are hidden by thousands.
  template <typename Visit>
  void forShown(std::uint64_t first, std::uint64_t last, const Visit& visit) const
  {
    forBits(shownWords, first / 64, (last + 63) / 64,
      [&](std::uint64_t word)
      {
        const std::uint64_t start = 64 * word;
        forBits(shown, std::max(first, start), std::min(last, start + 64), visit);
      });
  }

  /// Calls visit(i) for the bits that are set from `first` to before `last`.
  template <typename Visit>
  static void forBits(
    const std::uint64_t* words, std::uint64_t first, std::uint64_t last, const Visit& visit)
  {
    while (first < last)
    {
      const std::uint64_t end = std::min(last, (first / 64 + 1) * 64);
      std::uint64_t bits = words[first / 64] >> (first % 64);
      if (end - first < 64)
        bits &= (std::uint64_t{1} << (end - first)) - 1;
      for (; bits != 0; bits &= bits - 1)
        visit(first + static_cast<std::uint64_t>(std::countr_zero(bits)));
      first = end;
    }
  }

  bool isShown(std::uint64_t slot) const
  {
    if (shown != nullptr && ((shown[slot / 64] >> (slot % 64)) & 1) == 0)
      return false;
    return ranges.limits == 0 ||
           ranges.contain(&records[slot].x, values == nullptr ? nullptr : values + 4 * slot);
  }
};

} // namespace mote
