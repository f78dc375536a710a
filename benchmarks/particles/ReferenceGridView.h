#pragma once

#include "ReferenceGrid.h"

#include <limits>

namespace mote::bench
{

/// What the traversal needs of a grid of references, without the vectors that own it.
struct ReferenceGridView
{
  const CellGrid::Record* records;
  const std::uint32_t* references;
  const std::uint32_t* cellStart;
  const std::uint64_t* rowStart;
  const std::uint8_t* macrocellUsed;
  Vec3d origin;
  double unit;
  Vec3f lower, upper;
  Vec3i resolution;
  Vec3i macroResolution;
  float cellSize;

  explicit ReferenceGridView(const ReferenceGrid& grid)
    : records(grid.records_.data())
    , references(grid.references_.data())
    , cellStart(grid.cellStart_.data())
    , rowStart(grid.rowStart_.data())
    , macrocellUsed(grid.macrocellUsed_.data())
    , origin(grid.origin_)
    , unit(grid.unit_)
    , lower(grid.lower_)
    , upper(grid.upper_)
    , resolution(grid.resolution_)
    , macroResolution(grid.macroResolution_)
    , cellSize(grid.cellSize_)
  {
  }
};

/// Which spheres a packet has met: a hash table of their places that forgets all at once. Places of
/// neighbours differ in their last bits, so these bits are the hash.
class Mailbox
{
public:
  /// Forgets all.
  void start()
  {
    if (++packet_ == 0) // of 2^32: entries of the first one would look new
    {
      entries_.assign(entries_.size(), 0);
      packet_ = 1;
    }
    used_ = 0;
  }

  /// Whether the place is new; from now on it is not.
  bool insert(std::uint32_t place)
  {
    const std::uint64_t wanted = (std::uint64_t{packet_} << 32) | place;
    const std::size_t mask = entries_.size() - 1;
    for (std::size_t k = place & mask;; k = (k + 1) & mask)
    {
      if (entries_[k] == wanted)
        return false;
      if ((entries_[k] >> 32) == packet_)
        continue;
      entries_[k] = wanted;
      if (++used_ > entries_.size() / 2)
        grow();
      return true;
    }
  }

private:
  void grow()
  {
    const std::vector<std::uint64_t> old = std::move(entries_);
    entries_.assign(2 * old.size(), 0);
    used_ = 0;
    for (const std::uint64_t entry : old)
      if ((entry >> 32) == packet_)
        insert(static_cast<std::uint32_t>(entry));
  }

  std::vector<std::uint64_t> entries_ = std::vector<std::uint64_t>(2048, 0);
  std::size_t used_ = 0;
  std::uint32_t packet_ = 0; ///< entries of others are free
};

} // namespace mote::bench
