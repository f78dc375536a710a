#include "Camera.h"

#include "Error.h"

#include <array>
#include <cmath>

namespace mote
{

CameraRays::CameraRays(const Camera& camera, int width, int height)
  : tMin(camera.nearDistance), tMax(camera.farDistance)
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
  const Vec3d corner = right * (halfWidth * (camera.centerX - 1.0)) +
                       up * (halfHeight * (camera.centerY - 1.0));
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

struct BlockOffsets
{
  std::array<double, RayPacket::capacity> x, y;
  BlockOffsets()
  {
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      int column = 0, row = 0;
      packetOffset(i, column, row);
      x[i] = column + 0.5;
      y[i] = row + 0.5;
    }
  }
};

} // namespace

void CameraRays::fillBlock(
  RayPacket& packet, int x0, int y0, double jitterX, double jitterY) const
{
  static const BlockOffsets offsets;
  const double x = x0 + jitterX, y = y0 + jitterY;
  const Vec3d o = originAt(x, y), d = directionAt(x, y);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      packet.origin[axis][i] = o[axis] + offsets.x[i] * ox[axis] + offsets.y[i] * oy[axis];
      packet.direction[axis][i] = d[axis] + offsets.x[i] * dx[axis] + offsets.y[i] * dy[axis];
    }
  }
  for (int i = 0; i < RayPacket::capacity; ++i)
  {
    packet.tMin[i] = tMin;
    packet.t[i] = tMax;
    packet.slot[i] = RayPacket::noHit;
    packet.object[i] = -1;
  }
  packet.count = RayPacket::capacity;
}

} // namespace mote
