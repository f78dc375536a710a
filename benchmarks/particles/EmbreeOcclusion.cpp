#include "EmbreeOcclusion.h"

namespace mote::bench
{

namespace
{

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

EmbreeRays embreeRays(const OcclusionRays::Packet& packet, double reach)
{
  EmbreeRays rays;
  rays.count = packet.count;
  for (std::size_t k = 0; k < 3; ++k)
  {
    rays.origin[k] = packet.origin32[k];
    rays.direction[k] = packet.direction32[k];
  }
  rays.reach = static_cast<float>(reach);
  return rays;
}

void embreeOccluded(std::size_t mode, RTCScene scene, RTCIntersectContextFlags flags,
  const OcclusionRays& rays, OcclusionAnswers& answers)
{
  forPackets(rays, answers,
    [&](const OcclusionRays::Packet& packet)
    { return embreeOccluded(mode, scene, flags, embreeRays(packet, rays.reach)); });
}

} // namespace mote::bench
