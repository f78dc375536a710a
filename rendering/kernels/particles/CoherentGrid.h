#pragma once

#include "IsParticleStructure.h"
#include "RepeatedSpheres.h"
#include "StoredParticles.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace mote
{

/// How a CoherentGrid is built.
struct CoherentGridOptions
{
  double cellsPerParticle = 1.0; ///< lambda of the paper; [0.2, 5], values outside are clamped
  bool keepIndices = true;       ///< keep the way back to the input index: 4 or 8 bytes a particle
  /// Of a part of a larger input (see ParticleSample): the index there of every particle, read
  /// during the build, and the number of particles there. Empty: the particles are the input.
  std::span<const std::uint64_t> indices = {};
  std::size_t inputs = 0;
};

/// A uniform grid of cubic cells over particles, traversed slice by slice by bundles of rays.
///
/// Every particle lies in exactly one cell, that of its centre (the sphere-centre method); a bundle
/// visits, in each slice of cells across its major axis, the cells that its frustum overlaps when
/// widened by the largest radius. Macrocells of 6x6x6 cells skip empty space and what no range
/// shows. Where radii differ much, particles of similar radius have a grid of their own, so that
/// few large spheres do not widen the frustum for all. Particles are stored in cell order as x y z
/// r in float. Functions without a comment do what IsParticleStructure says.
///
/// Source: Gribble, Ize, Kensler, Wald, Parker, "A Coherent Grid Traversal Approach to Visualizing
/// Particle-based Simulation Data", UUSCI-2006-024; docs/coherent-grid.md says what is done
/// otherwise.
class CoherentGrid : public StoredParticles
{
public:
  /// One particle: centre relative to origin(), and radius, in unit(). 16 bytes.
  struct Record
  {
    float x, y, z, r;
  };

  static constexpr int macrocellSize = 6;

  /// Least and greatest of the eight values of the particles in a macrocell, as they are stored. 64
  /// bytes.
  struct MacroBounds
  {
    std::array<float, ParticleRanges::count> least, greatest;
  };

  static std::string name() { return "coherent-grid"; }
  using Options = CoherentGridOptions;

  void build(const ParticleSet& particles, const CoherentGridOptions& options = {},
    const Progress& progress = {});
  /// The rays of packets are cast one by one, those of bundles many times faster.
  void cast(RayPacket& packet, std::int32_t object) const;
  void cast(RayBundle& bundle, std::int32_t object) const;
  void occlude(RayPacket& packet, std::int32_t object) const;
  void occlude(RayBundle& bundle, std::int32_t object) const;
  /// The larger a cell looks, the larger.
  int bundleSide(const CameraRays& rays, int x0, int y0, int size) const;

  /// Takes 16 bytes a particle.
  void setAttributes(const std::vector<ParticleAttribute>& attributes);
  /// Looks at the macrocells, not at the particles.
  void setRanges(const ParticleRanges& ranges);
  void setVisibility(const std::function<bool(std::size_t slot)>& shown);
  bool isShown(std::size_t slot) const;
  /// Once ranges were set, this and slotsBetween() look at macrocells, and at the particles of
  /// those alone that a limit crosses.
  std::size_t shownCount() const;
  std::vector<SlotRun> slotsBetween(int k, double low, double high) const;
  void findNear(const Vec3d& point, double distance, std::vector<NearParticle>& found) const;

  Vec3d center(std::size_t slot) const
  {
    const Record& p = records_[slot];
    return origin_ + unit_ * Vec3d(p.x, p.y, p.z);
  }
  double radius(std::size_t slot) const { return unit_ * records_[slot].r; }
  std::uint64_t inputIndex(std::size_t slot) const
  {
    if (!index32_.empty())
      return index32_[slot];
    return index64_.empty() ? slot : index64_[slot];
  }
  std::size_t bytes() const;
  /// Grids, one for each group of similar radii that pays for a grid of its own, the largest radii
  /// first; and cells along each axis, edge of a cell, and number of particles of each.
  int layers() const { return static_cast<int>(layers_.size()); }
  Vec3i resolution(int layer = 0) const { return layers_[layer].resolution; }
  double cellSize(int layer = 0) const { return unit_ * layers_[layer].cellSize; }
  std::size_t layerSize(int layer) const { return layers_[layer].count; }

private:
  struct Builder;
  friend struct CoherentGridView;

  /// One grid of cells over the particles of similar radius. All arrays hold layer after layer.
  struct Layer
  {
    Vec3f lower{0.0f}; ///< corner of cell (0,0,0), in unit() relative to origin()
    Vec3i resolution{0};
    Vec3i macroResolution{0};
    float cellSize = 1.0f;
    float cellsPerUnit = 1.0f; ///< 1 / cellSize
    float largestRadius = 0.0f;
    std::size_t firstSlot = 0;
    std::size_t count = 0;
    std::size_t firstRow = 0;       ///< in rowStart_
    std::size_t firstCell = 0;      ///< in cellStart_
    std::size_t firstMacrocell = 0; ///< in macrocellShown_

    std::size_t rows() const { return static_cast<std::size_t>(resolution.y) * resolution.z; }
    std::size_t rowWidth() const { return static_cast<std::size_t>(resolution.x) + 1; }
    std::size_t macrocells() const
    {
      return static_cast<std::size_t>(macroResolution.x) * macroResolution.y * macroResolution.z;
    }
  };

  void clear();
  template <typename Use>
  void forRowsOf(const Layer& layer, int macroRow, const Use& f) const;
  template <typename Visit>
  void forMacrocells(const Visit& visit) const;
  template <typename Accepts>
  std::vector<SlotRun> runsOf(const Accepts& accepts) const;
  void findOccupied();
  void findMacroBounds();
  void findShown();
  void leaveOutRepeats();

  std::size_t inputs_ = 0;    ///< particles of the input, unfit ones too
  std::vector<Layer> layers_; ///< largest radii first: what hides most is met first
  /// By layer and cell, x fastest; a few more at the end for SIMD loads.
  RawVector<Record> records_;
  /// First particle of every cell relative to its row's; resolution.x + 1 entries a row.
  RawVector<std::uint32_t> cellStart_;
  /// First particle of row (y, z), counted y + z * resolution.y.
  RawVector<std::uint64_t> rowStart_;
  RawVector<std::uint32_t> index32_;
  RawVector<std::uint64_t> index64_;
  RepeatedSpheres repeats_; ///< in crowded cells

  // What is shown.
  RawVector<std::uint64_t> shown_; ///< one bit a particle, or empty: all are
  /// Where there are repeats: one bit a particle, of what visibility and ranges leave but one of
  /// each group of repeats_.
  RawVector<std::uint64_t> met_;
  RawVector<std::uint64_t> metWords_; ///< one bit a word of met_: whether any is set there
  /// Least and greatest of each value in a macrocell; made for the first limited range.
  std::vector<MacroBounds> macroBounds_;
  std::vector<std::uint8_t> macroHasNaN_;       ///< among attributes; as long as macroBounds_
  std::vector<std::uint8_t> macrocellOccupied_; ///< whether `shown_` leaves it a particle
  std::vector<std::uint8_t> macrocellShown_;    ///< whether ranges leave it one, most likely
};

} // namespace mote
