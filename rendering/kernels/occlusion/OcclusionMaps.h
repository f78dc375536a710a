#pragma once

#include "../core/RawVector.h"
#include "../core/Vec.h"
#include "../particles/ParticleStructure.h"
#include "OcclusionLookUp.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace mote
{

/// The light of the background, linear in the cosine to `up`: `top` straight up, `bottom` straight
/// down. Both must be finite and at least 0, one of them above 0.
struct OcclusionSky
{
  float top = 1.0f;
  float bottom = 1.0f;
  Vec3f up{0.0f, 0.0f, 1.0f}; ///< unit length

  float towards(const Vec3f& direction) const
  {
    return 0.5f * (top + bottom) + 0.5f * (top - bottom) * glm::dot(up, direction);
  }
  /// What a surface with nothing in its way receives: the mean over cosine-weighted directions.
  float onOpen(const Vec3f& normal) const
  {
    return 0.5f * (top + bottom) + (top - bottom) / 3.0f * glm::dot(up, normal);
  }
  float brightest() const { return top > bottom ? top : bottom; }
  bool operator==(const OcclusionSky& other) const = default;
};

/// How much of the sky the surfaces of particles see, as a latitude-longitude map over each.
///
/// A map is side x side texels of one byte q, which stands for maximum() * (q / 255)^2: the *open
/// share*, in [0, 1] under an even sky of 1, or the light received from an uneven one. Row r covers
/// the polar angles from r to r + 1 times pi / side, measured from +z in the object's coordinates;
/// column c covers the longitudes atan2(y, x) from c to c + 1 times 2 pi / side. Particles are
/// numbered by their slots in a structure, or by their indices in the input. A particle takes one
/// byte besides its texels; one under open sky, or that no light reaches, takes nothing more.
///
/// Source: Bigler, "Use of Silhouette Edges and Ambient Occlusion in Particle Visualization",
/// University of Utah, 2004; docs/ambient-occlusion.md.
class OcclusionMaps
{
public:
  /// What is stored for a particle.
  enum Level : std::uint8_t
  {
    Dark = 0, ///< nothing: no light reaches it
    Side1,    ///< one texel
    Side2,    ///< 2 x 2 texels, and so on
    Side4,
    Side8,
    Side16,
    Side32,
    Open,          ///< nothing: it sees all of the sky
    NotBaked = 15, ///< nothing, and nothing is known of it
  };
  static bool isLevel(std::uint8_t level) { return level <= Open || level == NotBaked; }
  /// Texels along one side of a map; 0 where none are stored.
  static int side(Level level) { return level >= Side1 && level <= Side32 ? 1 << (level - 1) : 0; }
  static std::size_t texelsOf(Level level)
  {
    return static_cast<std::size_t>(side(level)) * static_cast<std::size_t>(side(level));
  }
  /// The level of maps of `side` texels along a side: 1, 2, 4, 8, 16 or 32. Throws Error for any
  /// other.
  static Level levelOf(int side);

  /// Maps of some particles in a row: a Level each, and all their texels one after another, row by
  /// row.
  struct Piece
  {
    std::vector<std::uint8_t> levels;
    RawVector<std::uint8_t> texels;
  };

  OcclusionMaps() = default; ///< of no particles
  /// Of the particles of all pieces one after another. Throws Error where a level is none of Level,
  /// where the texels are more or fewer than the levels say, and for a sky without light.
  explicit OcclusionMaps(std::span<const Piece> pieces, const OcclusionSky& sky = {});
  /// Of `count` particles of which nothing is known.
  explicit OcclusionMaps(std::size_t count, const OcclusionSky& sky = {});

  std::size_t size() const { return count_; } ///< particles
  const OcclusionSky& sky() const { return sky_; }
  /// What 255 stands for: the light of the brightest part of the sky.
  float maximum() const { return sky_.brightest(); }
  Level level(std::size_t particle) const
  {
    return static_cast<Level>(
      blocks_[particle / blockSize].levels >> (4 * (particle % blockSize)) & 15);
  }
  bool isBaked(std::size_t particle) const { return level(particle) != NotBaked; }
  std::span<const std::uint8_t> texels(std::size_t particle) const;
  /// Texels of all particles, in their order.
  std::span<const std::uint8_t> texels() const { return texels_; }
  /// Memory in bytes.
  std::size_t bytes() const { return blocks_.size() * sizeof(Block) + texels_.size(); }

  /// For each of `count` hits on `particles` with normals of unit length, in the object's
  /// coordinates: the map's value there, bilinear between the middles of texels, all the way round
  /// and over the poles. NaN where nothing is known of a particle. Thread-safe.
  void lookUp(const std::uint64_t* particles, const float* nx, const float* ny, const float* nz,
    int count, float* values) const;
  /// The same in steps, between which the memory asked for can arrive: fetch(), find() and this.
  /// Up to OcclusionLookUp::capacity hits.
  void lookUp(const OcclusionLookUp& found, const std::uint64_t* particles, const float* nx,
    const float* ny, const float* nz, float* values) const;
  void fetch(const std::uint64_t* particles, int count) const;
  void find(const std::uint64_t* particles, int count, OcclusionLookUp& found) const;
  /// The same for one hit.
  float at(std::size_t particle, const Vec3f& normal) const;

  /// The byte that stands nearest to a value, and back.
  std::uint8_t encoded(float value) const;
  float decoded(float byte) const;

  /// These maps with what `newer` knows in place of what they knew. Throws Error where the numbers
  /// of particles or the skies differ.
  OcclusionMaps updated(const OcclusionMaps& newer) const;

  /// These maps less those of particles that `forgets` accepts; called from several threads.
  OcclusionMaps without(const std::function<bool(std::size_t particle)>& forgets) const;

  /// The maps that stand by slot of `structure`, by index of the input, `inputs` particles. What
  /// the structure has left out is NotBaked. Throws Error where the structure has another number of
  /// particles, or an index beyond the input.
  OcclusionMaps inInputOrder(const ParticleStructure& structure, std::size_t inputs) const;
  /// The way back. Throws Error where an index of the structure lies beyond these maps.
  OcclusionMaps inSlotOrder(const ParticleStructure& structure) const;

private:
  static constexpr std::size_t blockSize = 16;

  /// Of 16 particles.
  struct Block
  {
    std::uint64_t levels = ~std::uint64_t{0}; ///< 4 bits a particle, the first lowest
    std::uint64_t first = 0;                  ///< texel of the first particle
  };

  /// What a particle with one texel or none stands for.
  float plainValue(std::size_t particle, const Vec3f& normal) const;
  /// First texel of a particle.
  std::size_t firstTexel(std::size_t particle) const;
  /// Sets where blocks begin from the levels; returns the number of texels.
  std::size_t placeBlocks();
  /// The same, and makes room for the texels.
  void makeTexels();
  void setLevel(std::size_t particle, Level level);
  /// Maps of `count` particles, k being particle source(k) of these, or unknown where that is not
  /// below size().
  template <typename Source>
  OcclusionMaps gathered(std::size_t count, const Source& source) const;

  std::size_t count_ = 0;
  OcclusionSky sky_;
  RawVector<Block> blocks_;
  RawVector<std::uint8_t> texels_;
};

} // namespace mote
