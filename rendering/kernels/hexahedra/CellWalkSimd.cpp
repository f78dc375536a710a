// The walk of rays from cell to cell, compiled once for every SIMD instruction set.
//
// Sixteen rays go in step. What decides by which face a ray leaves its cell is done a ray at a
// time, with the cell's corners and edges in SIMD lanes; where on the face that is, and what lies
// before it, for all sixteen, with the rays in the lanes.
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

#include "detail/WalkPatch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

#if HWY_TARGET != HWY_SCALAR

namespace
{

using D4 = hn::CappedTag<float, 4>;
using V4 = hn::Vec<D4>;
constexpr std::size_t lanes = 16;
using Floats = float[lanes];

/// The rays that are on their way. A lane without a ray has nothing before it.
struct alignas(64) Lanes
{
  Floats x, y, dx, dy, from, to, length;
  Floats z, value, transmittance, red, green, blue;
  Floats outZ, outValue; ///< at the exit
  /// What counts of the way through the cell; perChange is 1 / (partOut - partIn).
  Floats depth, partIn, partOut, perChange;
  Floats cellValue, bend;
  Floats runZ, runTransmittance, runRed, runGreen, runBlue; ///< where the ray came into the mesh
  float corner[4][lanes][4];                                ///< of the exit face
  float mean[lanes][4];   ///< of the part, as WalkTransfer::Row::value
  float change[lanes][4]; ///< from its beginning to its end, as WalkTransfer::Row::look
  float atValue[lanes][4], atIntegral[lanes][4], atLook[lanes][4]; ///< where it begins
  std::uint32_t row[lanes], cell[lanes], entry[lanes], left[lanes];
  int ray[lanes];
  std::uint8_t exit[lanes];
};

/// The six faces of a cell's winding numbers, four bits each and counted from 4; what sets of six
/// edges add, the first six and the last.
struct FaceSums
{
  std::uint32_t of[2][64];
};
constexpr FaceSums makeFaceSums()
{
  FaceSums sums{};
  for (unsigned e = 0; e < 12; ++e)
    for (unsigned bits = 0; bits < 64; ++bits)
      if ((bits >> e % 6 & 1U) != 0)
        sums.of[e / 6][bits] += (1U << 4 * edgeFaces[e][0]) - (1U << 4 * edgeFaces[e][1]);
  return sums;
}
constexpr FaceSums faceSums = makeFaceSums();

HWY_INLINE unsigned bitsOf(hn::Mask<D4> mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(D4(), mask, bits);
  return bits[0];
}

/// Coordinates of four corners.
struct Four
{
  V4 x, y, z;
};

/// Four points of a mesh, coordinate by coordinate.
HWY_INLINE Four fourOf(const WalkCells::Point* points, const std::uint32_t* ids)
{
  const D4 d;
  const hn::Repartition<double, D4> pairs;
  const V4 a = hn::Load(d, &points[ids[0]].x), b = hn::Load(d, &points[ids[1]].x);
  const V4 c = hn::Load(d, &points[ids[2]].x), e = hn::Load(d, &points[ids[3]].x);
  const V4 abLow = hn::InterleaveLower(d, a, b), ceLow = hn::InterleaveLower(d, c, e);
  const V4 abHigh = hn::InterleaveUpper(d, a, b), ceHigh = hn::InterleaveUpper(d, c, e);
  const auto low = [&](V4 p, V4 q)
  {
    return hn::BitCast(d, hn::InterleaveLower(pairs, hn::BitCast(pairs, p), hn::BitCast(pairs, q)));
  };
  const auto high = [&](V4 p, V4 q)
  {
    return hn::BitCast(d, hn::InterleaveUpper(pairs, hn::BitCast(pairs, p), hn::BitCast(pairs, q)));
  };
  return {low(abLow, ceLow), high(abLow, ceLow), low(abHigh, ceHigh)};
}

/// Which of four edges turn counter-clockwise about the ray, and clockwise.
HWY_INLINE void turn(V4 ax, V4 ay, V4 bx, V4 by, unsigned first, unsigned& left, unsigned& right)
{
  const V4 p = hn::Mul(ax, by), q = hn::Mul(bx, ay);
  left |= bitsOf(hn::Gt(p, q)) << first;
  right |= bitsOf(hn::Lt(p, q)) << first;
}

template <int axis>
class Walker
{
public:
  explicit Walker(WalkTask& task)
    : task_(task)
    , cells_(*task.cells)
    , points_(task.cells->points())
    , next_(task.cells->adjacency().data())
    , transfer_(*task.transfer)
  {
    std::fill_n(reinterpret_cast<float*>(&l_), sizeof l_ / sizeof(float), 0.0f);
    std::fill_n(l_.ray, lanes, -1);
  }

  HWY_ATTR void walk()
  {
    for (std::size_t k = 0; k < lanes; ++k)
      begin(k);
    while (live_ > 0)
    {
      for (std::size_t k = 0; k < lanes; ++k)
        if (l_.ray[k] >= 0)
          leave(k);
      for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
        pass(first);
      if (isClipped_ != 0)
        clip();
      for (std::size_t k = 0; k < lanes; ++k)
        if (l_.ray[k] >= 0)
          look(k);
      for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
        gather(first);
      for (; isSeldom_ != 0; isSeldom_ &= isSeldom_ - 1)
        addSeldom(static_cast<std::size_t>(std::countr_zero(isSeldom_)));
      for (std::size_t k = 0; k < lanes; ++k)
        if (l_.ray[k] >= 0)
          go(k);
    }
  }

private:
  /// Puts the next ray that enters anything into a lane.
  HWY_INLINE void begin(std::size_t k)
  {
    const WalkRays& rays = task_.rays;
    for (; nextRay_ < rays.count; ++nextRay_)
    {
      const auto r = static_cast<std::size_t>(nextRay_);
      if (task_.entries.first[r] == WalkEntries::none)
        continue;
      l_.x[k] = rays.x[r];
      l_.y[k] = rays.y[r];
      l_.dx[k] = rays.dx[r];
      l_.dy[k] = rays.dy[r];
      l_.from[k] = rays.from[r];
      l_.to[k] = rays.to[r];
      l_.length[k] = rays.length[r];
      l_.transmittance[k] = 1.0f;
      l_.red[k] = l_.green[k] = l_.blue[k] = 0.0f;
      l_.entry[k] = task_.entries.first[r];
      l_.ray[k] = nextRay_++;
      isActive_ |= 1U << k;
      ++live_;
      enter(k);
      return;
    }
    l_.ray[k] = -1;
    l_.length[k] = 0.0f;
  }

  HWY_INLINE void enter(std::size_t k)
  {
    const WalkEntries::Entry& entry = task_.entries.all[l_.entry[k]];
    l_.cell[k] = entry.cell;
    l_.z[k] = entry.z;
    l_.value[k] = entry.value;
    l_.entry[k] = entry.next;
    l_.left[k] = mostSteps;
    isFresh_ |= 1U << k;
    if (task_.runs != nullptr)
      beginRun(k);
  }
  HWY_INLINE void beginRun(std::size_t k)
  {
    l_.runZ[k] = std::max(l_.z[k], l_.from[k]);
    l_.runTransmittance[k] = l_.transmittance[k];
    l_.runRed[k] = l_.red[k];
    l_.runGreen[k] = l_.green[k];
    l_.runBlue[k] = l_.blue[k];
  }

  /// Finds the face by which a ray leaves its cell.
  HWY_INLINE void leave(std::size_t k)
  {
    const D4 d;
    const std::uint32_t cell = l_.cell[k];
    const std::uint32_t* ids = cells_.mesh().cell(cell).data();
    V4 x[2], y[2];
    unsigned above = 0;
    for (std::size_t half = 0; half < 2; ++half)
    {
      const Four p = fourOf(points_, ids + 4 * half);
      const V4 z = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      const V4 u = axis == 0 ? p.y : axis == 1 ? p.z : p.x;
      const V4 v = axis == 0 ? p.z : axis == 1 ? p.x : p.y;
      x[half] = hn::Sub(hn::Sub(u, hn::Set(d, l_.x[k])), hn::Mul(hn::Set(d, l_.dx[k]), z));
      y[half] = hn::Sub(hn::Sub(v, hn::Set(d, l_.y[k])), hn::Mul(hn::Set(d, l_.dy[k]), z));
      above |= bitsOf(hn::Gt(y[half], hn::Zero(d))) << 4 * half;
    }
    unsigned left = 0, right = 0;
    turn(x[0], y[0], hn::Shuffle0321(x[0]), hn::Shuffle0321(y[0]), 0, left, right);
    turn(x[1], y[1], hn::Shuffle0321(x[1]), hn::Shuffle0321(y[1]), 4, left, right);
    turn(x[0], y[0], x[1], y[1], 8, left, right);
    const unsigned mixed = cornerBits.mixed[above], first = cornerBits.first[above];
    unsigned up = mixed & ~first & left, down = mixed & first & right;
    if (task_.isBackwards)
      std::swap(up, down);
    const std::uint32_t windings = 0x444444U + faceSums.of[0][up & 63U] + faceSums.of[1][up >> 6] -
                                   faceSums.of[0][down & 63U] - faceSums.of[1][down >> 6];
    const std::uint32_t exits = windings & windings >> 2 & 0x111111U;
    const float bend = cells_.bends()[cell];
    unsigned exit = static_cast<unsigned>(std::countr_zero(exits)) / 4;
    const bool isUnsure =
      (mixed & ~(left | right)) != 0 || exits == 0 || (exits & (exits - 1)) != 0;
    if (isUnsure || (std::signbit(bend) && task_.view->isFoldable(cell)))
    {
      ++task_.fallbacks;
      exit = seldomExit(task_, static_cast<std::size_t>(l_.ray[k]), cell, l_.z[k]);
    }
    ++task_.steps;
    l_.exit[k] = static_cast<std::uint8_t>(exit);
    l_.bend[k] = std::abs(bend);
    if (exit == noFace)
      return;
    const std::uint32_t behind = next_[cell][exit];
    __builtin_prefetch(&cells_.mesh().cell(behind != HexMesh::noCell ? behind : cell));
    __builtin_prefetch(&next_[behind != HexMesh::noCell ? behind : cell]);
    for (std::size_t i = 0; i < 4; ++i)
      hn::Store(hn::Load(d, &points_[ids[faceCorners[exit][i]]].x), d, l_.corner[i][k]);
    if (cells_.isOfCells())
      l_.cellValue[k] = cells_.ofCells()[cell];
  }

  /// Finds where the rays leave by their faces.
  HWY_INLINE void pass(std::size_t first)
  {
    const D d;
    FaceCorners c;
    for (std::size_t i = 0; i < 4; ++i)
    {
      V p[3];
      hn::LoadInterleaved4(d, l_.corner[i][first], p[0], p[1], p[2], c.value[i]);
      c.z[i] = p[axis];
      c.x[i] = hn::Sub(hn::Sub(p[(axis + 1) % 3], hn::Load(d, l_.x + first)),
        hn::Mul(hn::Load(d, l_.dx + first), c.z[i]));
      c.y[i] = hn::Sub(hn::Sub(p[(axis + 2) % 3], hn::Load(d, l_.y + first)),
        hn::Mul(hn::Load(d, l_.dy + first), c.z[i]));
    }
    const PatchPlace place = passPatch(c.x, c.y, task_.isBackwards);
    V z = place.of(c.z);
    if (task_.isBackwards)
      z = hn::Neg(z);
    const V in = hn::Load(d, l_.z + first);
    V before = hn::Load(d, l_.value + first), value = place.of(c.value);
    if (cells_.isOfCells())
      before = value = hn::Load(d, l_.cellValue + first);
    z = hn::Max(z, in);
    hn::Store(z, d, l_.outZ + first);
    hn::Store(value, d, l_.outValue + first);
    const V from = hn::Load(d, l_.from + first), to = hn::Load(d, l_.to + first);
    const V length = hn::Load(d, l_.length + first);
    hn::Store(hn::Mul(hn::Max(hn::Sub(hn::Min(z, to), hn::Max(in, from)), hn::Zero(d)), length), d,
      l_.depth + first);
    hn::Store(before, d, l_.partIn + first);
    hn::Store(value, d, l_.partOut + first);
    hn::Store(hn::Div(set(1.0f), hn::Sub(value, before)), d, l_.perChange + first);
    isClipped_ |= maskOf(hn::Or(hn::Lt(in, from), hn::Gt(z, to))) << first;
  }
  static HWY_INLINE std::uint32_t maskOf(M mask)
  {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(D(), mask, bits);
    return bits[0] | static_cast<std::uint32_t>(bits[1]) << 8;
  }

  /// Cuts parts off that lie before or behind what is wanted of the rays.
  HWY_INLINE void clip()
  {
    for (; isClipped_ != 0; isClipped_ &= isClipped_ - 1)
    {
      const auto k = static_cast<std::size_t>(std::countr_zero(isClipped_));
      if (l_.ray[k] < 0)
        continue;
      const float in = l_.z[k], change = l_.outValue[k] - l_.value[k];
      const auto at = [&](float z)
      {
        const float share = (z - in) / (l_.outZ[k] - in);
        return share > 0.0f ? l_.value[k] + std::min(share, 1.0f) * change : l_.value[k];
      };
      l_.partIn[k] = at(l_.from[k]);
      if (l_.outZ[k] > l_.to[k])
        l_.partOut[k] = at(l_.to[k]);
      l_.perChange[k] = 1.0f / (l_.partOut[k] - l_.partIn[k]);
      isFresh_ |= 1U << k;
    }
  }

  /// Rows and integrals where the part of a lane begins and ends, and what lies between.
  HWY_INLINE void look(std::size_t k)
  {
    const D4 d;
    if ((isFresh_ >> k & 1U) != 0 || cells_.isOfCells())
      lookAt(k, l_.partIn[k]);
    isFresh_ &= ~(1U << k);
    const std::uint32_t before = l_.row[k];
    const V4 value = hn::Load(d, l_.atValue[k]), integral = hn::Load(d, l_.atIntegral[k]);
    const V4 look = hn::Load(d, l_.atLook[k]);
    lookAt(k, l_.partOut[k]);
    const V4 sum = hn::Add(value, hn::Load(d, l_.atValue[k]));
    const V4 across = hn::Sub(hn::Load(d, l_.atIntegral[k]), integral);
    hn::Store(before == l_.row[k] ? hn::Mul(hn::Set(d, 0.5f), sum)
                                  : hn::Mul(across, hn::Set(d, l_.perChange[k])),
      d, l_.mean[k]);
    hn::Store(hn::Sub(hn::Load(d, l_.atLook[k]), look), d, l_.change[k]);
    if (transfer_.hasSolid() && transfer_.isSolid(before, l_.row[k]))
      isSeldom_ |= 1U << k;
    if (before != l_.row[k] && transfer_.pieceOf(before) != transfer_.pieceOf(l_.row[k]))
      isBroken_ |= 1U << k;
  }
  HWY_INLINE void lookAt(std::size_t k, float value)
  {
    const D4 d;
    const std::uint32_t r = transfer_.rowOf(value);
    const WalkTransfer::Row& row = transfer_.row(r);
    const V4 at = hn::Set(d, value - transfer_.from(r)), half = hn::Set(d, 0.5f);
    const V4 slope = hn::Load(d, row.slope), from = hn::Load(d, row.value);
    hn::Store(hn::MulAdd(at, slope, from), d, l_.atValue[k]);
    hn::Store(hn::MulAdd(at, hn::MulAdd(hn::Mul(half, at), slope, from), hn::Load(d, row.integral)),
      d, l_.atIntegral[k]);
    hn::Store(hn::MulAdd(at, hn::Load(d, row.lookSlope), hn::Load(d, row.look)), d, l_.atLook[k]);
    l_.row[k] = r;
  }

  /// Adds the parts to what the rays have gathered, but for those that are seldom.
  HWY_INLINE void gather(std::size_t first)
  {
    const D d;
    const V one = set(1.0f), zero = hn::Zero(d);
    const V depth = hn::Load(d, l_.depth + first);
    V extinction, mean[3], thinner, change[3];
    hn::LoadInterleaved4(d, l_.mean[first], extinction, mean[0], mean[1], mean[2]);
    hn::LoadInterleaved4(d, l_.change[first], thinner, change[0], change[1], change[2]);
    const V thick = hn::Mul(extinction, depth), square = hn::Mul(thick, thick);
    const V through = hn::Load(d, l_.transmittance + first);
    // Errors: of the line, and of a colour that changes on the way.
    const V bend = hn::Mul(hn::Load(d, l_.bend + first), set(task_.rate));
    const M bent = hn::And(hn::Ge(hn::Mul(bend, through), set(task_.allowed)), hn::Gt(depth, zero));
    const V most = hn::Max(hn::Max(hn::Abs(change[0]), hn::Abs(change[1])), hn::Abs(change[2]));
    const V uneven = hn::MulAdd(hn::Abs(thinner), depth, square);
    const M rough = hn::Gt(hn::Mul(most, uneven), set(task_.share));
    const std::uint32_t active = activeOf(first);
    const std::uint32_t broken = isBroken_ >> first & maskOf(hn::Gt(square, set(task_.share)));
    isBroken_ &= ~(active << first);
    if (task_.isAllSeldom)
      isSeldom_ |= active << first;
    std::uint32_t seldom = (maskOf(rough) | broken | isSeldom_ >> first) & active;
    for (std::uint32_t asked = maskOf(bent) & active & ~seldom; asked != 0; asked &= asked - 1)
      if (const int k = std::countr_zero(asked); !isLine(first + static_cast<std::size_t>(k)))
        seldom |= 1U << k;
    isSeldom_ |= seldom << first;
    const V passing = expOfMinus(thick), opacity = hn::Sub(one, passing);
    const V weight =
      hn::Mul(hn::Mul(through, opacity), hn::Div(one, hn::Max(extinction, set(1e-37f))));
    // Of what is coloured evenly along the way, the front hides a part of the back: for an optical
    // depth x, -x^2 / (12 + 6 x + 1.2 x^2) of the change of colour, as good as exact up to 2.
    const V hidden = hn::Div(hn::Mul(through, square),
      hn::MulAdd(set(1.2f), square, hn::MulAdd(set(6.0f), thick, set(12.0f))));
    float* const colors[3] = {l_.red + first, l_.green + first, l_.blue + first};
    const M plain = lanesOf(~seldom);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const V color = hn::Load(d, colors[c]);
      const V added = hn::NegMulAdd(hidden, change[c], hn::MulAdd(weight, mean[c], color));
      hn::Store(hn::IfThenElse(plain, added, color), d, colors[c]);
    }
    hn::Store(
      hn::IfThenElse(plain, hn::Mul(through, passing), through), d, l_.transmittance + first);
  }
  /// Lanes of which the bit is set.
  static HWY_INLINE M lanesOf(std::uint32_t bits)
  {
    const hn::RebindToUnsigned<D> du;
    const auto own = hn::Shl(hn::Set(du, 1), hn::Iota(du, 0));
    return hn::RebindMask(D(), hn::TestBit(hn::Set(du, bits), own));
  }
  HWY_INLINE std::uint32_t activeOf(std::size_t first) const
  {
    return isActive_ >> first & ((1U << hn::Lanes(D())) - 1);
  }
  /// e^-x for x >= 0.
  static HWY_INLINE V expOfMinus(V x)
  {
    const D d;
    const V t = hn::Max(hn::Mul(x, set(-1.44269504f)), set(-126.0f));
    const V whole = hn::Round(t), f = hn::Sub(t, whole);
    V p = set(1.5252734e-5f);
    for (const float c :
      {1.5403530e-4f, 1.3333558e-3f, 9.6181291e-3f, 5.5504109e-2f, 0.24022651f, 0.69314718f, 1.0f})
      p = hn::MulAdd(p, f, set(c));
    const auto scale = hn::ShiftLeft<23>(hn::Add(
      hn::ConvertTo(hn::RebindToSigned<D>(), whole), hn::Set(hn::RebindToSigned<D>(), 127)));
    return hn::Mul(p, hn::BitCast(d, scale));
  }

  WalkPart partOf(std::size_t k) const
  {
    return {l_.ray[k], l_.cell[k], {std::max(l_.z[k], l_.from[k]), std::min(l_.outZ[k], l_.to[k])},
      {l_.partIn[k], l_.partOut[k]}, l_.z[k]<l_.from[k], l_.outZ[k]> l_.to[k], l_.bend[k]};
  }
  bool isLine(std::size_t k) const { return task_.seldom->isLine(partOf(k), l_.transmittance[k]); }
  void addSeldom(std::size_t k)
  {
    ++task_.seldomParts;
    float color[4] = {l_.red[k], l_.green[k], l_.blue[k], l_.transmittance[k]};
    if (l_.depth[k] > 0.0f)
      task_.seldom->add(partOf(k), color);
    l_.red[k] = color[0];
    l_.green[k] = color[1];
    l_.blue[k] = color[2];
    l_.transmittance[k] = color[3];
  }

  /// Takes a ray to its next cell.
  HWY_INLINE void go(std::size_t k)
  {
    if (!(l_.transmittance[k] > task_.leastTransmittance) || l_.outZ[k] >= l_.to[k])
    {
      endRun(k);
      return end(k);
    }
    const std::uint32_t behind =
      l_.exit[k] == noFace ? HexMesh::noCell : next_[l_.cell[k]][l_.exit[k]];
    l_.left[k] = l_.outZ[k] > l_.z[k] ? mostSteps : l_.left[k] - 1;
    l_.z[k] = l_.outZ[k];
    l_.value[k] = l_.outValue[k];
    l_.cell[k] = behind;
    if (behind != HexMesh::noCell && l_.left[k] != 0)
      return task_.runs != nullptr ? splitRun(k) : void();
    endRun(k);
    if (l_.entry[k] == WalkEntries::none)
      end(k);
    else
      enter(k);
  }
  /// Where nothing is seen in a cell, another cloud may come between.
  void splitRun(std::size_t k)
  {
    if (l_.mean[k][0] != 0.0f)
      return;
    endRun(k);
    beginRun(k);
  }
  void endRun(std::size_t k)
  {
    const float through = l_.runTransmittance[k];
    if (task_.runs == nullptr || !(l_.transmittance[k] < through))
      return;
    const Vec3d color(
      l_.red[k] - l_.runRed[k], l_.green[k] - l_.runGreen[k], l_.blue[k] - l_.runBlue[k]);
    task_.runs[l_.ray[k]].push_back(
      {l_.runZ[k], {color / double(through), double(l_.transmittance[k]) / through}});
  }
  void end(std::size_t k)
  {
    task_.rays.color[static_cast<std::size_t>(l_.ray[k])] = {
      l_.red[k], l_.green[k], l_.blue[k], l_.transmittance[k]};
    l_.transmittance[k] = 1.0f;
    --live_;
    isActive_ &= ~(1U << k);
    begin(k);
  }

  /// That go no farther: cells that cross themselves may lead in circles.
  static constexpr std::uint32_t mostSteps = 1000;

  WalkTask& task_;
  const WalkCells& cells_;
  const WalkCells::Point* points_;
  const std::array<std::uint32_t, 6>* next_;
  const WalkTransfer& transfer_;
  Lanes l_;
  int nextRay_ = 0, live_ = 0;
  /// A bit each lane.
  std::uint32_t isActive_ = 0, isFresh_ = 0, isClipped_ = 0, isSeldom_ = 0, isBroken_ = 0;
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
