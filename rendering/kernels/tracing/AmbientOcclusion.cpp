#include "detail/AmbientOcclusion.h"

#include "../shading/Reflectance.h"
#include "../shading/SampleSequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

/// A packet being filled: rays of as many hits as it takes, all in a row.
struct AmbientOcclusion::Work
{
  RayPacket packet;
  Departures from;
  std::uint16_t hit[RayPacket::capacity]; ///< that each ray starts from
  int open[SurfaceBlock::capacity];       ///< rays that met nothing, a hit each
};

AmbientOcclusion::AmbientOcclusion(const SceneRays& rays, int filmSample)
  : rays_(rays)
  , count_(std::min(rays.scene().occlusion.rays, OcclusionOptions::mostRays))
  , reach_(occlusionReach(rays.scene()))
  , first_(static_cast<std::uint32_t>(filmSample) * static_cast<std::uint32_t>(count_))
{
}

void AmbientOcclusion::cast(Work& work) const
{
  rays_.occlude(work.packet, &work.from);
  for (int k = 0; k < work.packet.count; ++k)
    work.open[work.hit[k]] += work.packet.t[k] > 0.0;
  work.packet.count = 0;
}

void AmbientOcclusion::findShares(const SurfaceBlock& block, float* shares, bool known) const
{
  Work work;
  RayPacket& packet = work.packet;
  packet.count = 0;
  packet.footprint = block.width;
  packet.onSurface = OnSurface::Start;
  std::fill_n(work.open, block.count, 0);
  const auto isWanted = [&](int i) { return !known || std::isnan(shares[i]); };
  for (int i = 0; i < block.count; ++i)
  {
    if (!isWanted(i))
      continue;
    const Vec3d position(block.position.x[i], block.position.y[i], block.position.z[i]);
    const Vec3d normal(block.normal.x[i], block.normal.y[i], block.normal.z[i]);
    const bool isOutside = block.side[i] > 0.0f;
    for (int ray = 0; ray < count_; ++ray)
    {
      const glm::dvec2 at = samplePoint(first_ + static_cast<std::uint32_t>(ray), block.seed[i]);
      const Vec3d direction = cosineDirection(normal, at);
      const int k = packet.count++;
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.origin[axis][k] = position[axis];
        packet.direction[axis][k] = direction[axis];
      }
      rays_.leave(packet, k, work.from, block.surface, block.slot[i], std::sqrt(1.0 - at.x));
      packet.t[k] = reach_;
      packet.slot[k] = isOutside ? block.slot[i] : RayPacket::noHit;
      packet.object[k] = isOutside ? block.surface : -1;
      work.hit[k] = static_cast<std::uint16_t>(i);
      if (packet.count == RayPacket::capacity)
        cast(work);
    }
  }
  cast(work);
  for (int i = 0; i < block.count; ++i)
    if (isWanted(i))
      shares[i] = static_cast<float>(work.open[i]) / static_cast<float>(count_);
}

} // namespace mote
