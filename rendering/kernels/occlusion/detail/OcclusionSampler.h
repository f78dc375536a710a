#pragma once

#include "../../core/RayBundle.h"
#include "../../core/RayPacket.h"
#include "../../particles/NearParticle.h"
#include "../OcclusionBake.h"
#include "OcclusionNear.h"
#include "OcclusionSamples.h"
#include "OcclusionTexels.h"

#include <cstdint>
#include <vector>

namespace mote
{

/// The directions that rays are asked in. A texel asks first the few and, where these do not agree
/// with one another or with those of texels beside it, the many, which with the few make one set
/// that is spread evenly.
struct OcclusionDirectionSets
{
  explicit OcclusionDirectionSets(int samples);

  OcclusionDirections few, many;
};

/// Asks the rays of one particle after another. One a thread.
class OcclusionSampler
{
public:
  OcclusionSampler(const ParticleStructure& structure, const OcclusionBakeOptions& options,
    const OcclusionDirectionSets& directions);

  /// Turns to a particle.
  void begin(std::size_t slot);
  /// Whether another particle has all of this one inside.
  bool isSwallowed() const { return swallowed_; }

  /// Asks the first rays of all texels of a map.
  void askFew(const OcclusionPlaces& places);
  /// Asks the others where it takes them, or everywhere, and fills the map.
  void askMany(bool everywhere, OcclusionTexels& texels);
  /// Texels that ask rays, after askFew(): those that do not lie inside of other particles.
  std::size_t texels() const { return texels_.size(); }
  /// Rays asked since askFew(), those of them that met nothing, and all so far.
  std::size_t asked() const { return asked_; }
  std::size_t open() const { return open_; }
  std::size_t rays() const { return rays_; }

private:
  /// Bits of a block's directions at one place.
  using Bits = std::uint16_t;

  /// A sphere that the particle's surface may lie inside of: centre from the particle's, square of
  /// the radius less what rounding takes.
  struct Overlap
  {
    Vec3d center;
    double square;
  };

  /// A texel, and the sums of its rays' weights.
  struct Asker
  {
    Vec3f place;          ///< where its rays start, on the unit sphere
    float outside = 1.0f; ///< share of it that does not lie inside of another particle
    float open = 0.0f, all = 0.0f;
  };

  bool isInside(const Vec3f& place) const;
  void placeAskers();
  void ask(const OcclusionDirections& directions);
  void castPackets();
  void answer();
  void castBundles();
  void castBundle();
  void addUp();
  bool isSettled(int texel) const;

  const ParticleStructure& structure_;
  const OcclusionBakeOptions& options_;
  const OcclusionDirectionSets& directions_;
  double reach_, rounding_;
  double spacing_; ///< edge of the cube that a particle has on average

  std::uint64_t slot_ = 0;
  Vec3d center_{0.0};
  double radius_ = 0.0;
  std::uint32_t seed_ = 0;
  bool swallowed_ = false;
  std::vector<NearParticle> found_;
  OcclusionNear near_;
  double ball_ = 0.0; ///< all spheres are found that come as close to the centre
  std::vector<Overlap> overlaps_;

  const OcclusionPlaces* map_ = nullptr;
  std::vector<Asker> askers_;
  std::vector<std::uint32_t> texels_; ///< those that ask now
  std::vector<Vec3f> places_;         ///< of these
  OcclusionDirections turned_;
  std::vector<float> light_; ///< of the sky in these directions
  std::vector<Bits> facing_; ///< by asking texel and block: rays that are asked
  std::vector<Bits> unmet_;  ///< those that have met nothing so far
  RayPacket packet_;
  RayBundle bundle_;
  /// Entry of `unmet_` and lane of each ray of the packet or the bundle.
  std::array<std::uint32_t, RayBundle::capacity> asker_;
  std::size_t asked_ = 0, open_ = 0, rays_ = 0;
};

} // namespace mote
