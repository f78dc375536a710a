#include "EmbreeBake.h"

#include <limits>

namespace mote::bench
{

namespace
{

constexpr int capacity = RayPacket::capacity;
static_assert(capacity == EmbreeRays::capacity);

/// Numbers of a packet in float.
struct FloatPacket
{
  alignas(64) float origin[3][capacity], direction[3][capacity], nearest[capacity],
    farthest[capacity];

  FloatPacket(const RayPacket& from, const Vec3d& middle)
  {
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < from.count; ++i)
      {
        origin[k][i] = static_cast<float>(from.origin[k][i] - middle[k]);
        direction[k][i] = static_cast<float>(from.direction[k][i]);
      }
    for (int i = 0; i < from.count; ++i)
    {
      nearest[i] = static_cast<float>(from.tMin[i]);
      farthest[i] = static_cast<float>(from.t[i]);
    }
  }

  EmbreeRays rays(int count) const
  {
    EmbreeRays rays;
    rays.count = count;
    rays.origin = {origin[0], origin[1], origin[2]};
    rays.direction = {direction[0], direction[1], direction[2]};
    rays.nearest = nearest;
    rays.farthest = farthest;
    return rays;
  }
};

} // namespace

const std::vector<std::string>& EmbreeBake::modes()
{
  static const std::vector<std::string> all = []
  {
    std::vector<std::string> names = embreeOcclusionModes();
    for (std::size_t k = 1; k < embreeOcclusionModes().size(); ++k) // single rays are what they are
      names.push_back(names[k] + ", coherent");
    return names;
  }();
  return all;
}

void EmbreeBake::occlude(std::size_t mode, RayPacket& packet) const
{
  const FloatPacket numbers(packet, spheres_.middle());
  const std::size_t ways = embreeOcclusionModes().size();
  const bool alike = mode >= ways;
  const std::uint64_t met = embreeOccluded(alike ? mode - ways + 1 : mode, spheres_.scene(),
    alike ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT,
    numbers.rays(packet.count));
  for (int i = 0; i < packet.count; ++i)
    if ((met >> i & 1) != 0)
      packet.t[i] = -std::numeric_limits<double>::infinity();
}

} // namespace mote::bench
