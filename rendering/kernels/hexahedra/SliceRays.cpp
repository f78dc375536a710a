// Where rays meet slices, and which cells they meet there.

#include "SliceSurface.h"

#include "detail/CellFinder.h"
#include "detail/RaysOf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace mote
{

namespace
{

/// How far beside a slice its cells are looked for, of the mesh's size: more than coordinates in
/// float are rounded, and less than slices lie within the faces of cuts.
constexpr double besideFaces = 2e-7;

} // namespace

/// Whether a cell may hold points no farther than `margin` from a shape that is not rolled out.
bool SliceSurface::mayHold(const Frame& frame, const HexCorners& corners, double margin)
{
  const SliceShape& shape = frame.shape;
  const bool isRound =
    shape.kind == SliceShape::Kind::Cylinder || shape.kind == SliceShape::Kind::Unrolled;
  const Vec3d& normal = frame.axes[shape.kind == SliceShape::Kind::HalfPlane ? 1 : 2];
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3d& corner : corners)
  {
    const Vec3d from = corner - shape.point;
    const Vec3d along = glm::dot(from, frame.axes[2]) * frame.axes[2];
    const double at = isRound ? glm::length(from - along) : glm::dot(from, normal);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  if (isRound) // whose inner side is farther in than any corner, where cells are large
    return high >= shape.radius * (1.0 - 1e-9) - margin;
  return low <= margin && high >= -margin;
}

/// The cell at a place of a shape. Of cells whose faces lie in the shape it is the one on the side
/// of the normal, and behind the last ones the other: rounding is not to choose.
std::uint32_t SliceSurface::cellBeside(
  CellFinder& cells, const Frame& frame, const Vec3d& place, double margin)
{
  const bool isUnrolled = frame.shape.kind == SliceShape::Kind::Unrolled; // places are not
  const Vec3d normal = glm::normalize(isUnrolled ? radial(frame, place) : normalAt(frame, place));
  const std::uint32_t cell = cells.at(place + margin * normal);
  return cell != HexMesh::noCell ? cell : cells.at(place - margin * normal);
}

template <typename Rays, typename Take>
void SliceSurface::meetEach(Rays& rays, bool winsTies, const Take& take) const
{
  CellFinder cells = this->finder();
  const double margin = besideFaces * glm::length(meshOf(*structure_).bounds().size());
  constexpr bool isBundle = std::is_same_v<Rays, RayBundle>;
  Meeting met[2][Rays::capacity];
  int counts[2];
  for (std::size_t k = 0; k < frames_.size(); ++k)
  {
    const Frame& frame = frames_[k];
    this->meetAll(frame, rays, winsTies, met, counts);
    for (int n = 0; n < 2; ++n)
    {
      Box box;
      for (int i = 0; isBundle && i < counts[n]; ++i)
        box.add(met[n][i].place);
      if (counts[n] == 0)
        continue;
      if (isBundle)
        cells.gather(box.expanded(margin),
          [&](const HexCorners& corners) { return mayHold(frame, corners, 2.0 * margin); });
      for (int i = 0; i < counts[n]; ++i)
      {
        const Meeting& at = met[n][i];
        if (n > 0 && !(at.t < rays.t[at.ray])) // of the nearer side
          continue;
        if (const std::uint32_t cell = cellBeside(cells, frame, at.place, margin);
            cell != HexMesh::noCell)
          take(at.ray, at.t, std::uint64_t{k} << 32 | cell);
      }
    }
  }
}

namespace
{

/// Where rays pass a plane; no number where they do not.
void passPlane(const RayBundle& rays, const Vec3d& point, const Vec3d& normal, double* t)
{
  const double away = glm::dot(point - rays.origin, normal);
  const double along = glm::dot(rays.direction, normal);
  const double x = glm::dot(rays.dx, normal), y = glm::dot(rays.dy, normal);
  if (rays.kind == RayBundle::Kind::CommonOrigin)
    for (int i = 0; i < rays.count; ++i)
      t[i] = away / (along + double(rays.x[i]) * x + double(rays.y[i]) * y);
  else
    for (int i = 0; i < rays.count; ++i)
      t[i] = (away - double(rays.x[i]) * x - double(rays.y[i]) * y) / along;
}

void passPlane(const RayPacket& rays, const Vec3d& point, const Vec3d& normal, double* t)
{
  for (int i = 0; i < rays.count; ++i)
  {
    const HexRay ray = rayOf(rays, i);
    t[i] = glm::dot(point - ray.origin, normal) / glm::dot(ray.direction, normal);
  }
}

/// The points of rays at `t`, by coordinate: plain loops, which compilers turn into SIMD.
void placesAt(const RayBundle& rays, const double* t, double (*places)[RayBundle::capacity])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = rays.origin[axis], along = rays.direction[axis];
    const double dx = rays.dx[axis], dy = rays.dy[axis];
    if (rays.kind == RayBundle::Kind::CommonOrigin)
      for (int i = 0; i < rays.count; ++i)
        places[axis][i] = origin + t[i] * (along + double(rays.x[i]) * dx + double(rays.y[i]) * dy);
    else
      for (int i = 0; i < rays.count; ++i)
        places[axis][i] = origin + double(rays.x[i]) * dx + double(rays.y[i]) * dy + t[i] * along;
  }
}

void placesAt(const RayPacket& rays, const double* t, double (*places)[RayPacket::capacity])
{
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < rays.count; ++i)
      places[axis][i] = rays.origin[axis][i] + t[i] * rays.direction[axis][i];
}

/// Hits of ray i at no more than this do not count.
double leastOf(const RayBundle& rays, int)
{
  return rays.tMin;
}

double leastOf(const RayPacket& rays, int i)
{
  return rays.tMin[i];
}

/// How far along its way a ray goes for a length.
double perLength(const RayBundle& rays, int)
{
  return 1.0 / glm::length(rays.direction); // those beside it hardly differ
}

double perLength(const RayPacket& rays, int i)
{
  return 1.0 / glm::length(rayOf(rays, i).direction);
}

/// Hits of ray i count before this: what it has met, or `tie` behind that.
template <typename Rays>
double mostOf(const Rays& rays, int i, double tie)
{
  return tie > 0.0 && rays.object[i] >= 0 ? rays.t[i] + tie * perLength(rays, i) : rays.t[i];
}

} // namespace

/// Where rays that may still meet something pass a shape: nearer places, and farther ones.
template <typename Rays>
void SliceSurface::meetAll(const Frame& frame, const Rays& rays, bool winsTies,
  Meeting (&met)[2][Rays::capacity], int (&counts)[2]) const
{
  counts[0] = counts[1] = 0;
  const double tie = winsTies ? this->rounding() : 0.0;
  const Box& own = meshOf(*structure_).bounds();
  const Box box = own.expanded(surfaceError * glm::length(own.size()));
  const auto add = [&](int n, const Vec3d& place, int i, double t)
  {
    if (!(place.x < box.lower.x || place.y < box.lower.y || place.z < box.lower.z ||
          place.x > box.upper.x || place.y > box.upper.y || place.z > box.upper.z))
      met[n][counts[n]++] = {place, t, i};
  };
  if (frame.shape.kind == SliceShape::Kind::Plane) // most are
  {
    double t[Rays::capacity], places[3][Rays::capacity];
    passPlane(rays, frame.shape.point, frame.axes[2], t);
    placesAt(rays, t, places);
    for (int i = 0; i < rays.count; ++i)
      if (t[i] > leastOf(rays, i) && t[i] < mostOf(rays, i, tie))
        add(0, {places[0][i], places[1][i], places[2][i]}, i, t[i]);
    return;
  }
  for (int i = 0; i < rays.count; ++i)
  {
    const HexRay ray = rayOf(rays, i);
    double t[2] = {};
    const int count = meet(frame, ray.origin, ray.direction, t);
    for (int n = 0; n < count; ++n)
      if (t[n] > ray.tMin && t[n] < mostOf(rays, i, tie))
        add(n, meshPoint(frame, ray.origin + t[n] * ray.direction), i, t[n]);
  }
}

template <typename Rays>
void SliceSurface::castEach(Rays& rays, std::int32_t index) const
{
  this->meetEach(rays, true,
    [&](int i, double t, std::uint64_t slot)
    {
      rays.t[i] = t;
      rays.slot[i] = slot;
      rays.object[i] = index;
    });
}

template <typename Rays>
void SliceSurface::occludeEach(Rays& rays) const
{
  this->meetEach(rays, false,
    [&](int i, double, std::uint64_t) { rays.t[i] = -std::numeric_limits<double>::infinity(); });
}

void SliceSurface::cast(RayBundle& rays, std::int32_t index) const
{
  this->castEach(rays, index);
}

void SliceSurface::cast(RayPacket& rays, std::int32_t index) const
{
  this->castEach(rays, index);
}

void SliceSurface::occlude(RayBundle& rays, std::int32_t) const
{
  this->occludeEach(rays);
}

void SliceSurface::occlude(RayPacket& rays, std::int32_t) const
{
  this->occludeEach(rays);
}

} // namespace mote
