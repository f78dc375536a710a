#include "SecondaryRays.h"

#include <kernels/particles/GeneratedParticles.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote::bench
{

const char* nameOf(TriangleTask task)
{
  static constexpr const char* names[] = {"primary", "occlusion", "shadow", "reflection"};
  return names[static_cast<std::size_t>(task)];
}

Vec3d towardsLight()
{
  return glm::normalize(Vec3d(-0.3, 0.9, 0.5));
}

namespace
{

/// What a pixel shows.
struct Seen
{
  Vec3d at, normal, way; ///< the normal looks at the eye
  double width;          ///< of the pixel there
};

/// Calls visit(seen) for the pixels that show something, those of 8x8 side by side.
template <typename Visit>
void forSeen(const TriangleImage& image, const CameraRays& camera, const Visit& visit)
{
  RayBundle frame;
  camera.placeBundle(frame, 16, 0, 0, 0.0, 0.0);
  for (int y0 = 0; y0 < image.height(); y0 += 8)
    for (int x0 = 0; x0 < image.width(); x0 += 8)
      for (int i = 0; i < 64; ++i)
      {
        int x = 0, y = 0;
        bundleOffset(8, i, x, y);
        x += x0;
        y += y0;
        if (x >= image.width() || y >= image.height() || !std::isfinite(image.t(x, y)))
          continue;
        const TriangleImage::Block& block = image.blockAt(x, y);
        const int k = TriangleImage::place(x, y);
        const Vec3d way = camera.directionAt(x + 0.5, y + 0.5);
        Vec3d normal(block.normal[0][k], block.normal[1][k], block.normal[2][k]);
        if (!(glm::length(normal) > 0.0))
          continue;
        normal = glm::normalize(normal) * (glm::dot(normal, way) > 0.0 ? -1.0 : 1.0);
        const double t = block.t[k];
        visit(Seen{camera.originAt(x + 0.5, y + 0.5) + t * way, normal, glm::normalize(way),
          frame.footprint + t * frame.footprintPerT});
      }
}

} // namespace

SecondaryRays secondaryRays(
  TriangleTask task, const TriangleImage& image, const CameraRays& camera, const Box& bounds)
{
  SecondaryRays made;
  if (task == TriangleTask::Primary)
    return made;
  const Vec3d size = bounds.size(), light = towardsLight();
  const double side = std::max({size.x, size.y, size.z});
  made.rays.reach = task == TriangleTask::Occlusion ? occlusionReach * side : 4.0 * side;
  if (task == TriangleTask::Reflection)
    made.widthPerLength = glm::length(camera.dx) / glm::length(camera.d0);
  std::uint64_t number = 0;
  forSeen(image, camera,
    [&](const Seen& seen)
    {
      Vec3d way = light;
      if (task == TriangleTask::Occlusion)
      {
        way = cosineWeighted(seen.normal, uniformNumber(4, number), uniformNumber(4, number + 1));
        number += 2;
      }
      else if (task == TriangleTask::Reflection)
        way = glm::reflect(seen.way, seen.normal);
      else if (!(glm::dot(seen.normal, light) > 0.0))
        return;
      const Vec3d at = seen.at + 1e-5 * side * seen.normal;
      addRay(made.rays, at, way, at, Vec3d(0.0));
      made.width.resize(made.rays.packets.size(), std::numeric_limits<double>::infinity());
      made.width.back() = std::min(made.width.back(), seen.width);
    });
  return made;
}

} // namespace mote::bench
