// What comes in at the door of a triangle mesh.

#include <support/Triangles.h>

#include <kernels/core/Error.h>
#include <kernels/meshes/GeneratedMeshes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// The message of what is thrown, or nothing.
template <typename Make>
std::string complaintOf(const Make& make)
{
  try
  {
    make();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(TriangleMesh, KeepsPointsWithinTheUnitWhateverTheModelIsMeasuredIn)
{
  for (const double size : {1e-100, 1e-9, 1.0, 1e9, 1e100})
    for (const double away : {0.0, 1e6})
    {
      Triangles sphere = bumpySphere(8);
      const Vec3d middle = away * size * Vec3d(1.0, -2.0, 3.0);
      sphere.move([&](const Vec3d& p) { return middle + size * p; });
      const TriangleMesh mesh = sphere.mesh();
      EXPECT_EQ(mesh.validCount(), sphere.size());
      EXPECT_EQ(std::exp2(std::round(std::log2(mesh.unit()))), mesh.unit());
      float most = 0.0f;
      for (std::size_t i = 0; i < mesh.pointCount(); ++i)
      {
        const Vec3f p = glm::abs(mesh.points()[i]);
        most = std::max({most, p.x, p.y, p.z});
        EXPECT_LE(
          glm::length(mesh.point(i) - sphere.point(i)), 1e-7 * size + 4e-16 * glm::length(middle));
      }
      EXPECT_LE(most, 1.0f);
      EXPECT_GT(most, 0.25f);
    }
}

TEST(TriangleMesh, TakesAnyTypes)
{
  const std::int16_t points[] = {0, 0, 0, 4, 0, 0, 0, 2, 0, 9, 9, 9};
  const std::uint8_t bytes[] = {0, 1, 2};
  const std::int64_t longs[] = {0, 1, 2};
  for (const ArrayView& triangles : {ArrayView(bytes, ArrayView::Type::UInt8, 1, 3),
         ArrayView(longs, ArrayView::Type::Int64, 1, 3)})
  {
    const TriangleMesh mesh(ArrayView(points, ArrayView::Type::Int16, 4, 3), triangles);
    EXPECT_EQ(mesh.size(), 1u);
    // A point that no triangle has counts for nothing.
    EXPECT_EQ(mesh.origin(), Vec3d(2.0, 1.0, 0.0));
    EXPECT_EQ(mesh.point(1), Vec3d(4.0, 0.0, 0.0));
  }
}

TEST(TriangleMesh, CountsTrianglesThatAreNotFinite)
{
  Triangles all;
  all.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  all.add({0, 0, 1}, {1, notANumber, 0}, {0, 1, 0});
  all.add({0, 0, 1}, {1, 0, 0}, {std::numeric_limits<double>::infinity(), 1, 0});
  all.add({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
  const TriangleMesh mesh = all.mesh();
  EXPECT_EQ(mesh.size(), 4u);
  EXPECT_EQ(mesh.validCount(), 2u);
  EXPECT_TRUE(mesh.isValid(0));
  EXPECT_FALSE(mesh.isValid(1));
  EXPECT_FALSE(mesh.isValid(2));
  EXPECT_TRUE(mesh.isValid(3));
  EXPECT_EQ(mesh.origin(), Vec3d(0.5));
}

TEST(TriangleMesh, SaysWhatIsWrongWithArrays)
{
  const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const ArrayView three(points, 3, 3);
  const std::int32_t corners[] = {0, 1, 2, 0, 1, 3, -1, 1, 2};
  const auto said = [&](const ArrayView& p, const ArrayView& t)
  { return complaintOf([&] { TriangleMesh(p, t); }); };
  using Type = ArrayView::Type;
  EXPECT_EQ(said(three, ArrayView(corners, Type::Int32, 1, 3)), "");
  EXPECT_EQ(said(three, ArrayView(corners, Type::Int32, 3, 3)),
    "Triangle 1 has the corners 0, 1, 3, but the mesh has 3 points.");
  EXPECT_EQ(said(three, ArrayView(corners + 6, Type::Int32, 1, 3)),
    "Triangle 0 has the corners -1, 1, 2, but the mesh has 3 points.");
  EXPECT_NE(said(ArrayView(), ArrayView(corners, Type::Int32, 1, 3)), "");
  EXPECT_NE(said(ArrayView(points, 4, 2), ArrayView(corners, Type::Int32, 1, 3)), "");
  EXPECT_NE(said(three, ArrayView(corners, Type::Int32, 1, 2)), "");
  EXPECT_NE(said(three, ArrayView(points, 1, 3)), "");
  EXPECT_EQ(said(ArrayView(), ArrayView()), "");
}

TEST(TriangleMesh, MovesPointsOfTheSameTriangles)
{
  Triangles sphere = bumpySphere(6);
  TriangleMesh mesh = sphere.mesh();
  sphere.move([](const Vec3d& p) { return 3.0 * p + Vec3d(7.0, 0.0, 0.0); });
  mesh.movePoints(sphere.pointView());
  for (std::size_t i = 0; i < mesh.pointCount(); ++i)
    EXPECT_LT(glm::length(mesh.point(i) - sphere.point(i)), 1e-6);
  sphere.addPoint(Vec3d(0.0));
  EXPECT_NE(complaintOf([&] { mesh.movePoints(sphere.pointView()); }), "");
}

TEST(GeneratedMeshes, CountsAreWholeNumbersWithinLimits)
{
  for (const std::size_t count : {leastGenerated, leastGenerated + 1, mostGenerated})
    EXPECT_EQ(triangleCountIn(std::to_string(count)), count);
  for (const std::string& text : {std::string(), std::string("100x"), std::string("x"),
         std::string(" 100"), std::string("-100"), std::string("99999999999999999999999999"),
         std::to_string(leastGenerated - 1), std::to_string(mostGenerated + 1)})
    EXPECT_THROW(triangleCountIn(text), Error) << text;
}

TEST(GeneratedMeshes, OfSpheresAreClosedAndHaveTheVolumeOfOne)
{
  const GeneratedMesh mesh = displacedSphere(20000);
  EXPECT_GT(mesh.triangles.size(), 19000u);
  EXPECT_LE(mesh.triangles.size(), 20000u);
  double volume = 0.0, area = 0.0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& corners : mesh.triangles)
  {
    const Vec3d a(mesh.points[corners[0]]), b(mesh.points[corners[1]]), c(mesh.points[corners[2]]);
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
    for (std::size_t k = 0; k < 3; ++k)
      ++sides[{corners[k], corners[(k + 1) % 3]}];
  }
  // Of the waves, a twentieth of the radius high, the first order cancels.
  EXPECT_NEAR(volume, 4.0 / 3.0 * M_PI, 0.02);
  EXPECT_GT(area, 4.0 * M_PI);
  EXPECT_LT(area, 4.0 * M_PI * 1.2);
  // Every side has one triangle on its left and one on its right, but at the poles, whose points
  // are as many as there are columns.
  std::size_t open = 0;
  for (const auto& [side, count] : sides)
  {
    EXPECT_EQ(count, 1);
    open += sides.find({side.second, side.first}) == sides.end();
  }
  EXPECT_LT(open, 2 * 2 * 75u);
}
