#include "CellCrossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// This file must be compiled without contraction to fused multiply-adds, or what is computed in two
// places from the same numbers might differ.

namespace mote
{

namespace
{

/// A cell's corners in the line's frame: the line is x = y = 0, and t its parameter.
struct Frame
{
  std::array<double, 8> x, y, t;
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

/// A passed face: t, and +1 for leaving the cell, -1 for entering.
struct Crossing
{
  double t;
  int leaving;
};

struct Crossings
{
  std::array<Crossing, 12> of;
  int count = 0;

  void add(double t, int leaving) { of[static_cast<std::size_t>(count++)] = {t, leaving}; }
};

/// The corners of the faces, counter-clockwise seen from outside.
constexpr std::uint8_t faceCorners[6][4] = {
  {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};
constexpr std::uint8_t edgeCorners[12][2] = {
  {0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
/// The faces that have the edge in its own direction and against it.
constexpr std::uint8_t edgeFaces[12][2] = {
  {2, 0}, {5, 0}, {3, 0}, {4, 0}, {1, 2}, {1, 5}, {1, 3}, {1, 4}, {4, 2}, {2, 5}, {5, 3}, {3, 4}};

constexpr unsigned faceMask(std::size_t f)
{
  return 1U << faceCorners[f][0] | 1U << faceCorners[f][1] | 1U << faceCorners[f][2] |
         1U << faceCorners[f][3];
}
constexpr unsigned faceMasks[6] = {
  faceMask(0), faceMask(1), faceMask(2), faceMask(3), faceMask(4), faceMask(5)};

/// The exact sign of x1 y2 - x2 y1.
int sideOfOrigin(double x1, double y1, double x2, double y2)
{
  const double a = x1 * y2, b = x2 * y1;
  if (a != b) // rounding is monotonic
    return a > b ? 1 : -1;
  const double c = std::fma(x1, y2, -a), d = std::fma(x2, y1, -b);
  return c > d ? 1 : c < d ? -1 : 0;
}

/// How the edge from i to j passes the half-line y = 0, x > 0: +1 upwards, -1 downwards.
int passing(const Frame& f, std::size_t i, std::size_t j)
{
  const bool up = f.y[j] > 0.0;
  if (up == (f.y[i] > 0.0))
    return 0;
  const bool right = f.x[i] > 0.0;
  if (right == (f.x[j] > 0.0))
    return right ? (up ? 1 : -1) : 0;
  const int side = sideOfOrigin(f.x[i], f.y[i], f.x[j], f.y[j]);
  return up ? side > 0 : -static_cast<int>(side < 0);
}

/// A face in an order that depends on its corners' places alone. `sense` is +1 or -1: whether
/// that is the order that was given or the other way round.
struct Patch
{
  Point2 a, b, c, d;
  double ta, tb, tc, td;
  int sense;
  bool isTriangle; ///< d is a

  Patch(const Frame& f, const std::uint8_t (&corners)[4]);

  double t(double u, double v) const
  {
    return (1.0 - v) * ((1.0 - u) * ta + u * tb) + v * ((1.0 - u) * td + u * tc);
  }
};

bool isLess(const Frame& f, std::size_t i, std::size_t j)
{
  if (f.x[i] != f.x[j])
    return f.x[i] < f.x[j];
  if (f.y[i] != f.y[j])
    return f.y[i] < f.y[j];
  return f.t[i] < f.t[j];
}

bool isSame(const Frame& f, std::size_t i, std::size_t j)
{
  return f.x[i] == f.x[j] && f.y[i] == f.y[j] && f.t[i] == f.t[j];
}

Patch::Patch(const Frame& f, const std::uint8_t (&corners)[4])
{
  std::array<std::size_t, 4> k = {corners[0], corners[1], corners[2], corners[3]};
  std::size_t size = 4;
  for (std::size_t i = 0; i < 4 && size == 4; ++i)
    if (isSame(f, k[i], k[(i + 1) % 4]))
    {
      std::rotate(k.begin(), k.begin() + static_cast<std::ptrdiff_t>(i), k.end());
      k = {k[0], k[2], k[3], k[0]};
      size = 3;
    }
  isTriangle = size == 3;
  std::size_t least = 0;
  for (std::size_t j = 1; j < size; ++j)
    if (isLess(f, k[j], k[least]))
      least = j;
  const auto last = k.begin() + static_cast<std::ptrdiff_t>(size);
  std::rotate(k.begin(), k.begin() + static_cast<std::ptrdiff_t>(least), last);
  sense = 1;
  if (isLess(f, k[size - 1], k[1]))
  {
    std::swap(k[1], k[size - 1]);
    sense = -1;
  }
  if (isTriangle)
    k[3] = k[0];
  a = {f.x[k[0]], f.y[k[0]]}, b = {f.x[k[1]], f.y[k[1]]};
  c = {f.x[k[2]], f.y[k[2]]}, d = {f.x[k[3]], f.y[k[3]]};
  ta = f.t[k[0]], tb = f.t[k[1]], tc = f.t[k[2]], td = f.t[k[3]];
}

/// t where the line passes a triangle.
double tOfTriangle(const Patch& p)
{
  const double a = cross(p.b, p.c), b = cross(p.c, p.a), c = cross(p.a, p.b), sum = a + b + c;
  const double t = sum == 0.0 ? p.ta : (a * p.ta + b * p.tb + c * p.tc) / sum;
  return std::clamp(t, std::min({p.ta, p.tb, p.tc}), std::max({p.ta, p.tb, p.tc}));
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

/// Whether the plane shape turns the same way at all of its corners, and so has no fold.
bool isConvex(const Patch& p)
{
  const auto turn = [](const Point2& a, const Point2& b, const Point2& c) {
    return cross({b.x - a.x, b.y - a.y}, {c.x - b.x, c.y - b.y});
  };
  const double a = turn(p.d, p.a, p.b), b = turn(p.a, p.b, p.c), c = turn(p.b, p.c, p.d),
               d = turn(p.c, p.d, p.a);
  return std::min({a, b, c, d}) >= 0.0 || std::max({a, b, c, d}) <= 0.0;
}

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

double tAt(const Patch& patch, const Point2& uv)
{
  return patch.t(clamped(uv.x), clamped(uv.y));
}

/// Adds where the line passes a face, given its winding number about the line.
void addFace(const Frame& frame, std::size_t face, int winding, Crossings& crossings)
{
  const Patch patch(frame, faceCorners[face]);
  if (patch.isTriangle)
  {
    if (winding != 0)
      crossings.add(tOfTriangle(patch), winding);
    return;
  }
  if (winding != 0)
  {
    crossings.add(tAt(patch, PatchRoots(patch).root(winding * patch.sense)), winding);
    return;
  }
  if (isConvex(patch))
    return;
  const PatchRoots roots(patch);
  if (!roots.exist())
    return;
  const Point2 plus = roots.root(1), minus = roots.root(-1);
  // Both are in the face or neither is: the one that is surer of it says which.
  const double p = margin(plus), m = margin(minus);
  if ((std::abs(p) > std::abs(m) ? p : m) <= 0.0)
    return;
  crossings.add(tAt(patch, plus), patch.sense);
  crossings.add(tAt(patch, minus), -patch.sense);
}

/// All passed faces of a cell.
void findCrossings(const Frame& frame, Crossings& crossings)
{
  unsigned right = 0, above = 0;
  for (unsigned i = 0; i < 8; ++i)
  {
    right |= static_cast<unsigned>(frame.x[i] > 0.0) << i;
    above |= static_cast<unsigned>(frame.y[i] > 0.0) << i;
  }
  if (right == 0 || right == 0xff || above == 0 || above == 0xff)
    return;
  std::array<int, 6> winding{};
  for (std::size_t e = 0; e < 12; ++e)
  {
    const int p = passing(frame, edgeCorners[e][0], edgeCorners[e][1]);
    winding[edgeFaces[e][0]] += p;
    winding[edgeFaces[e][1]] -= p;
  }
  for (std::size_t f = 0; f < 6; ++f)
  {
    const unsigned mask = faceMasks[f], r = right & mask, a = above & mask;
    if (r == 0 || r == mask || a == 0 || a == mask)
      continue; // the line is beside the face
    addFace(frame, f, winding[f], crossings);
  }
}

/// From passed faces to intervals: where more were entered than left.
bool toIntervals(Crossings& crossings, CellIntervals& intervals)
{
  Crossing* const first = crossings.of.data();
  for (int i = 1; i < crossings.count; ++i) // a few, mostly two
    for (int j = i; j > 0 && first[j].t < first[j - 1].t; --j)
      std::swap(first[j], first[j - 1]);
  int inside = 0;
  for (int i = 0; i < crossings.count; ++i)
  {
    const bool before = inside > 0;
    inside -= first[i].leaving;
    if (!before && inside > 0)
      intervals.of[static_cast<std::size_t>(intervals.count)].in = first[i].t;
    else if (before && inside <= 0)
    {
      CellInterval& interval = intervals.of[static_cast<std::size_t>(intervals.count)];
      interval.out = first[i].t;
      if (intervals.count > 0 &&
          intervals.of[static_cast<std::size_t>(intervals.count - 1)].out == interval.in)
        intervals.of[static_cast<std::size_t>(intervals.count - 1)].out = interval.out;
      else
        intervals.count += interval.in < interval.out;
    }
  }
  return intervals.count > 0;
}

/// Parallel to nothing that meshes are usually made of.
const Vec3d askedDirection(0.8391, 0.3241, 0.4372);

} // namespace

CrossingLine::CrossingLine(const Vec3d& origin, const Vec3d& direction)
  : origin_(origin)
{
  const Vec3d size = glm::abs(direction);
  kz_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  kx_ = (kz_ + 1) % 3;
  ky_ = (kz_ + 2) % 3;
  if (direction[kz_] < 0.0) // so that leaving is counter-clockwise
    std::swap(kx_, ky_);
  shearX_ = direction[kx_] / direction[kz_];
  shearY_ = direction[ky_] / direction[kz_];
  inverse_ = 1.0 / direction[kz_];
}

bool CrossingLine::intersect(const HexMesh& mesh, std::size_t cell, CellIntervals& intervals) const
{
  return intersect(mesh.corners(cell), intervals);
}

bool CrossingLine::intersect(const HexCorners& corners, CellIntervals& intervals) const
{
  Frame frame;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Vec3d v = corners[i] - origin_;
    const double z = v[kz_];
    frame.x[i] = v[kx_] - shearX_ * z;
    frame.y[i] = v[ky_] - shearY_ * z;
    frame.t[i] = z * inverse_;
  }
  Crossings crossings;
  findCrossings(frame, crossings);
  intervals.count = 0;
  return crossings.count > 0 && toIntervals(crossings, intervals);
}

CrossingPoint::CrossingPoint(const Vec3d& point, double size)
  : line_(point, askedDirection)
  , at_(1e-14 * size)
{
}

bool CrossingPoint::isIn(const HexCorners& corners) const
{
  CellIntervals intervals;
  if (!line_.intersect(corners, intervals))
    return false;
  for (const CellInterval& i : intervals)
    if (i.in <= at_ && at_ < i.out)
      return true;
  return false;
}

} // namespace mote
