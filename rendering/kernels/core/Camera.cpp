#include "Camera.h"

#include "Error.h"

#include <algorithm>
#include <cmath>

namespace mote
{

CameraRays::CameraRays(const Camera& camera, int width, int height)
  : tMin(camera.nearDistance)
  , tMax(camera.farDistance)
{
  if (width < 1 || height < 1)
    throw Error("An image needs at least one pixel in each direction.");
  const Vec3d forward = glm::normalize(camera.forward);
  const Vec3d side = glm::cross(forward, camera.up);
  if (!(glm::dot(forward, forward) > 0.5) || !(glm::dot(side, side) > 0.0))
    throw Error("The camera has no view direction, or its view-up vector is parallel to it.");
  const Vec3d right = glm::normalize(side);
  const Vec3d up = glm::cross(right, forward);

  const bool perspective = camera.projection == Camera::Projection::Perspective;
  if (perspective && !(camera.viewAngle > 0.0 && camera.viewAngle < 180.0))
    throw Error("The camera's view angle must lie between 0 and 180 degrees.");
  const double halfHeight =
    perspective ? std::tan(camera.viewAngle * (0.5 * M_PI / 180.0)) : camera.parallelScale;
  const double halfWidth = halfHeight * camera.pixelAspect * width / height;

  const Vec3d stepX = right * (2.0 * halfWidth / width);
  const Vec3d stepY = up * (2.0 * halfHeight / height);
  const Vec3d corner =
    right * (halfWidth * (camera.centerX - 1.0)) + up * (halfHeight * (camera.centerY - 1.0));
  if (perspective)
  {
    o0 = camera.position;
    ox = oy = Vec3d(0.0);
    d0 = forward + corner;
    dx = stepX;
    dy = stepY;
  }
  else
  {
    o0 = camera.position + corner;
    ox = stepX;
    oy = stepY;
    d0 = forward;
    dx = dy = Vec3d(0.0);
  }
}

CameraRays CameraRays::transformed(const Mat4d& toLocal) const
{
  CameraRays rays = *this;
  rays.o0 = transformPoint(toLocal, o0);
  rays.ox = transformVector(toLocal, ox);
  rays.oy = transformVector(toLocal, oy);
  rays.d0 = transformVector(toLocal, d0);
  rays.dx = transformVector(toLocal, dx);
  rays.dy = transformVector(toLocal, dy);
  return rays;
}

namespace
{

/// Places of the rays of a bundle, in pixels from the middle of its square.
struct BundlePlaces
{
  float x[RayBundle::capacity], y[RayBundle::capacity];

  explicit BundlePlaces(int side)
  {
    const float middle = 0.5f * static_cast<float>(side - 1);
    for (int i = 0; i < RayBundle::capacity; ++i)
    {
      int column = 0, row = 0;
      if (i < side * side)
        bundleOffset(side, i, column, row);
      x[i] = static_cast<float>(column) - middle;
      y[i] = static_cast<float>(row) - middle;
    }
  }
};

const BundlePlaces& placesOf(int side)
{
  static const BundlePlaces two(2), four(4), eight(8), sixteen(16);
  return side == 2 ? two : side == 4 ? four : side == 8 ? eight : sixteen;
}

} // namespace

void CameraRays::placeBundle(
  RayBundle& bundle, int side, int x0, int y0, double jitterX, double jitterY) const
{
  const double x = x0 + 0.5 * side + jitterX, y = y0 + 0.5 * side + jitterY;
  const bool common = ox == Vec3d(0.0) && oy == Vec3d(0.0);
  bundle.kind = common ? RayBundle::Kind::CommonOrigin : RayBundle::Kind::CommonDirection;
  bundle.origin = originAt(x, y);
  bundle.direction = directionAt(x, y);
  bundle.dx = common ? dx : ox;
  bundle.dy = common ? dy : oy;
  bundle.footprint = std::max(glm::length(ox), glm::length(oy));
  bundle.footprintPerT = std::max(glm::length(dx), glm::length(dy));
}

void CameraRays::fillBundle(
  RayBundle& bundle, int side, int x0, int y0, double jitterX, double jitterY) const
{
  placeBundle(bundle, side, x0, y0, jitterX, jitterY);
  const int count = side * side;
  bundle.count = count;
  bundle.side = side;
  bundle.tMin = tMin;
  const BundlePlaces& places = placesOf(side);
  std::copy_n(places.x, count, bundle.x);
  std::copy_n(places.y, count, bundle.y);
  std::fill_n(bundle.t, count, tMax);
  std::fill_n(bundle.slot, count, RayBundle::noHit);
  std::fill_n(bundle.object, count, -1);
}

int suitingBundleSide(
  const CameraRays& rays, const Box& bounds, double spacing, int x0, int y0, int size)
{
  const double x = x0 + 0.5 * size, y = y0 + 0.5 * size;
  const Vec3d direction = rays.directionAt(x, y), toMiddle = bounds.center() - rays.originAt(x, y);
  const double along = glm::dot(toMiddle, direction) / glm::dot(direction, direction);
  const Vec3d extent = bounds.size();
  const double quarter = 0.25 * std::max({extent.x, extent.y, extent.z}) / glm::length(direction);
  const double t = std::max({along, quarter, rays.tMin});
  const double pixel =
    std::max(glm::length(rays.ox + t * rays.dx), glm::length(rays.oy + t * rays.dy));
  const double pixels = spacing / pixel;
  return pixels > 4.0 ? 16 : pixels > 1.0 ? 8 : pixels > 0.25 ? 4 : 2;
}

} // namespace mote
