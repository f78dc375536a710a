#include "detail/ShadowCaster.h"

#include "detail/ClippedRays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mote
{

namespace
{

/// Shadow rays lie up to this many widths of the camera's bundle apart (see docs/shadows.md).
constexpr double widestBundle = 2.0;
/// Points are seen from a point light within this ratio of half their extent to their distance.
constexpr double widestAngle = 0.5;

} // namespace

/// What one call of remove() works with.
struct ShadowCaster::Work
{
  const SceneRays& rays;
  SurfaceBlock& block;
  const LightSample& sample;
  double widest;     ///< how far the points of a bundle may lie apart, seen from the light
  Vec3d ahead, u, v; ///< the present bundle's frame: unit vectors, `ahead` from the light
  Vec3d middle;      ///< of the points, from the reference point
  double distance;   ///< of the middle from the sample; directional: from where rays start
  double x[SurfaceBlock::capacity], y[SurfaceBlock::capacity]; ///< of hits, from the middle
  double t[SurfaceBlock::capacity];
  double ownEnd[SurfaceBlock::capacity]; ///< of rays to hits that err: for what they hit itself
  std::uint16_t spare[SurfaceBlock::capacity];
  RayBundle bundle;

  Work(const SceneRays& scene, SurfaceBlock& hits, const LightSample& light, double widestSpread)
    : rays(scene)
    , block(hits)
    , sample(light)
    , widest(widestSpread)
  {
  }

  Vec3d position(int i) const
  {
    return {block.position.x[i], block.position.y[i], block.position.z[i]};
  }
  void shadow(int i)
  {
    block.cosine[i] = 0.0f;
    block.shine[i] = 0.0f;
  }
  bool isPoint() const { return sample.kind == Light::Kind::Point; }

  /// Brings hits with a key below `middle` to the front; answers how many. Where that would
  /// separate none, the front half.
  template <typename Key>
  int split(std::uint16_t* hits, int count, double at, const Key& key)
  {
    int low = 0, high = 0;
    for (int k = 0; k < count; ++k)
    {
      const std::uint16_t i = hits[k];
      (key(i) < at ? hits[low++] : spare[high++]) = i;
    }
    std::copy_n(spare, high, hits + low);
    return low == 0 || high == 0 ? count / 2 : low;
  }

  /// Where the ray to hit i ends: at the hit, less what may move surfaces along the ray, as a
  /// length.
  double endOf(int i, double blur) const { return std::max(t[i] - blur / distance, 0.5 * t[i]); }
  /// For all surfaces that is what rounding may move them by: spheres that coincide with the one
  /// that is lit would shadow it in speckles.
  double endOf(int i) const
  {
    return endOf(i, rays.rounding(block.surface) / double(block.cosine[i]));
  }
  /// For the one that the hit is of an allowed error, too.
  double ownEndOf(int i) const
  {
    return endOf(i, rays.clearance(block.surface, block.slot[i], double(block.cosine[i])));
  }

  int splitInPlane(std::uint16_t* hits, int count);
  void look(const Vec3d& lowest, const Vec3d& highest, const Box& bounds);
  double project(const std::uint16_t* hits, int count);
};

/// Splits across the longer side of the points' rectangle in the frame.
int ShadowCaster::Work::splitInPlane(std::uint16_t* hits, int count)
{
  double left = x[hits[0]], right = left, low = y[hits[0]], high = low;
  for (int k = 1; k < count; ++k)
  {
    left = std::min(left, x[hits[k]]);
    right = std::max(right, x[hits[k]]);
    low = std::min(low, y[hits[k]]);
    high = std::max(high, y[hits[k]]);
  }
  if (right - left > high - low)
    return split(hits, count, 0.5 * (left + right), [&](int i) { return x[i]; });
  return split(hits, count, 0.5 * (low + high), [&](int i) { return y[i]; });
}

/// Sets the frame for points in a box.
void ShadowCaster::Work::look(const Vec3d& lowest, const Vec3d& highest, const Box& bounds)
{
  middle = lowest + 0.5 * (highest - lowest);
  if (isPoint())
  {
    const Vec3d way = middle - sample.place;
    distance = glm::length(way);
    ahead = way / distance;
  }
  else
  {
    // The rays start before all that there is.
    ahead = -sample.place;
    const Vec3d first = {ahead.x > 0.0 ? bounds.lower.x : bounds.upper.x,
      ahead.y > 0.0 ? bounds.lower.y : bounds.upper.y,
      ahead.z > 0.0 ? bounds.lower.z : bounds.upper.z};
    const Vec3d size = bounds.size();
    distance = glm::dot(middle - first, ahead) + 0.01 * (size.x + size.y + size.z);
  }
  acrossAxes(ahead, u, v);
}

/// Places the points in the frame: where their rays cross the plane through the middle, and t in
/// distances of that plane. Answers their largest coordinate.
double ShadowCaster::Work::project(const std::uint16_t* hits, int count)
{
  double spread = 0.0;
  const bool fan = isPoint();
  const double perDistance = 1.0 / distance;
  for (int k = 0; k < count; ++k)
  {
    const int i = hits[k];
    const Vec3d p = position(i) - middle;
    t[i] = 1.0 + glm::dot(p, ahead) * perDistance;
    const double scale = fan ? 1.0 / t[i] : 1.0;
    x[i] = scale * glm::dot(p, u);
    y[i] = scale * glm::dot(p, v);
    spread = std::max({spread, std::abs(x[i]), std::abs(y[i])});
  }
  return spread;
}

ShadowCaster::ShadowCaster(const SceneRays& rays)
  : rays_(rays)
  , bounds_(rays.scene().bounds())
{
  bounds_.lower -= rays.reference();
  bounds_.upper -= rays.reference();
}

void ShadowCaster::remove(SurfaceBlock& block, const LightSample& sample, double footprint) const
{
  Work work(rays_, block, sample, widestBundle * footprint);
  std::uint16_t hits[SurfaceBlock::capacity];
  int count = 0;
  for (int i = 0; i < block.count; ++i)
  {
    if (!(block.cosine[i] > 0.0f))
      continue;
    if (block.side[i] > 0.0f || reachesWithin(block, i, sample))
      hits[count++] = static_cast<std::uint16_t>(i);
    else
      work.shadow(i);
  }
  if (count > 0)
    cast(work, hits, count);
}

/// Whether the sample lies in the solid that hit i is seen from within: else that itself keeps its
/// light out.
bool ShadowCaster::reachesWithin(const SurfaceBlock& block, int i, const LightSample& sample) const
{
  if (sample.kind != Light::Kind::Point)
    return false;
  const Vec3d place =
    transformPoint(rays_.toLocal(block.surface), rays_.reference() + sample.place);
  return withSurface(rays_.surface(block.surface).surface,
    [&](const auto& s) { return s.encloses(block.slot[i], place); });
}

void ShadowCaster::cast(Work& work, std::uint16_t* hits, int count) const
{
  const auto castParts = [&](int first)
  {
    cast(work, hits, first);
    cast(work, hits + first, count - first);
  };
  Vec3d lowest = work.position(hits[0]), highest = lowest;
  for (int k = 1; k < count; ++k)
  {
    const Vec3d p = work.position(hits[k]);
    lowest = glm::min(lowest, p);
    highest = glm::max(highest, p);
  }
  const Vec3d size = highest - lowest;
  work.look(lowest, highest, bounds_);
  // All points must lie before a point light, and not far aside.
  if (count > 1 && work.isPoint() && !(0.5 * glm::length(size) < widestAngle * work.distance))
  {
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double at = lowest[axis] + 0.5 * size[axis];
    return castParts(work.split(hits, count, at, [&](int i) { return work.position(i)[axis]; }));
  }
  const double spread = work.project(hits, count);
  if (count > 1 && 2.0 * spread > work.widest)
    return castParts(work.splitInPlane(hits, count));
  RayBundle& bundle = work.bundle;
  const double scale = spread > 0.0 ? spread : work.distance;
  const bool errs = rays_.errs(work.block.surface);
  for (int k = 0; k < count; ++k)
  {
    bundle.x[k] = static_cast<float>(work.x[hits[k]] / scale);
    bundle.y[k] = static_cast<float>(work.y[hits[k]] / scale);
    bundle.t[k] = work.endOf(hits[k]);
    if (errs)
      work.ownEnd[k] = work.ownEndOf(hits[k]);
    bundle.slot[k] = work.block.slot[hits[k]];
    bundle.object[k] = work.block.surface;
  }
  work.u *= scale;
  work.v *= scale;
  castTogether(work, hits, count);
}

void ShadowCaster::castTogether(Work& work, const std::uint16_t* hits, int count) const
{
  RayBundle& bundle = work.bundle;
  bundle.kind = work.isPoint() ? RayBundle::Kind::CommonOrigin : RayBundle::Kind::CommonDirection;
  bundle.count = count;
  bundle.tMin = 0.0;
  const Vec3d origin =
    rays_.reference() +
    (work.isPoint() ? work.sample.place : work.middle - work.distance * work.ahead);
  const auto surfaces = static_cast<std::int32_t>(rays_.scene().surfaces.size());
  for (std::int32_t k = 0; k < surfaces; ++k)
  {
    const SurfaceObject& object = rays_.surface(k);
    if (!object.castsShadows)
      continue;
    bundle.origin = transformPoint(rays_.toLocal(k), origin);
    bundle.direction = transformVector(rays_.toLocal(k), work.distance * work.ahead);
    bundle.dx = transformVector(rays_.toLocal(k), work.u);
    bundle.dy = transformVector(rays_.toLocal(k), work.v);
    // What is off by this much moves a shadow by the width of a pixel.
    const double width = rays_.localWidth(k, work.block.width);
    bundle.footprint = work.isPoint() ? 0.0 : width;
    bundle.footprintPerT = work.isPoint() ? width : 0.0;
    const bool endsSooner = k == work.block.surface && rays_.errs(k);
    for (int i = 0; endsSooner && i < count; ++i)
      work.ownEnd[i] = std::exchange(bundle.t[i], std::min(bundle.t[i], work.ownEnd[i]));
    withSurface(object.surface,
      [&](const auto& s)
      {
        const auto visit = [&](auto& some) { s.occlude(some, k); };
        if (object.clip.isAll())
          return visit(bundle);
        RayBundle world;
        world.kind = bundle.kind;
        world.origin = origin;
        world.direction = work.distance * work.ahead;
        world.dx = work.u;
        world.dy = work.v;
        castClipped(object.clip, world, OnSurface::End, bundle, visit,
          [&](ClippedPacket& clipped, RayPacket& packet) { clipped.cast(packet, visit); });
      });
    for (int i = 0; endsSooner && i < count; ++i)
      if (bundle.t[i] > 0.0)
        bundle.t[i] = work.ownEnd[i];
  }
  for (int k = 0; k < count; ++k)
    if (!(bundle.t[k] > 0.0))
      work.shadow(hits[k]);
}

} // namespace mote
