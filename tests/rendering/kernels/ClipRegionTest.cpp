// What of rays lies in a region that clips.

#include <kernels/core/ClipRegion.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double turn = 2.0 * std::numbers::pi;

ClipRegion regionOf(Random& random, int planes, bool hasCylinder)
{
  ClipRegion region;
  for (int k = 0; k < planes; ++k)
    region.planes.push_back(
      {random.inBox(Vec3d(-0.7), Vec3d(0.7)), random(0.1, 5.0) * random.direction()});
  if (!hasCylinder)
    return region;
  ClipCylinder& cylinder = region.cylinder.emplace();
  cylinder.center = random.inBox(Vec3d(-0.3), Vec3d(0.3));
  cylinder.axis = random(0.1, 3.0) * random.direction();
  cylinder.zeroAngle = random.direction();
  if (random(0.0, 1.0) < 0.7)
    cylinder.radius[0] = random(0.0, 0.6);
  if (random(0.0, 1.0) < 0.7)
    cylinder.radius[1] = cylinder.radius[0] + random(0.1, 1.0);
  if (random(0.0, 1.0) < 0.5)
    cylinder.height[0] = random(-1.0, 0.0);
  if (random(0.0, 1.0) < 0.5)
    cylinder.height[1] = random(0.0, 1.0);
  cylinder.angle[0] = random(-10.0, 10.0);
  cylinder.angle[1] = cylinder.angle[0] + random(0.1, 1.2) * turn;
  return region;
}

/// How far a point is within the region, by formulas of their own: below 0 outside.
double depthIn(const ClipRegion& region, const Vec3d& point)
{
  double depth = INFINITY;
  for (const ClipPlane& plane : region.planes)
    depth =
      std::min(depth, glm::dot(plane.normal, point - plane.point) / glm::length(plane.normal));
  if (!region.cylinder)
    return depth;
  const ClipCylinder& c = *region.cylinder;
  const Vec3d axis = glm::normalize(c.axis), from = point - c.center;
  const double height = glm::dot(from, axis);
  const Vec3d away = from - height * axis;
  const double radius = glm::length(away);
  depth = std::min({depth, height - c.height[0], c.height[1] - height, c.radius[1] - radius});
  if (c.radius[0] > 0.0)
    depth = std::min(depth, radius - c.radius[0]);
  const double width = c.angle[1] - c.angle[0];
  if (width >= turn)
    return depth;
  const Vec3d zero = glm::normalize(c.zeroAngle - glm::dot(c.zeroAngle, axis) * axis);
  const double angle =
    std::atan2(glm::dot(away, glm::cross(axis, zero)), glm::dot(away, zero)) - c.angle[0];
  const double on = angle - turn * std::floor(angle / turn); // from the first angle on
  const double inside = std::min(on, width - on), outside = std::min(on - width, turn - on);
  return std::min(depth, radius * (on <= width ? inside : -outside));
}

} // namespace

TEST(ClipRegion, SpansAreWhereTheRayIsInside)
{
  Random random(1);
  int inside = 0, outside = 0, many = 0;
  for (int k = 0; k < 20000; ++k)
  {
    const ClipRegion region = regionOf(random, k % 4, k % 3 != 0);
    const Vec3d origin = random.inBox(Vec3d(-2.0), Vec3d(2.0)),
                way = random(0.1, 4.0) * random.direction();
    const double tMin = random(-1.0, 0.5) / glm::length(way),
                 tMax = tMin + random(0.0, 5.0) / glm::length(way);
    RaySpan spans[ClipRegion::mostSpans];
    const int count = region.spansOf(origin, way, tMin, tMax, spans);
    many += count > 1;
    for (int s = 0; s < count; ++s)
    {
      EXPECT_LE(spans[s].tIn, spans[s].tOut);
      EXPECT_GE(spans[s].tIn, s == 0 ? tMin : spans[s - 1].tOut);
      EXPECT_LE(spans[s].tOut, tMax);
    }
    for (int i = 0; i < 10; ++i)
    {
      const double t = random(tMin, tMax);
      const Vec3d point = origin + t * way;
      const double depth = depthIn(region, point);
      if (std::abs(depth) < 1e-9)
        continue;
      bool isIn = false;
      for (int s = 0; s < count; ++s)
        isIn = isIn || (t >= spans[s].tIn && t <= spans[s].tOut);
      EXPECT_EQ(isIn, depth > 0.0) << k << " " << depth;
      EXPECT_EQ(region.contains(point), depth > 0.0);
      (isIn ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(outside, 10000);
  EXPECT_GT(many, 50);
}

TEST(ClipRegion, ToleranceMovesFacesOutwards)
{
  constexpr double tolerance = 0.05;
  Random random(3);
  int near = 0, outside = 0;
  for (int k = 0; k < 100000; ++k)
  {
    ClipRegion region = regionOf(random, k % 4, k % 3 != 0);
    region.tolerance = tolerance;
    const bool hasAngles =
      region.cylinder && region.cylinder->angle[1] - region.cylinder->angle[0] < turn;
    const Vec3d point = random.inBox(Vec3d(-2.0), Vec3d(2.0));
    const double depth = depthIn(region, point);
    if (std::abs(depth + tolerance) < 1e-9 || (hasAngles && depth < -tolerance))
      continue; // wedges grow by more at their edge
    ASSERT_EQ(region.contains(point), depth > -tolerance) << k << " " << depth;
    near += std::abs(depth) < tolerance;
    outside += depth < -tolerance;
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(outside, 10000);
}

TEST(ClipRegion, EndsOfSpansAreOnFacesThatLookOutwards)
{
  Random random(2);
  int found = 0;
  for (int k = 0; k < 5000; ++k)
  {
    const ClipRegion region = regionOf(random, k % 4, k % 3 != 0);
    const Vec3d origin = random.inBox(Vec3d(-2.0), Vec3d(2.0)), way = random.direction();
    RaySpan spans[ClipRegion::mostSpans];
    const int count = region.spansOf(origin, way, 0.0, 6.0, spans);
    for (int s = 0; s < count; ++s)
      for (const double t : {spans[s].tIn, spans[s].tOut})
      {
        if (t == 0.0 || t == 6.0)
          continue;
        const auto face = region.faceAt(origin + t * way, 1e-9);
        ASSERT_TRUE(face) << k;
        EXPECT_NEAR(glm::length(*face), 1.0, 1e-12);
        EXPECT_EQ(glm::dot(*face, way) < 0.0, t == spans[s].tIn) << k;
        ++found;
      }
  }
  EXPECT_GT(found, 500);
  ClipRegion plane;
  plane.planes.push_back({Vec3d(0.0), {0.0, 0.0, 1.0}});
  EXPECT_FALSE(plane.faceAt({0.0, 0.0, 1e-6}, 1e-9));
  EXPECT_FALSE(ClipRegion().faceAt(Vec3d(0.0), 1.0));
}

TEST(ClipRegion, RaysAlongFacesAndAxes)
{
  ClipRegion region;
  RaySpan spans[ClipRegion::mostSpans];
  EXPECT_TRUE(region.isAll());
  EXPECT_EQ(region.spansOf(Vec3d(0.0), {1.0, 0.0, 0.0}, 1.0, 2.0, spans), 1);
  EXPECT_EQ(region.spansOf(Vec3d(0.0), {1.0, 0.0, 0.0}, 2.0, 1.0, spans), 0);
  region.planes.push_back({Vec3d(0.0), {0.0, 0.0, 1.0}});
  EXPECT_EQ(region.spansOf(Vec3d(0.0), {1.0, 0.0, 0.0}, 0.0, 1.0, spans), 1) << "in the plane";
  EXPECT_EQ(region.spansOf({0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}, 0.0, 1.0, spans), 0);
  region.planes.push_back({Vec3d(-1.0), {0.0, 0.0, -1.0}});
  EXPECT_EQ(region.spansOf(Vec3d(0.0), {0.0, 0.0, 1.0}, -9.0, 9.0, spans), 0) << "empty";
  region.planes.clear();
  region.cylinder.emplace().radius[0] = 0.5;
  EXPECT_EQ(region.spansOf(Vec3d(0.0), {0.0, 0.0, 1.0}, 0.0, 9.0, spans), 0) << "in the hole";
  ASSERT_EQ(region.spansOf({-2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.0, 4.0, spans), 2);
  EXPECT_DOUBLE_EQ(spans[0].tOut, 1.5);
  EXPECT_DOUBLE_EQ(spans[1].tIn, 2.5);
  // Far from the origin the same.
  region.cylinder->center = {1e6, 1e6, 0.0};
  ASSERT_EQ(region.spansOf({1e6 - 2.0, 1e6, 0.0}, {1.0, 0.0, 0.0}, 0.0, 4.0, spans), 2);
  EXPECT_DOUBLE_EQ(spans[0].tOut, 1.5);
}
