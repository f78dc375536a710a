#include "ParticleMethod.h"

#include <kernels/core/Error.h>

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <atomic>

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
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

class EmbreeMethod : public ParticleMethod
{
public:
  explicit EmbreeMethod(int threads)
  {
    // Embree limits itself to 256 bits a vector unless told that wide ones are welcome.
    const std::string config =
      "threads=" + std::to_string(threads) + ",frequency_level=simd512,set_affinity=0";
    device_ = rtcNewDevice(config.c_str());
    if (device_ == nullptr)
      throw Error("Embree cannot start on this machine.");
    rtcSetDeviceMemoryMonitorFunction(device_, countBytes, &bytes_);
  }
  ~EmbreeMethod() override
  {
    if (scene_ != nullptr)
      rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeMethod(const EmbreeMethod&) = delete;
  EmbreeMethod& operator=(const EmbreeMethod&) = delete;

  void build(const ParticleInput& input) override
  {
    const ParticleSet& set = input.set;
    middle_ = input.statistics.centers.center();
    spheres_.resize(set.count());
    tbb::parallel_for(std::size_t{0}, set.count(),
      [&](std::size_t i)
      {
        const double r = set.radiusOf(i);
        const bool valid = isValidParticle(set.position(i), r);
        spheres_[i] = valid ? Vec4f(Vec3f(set.position(i) - middle_), static_cast<float>(r))
                            : Vec4f(Vec3f(std::numeric_limits<float>::quiet_NaN()), 0.0f);
      });
    scene_ = rtcNewScene(device_);
    // Measured: HIGH gives points the same tree as MEDIUM does.
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
      spheres_.data(), 0, sizeof(Vec4f), spheres_.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
      throw Error("Embree could not build its structure over this input.");
  }

  std::size_t bytes() const override
  {
    return static_cast<std::size_t>(bytes_.load()) + spheres_.capacity() * sizeof(Vec4f);
  }

  std::vector<std::string> modes() const override
  {
    return {"single", "packet 4x4", "stream 8x8", "stream 16x16"};
  }

  void cast(std::size_t mode, const CameraRays& rays, HitImage& image) const override
  {
    const FloatRays camera(rays, middle_);
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

private:
  static bool countBytes(void* sum, ssize_t bytes, bool)
  {
    *static_cast<std::atomic<ssize_t>*>(sum) += bytes;
    return true;
  }

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
            rtcIntersect1(scene_, &context, &hit);
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
        rtcIntersect16(valid, scene_, &context, reinterpret_cast<RTCRayHit16*>(&block.rays));
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
        rtcIntersectNM(scene_, &context, reinterpret_cast<RTCRayHitN*>(&block.rays),
          Block<SIDE>::size, 1, sizeof(block.rays));
        block.keep(x0, y0, image);
      });
  }

  std::atomic<ssize_t> bytes_{0};
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  Vec3d middle_{0.0};
  RawVector<Vec4f> spheres_;
};

} // namespace

std::unique_ptr<ParticleMethod> makeEmbreeMethod(const MethodOptions& options)
{
  return std::make_unique<EmbreeMethod>(options.threads);
}

} // namespace mote::bench
