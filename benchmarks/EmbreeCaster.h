#pragma once

#include "EmbreeDevice.h"
#include "particles/HitImage.h"

#include <kernels/core/Camera.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace mote::bench
{

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
struct EmbreeBlock
{
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  static constexpr int size = SIDE * SIDE;
  alignas(64) RTCRayHitNt<size> rays;

  static void offset(int i, int& x, int& y)
  {
    constexpr int blocks = SIDE / 4;
    x = i % 4 + 4 * ((i / 16) % blocks);
    y = (i / 4) % 4 + 4 * (i / 16 / blocks);
  }

  void fill(const FloatRays& camera, int x0, int y0, int width, int height)
  {
    for (int i = 0; i < size; ++i)
    {
      int x = 0, y = 0;
      offset(i, x, y);
      const Vec3f d = camera.direction(x0 + x, y0 + y);
      const bool used = x0 + x < width && y0 + y < height;
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

  /// Calls put(x, y, i) for every 4x4 pixels, the first of which is ray i.
  template <typename Put>
  void keep(int x0, int y0, const Put& put) const
  {
    for (int i = 0; i < size; i += 16)
    {
      int x = 0, y = 0;
      offset(i, x, y);
      put(x0 + x, y0 + y, i);
    }
  }
};

inline RTCIntersectContext coherentContext()
{
  return embreeContext(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
}

/// Casts a camera's rays by Embree. An Image has width(), height(), put(x, y, RTCRayHit) and
/// putBlock(x, y, rays, i), which takes 16 rays from i on of an RTCRayHitNt.
template <typename Image>
class EmbreeCaster
{
public:
  explicit EmbreeCaster(RTCScene scene)
    : scene_(scene)
  {
  }

  static std::vector<std::string> modes()
  {
    return {"single", "packet 4x4", "stream 8x8", "stream 16x16"};
  }

  /// What the scene's coordinates count from is `middle`.
  void cast(std::size_t mode, const CameraRays& rays, const Vec3d& middle, Image& image) const
  {
    const FloatRays camera(rays, middle);
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
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  void castSingle(const FloatRays& camera, Image& image) const
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
            image.put(x, y, hit);
          }
      });
  }

  void castPackets(const FloatRays& camera, Image& image) const
  {
    forBlocks(image.width(), image.height(), 4,
      [&](int x0, int y0)
      {
        static_assert(sizeof(RTCRayHitNt<16>) == sizeof(RTCRayHit16));
        RTCIntersectContext context = coherentContext();
        EmbreeBlock<4> block;
        block.fill(camera, x0, y0, image.width(), image.height());
        alignas(64) int valid[16];
        for (int i = 0; i < 16; ++i)
          valid[i] = block.rays.ray.tfar[i] > 0.0f ? -1 : 0;
        rtcIntersect16(valid, scene_, &context, reinterpret_cast<RTCRayHit16*>(&block.rays));
        block.keep(x0, y0, [&](int x, int y, int i) { image.putBlock(x, y, block.rays, i); });
      });
  }

  template <int SIDE>
  void castStreams(const FloatRays& camera, Image& image) const
  {
    forBlocks(image.width(), image.height(), SIDE,
      [&](int x0, int y0)
      {
        RTCIntersectContext context = coherentContext();
        EmbreeBlock<SIDE> block;
        block.fill(camera, x0, y0, image.width(), image.height());
        rtcIntersectNM(scene_, &context, reinterpret_cast<RTCRayHitN*>(&block.rays),
          EmbreeBlock<SIDE>::size, 1, sizeof(block.rays));
        block.keep(x0, y0, [&](int x, int y, int i) { image.putBlock(x, y, block.rays, i); });
      });
  }

  RTCScene scene_;
};

} // namespace mote::bench
