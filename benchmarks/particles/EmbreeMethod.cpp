#include "EmbreeSpheres.h"
#include "ParticleMethod.h"

#include <algorithm>
#include <limits>

namespace mote::bench
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The camera's rays in float. Directions keep their length, so that t is the distance along the
/// view axis here too; origins are relative to the middle of the data, as the spheres are.
struct FloatRays
{
  Vec3f origin, d0, dx, dy;

  FloatRays(const CameraRays& rays, const Vec3d& middle)
    : origin(rays.o0 - middle)
    , d0(rays.d0)
    , dx(rays.dx)
    , dy(rays.dy)
  {
  }
  Vec3f direction(int x, int y) const
  {
    return d0 + (static_cast<float>(x) + 0.5f) * dx + (static_cast<float>(y) + 0.5f) * dy;
  }
};

/// The rays of a SIDE x SIDE block, one compact 4x4 block after another.
template <int SIDE>
struct Block
{
  static constexpr int size = SIDE * SIDE;
  alignas(64) RTCRayHitNt<size> rays;

  static void offset(int i, int& x, int& y)
  {
    constexpr int blocks = SIDE / 4;
    x = i % 4 + 4 * ((i / 16) % blocks);
    y = (i / 4) % 4 + 4 * (i / 16 / blocks);
  }

  void fill(const FloatRays& camera, int x0, int y0, const HitImage& image)
  {
    for (int i = 0; i < size; ++i)
    {
      int x = 0, y = 0;
      offset(i, x, y);
      const Vec3f d = camera.direction(x0 + x, y0 + y);
      const bool used = x0 + x < image.width() && y0 + y < image.height();
      rays.ray.org_x[i] = camera.origin.x;
      rays.ray.org_y[i] = camera.origin.y;
      rays.ray.org_z[i] = camera.origin.z;
      rays.ray.dir_x[i] = d.x;
      rays.ray.dir_y[i] = d.y;
      rays.ray.dir_z[i] = d.z;
      rays.ray.tnear[i] = used ? 0.0f : infinity; // such rays are passed over
      rays.ray.tfar[i] = used ? infinity : -infinity;
      rays.ray.time[i] = 0.0f;
      rays.ray.mask[i] = ~0u;
      rays.ray.flags[i] = 0;
      rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  void keep(int x0, int y0, HitImage& image) const
  {
    for (int i = 0; i < size; i += HitImage::blockPixels)
    {
      int x = 0, y = 0;
      offset(i, x, y);
      image.putBlock(x0 + x, y0 + y, &rays.ray.tfar[i], &rays.hit.primID[i]);
    }
  }
};

/// Writes `size` rays of a packet from `first` on; those past its end are passed over.
template <int size>
void fillRays(const OcclusionRays::Packet& packet, int first, float reach, RTCRayNt<size>& rays)
{
  const auto copy = [&](const float* from, float* to) { std::copy_n(from + first, size, to); };
  copy(packet.origin32[0], rays.org_x);
  copy(packet.origin32[1], rays.org_y);
  copy(packet.origin32[2], rays.org_z);
  copy(packet.direction32[0], rays.dir_x);
  copy(packet.direction32[1], rays.dir_y);
  copy(packet.direction32[2], rays.dir_z);
  for (int i = 0; i < size; ++i)
  {
    const bool used = first + i < packet.count;
    rays.tnear[i] = used ? 0.0f : infinity;
    rays.tfar[i] = used ? reach : -infinity;
    rays.time[i] = 0.0f;
    rays.mask[i] = ~0u;
    rays.id[i] = rays.flags[i] = 0;
  }
}

RTCRay singleRay(const OcclusionRays::Packet& packet, int i, float reach)
{
  const auto &o = packet.origin32, &d = packet.direction32;
  return {o[0][i], o[1][i], o[2][i], 0.0f, d[0][i], d[1][i], d[2][i], 0.0f, reach, ~0u, 0, 0};
}

/// Bits of the rays that Embree has found something on: their tfar has become -infinity.
template <typename FarEnd>
std::uint64_t occludedBits(const OcclusionRays::Packet& packet, const FarEnd& tfar)
{
  std::uint64_t bits = 0;
  for (int i = 0; i < packet.count; ++i)
    bits |= std::uint64_t{tfar(i) < 0.0f} << i;
  return bits;
}

RTCIntersectContext coherentContext()
{
  return embreeContext(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
}

RTCIntersectContext incoherentContext()
{
  return embreeContext(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
}

class EmbreeMethod : public ParticleMethod
{
public:
  explicit EmbreeMethod(int threads)
    : spheres_(threads)
  {
  }

  void build(const ParticleInput& input) override { spheres_.build(input); }
  std::size_t bytes() const override { return spheres_.bytes(); }

  std::vector<std::string> modes() const override
  {
    return {"single", "packet 4x4", "stream 8x8", "stream 16x16"};
  }

  void cast(std::size_t mode, const CameraRays& rays, HitImage& image) const override
  {
    const FloatRays camera(rays, spheres_.middle());
    switch (mode)
    {
    case 0:
      castSingle(camera, image);
      break;
    case 1:
      castPackets(camera, image);
      break;
    case 2:
      castStreams<8>(camera, image);
      break;
    default:
      castStreams<16>(camera, image);
    }
  }

  std::vector<std::string> occlusionModes() const override
  {
    return {"single", "packet 16", "stream 64", "ray stream 64"};
  }

  void occlude(
    std::size_t mode, const OcclusionRays& rays, OcclusionAnswers& answers) const override
  {
    using Occlude = std::uint64_t (EmbreeMethod::*)(const OcclusionRays::Packet&, float) const;
    static constexpr Occlude all[] = {&EmbreeMethod::occludeSingle, &EmbreeMethod::occludePackets,
      &EmbreeMethod::occludeStream, &EmbreeMethod::occludeRayStream};
    const auto reach = static_cast<float>(rays.reach);
    forPackets(rays, answers,
      [&](const OcclusionRays::Packet& packet) { return (this->*all[mode])(packet, reach); });
  }

private:
  void castSingle(const FloatRays& camera, HitImage& image) const
  {
    forBlocks(image.width(), image.height(), 8,
      [&](int x0, int y0)
      {
        RTCIntersectContext context = coherentContext();
        for (int y = y0; y < std::min(image.height(), y0 + 8); ++y)
          for (int x = x0; x < std::min(image.width(), x0 + 8); ++x)
          {
            const Vec3f o = camera.origin, d = camera.direction(x, y);
            alignas(16) RTCRayHit hit = {};
            hit.ray = {o.x, o.y, o.z, 0.0f, d.x, d.y, d.z, 0.0f, infinity, ~0u, 0, 0};
            hit.hit.geomID = hit.hit.primID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(spheres_.scene(), &context, &hit);
            image.put(x, y, hit.ray.tfar, hit.hit.primID);
          }
      });
  }

  void castPackets(const FloatRays& camera, HitImage& image) const
  {
    forBlocks(image.width(), image.height(), 4,
      [&](int x0, int y0)
      {
        static_assert(sizeof(RTCRayHitNt<16>) == sizeof(RTCRayHit16));
        RTCIntersectContext context = coherentContext();
        Block<4> block;
        block.fill(camera, x0, y0, image);
        alignas(64) int valid[16];
        for (int i = 0; i < 16; ++i)
          valid[i] = block.rays.ray.tfar[i] > 0.0f ? -1 : 0;
        rtcIntersect16(
          valid, spheres_.scene(), &context, reinterpret_cast<RTCRayHit16*>(&block.rays));
        block.keep(x0, y0, image);
      });
  }

  template <int SIDE>
  void castStreams(const FloatRays& camera, HitImage& image) const
  {
    forBlocks(image.width(), image.height(), SIDE,
      [&](int x0, int y0)
      {
        RTCIntersectContext context = coherentContext();
        Block<SIDE> block;
        block.fill(camera, x0, y0, image);
        rtcIntersectNM(spheres_.scene(), &context, reinterpret_cast<RTCRayHitN*>(&block.rays),
          Block<SIDE>::size, 1, sizeof(block.rays));
        block.keep(x0, y0, image);
      });
  }

  std::uint64_t occludeSingle(const OcclusionRays::Packet& packet, float reach) const
  {
    RTCIntersectContext context = incoherentContext();
    return occludedBits(packet,
      [&](int i)
      {
        RTCRay ray = singleRay(packet, i, reach);
        rtcOccluded1(spheres_.scene(), &context, &ray);
        return ray.tfar;
      });
  }

  std::uint64_t occludePackets(const OcclusionRays::Packet& packet, float reach) const
  {
    constexpr int size = 16;
    static_assert(sizeof(RTCRayNt<size>) == sizeof(RTCRay16));
    RTCIntersectContext context = incoherentContext();
    alignas(64) RTCRayNt<size> rays[OcclusionRays::packetRays / size];
    for (int first = 0; first < packet.count; first += size)
    {
      RTCRayNt<size>& part = rays[first / size];
      fillRays(packet, first, reach, part);
      alignas(64) int valid[size];
      for (int i = 0; i < size; ++i)
        valid[i] = first + i < packet.count ? -1 : 0;
      rtcOccluded16(valid, spheres_.scene(), &context, reinterpret_cast<RTCRay16*>(&part));
    }
    return occludedBits(packet, [&](int i) { return rays[i / size].tfar[i % size]; });
  }

  std::uint64_t occludeStream(const OcclusionRays::Packet& packet, float reach) const
  {
    constexpr int size = OcclusionRays::packetRays;
    RTCIntersectContext context = incoherentContext();
    alignas(64) RTCRayNt<size> rays;
    fillRays(packet, 0, reach, rays);
    rtcOccludedNM(
      spheres_.scene(), &context, reinterpret_cast<RTCRayN*>(&rays), size, 1, sizeof(rays));
    return occludedBits(packet, [&](int i) { return rays.tfar[i]; });
  }

  std::uint64_t occludeRayStream(const OcclusionRays::Packet& packet, float reach) const
  {
    RTCIntersectContext context = incoherentContext();
    RTCRay rays[OcclusionRays::packetRays];
    for (int i = 0; i < packet.count; ++i)
      rays[i] = singleRay(packet, i, reach);
    rtcOccluded1M(
      spheres_.scene(), &context, rays, static_cast<unsigned>(packet.count), sizeof(RTCRay));
    return occludedBits(packet, [&](int i) { return rays[i].tfar; });
  }

  EmbreeSpheres spheres_;
};

} // namespace

std::unique_ptr<ParticleMethod> makeEmbreeMethod(const MethodOptions& options)
{
  return std::make_unique<EmbreeMethod>(options.threads);
}

} // namespace mote::bench
