// Spheres as a surface; where hits lie and look to is compiled once for every SIMD instruction set.

#include "ParticleSurface.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/ParticleSurface.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "../core/detail/HitPoints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Places hits on spheres, `own` being their centres and radii.
void placeOnSpheres(HitBlock& b, const HitPlacing& placing)
{
  const DD d;
  const auto from = [&](VD v, double origin) { return hn::Sub(v, hn::Set(d, origin)); };
  const Vec3d& origin = placing.local.origin;
  for (int i = 0; i < b.count; i += static_cast<int>(hn::Lanes(d)))
  {
    const Three<VD> point = pointsOn(placing.local, Vec3d(0.0), b, i);
    const Three<VD> outward = {hn::Sub(point.x, from(hn::Load(d, b.own[0] + i), origin.x)),
      hn::Sub(point.y, from(hn::Load(d, b.own[1] + i), origin.y)),
      hn::Sub(point.z, from(hn::Load(d, b.own[2] + i), origin.z))};
    // In radii: squares of very small or very large numbers would leave float's range.
    const VD perRadius = hn::Div(hn::Set(d, 1.0), hn::Load(d, b.own[3] + i));
    storePlaced(b, placing, narrowed(scaled(outward, perRadius)), i);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "../core/SurfaceRounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

HWY_EXPORT(placeOnSpheres);

Box ParticleSurface::bounds() const
{
  return withStructure(*structure_, [](const auto& s) { return s.statistics().bounds; });
}

double ParticleSurface::rounding() const
{
  return surfaceRounding(this->bounds().size());
}

const PkdTree* ParticleSurface::levels() const
{
  const auto* tree = structure_ ? std::get_if<PkdTree>(structure_.get()) : nullptr;
  return poe_ > 0.0 && tree != nullptr && tree->hasLods() ? tree : nullptr;
}

/// Leaves the sphere that the hit stands for, as if it lay on it, and meets its neighbours.
double ParticleSurface::clearance(std::uint64_t slot, double cosine) const
{
  const double ofRounding = this->rounding() / cosine;
  if (!PkdTree::isLod(slot))
    return ofRounding;
  const auto& tree = std::get<PkdTree>(*structure_);
  return ofRounding + 2.0 * tree.radius(tree.speaker(slot)) + tree.lod(slot).error;
}

void ParticleSurface::cast(RayBundle& rays, std::int32_t index) const
{
  if (const PkdTree* tree = levels())
    return tree->cast(rays, index, poe_);
  withStructure(*structure_, [&](const auto& s) { s.cast(rays, index); });
}

void ParticleSurface::cast(RayPacket& rays, std::int32_t index) const
{
  withStructure(*structure_, [&](const auto& s) { s.cast(rays, index); });
}

void ParticleSurface::occlude(RayBundle& rays, std::int32_t index) const
{
  withStructure(*structure_, [&](const auto& s) { s.occlude(rays, index); });
}

void ParticleSurface::occlude(RayPacket& rays, std::int32_t index) const
{
  withStructure(*structure_, [&](const auto& s) { s.occlude(rays, index); });
}

int ParticleSurface::bundleSide(const CameraRays& rays, int x0, int y0, int size) const
{
  if (const PkdTree* tree = levels())
    return tree->bundleSide(rays, x0, y0, size, poe_);
  return withStructure(
    *structure_, [&](const auto& s) { return s.bundleSide(rays, x0, y0, size); });
}

void ParticleSurface::fetch(HitBlock& block) const
{
  const PkdTree* tree = levels();
  withStructure(*structure_,
    [&](const auto& s)
    {
      for (int k = 0; k < block.count; ++k)
      {
        const bool isLod = tree != nullptr && PkdTree::isLod(block.slot[k]);
        const Vec3d center = isLod ? tree->lod(block.slot[k]).center : s.center(block.slot[k]);
        block.own[0][k] = center.x;
        block.own[1][k] = center.y;
        block.own[2][k] = center.z;
        block.own[3][k] = isLod ? 1.0 : s.radius(block.slot[k]);
      }
    });
}

namespace
{

/// The normal of a hit on what stands for spheres, that lies `aside` from its middle. Of a sphere
/// that is lit from the eye two thirds of the light come back in the mean: that is its cosine to
/// the eye, so that what is smaller than pixels does not flicker. Around the line of sight the
/// normals spread as those of spheres do, which is what counts for other lights.
Vec3d normalOfMany(const Vec3d& aside, const Vec3d& way)
{
  const Vec3d toEye = -glm::normalize(way);
  const Vec3d across = aside - glm::dot(aside, toEye) * toEye;
  const double length = glm::length(across);
  constexpr double cosine = 2.0 / 3.0;
  return length > 0.0 ? cosine * toEye + (std::sqrt(1.0 - cosine * cosine) / length) * across
                      : toEye;
}

} // namespace

void ParticleSurface::place(HitBlock& block, const HitPlacing& placing) const
{
  const RayBundle& rays = placing.local;
  for (int k = 0; levels() != nullptr && k < block.count; ++k)
    if (PkdTree::isLod(block.slot[k]))
    {
      const Vec3d way = rays.directionOf(block.ray[k]);
      const Vec3d point = rays.originOf(block.ray[k]) + block.t[k] * way;
      const Vec3d middle(block.own[0][k], block.own[1][k], block.own[2][k]);
      // As the centre of a sphere with this normal there, large enough to be told from the point.
      const double radius = std::max(glm::length(point - middle), rounding());
      const Vec3d center = point - radius * normalOfMany(point - middle, way);
      for (int axis = 0; axis < 3; ++axis)
        block.own[axis][k] = center[axis];
      block.own[3][k] = radius;
    }
  HWY_DYNAMIC_DISPATCH(placeOnSpheres)(block, placing);
}

Vec3d ParticleSurface::normalAt(std::uint64_t slot, const Vec3d& point) const
{
  if (PkdTree::isLod(slot))
    return point - std::get<PkdTree>(*structure_).lod(slot).center;
  return withStructure(
    *structure_, [&](const auto& s) { return (point - s.center(slot)) / s.radius(slot); });
}

Vec3d ParticleSurface::seenNormalAt(std::uint64_t slot, const Vec3d& point, const Vec3d& way) const
{
  return normalOfMany(point - std::get<PkdTree>(*structure_).lod(slot).center, way);
}

bool ParticleSurface::encloses(std::uint64_t slot, const Vec3d& point) const
{
  return !PkdTree::isLod(slot) &&
         withStructure(*structure_,
           [&](const auto& s) { return glm::length(point - s.center(slot)) < s.radius(slot); });
}

double ParticleSurface::largestWidth() const
{
  return 2.0 *
         withStructure(*structure_, [](const auto& s) { return s.statistics().largestRadius; });
}

void ParticleSurface::inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const
{
  withStructure(*structure_,
    [&](const auto& s)
    {
      for (int k = 0; k < count; ++k)
        ids[k] = s.inputIndex(
          PkdTree::isLod(slots[k]) ? std::get<PkdTree>(*structure_).speaker(slots[k]) : slots[k]);
    });
}

std::size_t ParticleSurface::slots() const
{
  return withStructure(*structure_, [](const auto& s) { return s.size(); });
}

std::vector<FeatureSize> ParticleSurface::featureSizes() const
{
  constexpr std::size_t most = 512; // each is a miss of the cache
  return withStructure(*structure_,
    [&](const auto& s)
    {
      std::vector<FeatureSize> sizes(std::min(s.size(), most));
      for (std::size_t k = 0; k < sizes.size(); ++k)
      {
        const double radius = s.radius(k * s.size() / sizes.size());
        sizes[k] = {radius, radius * radius * double(s.size()) / double(sizes.size())};
      }
      return sizes;
    });
}

} // namespace mote

#endif
