// The test of a cell by a bundle of lines, compiled once for every SIMD instruction set. What is
// computed are CellFaces.cpp's numbers to the last bit.
//
// This file must be compiled without contraction to fused multiply-adds, see CellFaces.cpp.

#include "detail/CellFaces.h"
#include "detail/LineBundlePasses.h"

#include <algorithm>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hexahedra/LineBundleSimd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

// At least four doubles at a time, and true fused multiply-adds for the errors of products.
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2 && !defined(HWY_DISABLE_BMI2_FMA)

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr std::size_t width = HWY_TARGET <= HWY_AVX3 ? 8 : 4;
constexpr std::size_t rays = LineBundle::capacity;
using Lanes = LineBundle::Lanes;

HWY_INLINE std::uint64_t bitsOf(M mask)
{
  std::uint8_t bits[8];
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0];
}
HWY_INLINE V set(double x)
{
  return hn::Set(D(), x);
}

/// Some lines: as many as there are lanes.
struct Lines
{
  V originX, originY, originZ, shearX, shearY;
};

/// A corner in the frames of some lines.
struct Place
{
  V x, y, z;
};

/// A cell and a bundle.
class CellTest
{
public:
  HWY_INLINE CellTest(const Lanes& lanes, const HexCorners& corners, const CornerValues* values)
    : lanes_(lanes)
    , values_(values)
  {
    for (std::size_t i = 0; i < 8; ++i)
    {
      const Vec3d& p = corners[i];
      for (std::size_t k = 0; k < 3; ++k)
      {
        frame_.points[k][i] = p[static_cast<int>(k)];
        at_[k][i] = p[lanes.axes[k]];
      }
    }
    if (!lanes.isFan)
      return;
    for (std::size_t i = 0; i < 8; ++i)
    {
      at_[0][i] -= lanes.originX[0];
      at_[1][i] -= lanes.originY[0];
      at_[2][i] -= lanes.originZ[0];
    }
  }

  void test(std::uint64_t wanted, BundlePasses& passes)
  {
    passes.passed = passes.seldom = 0;
    wanted &= lanes_.isFan ? metGroups<true>() : metGroups<false>();
    if (wanted == 0)
      return;
    lanes_.isFan ? lookAtEdges<true>(wanted) : lookAtEdges<false>(wanted);
    std::uint64_t unsure = wind() & wanted;
    std::uint64_t plus = 0, minus = 0, several = 0;
    for (const FaceWindings& w : windings_)
    {
      several |= (plus & w.plus) | (minus & w.minus);
      plus |= w.plus;
      minus |= w.minus;
    }
    unsure |= (plus ^ minus) | several;
    unsure |= lanes_.isFan ? folded<true>(wanted & ~unsure) : folded<false>(wanted & ~unsure);
    passes.passed = plus & minus & ~unsure & wanted;
    for (unsigned f = 0; f < 6; ++f)
      if (((windings_[f].plus | windings_[f].minus) & passes.passed) != 0)
        lanes_.isFan ? passFace<true>(f, passes, unsure) : passFace<false>(f, passes, unsure);
    passes.seldom = unsure & wanted;
  }

private:
  /// Lines first to first + width - 1.
  HWY_INLINE Lines linesAt(std::size_t first) const
  {
    const D d;
    return {hn::Load(d, &lanes_.originX[first]), hn::Load(d, &lanes_.originY[first]),
      hn::Load(d, &lanes_.originZ[first]), hn::Load(d, &lanes_.shearX[first]),
      hn::Load(d, &lanes_.shearY[first])};
  }

  /// As LineFrame::at().
  template <bool isFan>
  HWY_INLINE Place place(const Lines& lines, std::size_t i) const
  {
    V x = set(at_[0][i]), y = set(at_[1][i]), z = set(at_[2][i]);
    if constexpr (!isFan)
    {
      x = hn::Sub(x, lines.originX);
      y = hn::Sub(y, lines.originY);
      z = hn::Sub(z, lines.originZ);
    }
    return {hn::Sub(x, hn::Mul(lines.shearX, z)), hn::Sub(y, hn::Mul(lines.shearY, z)), z};
  }

  /// The least and greatest of what x (or y) of corners is about groups of lines: roundings are
  /// monotonic, so that no line of the group is beyond.
  template <bool isFan>
  static HWY_INLINE void reach(double at, double z, const Lanes::Bounds& origins,
    const Lanes::Bounds& depths, const Lanes::Bounds& shears, std::size_t first, V& least, V& most)
  {
    const D d;
    const V lower = hn::Load(d, &shears.lower[first]), upper = hn::Load(d, &shears.upper[first]);
    V xLower = set(at), xUpper = xLower, zLower = set(z), zUpper = zLower;
    if constexpr (!isFan)
    {
      xLower = hn::Sub(xLower, hn::Load(d, &origins.upper[first]));
      xUpper = hn::Sub(xUpper, hn::Load(d, &origins.lower[first]));
      zLower = hn::Sub(zLower, hn::Load(d, &depths.upper[first]));
      zUpper = hn::Sub(zUpper, hn::Load(d, &depths.lower[first]));
    }
    const V a = hn::Mul(lower, zLower), b = hn::Mul(upper, zLower);
    V low = hn::Min(a, b), high = hn::Max(a, b);
    if constexpr (!isFan)
    {
      const V c = hn::Mul(lower, zUpper), e = hn::Mul(upper, zUpper);
      low = hn::Min(low, hn::Min(c, e));
      high = hn::Max(high, hn::Max(c, e));
    }
    least = hn::Min(least, hn::Sub(xLower, high));
    most = hn::Max(most, hn::Sub(xUpper, low));
  }

  /// The lines of the groups of which some may pass the cell.
  template <bool isFan>
  HWY_INLINE std::uint64_t metGroups() const
  {
    const V zero = hn::Zero(D());
    std::uint64_t met = 0;
    for (std::size_t first = 0; first < Lanes::groups; first += width)
    {
      V x0 = set(1e308), x1 = set(-1e308), y0 = x0, y1 = x1;
      for (std::size_t i = 0; i < 8; ++i)
      {
        reach<isFan>(
          at_[0][i], at_[2][i], lanes_.groupX, lanes_.groupZ, lanes_.groupShearX, first, x0, x1);
        reach<isFan>(
          at_[1][i], at_[2][i], lanes_.groupY, lanes_.groupZ, lanes_.groupShearY, first, y0, y1);
      }
      const M meets = hn::And(
        hn::And(hn::Le(x0, zero), hn::Gt(x1, zero)), hn::And(hn::Le(y0, zero), hn::Gt(y1, zero)));
      for (std::uint64_t bits = bitsOf(meets); bits != 0; bits &= bits - 1)
        met |= std::uint64_t(0xff) << 8 * (first + std::size_t(std::countr_zero(bits)));
    }
    return met;
  }

  /// On which sides of the lines corners and edges are.
  template <bool isFan>
  HWY_INLINE void lookAtEdges(std::uint64_t wanted)
  {
    const V zero = hn::Zero(D());
    above_ = {};
    left_ = less_ = {};
    for (std::size_t first = 0; first < rays; first += width)
    {
      if ((wanted >> first & (width == 8 ? 0xffU : 0xfU)) == 0)
        continue;
      const Lines lines = linesAt(first);
      V x[8], y[8];
      for (std::size_t i = 0; i < 8; ++i)
      {
        const Place p = place<isFan>(lines, i);
        x[i] = p.x;
        y[i] = p.y;
        above_[i] |= bitsOf(hn::Gt(p.y, zero)) << first;
      }
      for (std::size_t e = 0; e < 12; ++e)
      {
        const std::size_t i = edgeCorners[e][0], j = edgeCorners[e][1];
        const V a = hn::Mul(x[i], y[j]), b = hn::Mul(x[j], y[i]);
        left_[e] |= bitsOf(hn::Gt(a, b)) << first;
        less_[e] |= bitsOf(hn::Lt(a, b)) << first;
      }
    }
  }

  /// Finds the windings. Gives the lines for which the rounding of a product decides.
  HWY_INLINE std::uint64_t wind()
  {
    // Edges count for the face that has them in their own direction, and against it for the other.
    std::array<std::array<std::uint64_t, 4>, 6> up, down;
    std::array<std::size_t, 6> count{};
    std::uint64_t unsure = 0;
    for (std::size_t e = 0; e < 12; ++e)
    {
      const std::uint64_t first = above_[edgeCorners[e][0]], second = above_[edgeCorners[e][1]];
      unsure |= (first ^ second) & ~(left_[e] | less_[e]);
      const std::uint64_t rises = ~first & second & left_[e], falls = first & ~second & less_[e];
      const std::size_t own = edgeFaces[e][0], other = edgeFaces[e][1];
      up[own][count[own]] = rises;
      down[own][count[own]++] = falls;
      up[other][count[other]] = falls;
      down[other][count[other]++] = rises;
    }
    // A face of four straight edges winds about a line once at most: 1, or 2 less 1.
    const auto more = [](const auto& a, const auto& b)
    {
      const std::uint64_t any = a[0] | a[1] | a[2] | a[3], none = ~(b[0] | b[1] | b[2] | b[3]);
      const std::uint64_t two = (a[0] & a[1]) | (a[2] & a[3]) | ((a[0] | a[1]) & (a[2] | a[3]));
      return (any & none) | two;
    };
    for (std::size_t f = 0; f < 6; ++f)
    {
      const auto& [a, b] = std::pair(up[f], down[f]);
      const std::uint64_t odd = a[0] ^ a[1] ^ a[2] ^ a[3] ^ b[0] ^ b[1] ^ b[2] ^ b[3];
      windings_[f] = {odd & more(a, b), odd & more(b, a)};
    }
    return unsure;
  }

  /// The lines that a folded face is around of whose winding number is 0.
  template <bool isFan>
  HWY_INLINE std::uint64_t folded(std::uint64_t asked) const
  {
    std::uint64_t found = 0;
    for (unsigned f = 0; f < 6; ++f)
    {
      const auto& k = faceCorners[f];
      const std::uint64_t all = above_[k[0]] & above_[k[1]] & above_[k[2]] & above_[k[3]];
      const std::uint64_t any = above_[k[0]] | above_[k[1]] | above_[k[2]] | above_[k[3]];
      const std::uint64_t left = asked & any & ~all & ~(windings_[f].plus | windings_[f].minus);
      if (left == 0 || isConvex(k))
        continue;
      for (std::size_t first = 0; first < rays; first += width)
        if ((left >> first & (width == 8 ? 0xffU : 0xfU)) != 0)
          found |= (foldedAt<isFan>(linesAt(first), k) << first) & left;
    }
    return found;
  }

  /// Whether a face is convex as all lines see it, beyond the roundings of foldedAt(). Turns are
  /// linear in the shears.
  HWY_INLINE bool isConvex(const std::uint8_t (&k)[4]) const
  {
    Vec3d sides[4];
    double length = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double side = at_[c][k[(i + 1) % 4]] - at_[c][k[i]];
        sides[i][static_cast<int>(c)] = side;
        length = std::max(length, std::abs(side));
      }
    double far = 0.0; // no place counts from further away
    for (std::size_t c = 0; c < 3; ++c)
      far = std::max(far, lanes_.farthest + 2.0 * length + std::abs(at_[c][k[0]]));
    const double least = 1e-13 * length * far;
    bool left = true, right = true;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Vec3d normal = glm::cross(sides[i], sides[(i + 1) % 4]);
      const double turn = glm::dot(normal, lanes_.middle);
      const double reach = std::abs(normal.x) * lanes_.reachX + std::abs(normal.y) * lanes_.reachY;
      left = left && turn - reach > least;
      right = right && turn + reach < -least;
    }
    return left || right;
  }

  /// As CellFaces.cpp's isConvex(), and whether the face has corners on both sides along x.
  template <bool isFan>
  HWY_INLINE std::uint64_t foldedAt(const Lines& lines, const std::uint8_t (&k)[4]) const
  {
    const V zero = hn::Zero(D());
    Place p[4];
    for (std::size_t i = 0; i < 4; ++i)
      p[i] = place<isFan>(lines, k[i]);
    const V most = hn::Max(hn::Max(p[0].x, p[1].x), hn::Max(p[2].x, p[3].x));
    const V least = hn::Min(hn::Min(p[0].x, p[1].x), hn::Min(p[2].x, p[3].x));
    const M mixed = hn::And(hn::Gt(most, zero), hn::Le(least, zero));
    V x[4], y[4], turns[4];
    for (std::size_t i = 0; i < 4; ++i)
    {
      x[i] = hn::Sub(p[(i + 1) % 4].x, p[i].x);
      y[i] = hn::Sub(p[(i + 1) % 4].y, p[i].y);
    }
    for (std::size_t i = 0; i < 4; ++i)
      turns[i] = hn::Sub(hn::Mul(x[i], y[(i + 1) % 4]), hn::Mul(y[i], x[(i + 1) % 4]));
    const V lower = hn::Min(hn::Min(turns[0], turns[1]), hn::Min(turns[2], turns[3]));
    const V upper = hn::Max(hn::Max(turns[0], turns[1]), hn::Max(turns[2], turns[3]));
    return bitsOf(hn::And(mixed, hn::And(hn::Lt(lower, zero), hn::Gt(upper, zero))));
  }

  /// As CellFaces.cpp's cross().
  static HWY_INLINE V crossed(V ax, V ay, V bx, V by)
  {
    const V p = hn::Mul(ax, by), q = hn::Mul(ay, bx), d = hn::Sub(p, q);
    const V error = hn::Sub(hn::MulSub(ax, by, p), hn::MulSub(ay, bx, q));
    const M exact = hn::Ge(hn::Mul(set(16.0), hn::Abs(d)), hn::Add(hn::Abs(p), hn::Abs(q)));
    return hn::IfThenElse(exact, d, hn::Add(d, error));
  }
  static HWY_INLINE V crossed(const Place& a, const Place& b)
  {
    return crossed(a.x, a.y, b.x, b.y);
  }

  /// As CellFaces.cpp's BernsteinRoots, within [0, 1]; `negative` says which root.
  static HWY_INLINE V rootOf(V h0, V h1, V h2, M negative)
  {
    const V zero = hn::Zero(D()), one = set(1.0);
    const V square = crossed(h1, h0, h2, h1);
    const V root = hn::Sqrt(hn::IfThenZeroElse(hn::Lt(square, zero), square));
    const M rises = hn::Ge(h1, zero);
    const V q = hn::IfThenElse(rises, hn::Neg(hn::Add(h1, root)), hn::Sub(root, h1));
    const M flat = hn::Eq(q, zero), first = hn::Not(hn::Xor(rises, negative));
    const M other = hn::Or(
      hn::And(first, hn::Not(hn::And(flat, hn::Eq(h2, zero)))), hn::And(hn::Eq(h0, zero), flat));
    const V n = hn::IfThenElse(other, q, h0), m = hn::IfThenElse(other, h2, q);
    const M none = hn::And(hn::Eq(n, zero), hn::Eq(m, zero));
    const V x = hn::IfThenElse(none, set(0.5), hn::Div(n, hn::Add(n, m)));
    return hn::IfThenElseZero(hn::Gt(x, zero), hn::Min(x, one));
  }

  /// Where the lines pass a face. Those that pass one with corners that coincide are left.
  template <bool isFan>
  void passFace(unsigned f, BundlePasses& passes, std::uint64_t& unsure) const
  {
    const std::uint64_t lines = (windings_[f].plus | windings_[f].minus) & passes.passed;
    const FaceOrder order(frame_, faceCorners[f]);
    if (order.isTriangle)
    {
      passes.passed &= ~lines;
      unsure |= lines;
      return;
    }
    FacePassing p;
    for (std::uint64_t left = lines; left != 0; left &= left - 1)
    {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const std::size_t n = p.count++;
      p.line[n] = static_cast<std::uint8_t>(i);
      p.shearX[n] = lanes_.shearX[i];
      p.shearY[n] = lanes_.shearY[i];
      p.inverse[n] = lanes_.inverse[i];
      p.sign[n] = (windings_[f].plus >> i & 1U) != 0 ? order.sense : -order.sense;
      if constexpr (!isFan)
      {
        p.originX[n] = lanes_.originX[i];
        p.originY[n] = lanes_.originY[i];
        p.originZ[n] = lanes_.originZ[i];
      }
    }
    for (std::size_t n = 0; n < p.count; n += width)
      passAt<isFan>(order, p, n);
    for (std::size_t n = 0; n < p.count; ++n)
    {
      const std::size_t i = p.line[n];
      const bool leaves = (windings_[f].plus >> i & 1U) != 0;
      (leaves ? passes.out : passes.in)[i] = p.t[n];
      (leaves ? passes.valueOut : passes.valueIn)[i] = p.value[n];
      (leaves ? passes.outFace : passes.inFace)[i] = static_cast<std::uint8_t>(f);
    }
  }

  /// t, and the value, where lines n to n + width - 1 pass the face.
  template <bool isFan>
  HWY_INLINE void passAt(const FaceOrder& order, FacePassing& p, std::size_t n) const
  {
    const D d;
    Lines lines{V(), V(), V(), hn::Load(d, &p.shearX[n]), hn::Load(d, &p.shearY[n])};
    if constexpr (!isFan)
    {
      lines.originX = hn::Load(d, &p.originX[n]);
      lines.originY = hn::Load(d, &p.originY[n]);
      lines.originZ = hn::Load(d, &p.originZ[n]);
    }
    const auto& k = order.corners;
    const Place a = place<isFan>(lines, k[0]), b = place<isFan>(lines, k[1]);
    const Place c = place<isFan>(lines, k[2]), e = place<isFan>(lines, k[3]);
    const V ac = crossed(a, c), be = crossed(b, e), half = set(0.5), one = set(1.0);
    const M negative = hn::Lt(hn::Load(d, &p.sign[n]), hn::Zero(d));
    const V u = rootOf(crossed(a, e), hn::Mul(half, hn::Add(ac, be)), crossed(b, c), negative);
    const V v =
      rootOf(crossed(a, b), hn::Mul(half, hn::Sub(ac, be)), crossed(e, c), hn::Not(negative));
    const V u1 = hn::Sub(one, u), v1 = hn::Sub(one, v);
    const V z = hn::Add(hn::Mul(v1, hn::Add(hn::Mul(u1, a.z), hn::Mul(u, b.z))),
      hn::Mul(v, hn::Add(hn::Mul(u1, e.z), hn::Mul(u, c.z))));
    hn::Store(hn::Mul(z, hn::Load(d, &p.inverse[n])), d, &p.t[n]);
    if (values_ == nullptr)
      return;
    const auto part = [&](V weight, std::size_t i)
    { return hn::Mul(weight, set((*values_)[k[i]])); };
    V value = hn::Add(part(hn::Mul(v1, u1), 0), part(hn::Mul(v1, u), 1));
    value = hn::Add(value, part(hn::Mul(v, u), 2));
    hn::Store(hn::Add(value, part(hn::Mul(v, u1), 3)), d, &p.value[n]);
  }

  const Lanes& lanes_;
  const CornerValues* values_;
  CellFrame frame_; ///< its points
  /// The corners in the frame's order of axes, from the origin of all lines where they have one.
  std::array<std::array<double, 8>, 3> at_;
  /// Bits, a line each: whether corners have y > 0, and edges turn counter-clockwise and clockwise.
  std::array<std::uint64_t, 8> above_;
  std::array<std::uint64_t, 12> left_, less_;
  std::array<FaceWindings, 6> windings_;
};

constexpr bool isThere = true;

#else

class CellTest
{
public:
  CellTest(const LineBundle::Lanes&, const HexCorners&, const CornerValues*) {}
  void test(std::uint64_t wanted, BundlePasses& passes)
  {
    passes.passed = 0;
    passes.seldom = wanted;
  }
};

constexpr bool isThere = false;

#endif

} // namespace

bool bundlePassesExist()
{
  return isThere;
}

void testCell(const LineBundle::Lanes& lanes, const HexCorners& corners, const CornerValues* values,
  std::uint64_t wanted, BundlePasses& passes)
{
  CellTest(lanes, corners, values).test(wanted, passes);
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(bundlePassesExist);
HWY_EXPORT(testCell);

bool hasBundlePasses()
{
  return HWY_DYNAMIC_DISPATCH(bundlePassesExist)();
}

void passesOf(const LineBundle::Lanes& lanes, const HexCorners& corners, const CornerValues* values,
  std::uint64_t wanted, BundlePasses& passes)
{
  HWY_DYNAMIC_DISPATCH(testCell)(lanes, corners, values, wanted, passes);
}

} // namespace mote

#endif
