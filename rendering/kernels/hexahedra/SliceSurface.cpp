#include "SliceSurface.h"

#include "../core/Error.h"
#include "../core/PlaceByNormals.h"
#include "../core/SurfaceRounding.h"
#include "CellSampler.h"
#include "detail/CellFaces.h"
#include "detail/CellFinder.h"
#include "detail/ValuesAt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace mote
{

namespace
{

Vec3d normalized(const Vec3d& direction, const char* what)
{
  const double length = glm::length(direction);
  if (!(length > 0.0) || !std::isfinite(length))
    throw Error(std::string("The ") + what + " of a slice has no length.");
  return direction / length;
}

} // namespace

SliceSurface::Frame SliceSurface::framed(const SliceShape& shape)
{
  Frame frame{shape};
  frame.axes[2] = normalized(shape.axis, "axis");
  Vec3d across = shape.out - glm::dot(shape.out, frame.axes[2]) * frame.axes[2];
  if (shape.kind == SliceShape::Kind::Plane && !(glm::length(across) > 0.0))
  {
    Vec3d other;
    acrossAxes(frame.axes[2], across, other);
  }
  frame.axes[0] = normalized(across, "direction away from the axis");
  frame.axes[1] = glm::cross(frame.axes[2], frame.axes[0]);
  const bool isRound =
    shape.kind == SliceShape::Kind::Cylinder || shape.kind == SliceShape::Kind::Unrolled;
  if (isRound && !(shape.radius > 0.0 && std::isfinite(shape.radius)))
    throw Error("The radius of a slice must be above 0.");
  return frame;
}

SliceSurface::SliceSurface(std::shared_ptr<const HexStructure> structure,
  std::shared_ptr<const HexField> field, const std::vector<SliceShape>& shapes,
  std::shared_ptr<const HiddenCells> hidden, bool showsNaN)
  : structure_(std::move(structure))
  , field_(std::move(field))
  , hidden_(std::move(hidden))
  , showsNaN_(showsNaN)
{
  if (shapes.size() >= std::size_t{1} << 31)
    throw Error("There are too many slices.");
  Box box;
  for (const SliceShape& shape : shapes)
  {
    const Frame frame = framed(shape);
    frames_.push_back(frame);
    box.add(boundsOf(frame, -M_PI, M_PI));
  }
  box = box.expanded(surfaceError * glm::length(box.size()));
  lower_ = box.lower;
  upper_ = box.upper;
}

Box SliceSurface::tightBounds() const
{
  const HexMesh& mesh = meshOf(*structure_);
  Box box;
  for (const Frame& frame : frames_)
  {
    double left = M_PI, right = -M_PI; // of a sector that is rolled out
    for (std::size_t i = 0; frame.shape.kind == SliceShape::Kind::Unrolled && i < mesh.pointCount();
         ++i)
    {
      const Vec3d p = (mesh.point(i) - frame.shape.point) * frame.axes;
      const double angle = std::atan2(p.y, p.x);
      left = std::min(left, angle);
      right = std::max(right, angle);
    }
    box.add(boundsOf(frame, left, right));
  }
  return box;
}

double SliceSurface::rounding() const
{
  return surfaceRounding(glm::max(this->bounds().size(), meshOf(*structure_).bounds().size()));
}

namespace
{

/// Where the edges of a box pass a plane.
Box planeIn(const Box& box, const Vec3d& point, const Vec3d& normal)
{
  Box met;
  const HexCorners corners = cornersOf(box);
  for (const auto& edge : edgeCorners)
  {
    const Vec3d &a = corners[edge[0]], &b = corners[edge[1]];
    const double from = glm::dot(a - point, normal), to = glm::dot(b - point, normal);
    if (from == 0.0)
      met.add(a);
    if (to == 0.0)
      met.add(b);
    if ((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0))
      met.add(a + from / (from - to) * (b - a));
  }
  return met;
}

} // namespace

/// `left` and `right` are the angles from where to where a cylinder is rolled out.
Box SliceSurface::boundsOf(const Frame& frame, double left, double right) const
{
  const Box& mesh = meshOf(*structure_).bounds();
  const SliceShape& shape = frame.shape;
  if (mesh.empty())
    return {};
  if (shape.kind == SliceShape::Kind::Plane || shape.kind == SliceShape::Kind::HalfPlane)
    return planeIn(mesh, shape.point, frame.axes[shape.kind == SliceShape::Kind::Plane ? 2 : 1]);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3d& corner : cornersOf(mesh))
  {
    const double height = glm::dot(corner - shape.point, frame.axes[2]);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  Box box;
  for (const double height : {low, high})
  {
    const Vec3d end = shape.point + height * frame.axes[2];
    if (shape.kind == SliceShape::Kind::Unrolled)
      for (const double side : {left, right})
        box.add(end + shape.radius * (frame.axes[0] + side * frame.axes[1]));
    else
      for (const double side : {-1.0, 1.0})
        box.add(end + side * shape.radius *
                        glm::sqrt(glm::max(Vec3d(0.0), 1.0 - frame.axes[2] * frame.axes[2])));
  }
  if (shape.kind == SliceShape::Kind::Unrolled)
    return box;
  box = {glm::max(box.lower, mesh.lower), glm::min(box.upper, mesh.upper)};
  return box.empty() ? Box() : box;
}

/// Where a ray passes a shape that is no plane, nearest first; how often.
int SliceSurface::meet(const Frame& frame, const Vec3d& origin, const Vec3d& way, double t[2])
{
  const SliceShape& shape = frame.shape;
  // In the frame, whose coordinates are products with its axes.
  const Vec3d from = (origin - shape.point) * frame.axes, go = way * frame.axes;
  if (shape.kind == SliceShape::Kind::Cylinder)
  {
    const double a = go.x * go.x + go.y * go.y;
    if (!(a > 0.0))
      return 0;
    const double nearest = -(from.x * go.x + from.y * go.y) / a;
    // Distance from the axis as what is left there, not as a difference of large squares.
    const double x = from.x + nearest * go.x, y = from.y + nearest * go.y;
    const double distance = std::sqrt(x * x + y * y);
    const double left = (shape.radius - distance) * (shape.radius + distance);
    if (left < 0.0)
      return 0;
    const double half = std::sqrt(left / a);
    t[0] = nearest - half;
    t[1] = nearest + half;
    return 2;
  }
  const int across = shape.kind == SliceShape::Kind::HalfPlane ? 1 : 0;
  const double level = shape.kind == SliceShape::Kind::Unrolled ? shape.radius : 0.0;
  t[0] = (level - from[across]) / go[across];
  if (!std::isfinite(t[0]))
    return 0;
  const Vec3d at = from + t[0] * go;
  if (shape.kind == SliceShape::Kind::HalfPlane)
    return at.x >= 0.0;
  return std::abs(at.y) <= M_PI * shape.radius;
}

/// Of what is rolled out.
Vec3d SliceSurface::unrolledPoint(const Frame& frame, const Vec3d& point)
{
  const SliceShape& shape = frame.shape;
  const Vec3d flat = (point - shape.point) * frame.axes;
  const double angle = flat.y / shape.radius;
  return shape.point +
         frame.axes * Vec3d(shape.radius * std::cos(angle), shape.radius * std::sin(angle), flat.z);
}

Vec3d SliceSurface::normalAt(const Frame& frame, const Vec3d& point)
{
  switch (frame.shape.kind)
  {
  case SliceShape::Kind::Plane:
    return frame.axes[2];
  case SliceShape::Kind::HalfPlane:
    return frame.axes[1];
  case SliceShape::Kind::Cylinder:
    return radial(frame, point);
  default:
    return frame.axes[0];
  }
}

/// From the axis to a point, and across it.
Vec3d SliceSurface::radial(const Frame& frame, const Vec3d& point)
{
  const Vec3d from = point - frame.shape.point;
  return from - glm::dot(from, frame.axes[2]) * frame.axes[2];
}

Vec3d SliceSurface::meshPoint(std::uint64_t slot, const Vec3d& point) const
{
  return meshPoint(frameOf(slot), point);
}

Vec3d SliceSurface::normalAt(std::uint64_t slot, const Vec3d& point) const
{
  return normalAt(frameOf(slot), point);
}

CellFinder SliceSurface::finder() const
{
  return {*structure_, [this](std::uint32_t cell)
    {
      if (hidden_ && (*hidden_)[cell])
        return false;
      if (showsNaN_)
        return true;
      CellSampler sampler(meshOf(*structure_), *field_);
      sampler.enter(cell);
      return !sampler.isNaN();
    }};
}

void SliceSurface::place(HitBlock& block, const HitPlacing& placing) const
{
  const RayBundle& rays = placing.local;
  for (int k = 0; k < block.count; ++k)
  {
    const int ray = block.ray[k];
    const Vec3d normal =
      normalAt(frameOf(block.slot[k]), rays.originOf(ray) + block.t[k] * rays.directionOf(ray));
    for (int axis = 0; axis < 3; ++axis)
      block.own[axis][k] = normal[axis];
  }
  placeByNormals(block, placing);
}

void SliceSurface::values(
  const std::uint64_t* slots, const Vec3d* points, int count, double* values) const
{
  for (int k = 0, end = 0; k < count; k = end)
  {
    // Hits of the same shape follow one another.
    const Frame& frame = frameOf(slots[k]);
    Vec3d places[HitBlock::capacity];
    for (end = k; end < count && end - k < HitBlock::capacity && &frameOf(slots[end]) == &frame;
         ++end)
      places[end - k] = meshPoint(frame, points[end]);
    valuesAt(meshOf(*structure_), *field_, slots + k, places, end - k, values + k);
  }
}

void SliceSurface::inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const
{
  const HexMesh& mesh = meshOf(*structure_);
  for (int k = 0; k < count; ++k)
    ids[k] = mesh.inputCell(cellOf(slots[k]));
}

SliceSurface SliceSurface::unowned() const
{
  SliceSurface copy(*this);
  copy.structure_ = mote::unowned(structure_);
  copy.field_ = mote::unowned(field_);
  copy.hidden_ = mote::unowned(hidden_);
  return copy;
}

} // namespace mote
