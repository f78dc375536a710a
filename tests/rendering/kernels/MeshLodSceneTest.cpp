// R-LODs in scenes: rays that leave them, and their colours.

#include "MeshParts.h"
#include "ShadowParts.h"

#include <kernels/scene/ColorMeans.h>
#include <kernels/tracing/detail/SceneRays.h>
#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

using namespace mote;
using namespace mote::testing;

namespace
{

const Camera fromAbove = lookAt({2.0, 3.0, 9.0}, Vec3d(0.0), 15.0);
constexpr int size = 96;
constexpr double pixels = 6.0; ///< of error

/// A bumpy sphere of many triangles, with R-LODs.
struct LodMesh
{
  Triangles triangles;
  std::shared_ptr<TriangleMesh> mesh = std::make_shared<TriangleMesh>(triangles.mesh());
  std::shared_ptr<RlodTree> tree = std::make_shared<RlodTree>();
  Scene scene;
  Camera camera = fromAbove;

  explicit LodMesh(Triangles of = bumpySphere(250))
    : triangles(std::move(of))
  {
    tree->build(*mesh);
    tree->makeLods();
    tree->setSparesMemory(true);
    SurfaceObject object;
    object.surface = MeshSurface(tree);
    addTo(scene, object);
  }
  LodMesh(const LodMesh&) = delete;
  LodMesh& operator=(const LodMesh&) = delete;
  SurfaceObject& object() { return scene.surfaces[0]; }
  Film traced(double poe)
  {
    MeshLook look;
    look.poe = poe;
    object().surface = MeshSurface(tree, look);
    return tracedFilm(scene, camera, size);
  }
};

/// How the pictures of a scene with R-LODs and without differ.
struct Comparison
{
  int pixels = 0;                  ///< that both hit
  double exact = 0.0, rough = 0.0; ///< mean red
  int darkened = 0; ///< from more than half of the greatest red to less than an eighth of it
};

Comparison comparisonOf(LodMesh& lods)
{
  const Film exact = lods.traced(0.0), rough = lods.traced(pixels);
  Comparison found;
  float most = 0.0f;
  for (int i = 0; i < size * size; ++i)
    most = std::max(most, exact.color()[4 * i]);
  for (int i = 0; i < size * size; ++i)
  {
    if (exact.object()[i] != 0 || rough.object()[i] != 0)
      continue;
    ++found.pixels;
    const float before = exact.color()[4 * i], after = rough.color()[4 * i];
    found.exact += before;
    found.rough += after;
    found.darkened += before > 0.5f * most && after < 0.125f * most;
  }
  found.exact /= found.pixels;
  found.rough /= found.pixels;
  return found;
}

} // namespace

TEST(MeshLodScene, ManyPixelsShowOneOfFewPlanes)
{
  LodMesh lods;
  const Film exact = lods.traced(0.0), rough = lods.traced(pixels);
  std::vector<std::uint64_t> seen, seenRough;
  for (int i = 0; i < size * size; ++i)
  {
    if (exact.object()[i] == 0)
    {
      seen.push_back(exact.id()[i]);
      EXPECT_EQ(rough.object()[i], 0) << "a hole at " << i;
    }
    if (rough.object()[i] == 0)
      seenRough.push_back(rough.id()[i]);
  }
  const auto countOf = [](std::vector<std::uint64_t>& ids)
  {
    std::sort(ids.begin(), ids.end());
    return std::unique(ids.begin(), ids.end()) - ids.begin();
  };
  EXPECT_LT(countOf(seenRough), countOf(seen) / 2);
}

TEST(MeshLodScene, RoughGroundSeenAtGrazingAnglesIsAsBrightAsItsTriangles)
{
  // A light at the eye: planes alone are as dark as their cosine, a sixth and less.
  Triangles ground;
  std::mt19937 random(7);
  std::normal_distribution<double> height(0.0, 0.0012);
  constexpr int side = 400;
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i)
      ground.addPoint({0.005 * i - 1.0, 0.005 * j - 1.0, height(random)});
  addGrid(ground, side);
  LodMesh lods(std::move(ground));
  lods.object().material.ambient = 0.0f;
  for (const double rise : {0.4, 1.0, 4.0})
  {
    SCOPED_TRACE(rise);
    const Vec3d eye(2.0, -6.0, rise);
    lods.camera = lookAt(eye, Vec3d(0.0), 15.0);
    lods.scene.lights = {shadowLight(Light::Kind::Directional, -glm::normalize(eye))};
    lods.scene.lights[0].shadows = false;
    const Comparison found = comparisonOf(lods);
    EXPECT_GT(found.pixels, 300);
    EXPECT_NEAR(found.rough / found.exact, 0.9, 0.15); // planes know not what hides what
  }
}

namespace
{

/// The same mesh, each triangle the other way round.
Triangles turned(Triangles of)
{
  for (std::size_t k = 0; k < of.corners.size(); k += 3)
    std::swap(of.corners[k + 1], of.corners[k + 2]);
  return of;
}

void expectNoDarkRim(Triangles triangles)
{
  LodMesh lods(std::move(triangles));
  lods.object().material.ambient = 0.0f;
  lods.scene.lights = {shadowLight(Light::Kind::Directional, {0.8, -0.3, -0.6})};
  lods.scene.lights[0].shadows = false;
  const Film exact = lods.traced(0.0), rough = lods.traced(pixels);
  int rim = 0, dark = 0;
  for (int y = 1; y + 1 < size; ++y)
    for (int x = 1; x + 1 < size; ++x)
    {
      const int i = y * size + x;
      if (rough.object()[i] != 0 || exact.object()[i] == 0)
        continue;
      float most = 0.0f; // beside it
      for (const int next : {i - 1, i + 1, i - size, i + size})
        if (exact.object()[next] == 0)
          most = std::max(most, exact.color()[4 * next]);
      rim += most > 0.3f;
      dark += most > 0.3f && rough.color()[4 * i] < 0.4f * most;
    }
  EXPECT_GT(rim, 10);
  EXPECT_LT(dark, rim / 8);
}

} // namespace

TEST(MeshLodScene, OutlinesHaveNoDarkRim)
{
  expectNoDarkRim(bumpySphere(250));
  expectNoDarkRim(turned(bumpySphere(250))); // triangles may look inwards
}

TEST(MeshLodScene, NoPlaneIsInItsOwnShadow)
{
  LodMesh lods;
  for (const auto kind : {Light::Kind::Directional, Light::Kind::Point})
    for (const Vec3d towards : {Vec3d(1.0, 1.0, 4.0), Vec3d(4.0, 1.0, 1.0), Vec3d(-3.0, 4.0, 3.0)})
    {
      lods.scene.lights = {
        shadowLight(kind, kind == Light::Kind::Point ? towards : -glm::normalize(towards))};
      lods.object().material.ambient = 0.0f;
      const Comparison found = comparisonOf(lods);
      EXPECT_GT(found.pixels, 1500);
      EXPECT_NEAR(found.rough, found.exact, 0.02);
      EXPECT_LT(found.darkened, found.pixels / 100);
    }
}

TEST(MeshLodScene, RaysLeaveTheirPlaneWhereverTheyStandInAPacket)
{
  LodMesh mesh;
  MeshLook look;
  look.poe = pixels;
  const MeshSurface surface(mesh.tree, look);
  mesh.object().surface = surface;
  const SceneRays rays(mesh.scene, Vec3d(0.0));
  const CameraRays camera(mesh.camera, size, size);
  int inTheirOwnWay = 0;
  for (int y = 0; y < size; y += 16)
    for (int x = 0; x < size; x += 16)
    {
      RayBundle bundle;
      camera.fillBundle(bundle, 16, x, y, 0.0, 0.0);
      surface.cast(bundle, 0);
      for (int i = 0; i < bundle.count; i += 3)
      {
        if (bundle.object[i] != 0 || !RlodTree::isLod(bundle.slot[i]))
          continue;
        const Vec3d at = bundle.originOf(i) + bundle.t[i] * bundle.directionOf(i);
        const Vec3d normal = glm::normalize(surface.normalAt(bundle.slot[i], at));
        const Vec3d ray = glm::normalize(bundle.directionOf(i)), along = glm::cross(normal, ray);
        const Vec3d way = glm::normalize(0.3 * glm::faceforward(normal, ray, normal) + along);
        RayPacket packet = emptyPacket();
        packet.footprint = bundle.footprint + bundle.t[i] * bundle.footprintPerT;
        Departures from;
        for (int k = 0; k < RayPacket::capacity; ++k)
        {
          addRay(packet, at, way, 0.0, 100.0);
          rays.leave(packet, k, from, 0, bundle.slot[i], std::abs(glm::dot(normal, way)));
        }
        RayPacket careless = packet;
        rays.occlude(packet, &from);
        rays.occlude(careless);
        for (int k = 0; k < packet.count; ++k)
          ASSERT_EQ(packet.t[k], packet.t[1]);
        inTheirOwnWay += careless.t[0] < 0.0 && packet.t[0] > 0.0;
      }
    }
  EXPECT_GT(inTheirOwnWay, 10);
}

TEST(MeshLodScene, NoPlaneHidesTheSkyFromItself)
{
  LodMesh lods;
  lods.scene.lights.clear();
  lods.scene.occlusion = {64, 0.05};
  lods.object().material.ambient = 1.0f;
  const Comparison found = comparisonOf(lods);
  EXPECT_GT(found.pixels, 1500);
  EXPECT_NEAR(found.rough, found.exact, 0.015);
  EXPECT_EQ(found.darkened, 0);
}

TEST(MeshLodScene, PathsLeaveThePlanesThatTheyBeginAt)
{
  LodMesh lods;
  lods.scene.lights = {shadowLight(Light::Kind::Directional, {-0.3, -0.3, -0.9})};
  lods.scene.paths.bounces = 2;
  const Comparison found = comparisonOf(lods);
  EXPECT_GT(found.pixels, 1500);
  EXPECT_NEAR(found.rough / found.exact, 1.0, 0.03);
}

namespace
{

/// Pixels on an object that differ from the exact picture by more than a tenth, and those of them
/// that are like nothing in the exact picture within `reach` pixels.
struct MovedPixels
{
  int moved = 0, lost = 0;
};

MovedPixels movedPixels(const Film& exact, const Film& rough, std::int32_t object, int reach)
{
  const auto red = [](const Film& film, int x, int y) { return film.color()[4 * (y * size + x)]; };
  MovedPixels found;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
    {
      if (exact.object()[y * size + x] != object || rough.object()[y * size + x] != object)
        continue;
      const float after = red(rough, x, y);
      if (std::abs(after - red(exact, x, y)) < 0.1f)
        continue;
      ++found.moved;
      bool isNear = false;
      for (int v = std::max(0, y - reach); v <= std::min(size - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(size - 1, x + reach); ++u)
          isNear = isNear || std::abs(red(exact, u, v) - after) < 0.05f;
      found.lost += !isNear;
    }
  return found;
}

/// Puts the mesh over a floor of two triangles, which has no R-LODs.
void addFloor(LodMesh& lods)
{
  Triangles floor;
  for (const double y : {-4.0, 4.0})
    for (const double x : {-4.0, 4.0})
      floor.addPoint({x, y, -1.2});
  floor.add(0, 1, 3);
  floor.add(0, 3, 2);
  addTo(lods.scene, objectOf(floor));
  lods.camera = lookAt({2.0, 5.0, 7.0}, {0.0, 0.0, -0.6}, 32.0);
}

} // namespace

TEST(MeshLodScene, ShadowsOfPlanesFallWhereThoseOfTheirTrianglesDo)
{
  LodMesh lods;
  addFloor(lods);
  for (SurfaceObject& object : lods.scene.surfaces)
    object.material.ambient = 0.0f;
  int moved = 0;
  for (const auto kind : {Light::Kind::Directional, Light::Kind::Point})
  {
    const Vec3d towards(-2.0, 1.0, 5.0);
    lods.scene.lights = {
      shadowLight(kind, kind == Light::Kind::Point ? towards : -glm::normalize(towards))};
    const MovedPixels found = movedPixels(lods.traced(0.0), lods.traced(pixels), 1, int(pixels));
    moved += found.moved;
    EXPECT_EQ(found.lost, 0);
    EXPECT_LT(found.moved, 120); // along the outline of the shadow
  }
  EXPECT_GT(moved, 0) << "were planes taken at all?";
}

TEST(MeshLodScene, MirrorsShowPlanes)
{
  LodMesh lods;
  addFloor(lods);
  lods.scene.surfaces[1].material.metallic = 1.0f;
  lods.scene.surfaces[1].material.roughness = 0.0f;
  lods.scene.surfaces[0].material.ambient = 1.0f; // it shines by itself
  lods.scene.surfaces[0].material.diffuse = 0.0f;
  lods.scene.lights.clear();
  lods.scene.sky = {Vec3f(0.0f), Vec3f(0.0f)};
  lods.scene.paths.bounces = 1;
  const MovedPixels found = movedPixels(lods.traced(0.0), lods.traced(pixels), 1, 2 * int(pixels));
  EXPECT_GT(found.moved, 0) << "were planes taken at all?";
  EXPECT_LT(found.moved, 120);
  EXPECT_LE(found.lost, 1); // no metal is quite smooth: a ray in thousands goes far aside
}

namespace
{

/// Waves of ground that R-LODs stand for, and a fence on it of two triangles, as high as the waves:
/// the rays that leave an R-LOD leave behind more of its own mesh than that.
struct FencedGround : LodMesh
{
  static Triangles ground()
  {
    Triangles waves;
    constexpr int side = 300;
    const auto wave = [](int i, int j) { return 0.02 * std::sin(0.15 * i) * std::sin(0.15 * j); };
    for (int j = 0; j <= side; ++j)
      for (int i = 0; i <= side; ++i)
        waves.addPoint({2.0 * i / side - 1.0, 2.0 * j / side - 1.0, wave(i, j)});
    addGrid(waves, side);
    return waves;
  }
  FencedGround()
    : LodMesh(ground())
  {
    Triangles fence;
    for (const double z : {-0.05, 0.04})
      for (const double x : {-0.9, 0.9})
        fence.addPoint({x, 0.0, z});
    fence.add(0, 1, 3);
    fence.add(0, 3, 2);
    addTo(scene, objectOf(fence));
    camera = lookAt({0.5, -5.0, 5.0}, Vec3d(0.0), 18.0);
    object().material.ambient = 0.0f;
    scene.surfaces[1].material.ambient = 0.0f;
    scene.lights = {shadowLight(Light::Kind::Directional, {0.0, -1.0, -0.7})};
  }
  /// How much darker the ground is than without the fence, all pixels added up.
  double taken(double poe)
  {
    const Film with = traced(poe);
    const SurfaceObject fence = scene.surfaces.back();
    scene.surfaces.pop_back();
    const Film without = traced(poe);
    scene.surfaces.push_back(fence);
    double sum = 0.0;
    for (int i = 0; i < size * size; ++i)
      if (with.object()[i] == 0)
        sum += std::max(0.0f, without.color()[4 * i] - with.color()[4 * i]);
    return sum;
  }
  void expectTaken(double least, double tolerance)
  {
    const double exact = taken(0.0), rough = taken(pixels);
    EXPECT_GT(exact, least) << "is there anything to be lost?";
    EXPECT_NEAR(rough / exact, 1.0, tolerance);
  }
};

} // namespace

TEST(MeshLodScene, OtherThingsThrowShadowsRightWhereTheyTouchPlanes)
{
  FencedGround ground;
  ground.expectTaken(30.0, 0.25);
  ground.scene.lights = {shadowLight(Light::Kind::Point, {0.0, 5.0, 3.5})};
  ground.expectTaken(30.0, 0.25);
  ground.scene.paths.bounces = 1;
  ground.scene.sky = {Vec3f(0.0f), Vec3f(0.0f)};
  ground.expectTaken(30.0, 0.25);
}

TEST(MeshLodScene, OtherThingsHideTheSkyRightWhereTheyTouchPlanes)
{
  FencedGround ground;
  ground.scene.lights.clear();
  ground.object().material.ambient = 1.0f;
  ground.scene.occlusion = {64, 0.06};
  ground.expectTaken(10.0, 0.4); // waves hide from one another what planes see of the fence
}

TEST(MeshLodScene, PlanesHaveTheMeanColour)
{
  LodMesh lods;
  std::mt19937 random(4);
  std::vector<float> values;
  for (std::size_t i = 0; i < lods.mesh->size(); ++i)
    values.push_back(static_cast<float>(random() % 2));
  SurfaceObject& object = lods.object();
  object.coloring.values = ArrayView(values.data(), values.size(), 1);
  object.coloring.map.table = {Vec4f(0.0f, 0.0f, 0.0f, 1.0f), Vec4f(1.0f)};
  object.material.ambient = 1.0f; // the colour itself
  object.material.diffuse = 0.0f;
  lods.scene.lights.clear();
  const auto spreadOf = [&](const Film& film)
  {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < size * size; ++i)
      if (film.object()[i] == 0)
      {
        sum += std::pow(film.color()[4 * i] - 0.5, 2.0);
        ++count;
      }
    return std::sqrt(sum / count);
  };
  EXPECT_NEAR(spreadOf(lods.traced(pixels)), 0.5, 1e-6) << "colours of the triangles that speak";
  const ColorMeans means = meansOf(*lods.tree, {}, object.coloring);
  object.coloring.means = means.view();
  EXPECT_LT(spreadOf(lods.traced(pixels)), 0.25);
  EXPECT_NEAR(spreadOf(lods.traced(0.0)), 0.5, 1e-6) << "without error nothing is a mean";
}

TEST(MeshLodScene, MeansAreWeightedByArea)
{
  Triangles triangles = randomTriangles(700, 3, 0.2);
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh mesh = triangles.mesh();
  RlodTree tree;
  tree.build(mesh);
  tree.makeLods();
  const auto valuesOf = [&](std::uint64_t triangle, double* values)
  {
    values[0] = triangle % 5 == 0 ? nan : static_cast<double>(triangle);
    values[1] = std::cos(static_cast<double>(triangle));
    values[2] = nan;
  };
  const std::vector<float> means = tree.lodMeans(3, valuesOf);
  int count = 0;
  for (const std::uint64_t slot : tree.lodSlots())
  {
    double sum[2] = {}, weight[2] = {};
    for (const std::uint64_t below : tree.slotsBelow(slot))
    {
      const auto corners = tree.localCorners(below);
      const double area =
        glm::length(glm::cross(Vec3d(corners[1] - corners[0]), Vec3d(corners[2] - corners[0])));
      double values[3];
      valuesOf(tree.inputIndex(below), values);
      for (int c = 0; c < 2; ++c)
        if (std::isfinite(values[c]))
        {
          sum[c] += area * values[c];
          weight[c] += area;
        }
    }
    const float* found = means.data() + 3 * RlodTree::lodPlace(slot);
    EXPECT_EQ(std::isnan(found[0]), weight[0] == 0.0);
    if (weight[0] > 0.0)
    {
      EXPECT_NEAR(found[0], sum[0] / weight[0], 1e-4 * 700);
    }
    EXPECT_NEAR(found[1], sum[1] / weight[1], 1e-5);
    EXPECT_TRUE(std::isnan(found[2]));
    ++count;
  }
  EXPECT_GT(count, 50);
}
