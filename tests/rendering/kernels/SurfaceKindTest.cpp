// What every kind of surface promises (see kernels/core/SurfaceKind.h), and light between kinds,
// judged by brute force.

#include "MeshParts.h"
#include "ShadowParts.h"

#include <support/CastOracle.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A volume whose scalar is z, in cells that fill [-4, 4]^2 x [-2, 2].
CloudObject slab()
{
  HexCells cells = hexBlock(8, 8, 4);
  cells.move([](const Vec3d& p) { return p - Vec3d(4.0, 4.0, 2.0); });
  const auto mesh = cells.mesh();
  return volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.z; }), evenTransfer(0.5F),
    HexStructureKind::CartesianBvh);
}

/// Cells in which the scalar is the distance from the origin.
CloudObject ball()
{
  HexCells cells = hexBlock(12, 12, 12, 0.3);
  cells.move([](const Vec3d& p) { return 0.25 * (p - Vec3d(6.0)); });
  const auto mesh = cells.mesh();
  return volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return glm::length(p); }),
    evenTransfer(0.5F), HexStructureKind::CylindricalGrid);
}

struct Kind
{
  const char* name;
  SurfaceObject object;
};

std::vector<SliceShape> slices()
{
  SliceShape plane, half, cylinder;
  plane.axis = {1.0, 2.0, 3.0};
  half.kind = SliceShape::Kind::HalfPlane;
  cylinder.kind = SliceShape::Kind::Cylinder;
  cylinder.axis = {0.0, 1.0, 0.1};
  return {plane, half, cylinder};
}

std::vector<Kind> kinds()
{
  return {{"particles", objectOf(randomParticles(60, 11, 0.1, 0.4))},
    {"iso-surface", isoSurfacesOf(ball(), {0.8, 1.1})}, {"mesh", objectOf(bumpySphere(20))},
    {"slices", slicesOf(ball(), slices())}};
}

RayBundle bundleTowards(const Vec3d& eye, int side)
{
  const CameraRays rays(lookAt(eye, Vec3d(0.0), 40.0), side, side);
  RayBundle bundle;
  rays.fillBundle(bundle, side, 0, 0, 0.0, 0.0);
  return bundle;
}

/// Ray i of a bundle as a packet of its own.
RayPacket packetOf(const RayBundle& bundle, int i)
{
  RayPacket packet;
  packet.count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    packet.origin[axis][0] = bundle.originOf(i)[axis];
    packet.direction[axis][0] = bundle.directionOf(i)[axis];
  }
  packet.tMin[0] = bundle.tMin;
  packet.t[0] = bundle.t[i];
  packet.slot[0] = RayPacket::noHit;
  packet.object[0] = -1;
  return packet;
}

} // namespace

TEST(SurfaceKind, BundlesPacketsAndOcclusionAgree)
{
  Random random(3);
  for (const Kind& kind : kinds())
    withSurface(kind.object.surface,
      [&](const auto& surface)
      {
        int hits = 0;
        for (int view = 0; view < 6; ++view)
        {
          const RayBundle before = bundleTowards(5.0 * random.direction(), 16);
          RayBundle bundle = before;
          surface.cast(bundle, 4);
          RayBundle dark = before;
          surface.occlude(dark, 4);
          for (int i = 0; i < bundle.count; ++i)
          {
            RayPacket packet = packetOf(before, i);
            surface.cast(packet, 4);
            ASSERT_EQ(packet.object[0], bundle.object[i]) << kind.name;
            ASSERT_EQ(dark.t[i] < 0.0, bundle.object[i] >= 0) << kind.name;
            if (bundle.object[i] < 0)
              continue;
            ++hits;
            EXPECT_EQ(bundle.object[i], 4);
            EXPECT_EQ(packet.slot[0], bundle.slot[i]) << kind.name;
            EXPECT_NEAR(packet.t[0], bundle.t[i], 1e-5) << kind.name;
            // Nothing stands before the hit, and the hit itself before what is behind it.
            for (const double share : {0.999, 1.001})
            {
              RayPacket part = packetOf(before, i);
              part.t[0] = share * bundle.t[i];
              surface.occlude(part, 4);
              EXPECT_EQ(part.t[0]<0.0, share> 1.0) << kind.name;
            }
            const Vec3d at = before.originOf(i) + bundle.t[i] * before.directionOf(i);
            const Box bounds = surface.bounds().expanded(surface.rounding());
            EXPECT_EQ(at, glm::clamp(at, bounds.lower, bounds.upper)) << kind.name;
          }
        }
        EXPECT_GT(hits, 300) << kind.name;
      });
}

TEST(SurfaceKind, PlacesABlockAsItPlacesSingleHits)
{
  const Mat4d toWorld =
    glm::scale(glm::rotate(Mat4d(1.0), 0.7, glm::normalize(Vec3d(1, 2, 3))), Vec3d(0.7, 1.0, 1.3));
  const glm::mat3 normals(glm::transpose(glm::inverse(Mat3d(toWorld))));
  for (const Kind& kind : kinds())
    withSurface(kind.object.surface,
      [&](const auto& surface)
      {
        const CameraRays camera(lookAt({2.0, 3.0, 4.0}, Vec3d(0.0), 30.0), 16, 16);
        RayBundle world, local;
        camera.fillBundle(world, 16, 0, 0, 0.0, 0.0);
        local = world;
        camera.transformed(glm::inverse(toWorld)).placeBundle(local, 16, 0, 0, 0.0, 0.0);
        surface.cast(local, 0);
        HitBlock block = hitsOf(local);
        ASSERT_GT(block.count, 60) << kind.name;
        const HitPlacing placing{local, world, world.origin - camera.o0, &normals, true};
        surface.fetch(block);
        surface.place(block, placing);
        for (int k = 0; k < block.count; ++k)
        {
          const int i = block.ray[k];
          const Vec3d at = block.t[k] * world.directionOf(i);
          EXPECT_NEAR(
            glm::distance(at, {block.position.x[k], block.position.y[k], block.position.z[k]}), 0.0,
            1e-12);
          const Vec3f normal(block.normal.x[k], block.normal.y[k], block.normal.z[k]);
          const Vec3f toEye(block.toEye.x[k], block.toEye.y[k], block.toEye.z[k]);
          EXPECT_NEAR(glm::length(normal), 1.0, 1e-5);
          EXPECT_GE(glm::dot(normal, toEye), 0.0f) << kind.name;
          EXPECT_NEAR(glm::dot(toEye, Vec3f(-glm::normalize(world.directionOf(i)))), 1.0, 1e-5);
          const Vec3d own =
            surface.normalAt(block.slot[k], local.originOf(i) + block.t[k] * local.directionOf(i));
          const Vec3f wanted = glm::normalize(normals * Vec3f(glm::normalize(own)));
          EXPECT_NEAR(std::abs(glm::dot(normal, wanted)), 1.0, 1e-4) << kind.name;
        }
      });
}

TEST(SurfaceKind, IsoSurfacesTellCellAndValue)
{
  Scene scene;
  addTo(scene, isoSurfacesOf(slab(), {1.0, -1.0}));
  scene.surfaces[0].id = 12;
  auto found = pick(scene, {0.25, 0.5, 9.0}, {0.0, 0.0, -2.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->object, 12);
  EXPECT_EQ(found->colorIndex, 0U);
  EXPECT_NEAR(found->t, 4.0, 1e-6);
  EXPECT_NEAR(found->normal.z, 1.0, 1e-6);
  const std::uint64_t above = found->id;
  found = pick(scene, {0.25, 0.5, -9.0}, {0.0, 0.0, 2.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->colorIndex, 1U);
  EXPECT_NE(found->id, above);
  EXPECT_FALSE(pick(scene, {4.25, 0.5, 9.0}, {0.0, 0.0, -2.0}));
}

namespace
{

/// The square [-4, 4]^2 at z = 0 as triangles.
SurfaceObject meshSquare()
{
  Triangles square;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
    {
      const auto at = [&](int u, int v) { return Vec3d(u - 4.0, v - 4.0, 0.0); };
      square.add(at(i, j), at(i + 1, j), at(i, j + 1));
      square.add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return objectOf(square);
}

enum class Square
{
  IsoSurface,
  Mesh
};

/// Spheres, and the square [-4, 4]^2 at z = 0 as another kind: what the scene holds, and what of it
/// light meets, by brute force in double.
struct Stage
{
  Particles particles;
  Scene scene;
  SurfaceObject& square() { return scene.surfaces[1]; }

  explicit Stage(Square kind)
    : particles(randomParticles(40, 77, 0.2, 0.6, {-3.0, -3.0, -2.5}, {3.0, 3.0, 2.5}))
  {
    addTo(scene, objectOf(particles));
    addTo(scene, kind == Square::Mesh ? meshSquare() : isoSurfacesOf(slab(), {0.0}));
    if (kind == Square::IsoSurface)
      square().coloring.palette = {Vec4f(1.0f)};
  }

  /// Whether anything stands between the picked place and `reach` along a unit vector; things are
  /// larger by `grown`.
  bool isOpen(const ScenePick& at, const Vec3d& way, double reach, double grown = 0.0) const
  {
    for (reference::Sphere sphere : reference::validSpheres(particles.set()))
    {
      if (at.object == 0 && sphere.particle == at.id)
        continue;
      sphere.radius += grown;
      reference::Hit hit;
      reference::meet({at.position, way, 0.0, reach}, sphere, hit);
      if (hit)
        return false;
    }
    return at.object == 1 || !meetsSquare(at.position, way, reach, grown);
  }
  static bool meetsSquare(const Vec3d& from, const Vec3d& way, double reach, double grown)
  {
    const double t = -from.z / way.z;
    const Vec3d p = from + t * way;
    return t > 0.0 && t < reach && std::max(std::abs(p.x), std::abs(p.y)) < 4.0 + grown;
  }
  /// Share of the cosine-weighted directions that are open.
  double openShare(const ScenePick& at, const Vec3d& normal, double reach) const
  {
    Vec3d u, v;
    acrossAxes(normal, u, v);
    constexpr int side = 64;
    int open = 0;
    for (int i = 0; i < side * side; ++i)
    {
      const double share = (i % side + 0.5) / side, angle = 2.0 * M_PI * (i / side + 0.5) / side;
      open += isOpen(at,
        std::sqrt(share) * (std::cos(angle) * u + std::sin(angle) * v) +
          std::sqrt(1.0 - share) * normal,
        reach);
    }
    return double(open) / (side * side);
  }

  /// Calls visit(pick, normal towards the eye, red) for the pixels of a film that hit something.
  template <typename Visit>
  void forPixels(const Camera& camera, int size, int samples, const Visit& visit) const
  {
    const Film film = tracedFilm(scene, camera, size, size, {samples});
    const CameraRays rays(camera, size, size);
    for (int i = 0; i < size * size; ++i)
    {
      const Vec3d direction = rays.directionAt(i % size + 0.5, i / size + 0.5);
      const auto at = pick(scene, rays.originAt(i % size + 0.5, i / size + 0.5), direction);
      EXPECT_EQ(film.object()[i], at ? at->object : -1);
      if (at)
        visit(*at, glm::dot(at->normal, direction) < 0.0 ? at->normal : -at->normal,
          double(film.color()[4 * i]));
    }
  }
};

const Camera above = lookAt({3.0, -6.0, 7.0}, Vec3d(0.0), 45.0);
const Camera below = lookAt({-4.0, 3.0, -8.0}, Vec3d(0.0), 45.0);

} // namespace

class SurfaceLight : public ::testing::TestWithParam<Square>
{
};

TEST_P(SurfaceLight, ShadowsBetweenKindsAreThoseOfBruteForce)
{
  Stage stage(GetParam());
  const Vec3d towards = glm::normalize(Vec3d(0.3, 0.2, 1.0));
  stage.scene.lights = {shadowLight(Light::Kind::Directional, -towards)};
  int pixels[2] = {}, shadowed[2] = {};
  for (const Camera& camera : {above, below})
    stage.forPixels(camera, 80, 1,
      [&](const ScenePick& at, const Vec3d& normal, double red)
      {
        const double cosine = std::max(0.0, glm::dot(normal, towards));
        const bool surely = stage.isOpen(at, towards, infinity, 1e-4);
        const bool maybe = stage.isOpen(at, towards, infinity, -1e-4);
        if (surely != maybe || cosine < 1e-3)
          return;
        ++pixels[at.object];
        shadowed[at.object] += !surely;
        EXPECT_NEAR(red, surely ? cosine : 0.0, 1e-4)
          << at.object << " at " << at.position.x << " " << at.position.y << " " << at.position.z;
      });
  for (int object = 0; object < 2; ++object)
  {
    EXPECT_GT(pixels[object], 500);
    EXPECT_GT(shadowed[object], 100);
  }
}

TEST_P(SurfaceLight, WhatCastsNoShadowsTakesNoLightAway)
{
  Stage stage(GetParam());
  stage.scene.lights = {shadowLight(Light::Kind::Point, {1.0, 1.0, 9.0})};
  Stage alone = stage;
  alone.scene.surfaces.pop_back();
  stage.square().castsShadows = false;
  const Film with = tracedFilm(stage.scene, below, 80),
             without = tracedFilm(alone.scene, below, 80);
  int compared = 0;
  for (std::size_t i = 0; i < with.pixels(); ++i)
    if (with.object()[i] == 0)
    {
      ++compared;
      EXPECT_EQ(with.color()[4 * i], without.color()[4 * i]);
    }
  EXPECT_GT(compared, 500);
  // In paths, too: light that comes straight from a light.
  for (Stage* s : {&stage, &alone})
  {
    s->scene.paths.bounces = 1;
    s->scene.sky = {Vec3f(0.0f), Vec3f(0.0f)};
  }
  const Film p = tracedFilm(stage.scene, below, 80), q = tracedFilm(alone.scene, below, 80);
  for (std::size_t i = 0; i < p.pixels(); ++i)
    if (p.object()[i] == 0)
    {
      EXPECT_NEAR(p.color()[4 * i], q.color()[4 * i], 1e-6);
    }
}

TEST_P(SurfaceLight, OcclusionBetweenKindsIsThatOfBruteForce)
{
  for (const double reach : {1.5, infinity})
  {
    Stage stage(GetParam());
    stage.scene.lights.clear();
    stage.scene.occlusion = {128, reach};
    for (SurfaceObject& object : stage.scene.surfaces)
    {
      object.material.ambient = 1.0f;
      object.material.diffuse = 0.0f;
    }
    double sum = 0.0, square = 0.0;
    int pixels[2] = {};
    for (const Camera& camera : {above, below})
      stage.forPixels(camera, 12, 1,
        [&](const ScenePick& at, const Vec3d& normal, double red)
        {
          const double error = red - stage.openShare(at, normal, reach);
          sum += error;
          square += error * error;
          ++pixels[at.object];
        });
    const int all = pixels[0] + pixels[1];
    EXPECT_GT(std::min(pixels[0], pixels[1]), 40);
    EXPECT_LT(std::sqrt(square / all), 0.02);
    EXPECT_LT(std::abs(sum / all), 3e-3);
  }
}

TEST_P(SurfaceLight, PathsBetweenKindsSeeTheSkyThatIsOpen)
{
  // One bounce under an even sky: albedo times the open share.
  Stage stage(GetParam());
  stage.scene.lights.clear();
  stage.scene.paths.bounces = 1;
  for (SurfaceObject& object : stage.scene.surfaces)
    object.material.diffuse = 0.6f;
  double sum = 0.0, square = 0.0;
  int all = 0;
  Camera camera = above;
  stage.forPixels(camera, 14, 1,
    [&](const ScenePick& at, const Vec3d& normal, double)
    {
      // The same ray again and again: a film of one pixel, no wider than a dot.
      const Vec3d eye = at.position + 1.0 * normal;
      Camera dot = lookAt(eye, at.position, 1e-4);
      const auto seen = pick(stage.scene, eye, -normal);
      if (!seen || seen->object != at.object || seen->id != at.id)
        return;
      const Film film = tracedFilm(stage.scene, dot, 1, 1, {256});
      const double error = film.color()[0] - 0.6 * stage.openShare(*seen, normal, infinity);
      sum += error;
      square += error * error;
      ++all;
    });
  EXPECT_GT(all, 60);
  EXPECT_LT(std::sqrt(square / all), 0.02);
  EXPECT_LT(std::abs(sum / all), 4e-3);
}

TEST_P(SurfaceLight, WhiteThingsUnderAWhiteSkyAreWhite)
{
  Stage stage(GetParam());
  stage.scene.lights.clear();
  stage.scene.paths.bounces = 200;
  const Film film = tracedFilm(stage.scene, above, 32, 32, {16});
  for (std::size_t i = 0; i < film.pixels(); ++i)
    EXPECT_NEAR(film.color()[4 * i], film.color()[4 * i + 3], 0.02); // less where a path ends
}

INSTANTIATE_TEST_SUITE_P(Kinds, SurfaceLight, ::testing::Values(Square::IsoSurface, Square::Mesh),
  [](const auto& info) { return info.param == Square::Mesh ? "Mesh" : "IsoSurface"; });
