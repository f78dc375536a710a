// The test of cells by lines, compiled once for every SIMD instruction set. What is computed are
// CellFaces.cpp's numbers to the last bit, which takes care of all that is seldom.
//
// This file must be compiled without contraction to fused multiply-adds, see CellFaces.cpp.

#include "detail/CellFaces.h"

#include <bit>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hexahedra/CellCrossingsSimd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

/// What became of the fast test of a cell.
enum class Outcome
{
  Nothing,
  Passed, ///< one interval was found
  Seldom  ///< the frame must be looked at by intersectFrame()
};

// Four doubles at a time and true fused multiply-adds for the errors of products.
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2 && !defined(HWY_DISABLE_BMI2_FMA)

namespace hn = hwy::HWY_NAMESPACE;
using D2 = hn::FixedTag<double, 2>;
using D4 = hn::FixedTag<double, 4>;
using V = hn::Vec<D4>;

/// One coordinate of the eight corners.
struct Eight
{
  V low, high;
};

HWY_INLINE unsigned bitsOf(hn::Mask<D4> mask)
{
  std::uint8_t bits[8];
  hn::StoreMaskBits(D4(), mask, bits);
  return bits[0];
}
HWY_INLINE unsigned bitsAbove(const Eight& v)
{
  const V zero = hn::Zero(D4());
  return bitsOf(hn::Gt(v.low, zero)) | bitsOf(hn::Gt(v.high, zero)) << 4;
}

/// Lanes 2, 3, 0, 1.
HWY_INLINE V opposite(V v)
{
  return hn::ConcatLowerUpper(D4(), v, v);
}
/// Lanes 1, 2, 3, 0.
HWY_INLINE V next(V v)
{
  return hn::CombineShiftRightBytes<8>(D4(), opposite(v), v);
}

HWY_INLINE V pairs(const double* low, const double* high)
{
  return hn::Combine(D4(), hn::LoadU(D2(), high), hn::LoadU(D2(), low));
}
HWY_INLINE V picked(const std::array<double, 8>& v, unsigned i, unsigned j, unsigned k, unsigned l)
{
  const hn::FixedTag<double, 1> one;
  return hn::Combine(D4(), hn::Combine(D2(), hn::LoadU(one, &v[l]), hn::LoadU(one, &v[k])),
    hn::Combine(D2(), hn::LoadU(one, &v[j]), hn::LoadU(one, &v[i])));
}

/// Four points' x, y and z, a vector each.
struct Columns
{
  V x, y, z;

  HWY_INLINE Columns(const Vec3d* points, const std::uint32_t* ids)
  {
    const double *p = &points[ids[0]].x, *q = &points[ids[1]].x, *r = &points[ids[2]].x,
                 *s = &points[ids[3]].x;
    const D4 d;
    x = hn::InterleaveLower(d, pairs(p, r), pairs(q, s));
    const V even = pairs(p + 1, r + 1), odd = pairs(q + 1, s + 1);
    y = hn::InterleaveLower(d, even, odd);
    z = hn::InterleaveUpper(d, even, odd);
  }
};

/// A line, ready for many cells.
class LineTest
{
public:
  HWY_INLINE explicit LineTest(const LineFrame& line)
    : axis_(line.kz)
    , swapped_(line.kx != (line.kz + 1) % 3)
    , originX_(hn::Set(D4(), line.origin.x))
    , originY_(hn::Set(D4(), line.origin.y))
    , originZ_(hn::Set(D4(), line.origin.z))
    , shearX_(hn::Set(D4(), line.shearX))
    , shearY_(hn::Set(D4(), line.shearY))
    , inverse_(hn::Set(D4(), line.inverse))
  {
  }

  HWY_INLINE Outcome cross(
    const Vec3d* points, const HexMesh::Cell& ids, CellFrame& frame, CellInterval& interval) const
  {
    Eight x, y, z;
    const Columns low(points, &ids[0]), high(points, &ids[4]);
    toFrame(low, x.low, y.low, z.low);
    toFrame(high, x.high, y.high, z.high);
    const unsigned right = bitsAbove(x), above = bitsAbove(y);
    if (right == 0 || right == 0xff || above == 0 || above == 0xff)
      return Outcome::Nothing;
    store(x, frame.x);
    store(y, frame.y);
    store(z, frame.z);
    store({low.x, high.x}, frame.points[0]);
    store({low.y, high.y}, frame.points[1]);
    store({low.z, high.z}, frame.points[2]);
    frame.right = right;
    frame.above = above;
    Windings windings;
    if (!wind(x, y, right, above, windings))
      return Outcome::Seldom;
    return crossFaces(frame, windings, foldedFaces(x, y), interval);
  }

private:
  /// The corners of a passed face in their order, and which of the roots it is.
  struct Passed
  {
    unsigned face = 0;
    int winding = 0;
    unsigned positive = 0; ///< whether the root where the orientation is positive
    const std::uint8_t* corners = nullptr;
  };

  static HWY_INLINE void store(const Eight& v, std::array<double, 8>& to)
  {
    hn::StoreU(v.low, D4(), to.data());
    hn::StoreU(v.high, D4(), to.data() + 4);
  }

  HWY_INLINE void toFrame(const Columns& p, V& x, V& y, V& z) const
  {
    x = axis_ == 0 ? p.y : axis_ == 1 ? p.z : p.x;
    y = axis_ == 0 ? p.z : axis_ == 1 ? p.x : p.y;
    z = axis_ == 0 ? p.x : axis_ == 1 ? p.y : p.z;
    if (swapped_)
      std::swap(x, y);
    z = hn::Sub(z, originZ_);
    x = hn::Sub(hn::Sub(x, originX_), hn::Mul(shearX_, z));
    y = hn::Sub(hn::Sub(y, originY_), hn::Mul(shearY_, z));
  }

  /// How the edges pass the half-line y = 0, x > 0. False where the rounding of a product decides.
  static HWY_INLINE bool wind(
    const Eight& x, const Eight& y, unsigned right, unsigned above, Windings& windings)
  {
    unsigned left = 0, less = 0; // which edges turn counter-clockwise and clockwise
    const auto turn = [&](V x1, V y1, V x2, V y2, int at)
    {
      const V a = hn::Mul(x1, y2), b = hn::Mul(x2, y1);
      left |= bitsOf(hn::Gt(a, b)) << at;
      less |= bitsOf(hn::Lt(a, b)) << at;
    };
    turn(x.low, y.low, next(x.low), next(y.low), 0);
    turn(x.high, y.high, next(x.high), next(y.high), 4);
    turn(x.low, y.low, x.high, y.high, 8);
    const unsigned passing = cornerBits.mixed[above], down = cornerBits.first[above];
    const unsigned mixed = cornerBits.mixed[right];
    const unsigned beside = passing & ~mixed & cornerBits.first[right], asked = passing & mixed;
    if ((asked & ~(left | less)) != 0)
      return false;
    windings = Windings(~down & (beside | (asked & left)), down & (beside | (asked & less)));
    return true;
  }

  static HWY_INLINE V pickedFrom(const std::array<double, 8>& v, const std::uint8_t (&k)[4])
  {
    return picked(v, k[0], k[1], k[2], k[3]);
  }

  /// Bit 4 f is set where CellFaces.cpp's isConvex() does not hold for face f.
  static HWY_INLINE unsigned foldedFaces(const Eight& x, const Eight& y)
  {
    const D4 d;
    const V zero = hn::Zero(d);
    unsigned left = 0, right = 0; // how each face turns at its corners
    const auto turn = [&](V px, V py, int face)
    {
      const V sideX = hn::Sub(next(px), px), sideY = hn::Sub(next(py), py);
      const V turns = hn::Sub(hn::Mul(sideX, next(sideY)), hn::Mul(next(sideX), sideY));
      left |= bitsOf(hn::Gt(turns, zero)) << 4 * face;
      right |= bitsOf(hn::Lt(turns, zero)) << 4 * face;
    };
    turn(x.low, y.low, 0);
    turn(x.high, y.high, 1);
    const V x5476 = hn::Shuffle01(x.high), y5476 = hn::Shuffle01(y.high);
    turn(hn::ConcatLowerLower(d, x5476, x.low), hn::ConcatLowerLower(d, y5476, y.low), 2);
    turn(hn::ConcatUpperUpper(d, x5476, x.low), hn::ConcatUpperUpper(d, y5476, y.low), 3);
    const V x6547 = hn::Shuffle01(next(x.high)), y6547 = hn::Shuffle01(next(y.high));
    const V x1230 = next(x.low), y1230 = next(y.low);
    turn(hn::ConcatUpperUpper(d, x6547, x1230), hn::ConcatUpperUpper(d, y6547, y1230), 4);
    turn(hn::ConcatLowerLower(d, x6547, x1230), hn::ConcatLowerLower(d, y6547, y1230), 5);
    const auto any = [](unsigned bits)
    {
      bits |= bits >> 1;
      return (bits | bits >> 2) & 0x111111U;
    };
    return any(left) & any(right);
  }

  /// Bits of how corners follow one another: which of the first six are less than another, and
  /// whether any are equal.
  struct Comparison
  {
    unsigned less = 0;
    bool tied = false;
  };
  static HWY_INLINE Comparison compared(V v)
  {
    const V beside = next(v), across = opposite(v);
    return {bitsOf(hn::Lt(v, beside)) | (bitsOf(hn::Lt(v, across)) & 3U) << 4,
      bitsOf(hn::Or(hn::Eq(v, beside), hn::Eq(v, across))) != 0};
  }

  /// The same for corners of which some have the same x: y decides, and then z. Corners that
  /// coincide stay tied.
  static HWY_NOINLINE Comparison comparedFully(const CellFrame& f, const std::uint8_t (&k)[4])
  {
    const V x = pickedFrom(f.points[0], k), y = pickedFrom(f.points[1], k),
            z = pickedFrom(f.points[2], k);
    const auto compare = [&](V xs, V ys, V zs, bool& tied)
    {
      const auto sameX = hn::Eq(x, xs), sameY = hn::Eq(y, ys);
      const auto sameXY = hn::And(sameX, sameY);
      tied = tied || bitsOf(hn::And(sameXY, hn::Eq(z, zs))) != 0;
      return bitsOf(hn::Or(
        hn::Lt(x, xs), hn::Or(hn::And(sameX, hn::Lt(y, ys)), hn::And(sameXY, hn::Lt(z, zs)))));
    };
    Comparison c;
    c.less = compare(next(x), next(y), next(z), c.tied);
    c.less |= (compare(opposite(x), opposite(y), opposite(z), c.tied) & 3U) << 4;
    return c;
  }

  /// Finds the order of a face's corners. False where some coincide.
  static HWY_INLINE bool order(const CellFrame& f, Passed& passed)
  {
    const auto& k = faceCorners[passed.face];
    Comparison c = compared(pickedFrom(f.points[0], k));
    if (c.tied)
      c = comparedFully(f, k);
    const unsigned which = faceOrders.of[c.less];
    passed.corners = faceOrders.corners[passed.face][which];
    // Of which % 2 the corners are the other way round.
    passed.positive = (passed.winding > 0 ? 1U : 0U) ^ which % 2;
    return !c.tied;
  }

  HWY_INLINE Outcome crossFaces(
    const CellFrame& frame, const Windings& windings, unsigned folded, CellInterval& interval) const
  {
    const unsigned mixed = cornerBits.mixedFaces[frame.right] & cornerBits.mixedFaces[frame.above];
    for (; folded != 0; folded &= folded - 1)
    {
      const auto f = static_cast<unsigned>(std::countr_zero(folded)) / 4;
      if ((mixed >> f & 1U) != 0 && windings.of(f) == 0 && isFoldPassed(frame, f))
        return Outcome::Seldom;
    }
    const std::uint64_t faces = windings.passed();
    if (faces == 0)
      return Outcome::Nothing;
    if (std::popcount(faces) != 2)
      return Outcome::Seldom;
    Passed passed[2];
    passed[0].face = static_cast<unsigned>(std::countr_zero(faces)) / 8;
    passed[1].face = static_cast<unsigned>(std::countr_zero(faces & (faces - 1))) / 8;
    for (Passed& p : passed)
      p.winding = windings.of(p.face);
    if (passed[0].winding * passed[1].winding != -1 || !order(frame, passed[0]) ||
        !order(frame, passed[1]))
      return Outcome::Seldom;
    double t[2];
    findT(frame, passed, t);
    const unsigned in = passed[0].winding < 0 ? 0 : 1;
    interval = {t[in], t[1 - in], static_cast<std::uint8_t>(passed[in].face),
      static_cast<std::uint8_t>(passed[1 - in].face)};
    return interval.in < interval.out ? Outcome::Passed : Outcome::Nothing;
  }

  /// As CellFaces.cpp's cross().
  static HWY_INLINE V crossed(V ax, V ay, V bx, V by)
  {
    const V p = hn::Mul(ax, by), q = hn::Mul(ay, bx), d = hn::Sub(p, q);
    const V error = hn::Sub(hn::MulSub(ax, by, p), hn::MulSub(ay, bx, q));
    const auto exact =
      hn::Ge(hn::Mul(hn::Set(D4(), 16.0), hn::Abs(d)), hn::Add(hn::Abs(p), hn::Abs(q)));
    return hn::IfThenElse(exact, d, hn::Add(d, error));
  }

  /// As CellFaces.cpp's BernsteinRoots; `negative` says which root.
  static HWY_INLINE V rootOf(V h0, V h1, V h2, hn::Mask<D4> negative)
  {
    const V zero = hn::Zero(D4());
    const V square = crossed(h1, h0, h2, h1);
    const V root = hn::Sqrt(hn::IfThenZeroElse(hn::Lt(square, zero), square));
    const auto rises = hn::Ge(h1, zero);
    const V q = hn::IfThenElse(rises, hn::Neg(hn::Add(h1, root)), hn::Sub(root, h1));
    const auto flat = hn::Eq(q, zero);
    const auto first = hn::Not(hn::Xor(rises, negative));
    const auto other = hn::Or(
      hn::And(first, hn::Not(hn::And(flat, hn::Eq(h2, zero)))), hn::And(hn::Eq(h0, zero), flat));
    const V n = hn::IfThenElse(other, q, h0), m = hn::IfThenElse(other, h2, q);
    const auto none = hn::And(hn::Eq(n, zero), hn::Eq(m, zero));
    return hn::IfThenElse(none, hn::Set(D4(), 0.5), hn::Div(n, hn::Add(n, m)));
  }

  /// t where the line passes two faces: of each, u and v are beside each other in a lane.
  HWY_INLINE void findT(const CellFrame& f, const Passed (&passed)[2], double (&t)[2]) const
  {
    static constexpr double signs[2][2] = {{-1.0, 1.0}, {1.0, -1.0}};
    const D4 d;
    const std::uint8_t *k = passed[0].corners, *l = passed[1].corners;
    const V abX = picked(f.x, k[0], k[1], l[0], l[1]), cdX = picked(f.x, k[2], k[3], l[2], l[3]);
    const V abY = picked(f.y, k[0], k[1], l[0], l[1]), cdY = picked(f.y, k[2], k[3], l[2], l[3]);
    const V h0 = crossed(hn::DupEven(abX), hn::DupEven(abY), hn::InterleaveUpper(d, cdX, abX),
      hn::InterleaveUpper(d, cdY, abY));
    const V h2 = crossed(hn::InterleaveUpper(d, abX, cdX), hn::InterleaveUpper(d, abY, cdY),
      hn::DupEven(cdX), hn::DupEven(cdY));
    const V diagonals = crossed(abX, abY, cdX, cdY); // ac, bd
    const V bd = hn::DupOdd(diagonals);
    const V h1 =
      hn::Mul(hn::Set(d, 0.5), hn::Add(hn::DupEven(diagonals), hn::OddEven(hn::Neg(bd), bd)));
    const V sign = pairs(signs[passed[0].positive], signs[passed[1].positive]);
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const V root = rootOf(h0, h1, h2, hn::Lt(sign, zero));
    const V uv = hn::IfThenElseZero(hn::Gt(root, zero), hn::Min(root, one));
    const V u = hn::DupEven(uv), v = hn::DupOdd(uv);
    const V ad = picked(f.z, k[0], k[3], l[0], l[3]), bc = picked(f.z, k[1], k[2], l[1], l[2]);
    const V along = hn::Add(hn::Mul(hn::Sub(one, u), ad), hn::Mul(u, bc));
    const V parts = hn::Mul(hn::OddEven(v, hn::Sub(one, v)), along);
    const V z = hn::Mul(hn::Add(hn::DupEven(parts), hn::DupOdd(parts)), inverse_);
    t[0] = hn::GetLane(z);
    t[1] = hn::GetLane(hn::UpperHalf(D2(), z));
  }

  int axis_;
  bool swapped_;
  V originX_, originY_, originZ_, shearX_, shearY_, inverse_;
};

#else

class LineTest
{
public:
  explicit LineTest(const LineFrame& line)
    : line_(line)
  {
  }

  Outcome cross(
    const Vec3d* points, const HexMesh::Cell& ids, CellFrame& frame, CellInterval&) const
  {
    frame.right = frame.above = 0;
    for (unsigned i = 0; i < 8; ++i)
      frame.add(i, points[ids[i]], line_.at(points[ids[i]]));
    return frame.isBeside() ? Outcome::Nothing : Outcome::Seldom;
  }

private:
  const LineFrame& line_;
};

#endif

} // namespace

bool intervalsOfCell(
  const LineFrame& line, const Vec3d* points, const HexMesh::Cell& ids, CellIntervals& intervals)
{
  CellFrame frame;
  const Outcome outcome = LineTest(line).cross(points, ids, frame, intervals.of[0]);
  intervals.count = outcome == Outcome::Passed ? 1 : 0;
  return outcome == Outcome::Seldom ? intersectFrame(frame, line.inverse, intervals)
                                    : outcome == Outcome::Passed;
}

std::size_t spansOfCells(const LineFrame& line, const HexMesh& mesh, const std::uint32_t* cells,
  std::size_t count, double tMin, double tMax, SpanBatch& spans)
{
  const LineTest test(line);
  const Vec3d* const points = &mesh.point(0);
  CellFrame frame;
  CellInterval interval;
  std::size_t i = 0;
  for (; i < count && spans.hasRoom(); ++i)
  {
    const Outcome outcome = test.cross(points, mesh.cell(cells[i]), frame, interval);
    if (outcome == Outcome::Passed)
      spans.add(interval.within(cells[i], tMin, tMax));
    if (outcome != Outcome::Seldom)
      continue;
    CellIntervals intervals;
    if (intersectFrame(frame, line.inverse, intervals))
      for (const CellInterval& part : intervals)
        spans.add(part.within(cells[i], tMin, tMax));
  }
  return i;
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(intervalsOfCell);
HWY_EXPORT(spansOfCells);

bool CrossingLine::intersect(const HexMesh& mesh, std::size_t cell, CellIntervals& intervals) const
{
  return HWY_DYNAMIC_DISPATCH(intervalsOfCell)(frame_, &mesh.point(0), mesh.cell(cell), intervals);
}

bool CrossingLine::intersect(const HexCorners& corners, CellIntervals& intervals) const
{
  constexpr HexMesh::Cell inOrder = {0, 1, 2, 3, 4, 5, 6, 7};
  return HWY_DYNAMIC_DISPATCH(intervalsOfCell)(frame_, corners.data(), inOrder, intervals);
}

std::size_t CrossingLine::addSpans(const HexMesh& mesh, const std::uint32_t* cells,
  std::size_t count, double tMin, double tMax, SpanBatch& spans) const
{
  return HWY_DYNAMIC_DISPATCH(spansOfCells)(frame_, mesh, cells, count, tMin, tMax, spans);
}

} // namespace mote

#endif
