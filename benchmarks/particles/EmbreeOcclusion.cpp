#include "EmbreeOcclusion.h"

#include <algorithm>
#include <limits>

namespace mote::bench
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Writes `size` rays from `first` on; those past the end are passed over.
template <int size>
void fillRays(const EmbreeRays& from, int first, RTCRayNt<size>& rays)
{
  const auto copy = [&](const float* numbers, float* to)
  { std::copy_n(numbers + first, size, to); };
  copy(from.origin[0], rays.org_x);
  copy(from.origin[1], rays.org_y);
  copy(from.origin[2], rays.org_z);
  copy(from.direction[0], rays.dir_x);
  copy(from.direction[1], rays.dir_y);
  copy(from.direction[2], rays.dir_z);
  for (int i = 0; i < size; ++i)
  {
    const bool used = first + i < from.count;
    rays.tnear[i] = used ? from.begin(first + i) : infinity;
    rays.tfar[i] = used ? from.end(first + i) : -infinity;
    rays.time[i] = 0.0f;
    rays.mask[i] = ~0u;
    rays.id[i] = rays.flags[i] = 0;
  }
}

RTCRay singleRay(const EmbreeRays& from, int i)
{
  const auto &o = from.origin, &d = from.direction;
  return {o[0][i], o[1][i], o[2][i], from.begin(i), d[0][i], d[1][i], d[2][i], 0.0f, from.end(i),
    ~0u, 0, 0};
}

/// Bits of the rays that Embree has found something on: their tfar has become -infinity.
template <typename FarEnd>
std::uint64_t occludedBits(const EmbreeRays& rays, const FarEnd& tfar)
{
  std::uint64_t bits = 0;
  for (int i = 0; i < rays.count; ++i)
    bits |= std::uint64_t{tfar(i) < 0.0f} << i;
  return bits;
}

std::uint64_t inSingles(RTCScene scene, RTCIntersectContext& context, const EmbreeRays& from)
{
  return occludedBits(from,
    [&](int i)
    {
      RTCRay ray = singleRay(from, i);
      rtcOccluded1(scene, &context, &ray);
      return ray.tfar;
    });
}

std::uint64_t inPackets(RTCScene scene, RTCIntersectContext& context, const EmbreeRays& from)
{
  constexpr int size = 16;
  static_assert(sizeof(RTCRayNt<size>) == sizeof(RTCRay16));
  alignas(64) RTCRayNt<size> rays[EmbreeRays::capacity / size];
  for (int first = 0; first < from.count; first += size)
  {
    RTCRayNt<size>& part = rays[first / size];
    fillRays(from, first, part);
    alignas(64) int valid[size];
    for (int i = 0; i < size; ++i)
      valid[i] = first + i < from.count ? -1 : 0;
    rtcOccluded16(valid, scene, &context, reinterpret_cast<RTCRay16*>(&part));
  }
  return occludedBits(from, [&](int i) { return rays[i / size].tfar[i % size]; });
}

std::uint64_t inStream(RTCScene scene, RTCIntersectContext& context, const EmbreeRays& from)
{
  constexpr int size = EmbreeRays::capacity;
  alignas(64) RTCRayNt<size> rays;
  fillRays(from, 0, rays);
  rtcOccludedNM(scene, &context, reinterpret_cast<RTCRayN*>(&rays), size, 1, sizeof(rays));
  return occludedBits(from, [&](int i) { return rays.tfar[i]; });
}

std::uint64_t inRayStream(RTCScene scene, RTCIntersectContext& context, const EmbreeRays& from)
{
  RTCRay rays[EmbreeRays::capacity];
  for (int i = 0; i < from.count; ++i)
    rays[i] = singleRay(from, i);
  rtcOccluded1M(scene, &context, rays, static_cast<unsigned>(from.count), sizeof(RTCRay));
  return occludedBits(from, [&](int i) { return rays[i].tfar; });
}

} // namespace

const std::vector<std::string>& embreeOcclusionModes()
{
  static const std::vector<std::string> names = {
    "single", "packet 16", "stream 64", "ray stream 64"};
  return names;
}

std::uint64_t embreeOccluded(
  std::size_t mode, RTCScene scene, RTCIntersectContextFlags flags, const EmbreeRays& rays)
{
  using Occlude = std::uint64_t (*)(RTCScene, RTCIntersectContext&, const EmbreeRays&);
  static constexpr Occlude all[] = {inSingles, inPackets, inStream, inRayStream};
  RTCIntersectContext context = embreeContext(flags);
  return all[mode](scene, context, rays);
}

void embreeOccluded(
  std::size_t mode, RTCScene scene, const OcclusionRays& rays, OcclusionAnswers& answers)
{
  forPackets(rays, answers,
    [&](const OcclusionRays::Packet& packet)
    {
      EmbreeRays asked;
      asked.count = packet.count;
      for (std::size_t k = 0; k < 3; ++k)
      {
        asked.origin[k] = packet.origin32[k];
        asked.direction[k] = packet.direction32[k];
      }
      asked.reach = static_cast<float>(rays.reach);
      return embreeOccluded(mode, scene, RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT, asked);
    });
}

} // namespace mote::bench
