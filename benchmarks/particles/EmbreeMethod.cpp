#include "EmbreeOcclusion.h"
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

RTCIntersectContext coherentContext()
{
  return embreeContext(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
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

  std::vector<std::string> occlusionModes() const override { return embreeOcclusionModes(); }

  void occlude(
    std::size_t mode, const OcclusionRays& rays, OcclusionAnswers& answers) const override
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
        return embreeOccluded(mode, spheres_.scene(), RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT, asked);
      });
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

  EmbreeSpheres spheres_;
};

} // namespace

std::unique_ptr<ParticleMethod> makeEmbreeMethod(const MethodOptions& options)
{
  return std::make_unique<EmbreeMethod>(options.threads);
}

} // namespace mote::bench
