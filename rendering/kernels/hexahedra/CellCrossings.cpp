#include "CellCrossings.h"

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

/// A cell's corners in the line's frame: the line is x = y = 0, and its parameter t is proportional
/// to z. Bit i of `right` and `above` says whether corner i has x > 0 and y > 0.
struct Frame
{
  std::array<double, 8> x, y, z;
  unsigned right = 0, above = 0;

  void add(unsigned i, double px, double py, double pz)
  {
    x[i] = px;
    y[i] = py;
    z[i] = pz;
    right |= static_cast<unsigned>(px > 0.0) << i;
    above |= static_cast<unsigned>(py > 0.0) << i;
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

/// What 8 bits, one a corner, say about edges and faces.
struct CornerBits
{
  std::array<std::uint16_t, 256> first{}; ///< the edge's first corner's bit
  std::array<std::uint16_t, 256> mixed{}; ///< whether the edge's corners differ
  std::array<std::uint8_t, 256> mixedFaces{};
};
constexpr CornerBits makeCornerBits()
{
  CornerBits bits;
  for (unsigned set = 0; set < 256; ++set)
  {
    for (unsigned e = 0; e < 12; ++e)
    {
      const unsigned i = set >> edgeCorners[e][0] & 1U, j = set >> edgeCorners[e][1] & 1U;
      bits.first[set] = static_cast<std::uint16_t>(bits.first[set] | i << e);
      bits.mixed[set] = static_cast<std::uint16_t>(bits.mixed[set] | (i ^ j) << e);
    }
    for (unsigned f = 0; f < 6; ++f)
    {
      unsigned sum = 0;
      for (const std::uint8_t corner : faceCorners[f])
        sum += set >> corner & 1U;
      bits.mixedFaces[set] =
        static_cast<std::uint8_t>(bits.mixedFaces[set] | (sum % 4 != 0 ? 1U : 0U) << f);
    }
  }
  return bits;
}
constexpr CornerBits cornerBits = makeCornerBits();

/// Six windings, a byte each, counted from 4 so that no byte borrows from the next.
class Windings
{
public:
  /// An edge passes the half-line, upwards or downwards.
  void add(unsigned edge, bool up)
  {
    const std::uint64_t by =
      (std::uint64_t(1) << 8 * edgeFaces[edge][0]) - (std::uint64_t(1) << 8 * edgeFaces[edge][1]);
    bytes_ += up ? by : std::uint64_t(0) - by;
  }
  int of(unsigned face) const { return static_cast<int>(bytes_ >> 8 * face & 0xffU) - 4; }

private:
  std::uint64_t bytes_ = 0x040404040404U;
};

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
Windings windingsOf(const Frame& f)
{
  Windings windings;
  const unsigned passing = cornerBits.mixed[f.above], down = cornerBits.first[f.above];
  const unsigned mixed = cornerBits.mixed[f.right], right = cornerBits.first[f.right];
  for (unsigned edges = passing & ~mixed & right; edges != 0; edges &= edges - 1)
  {
    const auto e = static_cast<unsigned>(std::countr_zero(edges));
    windings.add(e, (down >> e & 1U) == 0);
  }
  for (unsigned edges = passing & mixed; edges != 0; edges &= edges - 1)
  {
    const auto e = static_cast<unsigned>(std::countr_zero(edges));
    const std::size_t i = edgeCorners[e][0], j = edgeCorners[e][1];
    const bool up = (down >> e & 1U) == 0;
    if (sideOfOrigin(f.x[i], f.y[i], f.x[j], f.y[j]) == (up ? 1 : -1))
      windings.add(e, up);
  }
  return windings;
}

/// A face in an order that depends on its corners' places alone. `sense` is +1 or -1: whether
/// that is the order that was given or the other way round.
struct Patch
{
  Point2 a, b, c, d;
  double za, zb, zc, zd;
  int sense;
  bool isTriangle; ///< d is a

  Patch(const Frame& f, const std::uint8_t (&corners)[4]);

  double z(double u, double v) const
  {
    return (1.0 - v) * ((1.0 - u) * za + u * zb) + v * ((1.0 - u) * zd + u * zc);
  }
};

bool isLess(const Frame& f, std::size_t i, std::size_t j)
{
  if (f.x[i] != f.x[j])
    return f.x[i] < f.x[j];
  if (f.y[i] != f.y[j])
    return f.y[i] < f.y[j];
  return f.z[i] < f.z[j];
}

bool isSame(const Frame& f, std::size_t i, std::size_t j)
{
  return f.x[i] == f.x[j] && f.y[i] == f.y[j] && f.z[i] == f.z[j];
}

Patch::Patch(const Frame& f, const std::uint8_t (&corners)[4])
{
  std::array<std::size_t, 4> k = {corners[0], corners[1], corners[2], corners[3]};
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
  const std::size_t second = turned ? previous : next;
  const std::size_t last = isTriangle ? first : turned ? next : previous;
  const std::size_t third = isTriangle ? (turned ? next : previous) : middle;
  a = {f.x[first], f.y[first]}, b = {f.x[second], f.y[second]};
  c = {f.x[third], f.y[third]}, d = {f.x[last], f.y[last]};
  za = f.z[first], zb = f.z[second], zc = f.z[third], zd = f.z[last];
}

/// z where the line passes a triangle.
double zOfTriangle(const Patch& p)
{
  const double a = cross(p.b, p.c), b = cross(p.c, p.a), c = cross(p.a, p.b), sum = a + b + c;
  const double z = sum == 0.0 ? p.za : (a * p.za + b * p.zb + c * p.zc) / sum;
  return std::clamp(z, std::min({p.za, p.zb, p.zc}), std::max({p.za, p.zb, p.zc}));
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

/// Whether a face's plane shape turns the same way at all of its corners, and so has no fold. The
/// other way round the same numbers come out with the other sign.
bool isConvex(const Frame& f, const std::uint8_t (&k)[4])
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

/// Adds where the line passes a face whose winding number is 0: nowhere or twice.
void addFold(const Frame& frame, unsigned face, Crossings& crossings)
{
  if (isConvex(frame, faceCorners[face]))
    return;
  const Patch patch(frame, faceCorners[face]);
  if (patch.isTriangle)
    return;
  const PatchRoots roots(patch);
  if (!roots.exist())
    return;
  const Point2 plus = roots.root(1), minus = roots.root(-1);
  // Both are in the face or neither is: the one that is surer of it says which.
  const double p = margin(plus), m = margin(minus);
  if ((std::abs(p) > std::abs(m) ? p : m) <= 0.0)
    return;
  crossings.add(zAt(patch, plus), patch.sense);
  crossings.add(zAt(patch, minus), -patch.sense);
}

/// All passed faces of a cell, with z for t.
void findCrossings(const Frame& frame, Crossings& crossings)
{
  if (frame.right == 0 || frame.right == 0xff || frame.above == 0 || frame.above == 0xff)
    return;
  const Windings windings = windingsOf(frame);
  unsigned faces = cornerBits.mixedFaces[frame.right] & cornerBits.mixedFaces[frame.above];
  for (; faces != 0; faces &= faces - 1) // the line is beside the others
  {
    const auto f = static_cast<unsigned>(std::countr_zero(faces));
    const int winding = windings.of(f);
    if (winding == 0)
    {
      addFold(frame, f, crossings);
      continue;
    }
    const Patch patch(frame, faceCorners[f]);
    const double z = patch.isTriangle ? zOfTriangle(patch)
                                      : zAt(patch, PatchRoots(patch).root(winding * patch.sense));
    crossings.add(z, winding);
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
  double in = 0.0;
  for (int i = 0; i < crossings.count; ++i)
  {
    const bool before = inside > 0;
    inside -= first[i].leaving;
    if (!before && inside > 0)
      in = first[i].t;
    if (!before || inside > 0 || !(in < first[i].t))
      continue;
    if (intervals.count > 0 &&
        intervals.of[static_cast<std::size_t>(intervals.count - 1)].out == in)
      intervals.of[static_cast<std::size_t>(intervals.count - 1)].out = first[i].t;
    else
      intervals.of[static_cast<std::size_t>(intervals.count++)] = {in, first[i].t};
  }
  return intervals.count > 0;
}

/// Parallel to nothing that meshes are usually made of.
const Vec3d askedDirection(0.8391, 0.3241, 0.4372);

} // namespace

CrossingLine::CrossingLine(const Vec3d& origin, const Vec3d& direction)
{
  const Vec3d size = glm::abs(direction);
  kz_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  kx_ = (kz_ + 1) % 3;
  ky_ = (kz_ + 2) % 3;
  if (direction[kz_] < 0.0) // so that leaving is counter-clockwise
    std::swap(kx_, ky_);
  origin_ = {origin[kx_], origin[ky_], origin[kz_]};
  shearX_ = direction[kx_] / direction[kz_];
  shearY_ = direction[ky_] / direction[kz_];
  inverse_ = 1.0 / direction[kz_];
}

template <typename Corner>
bool CrossingLine::intersectCorners(const Corner& corner, CellIntervals& intervals) const
{
  Frame frame;
  for (unsigned i = 0; i < 8; ++i)
  {
    const double* const p = corner(i);
    const double z = p[kz_] - origin_.z;
    frame.add(i, p[kx_] - origin_.x - shearX_ * z, p[ky_] - origin_.y - shearY_ * z, z);
  }
  Crossings crossings;
  findCrossings(frame, crossings);
  intervals.count = 0;
  for (int i = 0; i < crossings.count; ++i)
    crossings.of[static_cast<std::size_t>(i)].t *= inverse_;
  return crossings.count > 0 && toIntervals(crossings, intervals);
}

bool CrossingLine::intersect(const HexMesh& mesh, std::size_t cell, CellIntervals& intervals) const
{
  const HexMesh::Cell& ids = mesh.cell(cell);
  return intersectCorners([&](unsigned i) { return &mesh.point(ids[i]).x; }, intervals);
}

bool CrossingLine::intersect(const HexCorners& corners, CellIntervals& intervals) const
{
  return intersectCorners([&](unsigned i) { return &corners[i].x; }, intervals);
}

CrossingPoint::CrossingPoint(const Vec3d& point, double size)
  : line_(point, askedDirection)
  , at_(1e-14 * size)
{
}

bool CrossingPoint::isIn(const HexMesh& mesh, std::size_t cell) const
{
  CellIntervals intervals;
  return line_.intersect(mesh, cell, intervals) && isIn(intervals);
}

bool CrossingPoint::isIn(const HexCorners& corners) const
{
  CellIntervals intervals;
  return line_.intersect(corners, intervals) && isIn(intervals);
}

bool CrossingPoint::isIn(const CellIntervals& intervals) const
{
  return std::any_of(intervals.begin(), intervals.end(),
    [this](const CellInterval& i) { return i.in <= at_ && at_ < i.out; });
}

} // namespace mote
