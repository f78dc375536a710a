#include "CylindricalSpace.h"

#include <cmath>
#include <numbers>

namespace mote
{

namespace
{

constexpr double fullTurn = 2.0 * std::numbers::pi;
constexpr double never = std::numeric_limits<double>::infinity();
/// What coordinates may be off by, as a share of the mesh's size: a thousandth of what is lost by
/// rays that begin 1e6 sizes away, in double.
constexpr double slack = 1e-9;

struct Planar
{
  double x, y;
};

double cross(const Planar& a, const Planar& b)
{
  return a.x * b.y - a.y * b.x;
}
double dot(const Planar& a, const Planar& b)
{
  return a.x * b.x + a.y * b.y;
}

constexpr std::uint8_t faces[6][4] = {
  {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};

/// The squared distance of a segment from the axis; `crossing` is a x b.
double distance2(const Planar& a, const Planar& b, double crossing)
{
  const Planar d{b.x - a.x, b.y - a.y};
  if (dot(a, d) >= 0.0)
    return dot(a, a);
  if (dot(b, d) <= 0.0)
    return dot(b, b);
  return crossing * crossing / dot(d, d);
}

/// Whether a triangle holds the axis, given its corners' cross products. Two corners are then at
/// an obtuse angle; those of a triangle that is seen from its edge have signs by rounding alone.
bool holdsAxis(const Planar& a, const Planar& b, const Planar& c, double ab, double bc, double ca)
{
  const bool around =
    (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
  return around && (dot(a, b) <= 0.0 || dot(b, c) <= 0.0 || dot(c, a) <= 0.0);
}

/// The least distance of the faces' hulls from the axis, squared; 0 where one holds the axis.
double nearest2(const std::array<Planar, 8>& p)
{
  double least = never;
  for (const auto& face : faces)
  {
    const Planar &a = p[face[0]], &b = p[face[1]], &c = p[face[2]], &d = p[face[3]];
    const double ab = cross(a, b), bc = cross(b, c), cd = cross(c, d), da = cross(d, a),
                 ac = cross(a, c), bd = cross(b, d);
    if (holdsAxis(a, b, c, ab, bc, -ac) || holdsAxis(a, c, d, ac, cd, da) ||
        holdsAxis(a, b, d, ab, bd, da) || holdsAxis(b, c, d, bc, cd, -bd))
      return 0.0;
    least = std::min({least, distance2(a, b, ab), distance2(b, c, bc), distance2(c, d, cd),
      distance2(d, a, da), distance2(a, c, ac), distance2(b, d, bd)});
  }
  return least;
}

/// The range of the corners' angles, where no face holds the axis. The second may be above 2 pi.
std::array<double, 2> angles(const std::array<Planar, 8>& p)
{
  Planar middle{0.0, 0.0};
  for (const Planar& q : p)
    middle = {middle.x + 0.125 * q.x, middle.y + 0.125 * q.y};
  double low = never, high = -never;
  bool ahead = true;
  for (const Planar& q : p)
  {
    const double along = dot(middle, q), slope = cross(middle, q) / along;
    ahead = ahead && along > 0.0;
    low = std::min(low, slope);
    high = std::max(high, slope);
  }
  double base = std::atan2(middle.y, middle.x);
  if (ahead)
  {
    low = std::atan(low);
    high = std::atan(high);
  }
  else
  {
    // The cell reaches far around the axis: from corner to corner along edges, each less than half
    // a turn.
    constexpr std::uint8_t tree[7][2] = {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {4, 5}, {5, 6}, {6, 7}};
    std::array<double, 8> at{};
    base = std::atan2(p[0].y, p[0].x);
    low = high = 0.0;
    for (const auto& edge : tree)
    {
      const Planar &a = p[edge[0]], &b = p[edge[1]];
      at[edge[1]] = at[edge[0]] + std::atan2(cross(a, b), dot(a, b));
      low = std::min(low, at[edge[1]]);
      high = std::max(high, at[edge[1]]);
    }
  }
  const double shift = fullTurn * std::floor((base + low) / fullTurn);
  return {base + low - shift, base + high - shift};
}

} // namespace

CylindricalSpace::CylindricalSpace(const CylinderAxis& axis, double extent, double seam)
  : origin_(axis.origin)
  , h_(glm::normalize(axis.direction))
  , extent_(extent)
  , seam_(seam)
{
  const Vec3d size = glm::abs(h_);
  const Vec3d other = size.x <= size.y && size.x <= size.z ? Vec3d(1, 0, 0)
                      : size.y <= size.z                   ? Vec3d(0, 1, 0)
                                                           : Vec3d(0, 0, 1);
  const Vec3d u = glm::normalize(other - glm::dot(other, h_) * h_), v = glm::cross(h_, u);
  x_ = std::cos(seam) * u + std::sin(seam) * v;
  y_ = glm::cross(h_, x_);
}

Vec3d CylindricalSpace::coordinates(const Vec3d& p) const
{
  const Vec3d q = toFrame(p);
  const double angle = std::atan2(q.y, q.x);
  return {std::sqrt(q.x * q.x + q.y * q.y), angle < 0.0 ? angle + fullTurn : angle, q.z};
}

CellOutline CylindricalSpace::outlineOf(HexCorners corners) const
{
  for (Vec3d& p : corners)
    p = toFrame(p);
  return {corners, slack * extent_};
}

CylindricalSpace::Ray CylindricalSpace::ray(const HexRay& r) const
{
  Ray ray;
  ray.origin = toFrame(r.origin);
  ray.direction = {glm::dot(r.direction, x_), glm::dot(r.direction, y_), glm::dot(r.direction, h_)};
  const Planar o{ray.origin.x, ray.origin.y}, d{ray.direction.x, ray.direction.y};
  ray.planar = dot(d, d);
  // What is left of a direction along the axis is rounding.
  if (ray.planar < 1e-30 * glm::dot(ray.direction, ray.direction))
    ray.planar = ray.direction.x = ray.direction.y = 0.0;
  ray.turn = ray.planar > 0.0 ? cross(o, d) : 0.0;
  ray.nearest = ray.planar > 0.0 ? -dot(o, d) / ray.planar : 0.0;
  ray.nearest2 = ray.planar > 0.0 ? ray.turn * ray.turn / ray.planar : dot(o, o);
  ray.inversePlanar = 1.0 / ray.planar;
  ray.inverseHeight = 1.0 / ray.direction.z;
  ray.foot = ray.planar > 0.0
               ? Vec3d(ray.turn / ray.planar * d.y, -ray.turn / ray.planar * d.x, 0.0)
               : Vec3d(o.x, o.y, 0.0);
  return ray;
}

SpaceBounds CylindricalSpace::boundsOf(const HexCorners& corners) const
{
  std::array<Planar, 8> p;
  double outer2 = 0.0, bottom = never, top = -never;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Vec3d q = toFrame(corners[i]);
    p[i] = {q.x, q.y};
    outer2 = std::max(outer2, dot(p[i], p[i]));
    bottom = std::min(bottom, q.z);
    top = std::max(top, q.z);
  }
  const double by = slack * extent_;
  const double inner = std::max(0.0, std::sqrt(nearest2(p)) - by), outer = std::sqrt(outer2) + by;
  // Near the axis angles mean less and less.
  const double aside = inner > 0.0 ? by / inner : never;
  std::array<double, 2> angle = {0.0, fullTurn};
  if (aside < 0.1)
  {
    angle = angles(p);
    angle = {angle[0] - aside, angle[1] + aside};
    if (angle[1] - angle[0] >= fullTurn)
      angle = {0.0, fullTurn};
  }
  SpaceBounds bounds({inner, angle[0], bottom - by}, {outer, angle[1], top + by});
  bounds.lower[0] = std::max(bounds.lower[0], 0.0F);
  return bounds;
}

double CylindricalSpace::area(const SpaceBounds& b)
{
  const Vec3d d = b.to() - b.from();
  const double angle = std::min(d.y, fullTurn);
  return (2.0 * b.lower[0] + d.x) * (d.x + d.z) * angle + 2.0 * d.x * d.z;
}

Lattice CylindricalSpace::lattice(const SpaceBounds& extent, const std::array<int, 3>& n)
{
  const Vec3d from = extent.from(), to = extent.to();
  return {
    {from.x, 0.0, from.z}, {(to.x - from.x) / n[0], fullTurn / n[1], (to.z - from.z) / n[2]}, n};
}

Lattice CylindricalSpace::within(const Lattice& l, int i, int j, int k, const std::array<int, 3>& n)
{
  return {l.lower + Vec3d(i, j, k) * l.step, l.step / Vec3d(n[0], n[1], n[2]), n};
}

LatticeRange CylindricalSpace::overlap(const Lattice& l, const SpaceBounds& b)
{
  LatticeRange range;
  for (const int k : {0, 2})
  {
    const auto i = static_cast<std::size_t>(k);
    range.first[i] = l.clampedAt(k, b.lower[i]);
    range.last[i] = l.clampedAt(k, b.upper[i]);
  }
  const int n = l.n[1];
  const int first = static_cast<int>(std::floor(b.lower[1] / l.step.y));
  const int last = static_cast<int>(std::floor(b.upper[1] / l.step.y));
  const bool all = last - first >= n - 1;
  range.first[1] = all ? 0 : (first + n) % n;
  range.last[1] = all ? n - 1 : range.first[1] + last - first;
  return range;
}

LatticeRange CylindricalSpace::overlapWithin(const Lattice& l, const SpaceBounds& b)
{
  LatticeRange range;
  for (const int k : {0, 2})
  {
    const auto i = static_cast<std::size_t>(k);
    range.first[i] = l.clampedAt(k, b.lower[i]);
    range.last[i] = l.clampedAt(k, b.upper[i]);
  }
  range.first[1] = l.n[1];
  range.last[1] = -1;
  for (const double shift : {-fullTurn, 0.0, fullTurn})
  {
    const double low = b.lower[1] + shift, high = b.upper[1] + shift;
    if (high < l.lower.y || low > l.lower.y + l.n[1] * l.step.y)
      continue;
    range.first[1] = std::min(range.first[1], l.clampedAt(1, low));
    range.last[1] = std::max(range.last[1], l.clampedAt(1, high));
  }
  if (range.last[1] < 0) // beside it by a rounding
  {
    range.first[1] = 0;
    range.last[1] = l.n[1] - 1;
  }
  return range;
}

CylindricalSpace::Region::Region(const SpaceBounds& b)
  : inner_(b.lower[0])
  , outer_(b.upper[0])
  , bottom_(b.lower[2])
  , top_(b.upper[2])
{
  constexpr double rounding = 3e-7; // of directions in float
  const double from = b.lower[1] - rounding, to = b.upper[1] + rounding;
  if (to - from > std::numbers::pi - 1e-3)
    return;
  from_ = {static_cast<float>(std::cos(from)), static_cast<float>(std::sin(from))};
  to_ = {static_cast<float>(std::cos(to)), static_cast<float>(std::sin(to))};
}

double CylindricalSpace::Region::area() const
{
  const double width = outer_ - inner_, height = top_ - bottom_;
  const Planar a{from_[0], from_[1]}, b{to_[0], to_[1]};
  const double angle = isSector() ? std::atan2(cross(a, b), dot(a, b)) : fullTurn;
  const double ends = isSector() ? 2.0 * width * height : 0.0;
  return (outer_ + inner_) * (width + height) * angle + ends;
}

namespace
{

/// Narrows to where a + b t >= 0. Most are all on one side, and nothing is divided.
bool clipHalf(double a, double b, double& tIn, double& tOut)
{
  const double in = a + b * tIn, out = a + b * tOut;
  if (in >= 0.0 && out >= 0.0)
    return true;
  if (!(in >= 0.0 || out >= 0.0))
    return false;
  (in >= 0.0 ? tOut : tIn) = -a / b;
  return tIn <= tOut;
}

} // namespace

bool CylindricalSpace::Region::clip(const Ray& ray, double& tIn, double& tOut) const
{
  const double outer2 = static_cast<double>(outer_) * outer_;
  const double inner2 = static_cast<double>(inner_) * inner_;
  if (ray.nearest2 > outer2)
    return false;
  const Vec3d &o = ray.origin, &d = ray.direction;
  if (d.z == 0.0)
  {
    if (o.z < bottom_ || o.z > top_)
      return false;
  }
  else
  {
    const double a = (bottom_ - o.z) * ray.inverseHeight, b = (top_ - o.z) * ray.inverseHeight;
    tIn = std::max(tIn, std::min(a, b));
    tOut = std::min(tOut, std::max(a, b));
  }
  if (ray.planar > 0.0)
  {
    const double half = std::sqrt((outer2 - ray.nearest2) * ray.inversePlanar);
    tIn = std::max(tIn, ray.nearest - half);
    tOut = std::min(tOut, ray.nearest + half);
  }
  else if (ray.nearest2 < inner2)
    return false;
  if (tIn > tOut)
    return false;
  if (isSector() &&
      (!clipHalf(from_[0] * o.y - from_[1] * o.x, from_[0] * d.y - from_[1] * d.x, tIn, tOut) ||
        !clipHalf(to_[1] * o.x - to_[0] * o.y, to_[1] * d.x - to_[0] * d.y, tIn, tOut)))
    return false;
  return ray.planar == 0.0 || ray.nearest2 >= inner2 || clipHole(ray, inner2, tIn, tOut);
}

/// Moves ends that lie within the inner cylinder out of it.
bool CylindricalSpace::Region::clipHole(
  const Ray& ray, double inner2, double& tIn, double& tOut) const
{
  const double half = std::sqrt((inner2 - ray.nearest2) * ray.inversePlanar);
  const double begin = ray.nearest - half, end = ray.nearest + half;
  if (tIn > begin && tIn < end)
    tIn = end;
  if (tOut > begin && tOut < end)
    tOut = begin;
  return tIn <= tOut;
}

bool CylindricalSpace::Region::contains(const Vec3d& p) const
{
  const double r2 = p.x * p.x + p.y * p.y;
  if (p.z < bottom_ || p.z > top_ || r2 > static_cast<double>(outer_) * outer_ ||
      r2 < static_cast<double>(inner_) * inner_)
    return false;
  return !isSector() || isBetween(p.x, p.y);
}

bool CylindricalSpace::Region::overlaps(const Region& other) const
{
  if (inner_ > other.outer_ || other.inner_ > outer_ || bottom_ > other.top_ ||
      other.bottom_ > top_)
    return false;
  // Of two sectors that overlap one begins within the other.
  return !isSector() || !other.isSector() || isBetween(other.from_[0], other.from_[1]) ||
         other.isBetween(from_[0], from_[1]);
}

CylindricalSpace::Walk::Walk(
  const CylindricalSpace&, const Ray& ray, const Lattice& lattice, double t, double tEnd)
  : ray_(ray)
  , lattice_(lattice)
  , tEnd_(tEnd)
  , t_(t)
  , inwards_(t < ray.nearest)
  , full_(lattice.n[1] * lattice.step.y > fullTurn - 1e-6)
{
  const Vec3d p = ray.at(t);
  const double r = std::sqrt(p.x * p.x + p.y * p.y);
  at_[0] = full_ && r < lattice.lower.x ? -1 : lattice.clampedAt(0, r);
  at_[2] = lattice.clampedAt(2, p.z);
  at_[1] = 0;
  if (lattice.n[1] > 1)
  {
    const double middle = lattice.lower.y + 0.5 * lattice.n[1] * lattice.step.y;
    double angle = r > 0.0 ? std::atan2(p.y, p.x) : std::atan2(ray.direction.y, ray.direction.x);
    angle += fullTurn * std::round((middle - angle) / fullTurn);
    at_[1] = lattice.clampedAt(1, angle);
    const double plane = lattice.lower.y + (at_[1] + (ray.turn > 0.0)) * lattice.step.y;
    cosine_ = std::cos(plane);
    sine_ = std::sin(plane);
    stepCosine_ = std::cos(lattice.step.y);
    stepSine_ = std::copysign(std::sin(lattice.step.y), ray.turn);
  }
  planRadius();
  planAngle();
  planHeight();
  choose();
}

void CylindricalSpace::Walk::planRadius()
{
  leaves_[0] = never;
  if (ray_.planar == 0.0)
    return;
  const auto shell = [&](int i)
  {
    const double r = lattice_.lower.x + i * lattice_.step.x;
    return (r * r - ray_.nearest2) / ray_.planar;
  };
  if (inwards_ && at_[0] >= 0)
  {
    const double half2 = shell(at_[0]);
    if (half2 > 0.0 && lattice_.lower.x + at_[0] * lattice_.step.x > 0.0)
    {
      if (full_ || at_[0] > 0)
        leaves_[0] = ray_.nearest - std::sqrt(half2);
      return;
    }
  }
  inwards_ = false;
  if (at_[0] < lattice_.n[0] - 1)
    leaves_[0] = ray_.nearest + std::sqrt(std::max(0.0, shell(at_[0] + 1)));
}

void CylindricalSpace::Walk::planAngle()
{
  leaves_[1] = never;
  if (lattice_.n[1] == 1)
    return;
  if (ray_.turn == 0.0)
  {
    if (full_ && ray_.planar > 0.0 && t_ < ray_.nearest)
      leaves_[1] = ray_.nearest;
    return;
  }
  if (!full_ && at_[1] == (ray_.turn > 0.0 ? lattice_.n[1] - 1 : 0))
    return;
  const double c = cosine_ * ray_.direction.y - sine_ * ray_.direction.x;
  if (c * ray_.turn > 0.0)
    leaves_[1] = ray_.nearest + (ray_.foot.x * sine_ - ray_.foot.y * cosine_) / c;
}

void CylindricalSpace::Walk::planHeight()
{
  leaves_[2] = never;
  const double d = ray_.direction.z;
  if (d == 0.0 || at_[2] == (d > 0.0 ? lattice_.n[2] - 1 : 0))
    return;
  leaves_[2] = (lattice_.lower.z + (at_[2] + (d > 0.0)) * lattice_.step.z - ray_.origin.z) / d;
}

void CylindricalSpace::Walk::choose()
{
  axis_ =
    leaves_[0] < leaves_[1] ? (leaves_[0] < leaves_[2] ? 0 : 2) : (leaves_[1] < leaves_[2] ? 1 : 2);
  tOut_ = std::min(std::max(leaves_[static_cast<std::size_t>(axis_)], t_), tEnd_);
}

/// Theta jumps by half a turn where a ray meets the axis.
void CylindricalSpace::Walk::passAxis()
{
  const double angle = std::atan2(ray_.direction.y, ray_.direction.x);
  at_[1] = lattice_.clampedAt(1, angle < 0.0 ? angle + fullTurn : angle);
}

bool CylindricalSpace::Walk::next()
{
  t_ = tOut_;
  if (t_ >= tEnd_)
    return false;
  if (axis_ == 0)
  {
    at_[0] += inwards_ ? -1 : 1;
    planRadius();
  }
  else if (axis_ == 2)
  {
    at_[2] += ray_.direction.z > 0.0 ? 1 : -1;
    planHeight();
  }
  else
  {
    if (ray_.turn == 0.0)
      passAxis();
    else
    {
      const int n = lattice_.n[1];
      at_[1] = (at_[1] + (ray_.turn > 0.0 ? 1 : n - 1)) % n;
      const double c = cosine_ * stepCosine_ - sine_ * stepSine_;
      sine_ = sine_ * stepCosine_ + cosine_ * stepSine_;
      cosine_ = c;
    }
    planAngle();
  }
  choose();
  return true;
}

} // namespace mote
