#pragma once

#include "../particles/EmbreeOcclusion.h"
#include "../particles/EmbreeSpheres.h"

#include <kernels/core/RayPacket.h>

namespace mote::bench
{

/// Answers the rays of a bake in place of Mote's structures.
class EmbreeBake
{
public:
  explicit EmbreeBake(int threads)
    : spheres_(threads)
  {
  }
  void build(const ParticleInput& input) { spheres_.build(input); }

  /// Ways of answering: all that Embree has, for rays that run alike and for any.
  static const std::vector<std::string>& modes();

  /// As occlude() of the structures, but that the particle that a ray leaves is not told to
  /// Embree: the rays begin outside of it. May be called from several threads.
  void occlude(std::size_t mode, RayPacket& packet) const;

private:
  EmbreeSpheres spheres_;
};

} // namespace mote::bench
