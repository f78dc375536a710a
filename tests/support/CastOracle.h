#pragma once

#include "SphereTree.h"

#include <kernels/core/HitBlock.h>
#include <kernels/core/RayBundle.h>
#include <kernels/core/RayPacket.h>

#include <string>

namespace mote::testing
{

/// What a check of many rays found.
struct CastReport
{
  std::size_t rays = 0;
  std::size_t hits = 0;
  std::size_t wrong = 0;
  std::string complaint; ///< about the first wrong ray

  void add(const CastReport& other);
};

/// Judges a structure's answers by the reference, allowing for one length of rounding, `slack`.
///
/// An answer is right if the point that it names lies on the sphere that it names, to within the
/// slack, and if it is no nearer than the nearest hit on spheres that are a slack larger, and no
/// farther than that on spheres a slack smaller. So near a silhouette either answer passes, and
/// nowhere else.
class CastOracle
{
public:
  CastOracle(const ParticleSet& particles, double slack);

  /// A slack of `share` times the longest side of the spheres' bounds. Float numbers relative to
  /// the middle of the data err by 6e-8 of their size; the ray's formulas add a few of those.
  static CastOracle forFloat(const ParticleSet& particles, double share = 4e-7);

  double slack() const { return slack_; }
  reference::Hit nearest(const reference::Ray& ray) const { return exact_.cast(ray); }

  /// Judges one answer; `particle` is an input index, or Hit::none.
  void judge(const reference::Ray& ray, double t, std::size_t particle, CastReport& report) const;

private:
  const ParticleSet particles_;
  double slack_;
  reference::SphereTree exact_, grown_, shrunk_;
};

/// The ray and its ends in words.
std::string describe(const reference::Ray& ray);

/// Ray i of a packet.
reference::Ray rayOf(const RayPacket& packet, int i);

/// Casts the packet and judges every ray of it, by an oracle of particles or of triangles.
template <typename Structure, typename Oracle>
CastReport checkPacket(const Structure& structure, const Oracle& oracle, const RayPacket& question)
{
  CastReport report;
  RayPacket packet = question;
  structure.cast(packet, 3);
  for (int i = 0; i < packet.count; ++i)
  {
    const bool isHit = packet.slot[i] != RayPacket::noHit;
    if (isHit != (packet.object[i] == 3))
      report.complaint = "slot and object do not agree";
    oracle.judge(rayOf(question, i), packet.t[i],
      isHit ? structure.inputIndex(packet.slot[i]) : reference::Hit::none, report);
  }
  return report;
}

/// Ray i of a bundle.
reference::Ray rayOf(const RayBundle& bundle, int i);

/// Casts the bundle and judges every ray of it.
template <typename Structure, typename Oracle>
CastReport checkBundle(const Structure& structure, const Oracle& oracle, const RayBundle& question)
{
  CastReport report;
  RayBundle bundle = question;
  structure.cast(bundle, 3);
  for (int i = 0; i < bundle.count; ++i)
  {
    const bool isHit = bundle.slot[i] != RayBundle::noHit;
    if (isHit != (bundle.object[i] == 3))
      report.complaint = "slot and object do not agree";
    oracle.judge(rayOf(question, i), bundle.t[i],
      isHit ? structure.inputIndex(bundle.slot[i]) : reference::Hit::none, report);
  }
  return report;
}

/// Calls visit(bundle) for all rays of an image, in bundles of `side` x `side`.
template <typename Visit>
void forBundles(const Camera& camera, int width, int height, int side, const Visit& visit)
{
  const CameraRays rays(camera, width, height);
  RayBundle bundle;
  for (int y = 0; y < height; y += side)
    for (int x = 0; x < width; x += side)
    {
      rays.fillBundle(bundle, side, x, y, 0.0, 0.0);
      visit(bundle);
    }
}

/// Casts all rays of an image, in bundles of `side` x `side`.
template <typename Structure, typename Oracle>
CastReport checkImage(const Structure& structure, const Oracle& oracle, const Camera& camera,
  int width, int height, int side = 16)
{
  CastReport report;
  forBundles(camera, width, height, side,
    [&](const RayBundle& bundle) { report.add(checkBundle(structure, oracle, bundle)); });
  return report;
}

/// A packet of no rays yet.
RayPacket emptyPacket();

/// Adds a ray to a packet that has room.
void addRay(RayPacket& packet, const Vec3d& origin, const Vec3d& direction, double tMin = 0.0,
  double tMax = std::numeric_limits<double>::infinity());

/// A camera at `eye` that looks at `target`, up being whatever suits.
Camera lookAt(const Vec3d& eye, const Vec3d& target, double viewAngle = 30.0);

/// The hits of a bundle on the object 0, as a surface takes them to fetch() and place().
inline HitBlock hitsOf(const RayBundle& rays)
{
  HitBlock block;
  for (int i = 0; i < rays.count; ++i)
    if (rays.object[i] == 0)
    {
      const int k = block.count++;
      block.ray[k] = static_cast<std::uint16_t>(i);
      block.slot[k] = rays.slot[i];
      block.rayX[k] = rays.x[i];
      block.rayY[k] = rays.y[i];
      block.t[k] = rays.t[i];
    }
  return block;
}

} // namespace mote::testing
