#include "Camera.h"

#include "Error.h"

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

} // namespace mote
