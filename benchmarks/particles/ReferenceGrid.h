#pragma once

#include "CellGrid.h"

#include <kernels/core/RayBundle.h>

#include <vector>

namespace mote::bench
{

/// The usual way to put spheres into a grid: every cell holds references to all spheres that
/// overlap it. A packet visits the cells that its frustum overlaps, and no others, but meets large
/// spheres again and again; a mailbox keeps it from testing them twice. The peer of the
/// sphere-centre method in Gribble et al. 2006.
class ReferenceGrid
{
public:
  static constexpr int macrocellSide = 6; ///< as in Mote's grid

  /// Builds in parallel, counting first and filling then, with about `lambda` cells a particle.
  /// Throws Error where a row of cells would hold more than 2^32 references.
  void build(const ParticleSet& particles, double lambda);

  /// Nearest hits of the rays of a bundle of up to 64, as CoherentGrid::cast() finds them; t and
  /// slot are written, the slot being the place of the sphere in the order of cells. Thread-safe.
  void cast(RayBundle& bundle) const;

  /// Structure and particles.
  std::size_t bytes() const;

private:
  friend struct ReferenceGridView;

  struct Slab
  {
    int first, last; ///< cells along z
  };
  void size(const CellGrid& centers, double lambda);
  template <typename Visit>
  void forReferences(const CellGrid& centers, Slab slab, const Visit& visit) const;
  void count(const CellGrid& centers, Slab slab);
  void fill(const CellGrid& centers, Slab slab);
  void markMacrocells();

  Vec3d origin_{0.0};
  double unit_ = 1.0;
  Vec3f lower_{0.0f}; ///< of the box of all spheres, a little larger
  Vec3f upper_{0.0f};
  Vec3i resolution_{0};
  Vec3i macroResolution_{0};
  float cellSize_ = 1.0f;
  float largestRadius_ = 0.0f;
  RawVector<CellGrid::Record> records_;
  RawVector<std::uint32_t> references_; ///< in cell order, x fastest
  /// First reference of every cell relative to its row's; resolution.x + 1 entries a row.
  RawVector<std::uint32_t> cellStart_;
  RawVector<std::uint64_t> rowStart_;
  std::vector<std::uint8_t> macrocellUsed_;
};

} // namespace mote::bench
