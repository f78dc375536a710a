#include "OcclusionRays.h"

#include "HitImage.h"

#include <kernels/particles/GeneratedParticles.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace mote::bench
{

namespace
{

struct Ray
{
  Vec3d origin, direction, left;
};

/// Makes the rays of pixels.
struct RayMaker
{
  const reference::SphereTree& tree;
  const ParticleInput& input;
  const CameraRays& camera;
  double side; ///< the longest of the bounds
  int width;
  int raysPerHit;

  void add(int x, int y, std::vector<Ray>& rays) const
  {
    const reference::Ray eye = reference::cameraRay(camera, x + 0.5, y + 0.5);
    const reference::Hit hit = tree.cast(eye);
    if (!hit)
      return;
    const Vec3d center = input.set.position(hit.particle);
    const double radius = input.set.radiusOf(hit.particle);
    const Vec3d normal = glm::normalize(eye.origin + hit.t * eye.direction - center);
    // A little off the surface, so that the particle itself does not count. The second bound is a
    // few units in the last place of coordinates in float, for particles that are small beside it.
    const double offset = std::max(1e-4 * radius, 2e-7 * side);
    const Vec3d origin = center + (radius + offset) * normal;
    const std::uint64_t pixel = static_cast<std::uint64_t>(y) * width + x;
    for (int k = 0; k < raysPerHit; ++k)
    {
      const std::uint64_t n = 2 * (pixel * raysPerHit + k);
      rays.push_back(
        {origin, cosineWeighted(normal, uniformNumber(4, n), uniformNumber(4, n + 1)), center});
    }
  }
};

/// The rays of a tile of pixels, one compact block of 8x8 pixels after another.
std::vector<Ray> raysOfTile(const RayMaker& maker, int x0, int y0, int width, int height)
{
  constexpr int block = 8;
  std::vector<Ray> rays;
  forBlocksOfTile(x0, y0, width, height, block,
    [&](int blockX, int blockY)
    {
      for (int i = 0; i < block * block; ++i)
      {
        int x = 0, y = 0;
        bundleOffset(block, i, x, y);
        if (blockX + x < width && blockY + y < height)
          maker.add(blockX + x, blockY + y, rays);
      }
    });
  return rays;
}

} // namespace

Vec3d cosineWeighted(const Vec3d& normal, double a, double b)
{
  const double z = 2.0 * a - 1.0, r = std::sqrt(1.0 - z * z);
  const double angle = 2.0 * 3.14159265358979323846 * b;
  const Vec3d sum = normal + Vec3d(r * std::cos(angle), r * std::sin(angle), z);
  return glm::length(sum) > 1e-6 ? glm::normalize(sum) : normal;
}

void addRay(OcclusionRays& rays, const Vec3d& origin, const Vec3d& direction, const Vec3d& left,
  const Vec3d& middle)
{
  if (rays.count++ % OcclusionRays::packetRays == 0)
    rays.packets.emplace_back();
  OcclusionRays::Packet& packet = rays.packets.back();
  const int i = packet.count++;
  for (int axis = 0; axis < 3; ++axis)
  {
    packet.origin[axis][i] = origin[axis];
    packet.direction[axis][i] = direction[axis];
    packet.origin32[axis][i] = static_cast<float>(origin[axis] - middle[axis]);
    packet.direction32[axis][i] = static_cast<float>(direction[axis]);
    packet.left[axis][i] = left[axis];
  }
}

OcclusionRays makeOcclusionRays(const reference::SphereTree& tree, const ParticleInput& input,
  const CameraRays& camera, int width, int height, int raysPerHit)
{
  const Vec3d size = input.statistics.bounds.size();
  const double side = std::max({size.x, size.y, size.z});
  const RayMaker maker{tree, input, camera, side, width, raysPerHit};
  const std::size_t columns = (static_cast<std::size_t>(width) + tileSide - 1) / tileSide;
  const std::size_t rows = (static_cast<std::size_t>(height) + tileSide - 1) / tileSide;
  std::vector<std::vector<Ray>> tiles(columns * rows);
  forTiles(width, height,
    [&](int x0, int y0)
    { tiles[y0 / tileSide * columns + x0 / tileSide] = raysOfTile(maker, x0, y0, width, height); });

  OcclusionRays made;
  made.reach = occlusionReach * side;
  const Vec3d middle = middleOf(input);
  for (const std::vector<Ray>& tile : tiles)
    for (const Ray& ray : tile)
      addRay(made, ray.origin, ray.direction, ray.left, middle);
  return made;
}

OcclusionAnswers referenceAnswers(const reference::SphereTree& tree, const OcclusionRays& rays)
{
  OcclusionAnswers answers(rays.packets.size());
  forPackets(rays, answers,
    [&](const OcclusionRays::Packet& packet)
    {
      std::uint64_t bits = 0;
      for (int i = 0; i < packet.count; ++i)
      {
        const auto at = [i](const double(&v)[3][OcclusionRays::packetRays])
        { return Vec3d(v[0][i], v[1][i], v[2][i]); };
        if (tree.cast({at(packet.origin), at(packet.direction), 0.0, rays.reach}))
          bits |= std::uint64_t{1} << i;
      }
      return bits;
    });
  return answers;
}

} // namespace mote::bench
