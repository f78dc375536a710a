#include "detail/CellFaces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

// This file must be compiled without contraction to fused multiply-adds, or what is computed in two
// places from the same numbers might differ.

namespace mote
{

namespace
{

/// A passed face: t, and +1 for leaving the cell, -1 for entering.
struct Crossing
{
  double t;
  int leaving;
  std::uint8_t face;
};

struct Crossings
{
  std::array<Crossing, 12> of;
  int count = 0;

  void add(double t, int leaving, unsigned face)
  {
    of[static_cast<std::size_t>(count++)] = {t, leaving, static_cast<std::uint8_t>(face)};
  }
};

struct Point2
{
  double x, y;
};

/// a.x b.y - a.y b.x with a small error relative to the result: along edges, where a and b are
/// nothing but rounding, their proportions still say where on the edge.
double cross(const Point2& a, const Point2& b)
{
  const double p = a.x * b.y, q = a.y * b.x, d = p - q;
  if (16.0 * std::abs(d) >= std::abs(p) + std::abs(q))
    return d;
  return d + (std::fma(a.x, b.y, -p) - std::fma(a.y, b.x, -q));
}

/// The exact sign of x1 y2 - x2 y1.
int sideOfOrigin(double x1, double y1, double x2, double y2)
{
  const double a = x1 * y2, b = x2 * y1;
  if (a != b) // rounding is monotonic
    return a > b ? 1 : -1;
  const double c = std::fma(x1, y2, -a), d = std::fma(x2, y1, -b);
  return c > d ? 1 : c < d ? -1 : 0;
}

/// How the edges pass the half-line y = 0, x > 0.
Windings windingsOf(const CellFrame& f)
{
  const unsigned passing = cornerBits.mixed[f.above], down = cornerBits.first[f.above];
  const unsigned mixed = cornerBits.mixed[f.right];
  unsigned through = passing & ~mixed & cornerBits.first[f.right];
  for (unsigned edges = passing & mixed; edges != 0; edges &= edges - 1)
  {
    const auto e = static_cast<unsigned>(std::countr_zero(edges));
    const std::size_t i = edgeCorners[e][0], j = edgeCorners[e][1];
    if (sideOfOrigin(f.x[i], f.y[i], f.x[j], f.y[j]) == ((down >> e & 1U) == 0 ? 1 : -1))
      through |= 1U << e;
  }
  return {through & ~down, through & down};
}

bool isLess(const CellFrame& f, std::size_t i, std::size_t j)
{
  const auto& [x, y, z] = f.points;
  return x[i] != x[j] ? x[i] < x[j] : y[i] != y[j] ? y[i] < y[j] : z[i] < z[j];
}

bool isSame(const CellFrame& f, std::size_t i, std::size_t j)
{
  const auto& [x, y, z] = f.points;
  return x[i] == x[j] && y[i] == y[j] && z[i] == z[j];
}

} // namespace

FaceOrder::FaceOrder(const CellFrame& f, const std::uint8_t (&given)[4])
{
  std::array<std::size_t, 4> k = {given[0], given[1], given[2], given[3]};
  std::size_t size = 4;
  for (std::size_t i = 0; i < 4; ++i)
    if (isSame(f, k[i], k[(i + 1) % 4]))
    {
      k = {k[i], k[(i + 2) % 4], k[(i + 3) % 4], k[i]};
      size = 3;
      break;
    }
  isTriangle = size == 3;
  std::size_t least = 0;
  for (std::size_t j = 1; j < size; ++j)
    if (isLess(f, k[j], k[least]))
      least = j;
  const auto behind = [&](std::size_t i)
  { return k[least + i < size ? least + i : least + i - size]; };
  const std::size_t first = k[least], middle = behind(2);
  const std::size_t next = behind(1), previous = behind(size - 1);
  const bool turned = isLess(f, previous, next);
  sense = turned ? -1 : 1;
  corners = {first, turned ? previous : next, isTriangle ? (turned ? next : previous) : middle,
    isTriangle ? first
    : turned   ? next
               : previous};
}

namespace
{

/// A face in its order.
struct Patch
{
  Point2 a, b, c, d;
  double za, zb, zc, zd;
  int sense;
  bool isTriangle; ///< d is a

  Patch(const CellFrame& f, const FaceOrder& order)
    : sense(order.sense)
    , isTriangle(order.isTriangle)
  {
    const auto& k = order.corners;
    a = {f.x[k[0]], f.y[k[0]]}, b = {f.x[k[1]], f.y[k[1]]};
    c = {f.x[k[2]], f.y[k[2]]}, d = {f.x[k[3]], f.y[k[3]]};
    za = f.z[k[0]], zb = f.z[k[1]], zc = f.z[k[2]], zd = f.z[k[3]];
  }
  Patch(const CellFrame& f, const std::uint8_t (&corners)[4])
    : Patch(f, FaceOrder(f, corners))
  {
  }

  double z(double u, double v) const
  {
    return (1.0 - v) * ((1.0 - u) * za + u * zb) + v * ((1.0 - u) * zd + u * zc);
  }
};

/// z where the line passes a triangle.
double zOfTriangle(const Patch& p)
{
  const double a = cross(p.b, p.c), b = cross(p.c, p.a), c = cross(p.a, p.b), sum = a + b + c;
  const double z = sum == 0.0 ? p.za : (a * p.za + b * p.zb + c * p.zc) / sum;
  return std::clamp(z, std::min({p.za, p.zb, p.zc}), std::max({p.za, p.zb, p.zc}));
}

std::array<double, 4> weightsInTriangle(const Patch& p)
{
  const double a = cross(p.b, p.c), b = cross(p.c, p.a), c = cross(p.a, p.b), sum = a + b + c;
  if (sum == 0.0)
    return {1.0, 0.0, 0.0, 0.0};
  return {a / sum, b / sum, c / sum, 0.0};
}

/// The roots of h0 (1 - x)^2 + 2 h1 x (1 - x) + h2 x^2.
class BernsteinRoots
{
public:
  BernsteinRoots(double h0, double h1, double h2)
    : h0_(h0)
    , h1_(h1)
    , h2_(h2)
    , root_(std::sqrt(std::max(cross({h1, h0}, {h2, h1}), 0.0)))
  {
  }

  bool exist() const { return root_ > 0.0; }
  /// The root where the polynomial rises or falls, as `sign` says.
  double at(int sign) const
  {
    // Both roots are proportions x : 1 - x. A double root at an end is told by one of them only.
    const double q = h1_ >= 0.0 ? -(h1_ + root_) : root_ - h1_;
    const bool first = (h1_ >= 0.0) == (sign < 0);
    return (first && (q != 0.0 || h2_ != 0.0)) || (h0_ == 0.0 && q == 0.0) ? share(q, h2_)
                                                                           : share(h0_, q);
  }

private:
  static double share(double n, double m) { return n == 0.0 && m == 0.0 ? 0.5 : n / (n + m); }

  double h0_, h1_, h2_, root_;
};

/// Where the line passes a patch: the (u, v) with (0, 0) between the points of two opposite edges,
/// found along both. All follows from the areas that corners make with the line.
class PatchRoots
{
public:
  explicit PatchRoots(const Patch& p)
    : PatchRoots(p, cross(p.a, p.c), cross(p.b, p.d))
  {
  }

  bool exist() const { return u_.exist() && v_.exist(); }
  /// Where the plane shape's orientation is `sign`.
  Point2 root(int sign) const { return {u_.at(sign), v_.at(-sign)}; }

private:
  PatchRoots(const Patch& p, double ac, double bd)
    : u_(cross(p.a, p.d), 0.5 * (ac + bd), cross(p.b, p.c))
    , v_(cross(p.a, p.b), 0.5 * (ac - bd), cross(p.d, p.c))
  {
  }

  BernsteinRoots u_, v_;
};

/// How far inside of the unit square; negative outside.
double margin(const Point2& uv)
{
  const double inside = std::min({uv.x, 1.0 - uv.x, uv.y, 1.0 - uv.y});
  return std::isnan(inside) ? -std::numeric_limits<double>::infinity() : inside;
}

double clamped(double x)
{
  return x > 0.0 ? std::min(x, 1.0) : 0.0;
}

double zAt(const Patch& patch, const Point2& uv)
{
  return patch.z(clamped(uv.x), clamped(uv.y));
}

std::array<double, 4> weightsAt(const Point2& uv)
{
  const double u = clamped(uv.x), v = clamped(uv.y);
  return {(1.0 - v) * (1.0 - u), (1.0 - v) * u, v * u, v * (1.0 - u)};
}

/// Whether a face's plane shape turns the same way at all of its corners, and so has no fold. The
/// other way round the same numbers come out with the other sign.
bool isConvex(const CellFrame& f, const std::uint8_t (&k)[4])
{
  const auto side = [&](std::size_t i, std::size_t j) {
    return Point2{f.x[k[j]] - f.x[k[i]], f.y[k[j]] - f.y[k[i]]};
  };
  const Point2 e[4] = {side(0, 1), side(1, 2), side(2, 3), side(3, 0)};
  const auto turn = [&](std::size_t i, std::size_t j) { return e[i].x * e[j].y - e[i].y * e[j].x; };
  const double t0 = turn(0, 1), t1 = turn(1, 2), t2 = turn(2, 3), t3 = turn(3, 0);
  return std::min(std::min(t0, t1), std::min(t2, t3)) >= 0.0 ||
         std::max(std::max(t0, t1), std::max(t2, t3)) <= 0.0;
}

/// Where the line passes a face whose winding number is 0: nowhere or twice.
struct Fold
{
  bool isPassed = false;
  double plus = 0.0, minus = 0.0; ///< z where the face's orientation is positive and negative
  int sense = 0;
};
Fold foldOf(const CellFrame& frame, unsigned face)
{
  if (isConvex(frame, faceCorners[face]))
    return {};
  const Patch patch(frame, faceCorners[face]);
  if (patch.isTriangle)
    return {};
  const PatchRoots roots(patch);
  if (!roots.exist())
    return {};
  const Point2 plus = roots.root(1), minus = roots.root(-1);
  // Both are in the face or neither is: the one that is surer of it says which.
  const double p = margin(plus), m = margin(minus);
  if ((std::abs(p) > std::abs(m) ? p : m) <= 0.0)
    return {};
  return {true, zAt(patch, plus), zAt(patch, minus), patch.sense};
}

/// All passed faces of a cell, with z for t.
void findCrossings(const CellFrame& frame, Crossings& crossings)
{
  if (frame.isBeside())
    return;
  const Windings windings = windingsOf(frame);
  unsigned faces = cornerBits.mixedFaces[frame.right] & cornerBits.mixedFaces[frame.above];
  for (; faces != 0; faces &= faces - 1) // the line is beside the others
  {
    const auto f = static_cast<unsigned>(std::countr_zero(faces));
    const int winding = windings.of(f);
    if (winding == 0)
    {
      if (const Fold fold = foldOf(frame, f); fold.isPassed)
      {
        crossings.add(fold.plus, fold.sense, f);
        crossings.add(fold.minus, -fold.sense, f);
      }
      continue;
    }
    const Patch patch(frame, faceCorners[f]);
    const double z = patch.isTriangle ? zOfTriangle(patch)
                                      : zAt(patch, PatchRoots(patch).root(winding * patch.sense));
    crossings.add(z, winding, f);
  }
}

/// From passed faces, which it sorts, to intervals: where more were entered than left.
bool toIntervals(Crossings& crossings, CellIntervals& intervals)
{
  Crossing* const first = crossings.of.data();
  for (int i = 1; i < crossings.count; ++i) // a few, mostly two
    for (int j = i; j > 0 && first[j].t < first[j - 1].t; --j)
      std::swap(first[j], first[j - 1]);
  int inside = 0;
  CellInterval part;
  for (int i = 0; i < crossings.count; ++i)
  {
    const bool before = inside > 0;
    inside -= first[i].leaving;
    if (!before && inside > 0)
    {
      part.in = first[i].t;
      part.inFace = first[i].face;
    }
    if (!before || inside > 0 || !(part.in < first[i].t))
      continue;
    part.out = first[i].t;
    part.outFace = first[i].face;
    if (intervals.count > 0 &&
        intervals.of[static_cast<std::size_t>(intervals.count - 1)].out == part.in)
    {
      intervals.of[static_cast<std::size_t>(intervals.count - 1)].out = part.out;
      intervals.of[static_cast<std::size_t>(intervals.count - 1)].outFace = part.outFace;
    }
    else
      intervals.of[static_cast<std::size_t>(intervals.count++)] = part;
  }
  return intervals.count > 0;
}

} // namespace

bool isFoldPassed(const CellFrame& frame, unsigned face)
{
  return foldOf(frame, face).isPassed;
}

bool intersectFrame(const CellFrame& frame, double inverse, CellIntervals& intervals)
{
  Crossings crossings;
  findCrossings(frame, crossings);
  intervals.count = 0;
  for (int i = 0; i < crossings.count; ++i)
    crossings.of[static_cast<std::size_t>(i)].t *= inverse;
  return crossings.count > 0 && toIntervals(crossings, intervals);
}

FacePoint facePointOf(const CellFrame& frame, std::uint8_t face, int leaving)
{
  const FaceOrder order(frame, faceCorners[face]);
  const Patch patch(frame, order);
  FacePoint point;
  for (std::size_t i = 0; i < 4; ++i)
    point.corners[i] = static_cast<std::uint8_t>(order.corners[i]);
  point.weights = patch.isTriangle ? weightsInTriangle(patch)
                                   : weightsAt(PatchRoots(patch).root(leaving * patch.sense));
  return point;
}

} // namespace mote
