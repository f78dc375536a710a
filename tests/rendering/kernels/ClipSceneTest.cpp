// Objects of which a part of space is shown, beside brute force.

#include "MeshParts.h"
#include "ShadowParts.h"

#include <kernels/tracing/CloudPicking.h>

#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

using Spans = RaySpan[ClipRegion::mostSpans];

/// A slanted cut, and a hollow piece of a cylinder.
std::vector<ClipRegion> regions()
{
  std::vector<ClipRegion> all(3);
  all[0].planes.push_back({{0.1, 0.0, 0.2}, {-0.3, 0.2, -1.0}});
  all[1].cylinder.emplace();
  all[1].cylinder->axis = {0.2, 1.0, 0.1};
  all[1].cylinder->radius[0] = 0.35;
  all[1].cylinder->radius[1] = 0.8;
  all[1].cylinder->angle[0] = 0.5;
  all[1].cylinder->angle[1] = 4.5;
  all[2] = all[1];
  all[2].planes = all[0].planes;
  return all;
}

const std::vector<Camera> cameras = {lookAt({2.0, 1.0, 4.0}, Vec3d(0.0), 35.0),
  lookAt({0.3, 0.1, 0.5}, Vec3d(-0.4), 80.0), lookAt({-1.0, 3.0, 0.2}, Vec3d(0.0), 40.0)};

/// What brute force finds: t, or infinity; and whether rounding may decide.
struct Found
{
  double t = INFINITY;
  bool isOnCut = false;
};

Found nearestOf(const std::vector<reference::Sphere>& spheres, const ClipRegion& region,
  const reference::Ray& ray)
{
  Spans spans;
  const int count = region.spansOf(ray.origin, ray.direction, ray.tMin, ray.tMax, spans);
  for (int s = 0; s < count; ++s)
  {
    const Vec3d begin = ray.origin + spans[s].tIn * ray.direction;
    for (const reference::Sphere& sphere : spheres)
      if (spans[s].tIn > ray.tMin && glm::length(begin - sphere.center) < sphere.radius)
        return {spans[s].tIn, true};
    reference::Ray part = ray;
    part.tMin = spans[s].tIn;
    part.tMax = spans[s].tOut;
    if (const reference::Hit hit = reference::bruteForce(spheres, part))
      return {hit.t, false};
  }
  return {};
}

Found nearestOf(
  const TriangleOracle& triangles, const ClipRegion& region, const reference::Ray& ray)
{
  Spans spans;
  const int count = region.spansOf(ray.origin, ray.direction, ray.tMin, ray.tMax, spans);
  for (int s = 0; s < count; ++s)
  {
    reference::Ray part = ray;
    part.tMin = spans[s].tIn;
    part.tMax = spans[s].tOut;
    if (const double t = triangles.nearest(part); std::isfinite(t))
      return {t, false};
  }
  return {};
}

struct Report
{
  int pixels = 0, hits = 0, onCuts = 0, wrong = 0;
};

/// Compares films, whose rays go in bundles, and picks with brute force. A few pixels in which a
/// ray passes an edge may be either.
template <typename Oracle>
Report compare(const Scene& scene, const Oracle& oracle)
{
  constexpr int size = 48;
  Report report;
  for (const Camera& camera : cameras)
  {
    const Film film = tracedFilm(scene, camera, size);
    const CameraRays rays(camera, size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
      {
        reference::Ray ray = reference::cameraRay(rays, x + 0.5, y + 0.5);
        const Found truth = nearestOf(oracle, scene.surfaces[0].clip, ray);
        const auto picked = pick(scene, ray.origin, ray.direction, ray.tMin, ray.tMax);
        const double seen = film.depth()[y * size + x], asked = picked ? picked->t : INFINITY;
        ++report.pixels;
        report.hits += std::isfinite(truth.t);
        report.onCuts += truth.isOnCut;
        const auto isRight = [&](double t)
        { return t == truth.t || std::abs(t - truth.t) < 1e-5 * truth.t; };
        report.wrong += !isRight(seen) || !isRight(asked);
        if (truth.isOnCut && picked && isRight(asked))
        {
          const auto face = scene.surfaces[0].clip.faceAt(picked->position, 1e-6);
          report.wrong += !face || glm::length(*face - picked->normal) > 1e-6;
        }
      }
  }
  return report;
}

Particles ball(int count, std::uint64_t seed)
{
  Random random(seed);
  Particles particles;
  for (int k = 0; k < count; ++k)
    particles.add(random.inBox(Vec3d(-0.8), Vec3d(0.8)), random(0.03, 0.2));
  return particles;
}

} // namespace

TEST(ClipScene, ParticlesAreCutAndClosedAsByBruteForce)
{
  for (const ClipRegion& region : regions())
    for (const ParticleStructureKind kind :
      {ParticleStructureKind::PkdTree, ParticleStructureKind::CoherentGrid})
    {
      SCOPED_TRACE(static_cast<int>(kind));
      const Particles particles = ball(400, 3);
      ParticleStructureOptions options;
      options.kind = kind;
      Scene scene;
      SurfaceObject object;
      object.surface = ParticleSurface(makeParticleStructure(particles.set(), options));
      object.clip = region;
      addTo(scene, object);
      const Report report = compare(scene, reference::validSpheres(particles.set()));
      EXPECT_LE(report.wrong, report.pixels / 1000) << "of " << report.pixels;
      EXPECT_GT(report.hits, report.pixels / 20);
      EXPECT_GT(report.onCuts, report.hits / 30);
    }
}

TEST(ClipScene, TrianglesAreCutOpenAsByBruteForce)
{
  const Triangles sphere = bumpySphere(14);
  for (const ClipRegion& region : regions())
  {
    Scene scene;
    SurfaceObject object = objectOf(sphere);
    object.clip = region;
    addTo(scene, object);
    const Report report = compare(scene, TriangleOracle(sphere));
    EXPECT_LE(report.wrong, report.pixels / 1000) << "of " << report.pixels;
    EXPECT_GT(report.hits, report.pixels / 20);
  }
}

TEST(ClipScene, CloudsAreTheirChordsWithinTheRegion)
{
  HexCells cells = hexBlock(4, 4, 4);
  cells.move([](const Vec3d& p) { return p - Vec3d(2.0); });
  const auto mesh = cells.mesh();
  TransferFunction f;
  f.knots = {{0.0, Vec4f(1.0f, 1.0f, 1.0f, 0.2f)}};
  const double none = 1.0 - double(0.2f);
  Random random(4);
  for (const ClipRegion& region : regions())
  {
    Scene scene;
    scene.clouds.push_back(volumeOf(mesh, std::vector<double>(mesh->pointCount(), 0.0), f));
    CloudObject& cloud = scene.clouds[0];
    cloud.clip = region;
    for (const VolumeIntegrator integrator :
      {VolumeIntegrator::CellByCell, VolumeIntegrator::Trilinear})
      for (const Camera& camera : cameras)
      {
        cloud.sampling.integrator = integrator;
        cloud.sampling.step = 0.01;
        cloud.sampling.saturation = 1.0;
        constexpr int size = 24;
        const Film film = tracedFilm(scene, camera, size);
        const CameraRays rays(camera, size, size);
        for (int i = 0; i < size * size; ++i)
        {
          const reference::Ray ray =
            reference::cameraRay(rays, i % size + 0.5, i / size + 0.5); // NOLINT: whole rows
          ClipRegion both = region;
          for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0})
            {
              Vec3d normal(0.0);
              normal[axis] = -sign;
              both.planes.push_back({2.0 * Vec3d(sign), normal});
            }
          Spans spans;
          double length = 0.0;
          const int count =
            both.spansOf(ray.origin, ray.direction, std::max(0.0, ray.tMin), ray.tMax, spans);
          for (int s = 0; s < count; ++s)
            length += (spans[s].tOut - spans[s].tIn) * glm::length(ray.direction);
          EXPECT_NEAR(film.color()[4 * i + 3], 1.0 - std::pow(none, length), 2e-4) << i;
          const auto picked = pickCloud(scene, ray.origin, ray.direction, 0.0, 1e30);
          EXPECT_EQ(picked.has_value(), length > 1e-9) << i;
          EXPECT_TRUE(!picked || length <= 1e-6 || region.contains(picked->position)) << i;
        }
      }
  }
}

TEST(ClipScene, WhatIsCutAwayThrowsNoShadow)
{
  Triangles floor, roof;
  for (Triangles* one : {&floor, &roof})
  {
    const double z = one == &floor ? 0.0 : 0.5, side = one == &floor ? 2.0 : 1.0;
    one->add({-side, -side, z}, {side, -side, z}, {side, side, z});
    one->add({-side, -side, z}, {side, side, z}, {-side, side, z});
  }
  for (const Light::Kind kind : {Light::Kind::Directional, Light::Kind::Point})
  {
    Scene scene;
    addTo(scene, objectOf(floor));
    addTo(scene, objectOf(roof));
    scene.surfaces[1].clip.planes.push_back({Vec3d(0.0), {1.0, 0.0, 0.0}});
    for (SurfaceObject& object : scene.surfaces)
      object.material.ambient = 0.0f;
    const bool isPoint = kind == Light::Kind::Point;
    scene.lights = {shadowLight(kind, Vec3d(0.0, 0.0, isPoint ? 20.0 : -1.0))};
    const Camera below = lookAt({0.0, -6.0, 0.25}, {0.0, 0.0, 0.0}, 30.0);
    const CameraRays rays(below, 64, 64);
    const Film film = tracedFilm(scene, below, 64);
    int lit = 0, dark = 0;
    for (int i = 0; i < 64 * 64; ++i)
    {
      const reference::Ray ray = reference::cameraRay(rays, i % 64 + 0.5, i / 64 + 0.5);
      const Vec3d at = ray.origin + double(film.depth()[i]) * ray.direction;
      if (film.object()[i] != 0 || std::abs(at.x) < 0.1 || std::abs(at.x) > 0.9 ||
          std::abs(at.y) > 0.9)
        continue;
      (at.x < 0.0 ? lit : dark) += 1;
      EXPECT_EQ(film.color()[4 * i] > 0.0f, at.x < 0.0) << at.x << " " << at.y;
    }
    EXPECT_GT(lit, 20);
    EXPECT_GT(dark, 20);
  }
}

TEST(ClipScene, CutFacesAreFlat)
{
  Scene scene = oneSphere();
  scene.surfaces[0].clip.planes.push_back({{0.0, 0.0, 0.3}, {0.0, 0.0, -1.0}});
  Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0);
  camera.projection = Camera::Projection::Orthographic;
  camera.parallelScale = 1.2;
  const Film film = tracedFilm(scene, camera, 65);
  const float* middle = film.color() + 4 * (32 * 65 + 32);
  EXPECT_GT(middle[0], 0.5f);
  int flat = 0;
  for (int i = 0; i < 65 * 65; ++i)
    if (std::abs(film.depth()[i] - 4.7f) < 1e-5f)
    {
      ++flat;
      EXPECT_FLOAT_EQ(film.color()[4 * i], middle[0]);
    }
  const double pixel = 2.4 / 65;
  EXPECT_NEAR(flat * pixel * pixel, M_PI * (1.0 - 0.09), 0.05);
}
