// The walk of rays from cell to cell, compiled once for every SIMD instruction set.
//
// Thirty-two neighbouring rays go in step. The faces by which rays leave their cells are found cell
// by cell: with AVX-512 a ray at a time, with all edges in a vector; else for all rays in the cell
// at once, or, where a cell has one ray, with corners and edges in SIMD lanes. Where on the face
// that is, and what lies before it, is found for all rays.
//
// This file must be compiled without contraction to fused multiply-adds: a corner about a ray must
// be the same numbers whatever cell and whichever source asks.

#include "detail/WalkTask.h"

#include <algorithm>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hexahedra/CellWalkSimd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "detail/WalkExits-inl.h"
#include "detail/WalkParts-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

#if HWY_TARGET != HWY_SCALAR

namespace
{

template <int axis>
class Walker
{
public:
  explicit Walker(WalkTask& task)
    : task_(task)
    , exits_(task, l_)
    , parts_(task, l_)
  {
  }

  HWY_ATTR void walk()
  {
    std::fill_n(reinterpret_cast<float*>(&l_), sizeof l_ / sizeof(float), 0.0f);
    for (std::size_t first = 0; first < static_cast<std::size_t>(task_.rays.count); first += lanes)
    {
      begin(first);
      while (l_.active != 0)
      {
        exits_.find();
        parts_.add();
        go();
      }
    }
  }

private:
  /// Puts the next rays into the lanes.
  HWY_INLINE void begin(std::size_t first)
  {
    const WalkRays& rays = task_.rays;
    const std::size_t count = std::min(lanes, static_cast<std::size_t>(rays.count) - first);
    l_.first = first;
    std::copy_n(&rays.x[first], count, l_.x);
    std::copy_n(&rays.y[first], count, l_.y);
    std::copy_n(&rays.dx[first], count, l_.dx);
    std::copy_n(&rays.dy[first], count, l_.dy);
    std::copy_n(&rays.from[first], count, l_.from);
    std::copy_n(&rays.to[first], count, l_.to);
    std::copy_n(&rays.length[first], count, l_.length);
    if constexpr (isWide)
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < 16; ++i)
        {
          l_.rayXY[k][i] = i < 8 ? l_.x[k] : l_.y[k];
          l_.raySlope[k][i] = i < 8 ? l_.dx[k] : l_.dy[k];
        }
    std::fill_n(l_.transmittance, lanes, 1.0f);
    std::fill_n(l_.color[0], 3 * lanes, 0.0f);
    l_.active = 0;
    for (std::size_t k = 0; k < count; ++k)
    {
      l_.entry[k] = task_.entries.first[first + k];
      if (l_.entry[k] != WalkEntries::none)
      {
        l_.active |= 1U << k;
        enter(k);
      }
    }
  }

  HWY_INLINE void enter(std::size_t k)
  {
    const WalkEntries::Entry& entry = task_.entries.all[l_.entry[k]];
    l_.cell[k] = entry.cell;
    l_.before[k] = HexMesh::noCell;
    l_.z[k] = entry.z;
    l_.value[k] = entry.value;
    l_.entry[k] = entry.next;
    l_.left[k] = mostSteps;
    parts_.begin(1U << k);
    if (task_.runs != nullptr)
      beginRun(k);
  }

  /// Takes the rays to their next cells.
  HWY_INLINE void go()
  {
    const D d;
    const DI di;
    std::uint32_t isOver = 0, isOut = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d))
    {
      const V z = hn::Load(d, l_.outZ + first), before = hn::Load(d, l_.z + first);
      const V through = hn::Load(d, l_.transmittance + first);
      const M ends = hn::Or(hn::Not(hn::Gt(through, set(task_.leastTransmittance))),
        hn::Ge(z, hn::Load(d, l_.to + first)));
      isOver |= maskOf(ends) << first;
      hn::Store(z, d, l_.z + first);
      hn::Store(hn::Load(d, l_.outValue + first), d, l_.value + first);
      const VI behind = hn::Load(di, reinterpret_cast<const std::int32_t*>(l_.behind + first));
      hn::Store(behind, di, reinterpret_cast<std::int32_t*>(l_.cell + first));
      const VI fewer = hn::Sub(hn::Load(di, l_.left + first), hn::Set(di, 1));
      const VI left =
        hn::IfThenElse(hn::RebindMask(di, hn::Gt(z, before)), hn::Set(di, mostSteps), fewer);
      hn::Store(left, di, l_.left + first);
      const auto out = hn::Or(hn::Eq(behind, hn::Set(di, -1)), hn::Lt(left, hn::Zero(di)));
      isOut |= maskOf(hn::RebindMask(d, out)) << first;
    }
    if (HWY_UNLIKELY(task_.runs != nullptr))
      forLanes(l_.active & ~(isOver | isOut), [&](std::size_t k) { splitRun(k); });
    forLanes((isOver | isOut) & l_.active,
      [&](std::size_t k)
      {
        endRun(k);
        if ((isOver >> k & 1U) == 0 && l_.entry[k] != WalkEntries::none)
          enter(k);
        else
          end(k);
      });
  }
  void end(std::size_t k)
  {
    task_.rays.color[l_.ray(k)] = {
      l_.color[0][k], l_.color[1][k], l_.color[2][k], l_.transmittance[k]};
    l_.active &= ~(1U << k);
  }

  HWY_INLINE void beginRun(std::size_t k)
  {
    l_.runZ[k] = std::max(l_.z[k], l_.from[k]);
    for (std::size_t c = 0; c < 3; ++c)
      l_.runColor[c][k] = l_.color[c][k];
    l_.runColor[3][k] = l_.lastTransmittance[k] = l_.transmittance[k];
  }
  /// Where nothing is seen in a cell, another cloud may come between.
  void splitRun(std::size_t k)
  {
    const bool isSeen = l_.transmittance[k] != l_.lastTransmittance[k];
    l_.lastTransmittance[k] = l_.transmittance[k];
    if (isSeen)
      return;
    endRun(k);
    beginRun(k);
  }
  void endRun(std::size_t k)
  {
    const float through = l_.runColor[3][k];
    if (task_.runs == nullptr || !(l_.transmittance[k] < through))
      return;
    Vec3d color;
    for (int c = 0; c < 3; ++c)
      color[c] = l_.color[c][k] - l_.runColor[c][k];
    task_.runs[l_.ray(k)].push_back(
      {l_.runZ[k], {color / double(through), double(l_.transmittance[k]) / through}});
  }

  /// That go no farther: cells that cross themselves may lead in circles.
  static constexpr std::int32_t mostSteps = 1000;

  WalkTask& task_;
  Lanes l_;
  WalkExits<axis> exits_;
  WalkParts<axis> parts_;
};

} // namespace

HWY_ATTR void walkAll(WalkTask& task)
{
  if (task.axis == 0)
    Walker<0>(task).walk();
  else if (task.axis == 1)
    Walker<1>(task).walk();
  else
    Walker<2>(task).walk();
}

bool walkExists()
{
  return true;
}

#else

void walkAll(WalkTask&) {}
bool walkExists()
{
  return false;
}

#endif

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(walkAll);
HWY_EXPORT(walkExists);

bool canWalk()
{
  return HWY_DYNAMIC_DISPATCH(walkExists)();
}

void walkRays(WalkTask& task)
{
  HWY_DYNAMIC_DISPATCH(walkAll)(task);
}

} // namespace mote

#endif
