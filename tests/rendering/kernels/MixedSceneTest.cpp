// Kinds of surfaces and clouds in one scene, each ray judged by brute force over all of them.

#include "MeshParts.h"
#include "ShadowParts.h"

#include <kernels/tracing/detail/SceneRays.h>

#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double slack = 4e-6; ///< of all kinds, in scenes of this size

/// A mesh, iso-surfaces of a linear field, which are two planes within a block of cells, and
/// particles, in and through one another.
struct Mixed
{
  Triangles triangles = bumpySphere(14, {0.2, -0.1, 0.0}, 0.9);
  TriangleOracle oracle{triangles, 2e-6};
  std::vector<reference::Sphere> spheres;
  Vec3d across = glm::normalize(Vec3d(0.3, 0.2, 1.0));
  std::vector<double> values = {-0.35, 0.4};
  Mat4d isoToWorld = glm::rotate(Mat4d(1.0), 0.4, Vec3d(1, 2, 3));
  Scene scene;

  Mixed()
  {
    addTo(scene, objectOf(triangles));
    HexCells cells = hexBlock(6, 6, 6, 0.2);
    cells.move([](const Vec3d& p) { return (p - Vec3d(3.0)) / 3.0; });
    const auto mesh = cells.mesh();
    CloudObject field = volumeOf(mesh,
      pointValues(*mesh, [&](const Vec3d& p) { return glm::dot(across, p); }), evenTransfer(0.5F));
    field.toWorld = isoToWorld;
    addTo(scene, isoSurfacesOf(field, values));
    const Particles particles = randomParticles(40, 3, 0.05, 0.3);
    spheres = reference::validSpheres(particles.set());
    addTo(scene, objectOf(particles));
  }

  /// t where the ray meets one of the planes, `inside` the block by more than so much.
  double nearestPlane(const reference::Ray& world, double inside) const
  {
    const Mat4d toLocal = glm::inverse(isoToWorld);
    const Vec3d from = transformPoint(toLocal, world.origin);
    const Vec3d way = transformVector(toLocal, world.direction);
    double nearest = infinity;
    for (const double value : values)
    {
      const double t = (value - glm::dot(across, from)) / glm::dot(across, way);
      const Vec3d at = glm::abs(from + t * way);
      if (t > world.tMin + inside && t < world.tMax - inside &&
          std::max({at.x, at.y, at.z}) < 1.0 - inside)
        nearest = std::min(nearest, t);
    }
    return nearest;
  }
  double nearestSphere(const reference::Ray& ray, double grown) const
  {
    reference::Hit hit;
    for (reference::Sphere sphere : spheres)
    {
      sphere.radius += grown;
      reference::meet(ray, sphere, hit);
    }
    return hit.t;
  }
  /// The nearest hit that rounding cannot take away, and what it may add to its t.
  double nearestSure(const reference::Ray& ray) const
  {
    constexpr double steep = 1e3; // along the ray, where it meets spheres and planes from the side
    return std::min({oracle.nearestSure(ray), nearestPlane(ray, slack) + steep * slack,
      nearestSphere(ray, -slack) + steep * slack});
  }
  bool mayHit(const reference::Ray& ray) const
  {
    return oracle.mayHit(ray) || nearestPlane(ray, -slack) < infinity ||
           nearestSphere(ray, slack) < infinity;
  }
  /// How far a hit lies off what it names.
  double distance(const RayPacket& answer, int i, const Vec3d& at) const
  {
    const auto& object = scene.surfaces[static_cast<std::size_t>(answer.object[i])];
    std::uint64_t id = 0;
    withSurface(object.surface, [&](const auto& s) { s.inputIds(&answer.slot[i], 1, &id); });
    if (answer.object[i] == 0)
      return distanceFrom(triangles.of(id), at);
    if (answer.object[i] == 2)
      return std::abs(glm::length(at - spheres[id].center) - spheres[id].radius);
    const double height = glm::dot(across, transformPoint(glm::inverse(isoToWorld), at));
    return std::min(std::abs(height - values[0]), std::abs(height - values[1]));
  }
};

std::vector<RayPacket> raysAnywhere(int packets)
{
  Random random(5);
  std::vector<RayPacket> all;
  for (int k = 0; k < packets; ++k)
  {
    all.push_back(emptyPacket());
    for (int i = 0; i < (k % 4 == 0 ? 1 : RayPacket::capacity); ++i)
    {
      const Vec3d from = random.inBox(Vec3d(-2.0), Vec3d(2.0));
      const Vec3d way = random.inBox(Vec3d(-1.0), Vec3d(1.0)) - from;
      const bool ends = i % 5 == 0;
      addRay(all.back(), from, way, ends ? random(0.0, 0.5) : 0.0, ends ? random() : infinity);
    }
  }
  return all;
}

} // namespace

TEST(MixedScene, SurfacesErrWhereverAnyErrorIsAllowed)
{
  const Triangles triangles = bumpySphere(14);
  const auto tree = std::make_shared<RlodTree>();
  tree->build(triangles.mesh());
  tree->makeLods();
  for (const double pixels : {0.0, 0.2, 1.0, 6.0})
  {
    Scene scene;
    SurfaceObject object;
    MeshLook look;
    look.poe = pixels;
    object.surface = MeshSurface(tree, look);
    addTo(scene, object);
    EXPECT_EQ(SceneRays(scene, Vec3d(0.0)).errs(0), pixels > 0.0) << pixels;
  }
}

TEST(MixedScene, NearestAndAnyHitsAreThoseOfBruteForceOverAllKinds)
{
  const Mixed mixed;
  const Vec3d reference(0.5, -1.0, 2.0);
  const SceneRays rays(mixed.scene, reference);
  std::size_t hits[3] = {}, missed = 0, wrong = 0, all = 0;
  for (const RayPacket& question : raysAnywhere(300))
  {
    RayPacket asked = question;
    for (int i = 0; i < asked.count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        asked.origin[axis][i] -= reference[axis];
    RayPacket dark = asked, answer = asked;
    rays.cast(answer);
    rays.occlude(dark);
    for (int i = 0; i < asked.count; ++i, ++all)
    {
      const reference::Ray ray = rayOf(question, i);
      const double sure = mixed.nearestSure(ray);
      const bool isHit = answer.object[i] >= 0, isDark = dark.t[i] < 0.0;
      wrong += isDark ? !mixed.mayHit(ray) : sure < infinity;
      if (!isHit)
      {
        ++missed;
        wrong += sure < infinity;
        continue;
      }
      ++hits[answer.object[i]];
      const double t = answer.t[i];
      wrong += !(t > ray.tMin && t < ray.tMax && t <= sure &&
                 mixed.distance(answer, i, ray.origin + t * ray.direction) <= slack);
    }
  }
  EXPECT_EQ(wrong, 0u) << "of " << all;
  for (const std::size_t count : hits)
    EXPECT_GT(count, all / 20);
  EXPECT_GT(missed, all / 20);
}

TEST(MixedScene, PicturesShowTheNearestOfAllKinds)
{
  const Mixed mixed;
  constexpr int size = 64;
  int wrong = 0, seen[4] = {};
  for (const Vec3d& eye : {Vec3d(2.0, -1.6, 3.2), Vec3d(-3.5, 0.5, 0.8), Vec3d(0.1, 0.2, 0.9)})
  {
    const Camera camera = lookAt(eye, Vec3d(0.0), 40.0);
    const Film film = tracedFilm(mixed.scene, camera, size);
    const CameraRays rays(camera, size, size);
    for (int i = 0; i < size * size; ++i)
    {
      const reference::Ray ray = reference::cameraRay(rays, i % size + 0.5, i / size + 0.5);
      const double nearest[3] = {
        mixed.oracle.nearest(ray), mixed.nearestPlane(ray, 0.0), mixed.nearestSphere(ray, 0.0)};
      const double t = std::min({nearest[0], nearest[1], nearest[2]});
      const std::int32_t object = film.object()[i];
      ++seen[object + 1];
      if (object < 0)
        wrong += mixed.nearestSure(ray) < infinity;
      else
        wrong += std::abs(nearest[object] - t) > 1e-4 || std::abs(film.depth()[i] - t) > 1e-4;
    }
  }
  EXPECT_LE(wrong, 3) << "edges of triangles and spheres, of 12288 pixels";
  for (const int count : seen)
    EXPECT_GT(count, 600);
}

TEST(MixedScene, CloudsEndAtMeshesAndBeginAgainBehindThem)
{
  // A mesh that light passes in part, in a cloud of many colours.
  const Triangles triangles = bumpySphere(14, {0.3, 0.0, 0.1}, 0.8);
  const TriangleOracle oracle(triangles);
  HexCells cells = hexBlock(4, 4, 4, 0.2);
  cells.move([](const Vec3d& p) { return (p - Vec3d(2.0)) / 2.0; });
  const auto mesh = cells.mesh();
  CloudObject cloud = volumeOf(mesh, pointValues(*mesh, wave), colorful());
  cloud.toWorld = glm::rotate(Mat4d(1.0), 0.5, Vec3d(3, 1, 2));
  cloud.sampling.integrator = VolumeIntegrator::CellByCell;
  cloud.sampling.tolerance = 1e-5;
  const Camera camera = lookAt({2.0, 2.5, 3.0}, Vec3d(0.0), 35.0);
  constexpr int size = 24;
  const CameraRays rays(camera, size, size);
  for (const float opacity : {1.0f, 0.4f})
  {
    Scene scene;
    SurfaceObject object = objectOf(triangles);
    object.material.opacity = opacity;
    object.material.ambient = 1.0f;
    object.material.diffuse = 0.0f;
    object.coloring.constant = Vec4f(0.2f, 0.9f, 0.4f, 1.0f);
    addTo(scene, object);
    scene.lights.clear();
    scene.clouds = {cloud};
    const Film film = tracedFilm(scene, camera, size);
    int wrong = 0, through = 0, both = 0;
    for (int i = 0; i < size * size; ++i)
    {
      reference::Ray ray = reference::cameraRay(rays, i % size + 0.5, i / size + 0.5);
      Vec3d color(0.0);
      double left = 1.0, covered = 0.0;
      int met = 0;
      for (double from = 0.0; left > 0.0 && from < infinity;)
      {
        const double to = oracle.nearest(ray);
        const RayColor part = gatheredByDefinition(cloud, ray.origin, ray.direction, from, to, 400);
        color += left * part.color;
        covered += 1.0 - part.transmittance;
        left *= part.transmittance;
        if (to < infinity)
        {
          color += left * double(opacity) * Vec3d(0.2f, 0.9f, 0.4f);
          left *= 1.0 - double(opacity);
          ++met;
        }
        from = to;
        ray.tMin = to + 1e-6;
      }
      through += met > 1;
      both += met > 0 && covered > 0.05;
      const float* c = film.color() + 4 * i;
      const double off = std::max({std::abs(c[0] - color.x), std::abs(c[1] - color.y),
        std::abs(c[2] - color.z), std::abs(c[3] - (1.0 - left))});
      wrong += off > 2e-3;
    }
    EXPECT_LE(wrong, 1) << "of " << size * size;
    EXPECT_GT(both, 80);
    EXPECT_EQ(through > 80, opacity < 1.0f);
  }
}
