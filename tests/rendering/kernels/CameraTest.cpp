// Rays of cameras against the projections that define them.

#include <kernels/core/Camera.h>
#include <kernels/core/Error.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

using namespace mote;
using mote::testing::Random;

namespace
{

void expectNear(const Vec3d& a, const Vec3d& b, double tolerance)
{
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(a[axis], b[axis], tolerance);
}

/// Image position of a point in pixels, by the matrices of graphics libraries.
Vec3d project(const Camera& camera, const Vec3d& point, int width, int height)
{
  const glm::dmat4 view = glm::lookAt(camera.position, camera.position + camera.forward, camera.up);
  const double aspect = camera.pixelAspect * width / height;
  const double s = camera.parallelScale;
  const bool perspective = camera.projection == Camera::Projection::Perspective;
  const glm::dmat4 projection =
    perspective ? glm::perspective(camera.viewAngle * M_PI / 180.0, aspect, 0.1, 1000.0)
                : glm::ortho(-s * aspect, s * aspect, -s, s, 0.1, 1000.0);
  const glm::dvec4 eye = view * glm::dvec4(point, 1.0);
  const glm::dvec4 clip = projection * eye;
  // A window centre moves the centre of the image by as many half widths and half heights.
  const double x = clip.x / clip.w - camera.centerX, y = clip.y / clip.w - camera.centerY;
  return {0.5 * (x + 1.0) * width, 0.5 * (y + 1.0) * height, -eye.z};
}

} // namespace

TEST(Camera, RaysGoThroughThePointsThatProjectToTheirPixels)
{
  Random random(3);
  for (int k = 0; k < 500; ++k)
  {
    Camera camera;
    camera.projection =
      k % 2 == 0 ? Camera::Projection::Perspective : Camera::Projection::Orthographic;
    camera.position = random.inBox(Vec3d(-9.0), Vec3d(9.0));
    camera.forward = random(0.1, 10.0) * random.direction();
    camera.up = random(0.1, 10.0) * random.direction();
    camera.viewAngle = random(1.0, 160.0);
    camera.parallelScale = random(0.1, 10.0);
    camera.pixelAspect = random(0.5, 2.0);
    camera.centerX = random(-1.0, 1.0);
    camera.centerY = random(-1.0, 1.0);
    const int width = 1 + static_cast<int>(random(0.0, 100.0));
    const int height = 1 + static_cast<int>(random(0.0, 100.0));
    const CameraRays rays(camera, width, height);
    const double x = random(0.0, width), y = random(0.0, height), t = random(1.0, 20.0);
    const Vec3d point = rays.originAt(x, y) + t * rays.directionAt(x, y);
    // t is the distance along the view axis.
    expectNear(project(camera, point, width, height), {x, y, t}, 1e-9);
  }
}

TEST(Camera, TransformedRaysMeetTransformedPointsAtTheSameT)
{
  const Camera camera = mote::testing::lookAt({3.0, 1.0, 2.0}, {0.0, 0.0, 0.0});
  glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(5.0, -2.0, 1.0));
  matrix =
    glm::scale(glm::rotate(matrix, 1.1, glm::dvec3(1.0, 2.0, 3.0)), glm::dvec3(2.0, 1.0, 0.5));
  const CameraRays rays(camera, 64, 48), local = rays.transformed(matrix);
  const Vec3d point = rays.originAt(10.5, 20.5) + 3.25 * rays.directionAt(10.5, 20.5);
  expectNear(transformPoint(matrix, point),
    local.originAt(10.5, 20.5) + 3.25 * local.directionAt(10.5, 20.5), 1e-12);
  EXPECT_EQ(local.tMin, rays.tMin);
  EXPECT_EQ(local.tMax, rays.tMax);
}

TEST(Camera, BundlesHoldTheRaysOfTheirPixels)
{
  for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic})
    for (const int side : {2, 4, 8, 16})
    {
      Camera camera = mote::testing::lookAt({3.0, 1.0, 2.0}, {0.0, 0.0, 0.0}, 70.0);
      camera.projection = projection;
      camera.nearDistance = 0.25;
      camera.farDistance = 40.0;
      const CameraRays rays(camera, 64, 48);
      RayBundle bundle;
      rays.fillBundle(bundle, side, 16, 32, 0.25, -0.125);
      ASSERT_EQ(bundle.count, side * side);
      EXPECT_EQ(bundle.side, side);
      EXPECT_EQ(bundle.tMin, 0.25);
      std::set<std::pair<int, int>> seen;
      for (int i = 0; i < bundle.count; ++i)
      {
        int dx = 0, dy = 0;
        bundleOffset(side, i, dx, dy);
        seen.insert({dx, dy});
        const double x = 16 + dx + 0.75, y = 32 + dy + 0.375;
        const reference::Ray ray = mote::testing::rayOf(bundle, i);
        expectNear(ray.origin, rays.originAt(x, y), 1e-14);
        expectNear(ray.direction, rays.directionAt(x, y), 1e-14);
        EXPECT_EQ(bundle.t[i], 40.0);
        EXPECT_EQ(bundle.slot[i], RayBundle::noHit);
        EXPECT_EQ(bundle.object[i], -1);
      }
      EXPECT_EQ(seen.size(), static_cast<std::size_t>(side * side));
    }
}

TEST(Camera, AlignedRunsOfABundleAreCompact)
{
  for (const int run : {4, 8, 16, 64, 256})
    for (int first = 0; first < 256; first += run)
    {
      int left = 16, right = 0, bottom = 16, top = 0;
      for (int i = first; i < first + run; ++i)
      {
        int x = 0, y = 0;
        bundleOffset(16, i, x, y);
        left = std::min(left, x), right = std::max(right, x);
        bottom = std::min(bottom, y), top = std::max(top, y);
      }
      EXPECT_EQ((right - left + 1) * (top - bottom + 1), run);
    }
}

TEST(Camera, RefusesWhatIsNotACamera)
{
  Camera camera;
  EXPECT_THROW(CameraRays(camera, 0, 5), Error);
  EXPECT_THROW(CameraRays(camera, 5, -1), Error);
  camera.forward = Vec3d(0.0);
  EXPECT_THROW(CameraRays(camera, 5, 5), Error);
  camera = Camera();
  camera.up = camera.forward;
  EXPECT_THROW(CameraRays(camera, 5, 5), Error);
  for (const double angle : {0.0, 180.0, -3.0, std::nan("")})
  {
    camera = Camera();
    camera.viewAngle = angle;
    EXPECT_THROW(CameraRays(camera, 5, 5), Error) << angle;
  }
  camera = Camera();
  camera.viewAngle = 0.0; // says nothing in an orthographic view
  camera.projection = Camera::Projection::Orthographic;
  EXPECT_NO_THROW(CameraRays(camera, 5, 5));
}
