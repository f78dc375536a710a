// Colours of points of meshes: mixed where a ray hits, values before they are looked up.

#include "MeshParts.h"
#include "ShadowParts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace mote;
using namespace mote::testing;

namespace
{

const Camera above = lookAt({0.0, 0.0, 9.0}, Vec3d(0.0), 20.0);

/// A bumpy sphere whose points have values.
struct ColoredMesh
{
  Triangles triangles = bumpySphere(7);
  std::shared_ptr<TriangleMesh> mesh = std::make_shared<TriangleMesh>(triangles.mesh());
  std::vector<double> values;
  std::vector<std::uint8_t> bytes;
  Scene scene;

  explicit ColoredMesh(const std::function<double(const Vec3d&)>& valueAt)
  {
    for (std::size_t i = 0; i < triangles.pointCount(); ++i)
      values.push_back(valueAt(triangles.point(i)));
    const auto tree = std::make_shared<RlodTree>();
    tree->build(*mesh);
    MeshLook look;
    look.corners = mesh->corners();
    look.mixesColors = true;
    SurfaceObject object;
    object.surface = MeshSurface(tree, look);
    object.coloring.values = ArrayView(values.data(), values.size(), 1);
    object.coloring.map.table = {Vec4f(0.0f, 0.0f, 0.0f, 1.0f), Vec4f(1.0f)};
    object.material.ambient = 1.0f; // the colour itself
    object.material.diffuse = 0.0f;
    addTo(scene, object);
    scene.lights.clear();
  }
  ColoredMesh(const ColoredMesh&) = delete;
  ColoredMesh& operator=(const ColoredMesh&) = delete;
  SurfaceObject& object() { return scene.surfaces[0]; }

  /// Calls visit(hit, colour) for the pixels that hit something; returns their number.
  int forPixels(const std::function<void(const ScenePick&, const float*)>& visit) const
  {
    constexpr int size = 64;
    const Film film = tracedFilm(scene, above, size);
    const CameraRays rays(above, size, size);
    int count = 0;
    for (int i = 0; i < size * size; ++i)
    {
      const double x = i % size + 0.5, y = i / size + 0.5;
      const auto hit = pick(scene, rays.originAt(x, y), rays.directionAt(x, y));
      EXPECT_EQ(film.object()[i], hit ? 0 : -1);
      if (!hit)
        continue;
      ++count;
      visit(*hit, film.color() + 4 * i);
    }
    return count;
  }
};

double linear(const Vec3d& p)
{
  return 0.5 + 0.3 * p.x - 0.1 * p.y + 0.05 * p.z;
}

} // namespace

TEST(MeshColors, LinearValuesOfPointsAreThoseOfThePlaceThatIsHit)
{
  ColoredMesh colored(linear);
  const auto check = [](const ScenePick& hit, const float* color)
  { EXPECT_NEAR(color[0], linear(hit.position), 2e-6); };
  EXPECT_GT(colored.forPixels(check), 1000);
  colored.object().toWorld = Mat4d(0.5); // where it is placed does not matter
  colored.object().toWorld[3] = {0.2, 0.1, 0.0, 1.0};
  const auto checkPlaced = [](const ScenePick& hit, const float* color)
  { EXPECT_NEAR(color[0], linear(2.0 * (hit.position - Vec3d(0.2, 0.1, 0.0))), 2e-6); };
  EXPECT_GT(colored.forPixels(checkPlaced), 300);
}

TEST(MeshColors, ValuesAreMixedBeforeTheyAreLookedUp)
{
  // Two colours with a step between them: no pixel has a third.
  ColoredMesh colored(linear);
  colored.object().coloring.map.table = {{1.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f, 1.0f}};
  colored.object().coloring.map.interpolation = ColorMap::Interpolation::Nearest;
  int blue = 0;
  const int count = colored.forPixels(
    [&](const ScenePick& hit, const float* color)
    {
      const double value = linear(hit.position);
      if (std::abs(value - 0.5) < 1e-6)
        return;
      blue += value > 0.5;
      EXPECT_EQ(color[0], value > 0.5 ? 0.0f : 1.0f);
      EXPECT_EQ(color[2], value > 0.5 ? 1.0f : 0.0f);
    });
  EXPECT_GT(blue, count / 4);
  EXPECT_LT(blue, 3 * count / 4);
}

TEST(MeshColors, MagnitudesAreMixedAndNotVectors)
{
  ColoredMesh colored(linear);
  std::vector<float> vectors; // opposite directions: as vectors they would mix to nothing
  for (std::size_t i = 0; i < colored.values.size(); ++i)
    vectors.insert(vectors.end(), {0.0f, (i % 2 == 0 ? 1.0f : -1.0f), 0.0f});
  colored.object().coloring.values = ArrayView(vectors.data(), colored.values.size(), 3);
  colored.object().coloring.component = ArrayView::magnitude;
  colored.forPixels(
    [](const ScenePick&, const float* color) { EXPECT_NEAR(color[0], 1.0f, 1e-6); });
}

TEST(MeshColors, DirectColoursAreMixedThemselves)
{
  ColoredMesh colored(linear);
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < colored.values.size(); ++i)
    for (const double channel : {colored.values[i], 1.0 - colored.values[i], 0.25})
      bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0 * channel)));
  colored.object().coloring.direct =
    ArrayView(bytes.data(), ArrayView::Type::UInt8, colored.values.size(), 3);
  const auto check = [](const ScenePick& hit, const float* color)
  {
    EXPECT_NEAR(color[0], linear(hit.position), 0.0021); // bytes are rounded
    EXPECT_NEAR(color[1], 1.0 - linear(hit.position), 0.0021);
    EXPECT_NEAR(color[2], 64.0 / 255.0, 1e-6);
  };
  EXPECT_GT(colored.forPixels(check), 1000);
}

TEST(MeshColors, OnlyTrianglesAtANanHaveItsColour)
{
  ColoredMesh colored(linear);
  std::uint64_t spoilt = 0; // the point nearest to the eye
  for (std::size_t i = 0; i < colored.values.size(); ++i)
    if (colored.triangles.point(i).z > colored.triangles.point(spoilt).z)
      spoilt = i;
  colored.values[spoilt] = NAN;
  colored.object().coloring.map.nan = {0.0f, 1.0f, 0.0f, 1.0f};
  int green = 0;
  colored.forPixels(
    [&](const ScenePick& hit, const float* color)
    {
      const auto& corners = colored.mesh->triangles()[hit.id];
      const bool isSpoilt = std::count(corners.begin(), corners.end(), spoilt) > 0;
      green += isSpoilt;
      EXPECT_NEAR(color[1], isSpoilt ? 1.0 : linear(hit.position), 2e-6);
    });
  EXPECT_GT(green, 20);
}

TEST(MeshColors, PathsMeetTheSameColours)
{
  // A wall of two colours beside a white floor: light that comes by it has the colour of the part
  // that is near.
  Triangles room;
  for (const double y : {-4.0, 0.0})
  {
    room.add({0, y, 0}, {4, y, 0}, {4, y + 4.0, 0});
    room.add({0, y, 0}, {4, y + 4.0, 0}, {0, y + 4.0, 0});
    room.add({0, y, 0}, {0, y + 4.0, 0}, {0, y + 4.0, 4});
    room.add({0, y, 0}, {0, y + 4.0, 4}, {0, y, 4});
  }
  const auto mesh = std::make_shared<TriangleMesh>(room.mesh());
  const auto tree = std::make_shared<RlodTree>();
  tree->build(*mesh);
  Scene scene;
  SurfaceObject object;
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < room.pointCount(); ++i)
  {
    const bool wall = i % 12 >= 6, far = i >= 12;
    for (const int channel : {wall && far ? 0 : 255, wall ? 0 : 255, wall && !far ? 0 : 255})
      bytes.push_back(static_cast<std::uint8_t>(channel));
  }
  MeshLook look;
  look.corners = mesh->corners();
  look.mixesColors = true;
  object.surface = MeshSurface(tree, look);
  object.coloring.direct = ArrayView(bytes.data(), ArrayView::Type::UInt8, room.pointCount(), 3);
  object.material.diffuse = 1.0f;
  addTo(scene, object);
  scene.lights.clear();
  scene.paths.bounces = 2;
  for (const double y : {-2.0, 2.0})
  {
    const Camera dot = lookAt({0.5, y, 3.0}, {0.5, y, 0.0}, 1e-3);
    const Film film = tracedFilm(scene, dot, 1, 1, {256});
    const float* color = film.color();
    // What reaches the floor by the wall: nearly half of the light there.
    EXPECT_GT(std::abs(color[0] - color[2]), 0.15f);
    EXPECT_EQ(color[0] > color[2], y < 0.0);
    EXPECT_LT(color[1], std::max(color[0], color[2]));
  }
}

TEST(MeshColors, WhatIsClearBetweenPointsIsNotMet)
{
  const auto valueAt = [](const Vec3d& p) { return 0.5 + 0.3 * p.x - 0.2 * p.z; };
  ColoredMesh colored(valueAt);
  ColorMap& map = colored.object().coloring.map;
  map.table = {{1.0f, 0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f, 1.0f}};
  map.interpolation = ColorMap::Interpolation::Nearest;
  int met = 0, behind = 0;
  for (int i = 0; i < 400; ++i)
  {
    const Vec3d from(0.08 * (i % 20) - 0.76, 0.08 * (i / 20) - 0.76, 5.0);
    const auto hit = pick(colored.scene, from, {0.0, 0.0, -1.0});
    if (!hit)
      continue;
    ++met;
    behind += hit->position.z < 0.0;
    EXPECT_GT(valueAt(hit->position), 0.5 - 1e-6);
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(behind, 5); // seen through what is clear
}

TEST(MeshColors, PicksTellWhatTheColourIsMixedFrom)
{
  ColoredMesh colored(linear);
  const int count = colored.forPixels(
    [&](const ScenePick& hit, const float*)
    {
      Vec3d place(0.0);
      double sum = 0.0, most = 0.0;
      for (const auto& [point, share] : hit.colorShares)
      {
        EXPECT_GE(share, 0.0);
        sum += share;
        place += share * colored.triangles.point(point);
        most = std::max(most, share);
      }
      EXPECT_NEAR(sum, 1.0, 1e-12);
      EXPECT_LT(glm::distance(place, hit.position), 2e-6);
      const bool isOne = std::any_of(hit.colorShares.begin(), hit.colorShares.end(),
        [&](const auto& one) { return one.first == hit.colorIndex && one.second == most; });
      EXPECT_TRUE(isOne);
    });
  EXPECT_GT(count, 1000);
}

TEST(MeshColors, CellsHaveOneColourEach)
{
  ColoredMesh colored(linear);
  std::vector<double> values;
  for (std::size_t t = 0; t < colored.triangles.size(); ++t)
    values.push_back(double(t % 7) / 7.0);
  colored.object().coloring.values = ArrayView(values.data(), values.size(), 1);
  const auto tree = std::make_shared<RlodTree>();
  tree->build(*colored.mesh);
  colored.object().surface = MeshSurface(tree);
  colored.forPixels(
    [&](const ScenePick& hit, const float* color)
    {
      EXPECT_NEAR(color[0], values[hit.id], 1e-6);
      EXPECT_EQ(hit.colorShares[0], std::pair(hit.id, 1.0));
      EXPECT_EQ(hit.colorShares[1].second, 0.0);
    });
}
