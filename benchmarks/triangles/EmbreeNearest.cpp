#include "EmbreeNearest.h"

namespace mote::bench
{

namespace
{

/// Rays that have hit nothing yet.
template <int size>
void fillHits(const EmbreeRays& from, int first, RTCRayHitNt<size>& rays)
{
  fillRays(from, first, rays.ray);
  std::fill_n(rays.hit.geomID, size, RTC_INVALID_GEOMETRY_ID);
  std::fill_n(rays.hit.primID, size, RTC_INVALID_GEOMETRY_ID);
}

float distanceOf(unsigned geometry, float tfar)
{
  return geometry == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : tfar;
}

template <int size>
void keepHits(const RTCRayHitNt<size>& rays, int first, PacketHits& hits)
{
  for (int i = 0; i < size; ++i)
    hits.t[first + i] = distanceOf(rays.hit.geomID[i], rays.ray.tfar[i]);
  std::copy_n(rays.hit.primID, size, hits.triangle + first);
  std::copy_n(rays.hit.Ng_x, size, hits.normal[0] + first);
  std::copy_n(rays.hit.Ng_y, size, hits.normal[1] + first);
  std::copy_n(rays.hit.Ng_z, size, hits.normal[2] + first);
}

void inSingles(
  RTCScene scene, RTCIntersectContext& context, const EmbreeRays& from, PacketHits& hits)
{
  for (int i = 0; i < from.count; ++i)
  {
    alignas(16) RTCRayHit ray = {};
    ray.ray = singleRay(from, i);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &ray);
    hits.t[i] = distanceOf(ray.hit.geomID, ray.ray.tfar);
    hits.triangle[i] = ray.hit.primID;
    hits.normal[0][i] = ray.hit.Ng_x;
    hits.normal[1][i] = ray.hit.Ng_y;
    hits.normal[2][i] = ray.hit.Ng_z;
  }
}

void inPackets(
  RTCScene scene, RTCIntersectContext& context, const EmbreeRays& from, PacketHits& hits)
{
  constexpr int size = 16;
  for (int first = 0; first < from.count; first += size)
  {
    alignas(64) RTCRayHitNt<size> rays;
    fillHits(from, first, rays);
    alignas(64) int valid[size];
    for (int i = 0; i < size; ++i)
      valid[i] = first + i < from.count ? -1 : 0;
    rtcIntersect16(valid, scene, &context, reinterpret_cast<RTCRayHit16*>(&rays));
    keepHits(rays, first, hits);
  }
}

void inStream(
  RTCScene scene, RTCIntersectContext& context, const EmbreeRays& from, PacketHits& hits)
{
  constexpr int size = EmbreeRays::capacity;
  alignas(64) RTCRayHitNt<size> rays;
  fillHits(from, 0, rays);
  rtcIntersectNM(scene, &context, reinterpret_cast<RTCRayHitN*>(&rays), size, 1, sizeof(rays));
  keepHits(rays, 0, hits);
}

} // namespace

void embreeNearest(std::size_t mode, RTCScene scene, RTCIntersectContextFlags flags,
  const OcclusionRays& rays, std::vector<PacketHits>& hits)
{
  using Cast = void (*)(RTCScene, RTCIntersectContext&, const EmbreeRays&, PacketHits&);
  static constexpr Cast all[] = {inSingles, inPackets, inStream};
  forPackets(rays,
    [&](const OcclusionRays::Packet& packet, std::size_t place)
    {
      RTCIntersectContext context = embreeContext(flags);
      all[mode](scene, context, embreeRays(packet, rays.reach), hits[place]);
    });
}

} // namespace mote::bench
