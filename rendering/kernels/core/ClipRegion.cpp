#include "ClipRegion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mote
{

namespace
{

/// The parts of a ray that are left.
class Spans
{
public:
  Spans(RaySpan* spans, double tMin, double tMax)
    : spans_(spans)
  {
    if (tMin <= tMax)
      spans_[count_++] = {tMin, tMax};
  }

  int count() const { return count_; }

  void keep(const RaySpan& part)
  {
    int kept = 0;
    for (int k = 0; k < count_; ++k)
    {
      const RaySpan span = {std::max(spans_[k].tIn, part.tIn), std::min(spans_[k].tOut, part.tOut)};
      if (span.tIn <= span.tOut)
        spans_[kept++] = span;
    }
    count_ = kept;
  }

  /// Leaves out what is within a part. There is room for one span more than there are.
  void drop(const RaySpan& part)
  {
    if (!(part.tIn < part.tOut))
      return;
    RaySpan left[ClipRegion::mostSpans + 1];
    int kept = 0;
    for (int k = 0; k < count_; ++k)
    {
      const RaySpan span = spans_[k];
      if (part.tIn >= span.tOut || part.tOut <= span.tIn)
        left[kept++] = span;
      else
      {
        if (span.tIn < part.tIn)
          left[kept++] = {span.tIn, part.tIn};
        if (part.tOut < span.tOut)
          left[kept++] = {part.tOut, span.tOut};
      }
    }
    count_ = std::min(kept, ClipRegion::mostSpans);
    std::copy_n(left, count_, spans_);
  }

private:
  RaySpan* spans_;
  int count_ = 0;
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr RaySpan none = {infinity, -infinity}, all = {-infinity, infinity};

/// Where height + t * slope >= 0.
RaySpan aboveZero(double height, double slope)
{
  if (slope == 0.0)
    return height >= 0.0 ? all : none;
  const double t = -height / slope;
  return slope > 0.0 ? RaySpan{t, infinity} : RaySpan{-infinity, t};
}

RaySpan both(const RaySpan& a, const RaySpan& b)
{
  return {std::max(a.tIn, b.tIn), std::min(a.tOut, b.tOut)};
}

/// The axes of a cylinder: across, where the angle is 0 and a quarter of a turn, and along it.
struct CylinderAxes
{
  Vec3d u, v, w;

  explicit CylinderAxes(const ClipCylinder& cylinder)
    : w(glm::normalize(cylinder.axis))
  {
    u = glm::normalize(cylinder.zeroAngle - glm::dot(cylinder.zeroAngle, w) * w);
    v = glm::cross(w, u);
  }
  Vec3d of(const Vec3d& p) const { return {glm::dot(p, u), glm::dot(p, v), glm::dot(p, w)}; }
};

/// Where a ray is within a radius of the axis: |p + t d| <= radius, across the axis.
RaySpan withinRadius(const Vec3d& p, const Vec3d& d, double radius)
{
  const double a = d.x * d.x + d.y * d.y;
  if (a == 0.0)
    return p.x * p.x + p.y * p.y <= radius * radius ? all : none;
  // From the ray's point that is nearest to the axis: differences of large numbers lose digits.
  const double nearest = -(p.x * d.x + p.y * d.y) / a;
  const double across = (p.x * d.y - p.y * d.x);
  const double rest = radius * radius - across * across / a;
  if (!(rest >= 0.0))
    return none;
  const double half = std::sqrt(rest / a);
  return {nearest - half, nearest + half};
}

void cutByAngles(
  const ClipCylinder& cylinder, double tolerance, const Vec3d& p, const Vec3d& d, Spans& spans)
{
  constexpr double turn = 2.0 * std::numbers::pi;
  const double width = cylinder.angle[1] - cylinder.angle[0];
  if (!(width < turn))
    return;
  // On the side of the first half-plane where angles grow, and of the second where they fall.
  const auto beside = [&](double angle, double sign, double margin)
  {
    const double c = sign * std::cos(angle), s = sign * std::sin(angle);
    return aboveZero(c * p.y - s * p.x + margin, c * d.y - s * d.x);
  };
  const double* angle = cylinder.angle;
  if (width <= std::numbers::pi)
    spans.keep(both(beside(angle[0], 1.0, tolerance), beside(angle[1], -1.0, tolerance)));
  else
    spans.drop(both(beside(angle[0], -1.0, -tolerance), beside(angle[1], 1.0, -tolerance)));
}

void cut(const ClipCylinder& cylinder, double tolerance, const Vec3d& origin,
  const Vec3d& direction, Spans& spans)
{
  const CylinderAxes axes(cylinder);
  const Vec3d p = axes.of(origin - cylinder.center), d = axes.of(direction);
  if (std::isfinite(cylinder.height[0]))
    spans.keep(aboveZero(p.z - cylinder.height[0] + tolerance, d.z));
  if (std::isfinite(cylinder.height[1]))
    spans.keep(aboveZero(cylinder.height[1] - p.z + tolerance, -d.z));
  if (std::isfinite(cylinder.radius[1]))
    spans.keep(withinRadius(p, d, cylinder.radius[1] + tolerance));
  if (cylinder.radius[0] > tolerance)
    spans.drop(withinRadius(p, d, cylinder.radius[0] - tolerance));
  cutByAngles(cylinder, tolerance, p, d, spans);
}

/// The nearest of some faces to a point.
struct NearestFace
{
  double distance;
  std::optional<Vec3d> normal;

  void add(double other, const Vec3d& outward)
  {
    if (!(std::abs(other) <= distance))
      return;
    distance = std::abs(other);
    normal = outward;
  }
};

void addFaces(const ClipCylinder& cylinder, const Vec3d& point, NearestFace& nearest)
{
  const CylinderAxes axes(cylinder);
  const Vec3d p = axes.of(point - cylinder.center);
  const double radius = std::hypot(p.x, p.y);
  const Vec3d away = radius > 0.0 ? (p.x * axes.u + p.y * axes.v) / radius : axes.u;
  for (const int end : {0, 1})
  {
    const double sign = end == 0 ? -1.0 : 1.0;
    nearest.add(p.z - cylinder.height[end], sign * axes.w);
    if (cylinder.radius[end] > 0.0)
      nearest.add(radius - cylinder.radius[end], sign * away);
    if (cylinder.angle[1] - cylinder.angle[0] < 2.0 * std::numbers::pi)
    {
      const double c = std::cos(cylinder.angle[end]), s = std::sin(cylinder.angle[end]);
      if (c * p.x + s * p.y >= 0.0)
        nearest.add(c * p.y - s * p.x, sign * (c * axes.v - s * axes.u));
    }
  }
}

} // namespace

std::optional<Vec3d> ClipRegion::faceAt(const Vec3d& point, double tolerance) const
{
  NearestFace nearest{tolerance, {}};
  for (const ClipPlane& plane : planes)
  {
    const Vec3d inwards = glm::normalize(plane.normal);
    nearest.add(glm::dot(inwards, point - plane.point), -inwards);
  }
  if (cylinder)
    addFaces(*cylinder, point, nearest);
  return nearest.normal;
}

bool ClipRegion::contains(const Vec3d& point) const
{
  RaySpan spans[mostSpans];
  return spansOf(point, Vec3d(0.0), 0.0, 0.0, spans) > 0;
}

int ClipRegion::spansOf(const Vec3d& origin, const Vec3d& direction, double tMin, double tMax,
  RaySpan spans[mostSpans]) const
{
  Spans left(spans, tMin, tMax);
  for (const ClipPlane& plane : planes)
  {
    const double margin = tolerance > 0.0 ? tolerance * glm::length(plane.normal) : 0.0;
    left.keep(aboveZero(
      glm::dot(plane.normal, origin - plane.point) + margin, glm::dot(plane.normal, direction)));
  }
  if (cylinder)
    cut(*cylinder, tolerance, origin, direction, left);
  return left.count();
}

} // namespace mote
