// Rays on their way through an RlodPaperTree. Included once per SIMD instruction set.

#if defined(MOTE_PAPER_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PAPER_RAYS_INL_H
#undef MOTE_PAPER_RAYS_INL_H
#else
#define MOTE_PAPER_RAYS_INL_H
#endif

#include "RlodPaperTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mote::bench
{
namespace HWY_NAMESPACE
{

constexpr float infinity = std::numeric_limits<float>::infinity();
/// By which places may be rounded, in the tree's unit: planes count as so thick.
constexpr float placeRounding = 0x1p-20f;

/// SIZE rays in the tree's coordinates: origin + tau * way, the origin being near the triangles and
/// |way| about 1, so that float errors are relative to the tree.
template <int SIZE>
struct PaperRays
{
  static constexpr int align = SIZE * 4 < 64 ? SIZE * 4 : 64;

  alignas(align) float origin[3][SIZE];
  alignas(align) float way[3][SIZE];
  alignas(align) float inverse[3][SIZE];               ///< of `way`, finite
  alignas(align) float lower[3][SIZE], upper[3][SIZE]; ///< a plane p is met at p * inverse + these
  alignas(align) float shearX[SIZE], shearY[SIZE], perDepth[SIZE]; ///< see beginGroup()
  alignas(align) float least[SIZE], best[SIZE];            ///< tau that count: between these
  alignas(align) float enter[SIZE], leave[SIZE];           ///< of the bounds
  alignas(align) float allowed[SIZE], allowedPerTau[SIZE]; ///< error, where an R-LOD begins
  alignas(align) std::uint32_t slot[SIZE];
  double tau0[SIZE], perT[SIZE]; ///< tau is t * perT - tau0
  int group[SIZE];               ///< rays of one group go through the tree together, or -1
  int axes[3];                   ///< the depth's last

  static constexpr std::uint32_t none = ~0U;

  /// Takes the rays from `count` on out, and finds where all enter and leave the bounds; origin,
  /// way, least and best are known.
  void prepare(const RlodPaperArrays& tree, int count)
  {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < SIZE; ++i)
      {
        const float safe = std::copysign(std::max(std::abs(way[axis][i]), 1e-18f), way[axis][i]);
        const float per = 1.0f / safe, at = origin[axis][i] * per;
        const float reach = placeRounding * std::abs(per);
        inverse[axis][i] = per;
        lower[axis][i] = -at - reach;
        upper[axis][i] = reach - at;
      }
    for (int i = 0; i < SIZE; ++i)
    {
      enter[i] = least[i];
      leave[i] = best[i];
      slot[i] = none;
    }
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < SIZE; ++i)
      {
        const float a = tree.lower[axis] * inverse[axis][i],
                    b = tree.upper[axis] * inverse[axis][i];
        enter[i] = std::max(enter[i], std::min(a, b) + lower[axis][i]);
        leave[i] = std::min(leave[i], std::max(a, b) + upper[axis][i]);
      }
    for (int i = 0; i < SIZE; ++i)
    {
      const float x = std::abs(way[0][i]), y = std::abs(way[1][i]), z = std::abs(way[2][i]);
      const int depth = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
      group[i] =
        depth << 3 | (way[0][i] < 0.0f) | (way[1][i] < 0.0f) << 1 | (way[2][i] < 0.0f) << 2;
      if (i >= count || !(enter[i] <= leave[i]))
        group[i] = -1;
    }
  }

  /// Shears that make the ways of a group's rays lie along its steepest axis: Woop, Benthin, Wald,
  /// "Watertight Ray/Triangle Intersection" (2013).
  void beginGroup(int which)
  {
    axes[2] = which >> 3;
    axes[0] = (axes[2] + 1) % 3;
    axes[1] = (axes[2] + 2) % 3;
    for (int i = 0; i < SIZE; ++i)
    {
      perDepth[i] = inverse[axes[2]][i];
      shearX[i] = way[axes[0]][i] * perDepth[i];
      shearY[i] = way[axes[1]][i] * perDepth[i];
    }
  }
};

/// Where a line's tau begin to count: its way to the bounds.
inline double wayTo(const RlodPaperArrays& tree, const Vec3d& from)
{
  return glm::length(from - glm::clamp(from, Vec3d(tree.lower), Vec3d(tree.upper)));
}

/// Takes rays of a bundle, from `first` on.
template <int SIZE>
int takeRays(
  const RlodPaperTree& tree, const RayBundle& from, int first, double poe, PaperRays<SIZE>& rays)
{
  const int count = std::min(SIZE, from.count - first);
  const bool common = from.kind == RayBundle::Kind::CommonOrigin;
  const double unit = tree.unit(), perT = glm::length(from.direction) / unit;
  const Vec3d eye = (from.origin - tree.origin()) / unit, way = from.direction / (unit * perT);
  const double tau0 = wayTo(tree.arrays(), eye);
  const Vec3d dx = from.dx / unit, dy = from.dy / unit;
  const double ways = common ? 1.0 / perT : 0.0, origins = common ? tau0 / perT : 1.0;
  const Vec3f o(eye + tau0 * way), ox(origins * dx), oy(origins * dy);
  const Vec3f d(way), wx(ways * dx), wy(ways * dy);
  alignas(64) float x[SIZE], y[SIZE];
  for (int i = 0; i < SIZE; ++i)
  {
    const int k = first + std::min(i, count - 1);
    x[i] = from.x[k];
    y[i] = from.y[k];
    rays.best[i] = static_cast<float>(from.t[k] * perT - tau0);
  }
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < SIZE; ++i)
    {
      rays.origin[axis][i] = o[axis] + x[i] * ox[axis] + y[i] * oy[axis];
      rays.way[axis][i] = d[axis] + x[i] * wx[axis] + y[i] * wy[axis];
    }
  const double perTau = poe * from.footprintPerT / perT;
  for (int i = 0; i < SIZE; ++i)
  {
    rays.least[i] = static_cast<float>(from.tMin * perT - tau0);
    rays.tau0[i] = tau0;
    rays.perT[i] = perT;
    rays.allowed[i] = static_cast<float>((poe * from.footprint + tau0 * perTau) / unit);
    rays.allowedPerTau[i] = static_cast<float>(perTau / unit);
  }
  rays.prepare(tree.arrays(), perT > 0.0 ? count : 0);
  return count;
}

/// Takes rays of a packet.
template <int SIZE>
int takeRays(
  const RlodPaperTree& tree, const RayPacket& from, int first, double poe, PaperRays<SIZE>& rays)
{
  const int count = std::min(SIZE, from.count - first);
  const double unit = tree.unit();
  for (int i = 0; i < SIZE; ++i)
  {
    const int k = first + std::min(i, count - 1);
    const Vec3d direction(from.direction[0][k], from.direction[1][k], from.direction[2][k]);
    const Vec3d eye =
      (Vec3d(from.origin[0][k], from.origin[1][k], from.origin[2][k]) - tree.origin()) / unit;
    const double perT = std::max(glm::length(direction) / unit, 1e-300);
    const Vec3d way = direction / (unit * perT);
    const double tau0 = wayTo(tree.arrays(), eye);
    for (int axis = 0; axis < 3; ++axis)
    {
      rays.origin[axis][i] = static_cast<float>(eye[axis] + tau0 * way[axis]);
      rays.way[axis][i] = static_cast<float>(way[axis]);
    }
    rays.tau0[i] = tau0;
    rays.perT[i] = perT;
    rays.least[i] = static_cast<float>(from.tMin[k] * perT - tau0);
    rays.best[i] = static_cast<float>(from.t[k] * perT - tau0);
    const double perTau = poe * from.footprintPerT / perT;
    rays.allowed[i] = static_cast<float>((poe * from.footprint + tau0 * perTau) / unit);
    rays.allowedPerTau[i] = static_cast<float>(perTau / unit);
  }
  rays.prepare(tree.arrays(), count);
  return count;
}

} // namespace HWY_NAMESPACE
} // namespace mote::bench
HWY_AFTER_NAMESPACE();

#endif
