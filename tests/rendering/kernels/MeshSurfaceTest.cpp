// Meshes as surfaces of a scene: normals, ids, colours. What all kinds share is in
// SurfaceKindTest.cpp.

#include "MeshParts.h"
#include "ShadowParts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A sphere of few triangles with the normals of the true one.
struct SmoothSphere
{
  Triangles triangles;
  std::vector<float> normals;
  SurfaceObject object;

  explicit SmoothSphere(int rings, bool smooth = true)
    : triangles(bumpySphere(rings))
  {
    triangles.move([](const Vec3d& p) { return glm::normalize(p); });
    for (const double coordinate : triangles.points)
      normals.push_back(static_cast<float>(-3.0 * coordinate)); // any length, either side
    const auto mesh = std::make_shared<TriangleMesh>(triangles.mesh());
    const auto tree = std::make_shared<RlodTree>();
    tree->build(*mesh);
    MeshLook look;
    if (smooth)
    {
      look.normals = ArrayView(normals.data(), normals.size() / 3, 3);
      look.corners = mesh->corners();
    }
    object.surface = MeshSurface(tree, look);
  }
  SmoothSphere(const SmoothSphere&) = delete;
  SmoothSphere& operator=(const SmoothSphere&) = delete;
};

/// Largest and root-mean-square difference of a film from a unit sphere lit from the eye.
std::pair<double, double> differenceFromSphere(const SurfaceObject& object)
{
  Scene scene;
  addTo(scene, object);
  Light light;
  light.kind = Light::Kind::Directional;
  light.vector = {0.0, 0.0, -1.0};
  scene.lights = {light};
  Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0));
  camera.projection = Camera::Projection::Orthographic;
  camera.parallelScale = 1.0;
  constexpr int size = 96;
  const Film film = tracedFilm(scene, camera, size);
  double most = 0.0, sum = 0.0;
  int count = 0;
  for (int i = 0; i < size * size; ++i)
  {
    const double x = (i % size + 0.5) / size * 2.0 - 1.0, y = (i / size + 0.5) / size * 2.0 - 1.0;
    if (x * x + y * y > 0.8)
      continue;
    EXPECT_EQ(film.object()[i], 0);
    const double error = film.color()[4 * i] - std::sqrt(1.0 - x * x - y * y);
    most = std::max(most, std::abs(error));
    sum += error * error;
    ++count;
  }
  return {most, std::sqrt(sum / count)};
}

} // namespace

TEST(MeshSurface, NormalsOfPointsMakeFewTrianglesLookRound)
{
  const auto [most, rms] = differenceFromSphere(SmoothSphere(16).object);
  const auto [mostFlat, rmsFlat] = differenceFromSphere(SmoothSphere(16, false).object);
  EXPECT_LT(most, 0.03);
  EXPECT_LT(rms, 0.006);
  EXPECT_GT(mostFlat, 2.0 * most);
  EXPECT_GT(rmsFlat, 5.0 * rms);
  EXPECT_LT(differenceFromSphere(SmoothSphere(64).object).second, 0.3 * rms);
}

TEST(MeshSurface, SmoothNormalsFaceTheEyeUpToTheOutline)
{
  const SmoothSphere sphere(10);
  const auto& surface = std::get<MeshSurface>(sphere.object.surface);
  const CameraRays rays(lookAt({0.5, 1.0, 4.0}, Vec3d(0.0)), 64, 64);
  int hits = 0;
  for (int y = 0; y < 64; y += 16)
    for (int x = 0; x < 64; x += 16)
    {
      RayBundle bundle;
      rays.fillBundle(bundle, 16, x, y, 0.0, 0.0);
      surface.cast(bundle, 0);
      HitBlock block = hitsOf(bundle);
      surface.fetch(block);
      surface.place(block, {bundle, bundle, Vec3d(0.0), nullptr, false});
      for (int k = 0; k < block.count; ++k, ++hits)
      {
        const Vec3f normal(block.normal.x[k], block.normal.y[k], block.normal.z[k]);
        const Vec3f eye(block.toEye.x[k], block.toEye.y[k], block.toEye.z[k]);
        EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
        EXPECT_GE(glm::dot(normal, eye), 0.0f);
        const int i = block.ray[k];
        const Vec3d at = bundle.originOf(i) + bundle.t[i] * bundle.directionOf(i);
        EXPECT_GT(glm::dot(Vec3d(normal), glm::normalize(at)), 0.95);
      }
    }
  EXPECT_GT(hits, 1000);
}

TEST(MeshSurface, PicksHaveSmoothNormals)
{
  const SmoothSphere sphere(24), flat(24, false);
  Random random(31);
  double most = 0.0, mostFlat = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    const Vec3d way = random.direction();
    const auto offOf = [&](const SmoothSphere& some)
    {
      Scene scene;
      addTo(scene, some.object);
      const auto found = pick(scene, 3.0 * way, -way);
      EXPECT_TRUE(found);
      return found ? glm::length(found->normal - way) : 2.0;
    };
    most = std::max(most, offOf(sphere));
    mostFlat = std::max(mostFlat, offOf(flat));
  }
  EXPECT_LT(most, 0.015);
  EXPECT_GT(mostFlat, 5.0 * most);
}

TEST(MeshSurface, TellsTrianglesOrTheirCells)
{
  Triangles square; // two cells of two triangles each
  square.add({0, 0, 0}, {1, 0, 0}, {1, 1, 0});
  square.add({0, 0, 0}, {1, 1, 0}, {0, 1, 0});
  square.add({2, 0, 0}, {3, 0, 0}, {3, 1, 0});
  square.add({2, 0, 0}, {3, 1, 0}, {2, 1, 0});
  const std::int64_t cells[] = {70, 70, 80, 80};
  Scene scene;
  addTo(scene, objectOf(square));
  const auto idAt = [&](double x, double y)
  {
    const auto found = pick(scene, {x, y, 5.0}, {0.0, 0.0, -1.0});
    EXPECT_TRUE(found && found->colorIndex == found->id);
    return found ? found->id : 999;
  };
  EXPECT_EQ(idAt(0.75, 0.25), 0u);
  EXPECT_EQ(idAt(0.25, 0.75), 1u);
  EXPECT_EQ(idAt(2.25, 0.75), 3u);
  EXPECT_FALSE(pick(scene, {1.5, 0.5, 5.0}, {0.0, 0.0, -1.0}));
  const auto tree = std::make_shared<RlodTree>();
  tree->build(square.mesh());
  MeshLook look;
  look.cells = ArrayView(cells, ArrayView::Type::Int64, 4, 1);
  scene.surfaces[0].surface = MeshSurface(tree, look);
  EXPECT_EQ(idAt(0.75, 0.25), 70u);
  EXPECT_EQ(idAt(0.25, 0.75), 70u);
  EXPECT_EQ(idAt(2.25, 0.75), 80u);
}

TEST(MeshSurface, ComparesByWhatItShows)
{
  const auto tree = std::make_shared<RlodTree>(), other = std::make_shared<RlodTree>();
  const float normals[3] = {};
  MeshLook smooth;
  smooth.normals = ArrayView(normals, 1, 3);
  EXPECT_EQ(MeshSurface(tree), MeshSurface(tree));
  EXPECT_NE(MeshSurface(tree), MeshSurface(other));
  EXPECT_NE(MeshSurface(tree), MeshSurface(tree, smooth));
  EXPECT_EQ(MeshSurface(tree, smooth), MeshSurface(tree, smooth).unowned());
}

TEST(MeshSurface, TinyTrianglesHaveNormals)
{
  for (const double size : {1e-30, 1e30})
  {
    Triangles square;
    square.add(size * Vec3d(0, 0, 0), size * Vec3d(1, 0, 0), size * Vec3d(1, 1, 0));
    square.add(
      1e-7 * size * Vec3d(0, 0, 1), 1e-7 * size * Vec3d(-1, 0, 1), 1e-7 * size * Vec3d(-1, -1, 1));
    const SurfaceObject object = objectOf(square);
    const auto& surface = std::get<MeshSurface>(object.surface);
    for (std::uint64_t slot = 0; slot < 2; ++slot)
      EXPECT_NEAR(std::abs(glm::normalize(surface.normalAt(slot, Vec3d(0.0))).z), 1.0, 1e-3);
  }
}

TEST(MeshSurface, EdgesAreAsFarAsTheyLook)
{
  // Anywhere, and long beside their size, so that what is said along an edge would show.
  Triangles triangles = randomTriangles(200, 5, 0.4);
  triangles.move([](const Vec3d& p) { return Vec3d(40.0, -30.0, 20.0) + 3.0 * p; });
  const auto object = objectOf(triangles);
  const auto& surface = std::get<MeshSurface>(object.surface);
  Random random(6);
  int met = 0;
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    const auto [a, b, c] = triangles.of(triangle);
    const double u = random(0.1, 0.8), v = random(0.1, 0.9 - u);
    const Vec3d point = a + u * (b - a) + v * (c - a);
    const Vec3d normal = glm::normalize(glm::cross(b - a, c - a));
    const Vec3d way = -normal;
    RayPacket ray = emptyPacket();
    addRay(ray, point + 0.001 * normal, way, 0.0, 0.002);
    surface.cast(ray, 0);
    ASSERT_EQ(ray.object[0], 0);
    std::uint64_t id = 0;
    surface.inputIds(&ray.slot[0], 1, &id);
    if (id != triangle) // another one lies over it
      continue;
    ++met;
    EdgeSeen seen;
    surface.edges(&ray.slot[0], &point, &way, 1, &seen);
    // Where barycentric coordinates are distances over heights.
    const std::array<double, 3> share = {v, 1.0 - u - v, u};
    const std::array<double, 3> length = {
      glm::length(b - a), glm::length(c - b), glm::length(a - c)};
    const double twiceArea = glm::length(glm::cross(b - a, c - a));
    int nearest = 0;
    for (int side = 1; side < 3; ++side)
      if (share[side] / length[side] < share[nearest] / length[nearest])
        nearest = side;
    const double height = twiceArea / length[nearest];
    EXPECT_NEAR(seen.distance, share[nearest] * height, 1e-4 * height);
    EXPECT_NEAR(seen.extent, height, 1e-3 * height);
  }
  EXPECT_GT(met, 190);
}
