// Volumes in films: behind and in front of surfaces, and of one another.

#include "SceneParts.h"

#include <kernels/tracing/RayCaster.h>

#include <support/CastOracle.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A cube of side 4 about the origin of an even cloud.
CloudObject cube(float opacity, const Vec3f& color, const Mat4d& toWorld = Mat4d(1.0))
{
  HexCells cells = hexBlock(4, 4, 4);
  cells.move([](const Vec3d& p) { return p - Vec3d(2.0); });
  const auto mesh = cells.mesh();
  TransferFunction f;
  f.knots = {{0.0, Vec4f(color, opacity)}};
  CloudObject volume = volumeOf(mesh, std::vector<double>(mesh->pointCount(), 0.0), f);
  volume.toWorld = toWorld;
  return volume;
}

Camera along(double distance = 20.0)
{
  Camera camera = lookAt({0, 0, distance}, Vec3d(0.0), 20.0);
  camera.projection = Camera::Projection::Orthographic;
  camera.parallelScale = 3.0;
  return camera;
}

Film traced(const Scene& scene, const Camera& camera, int samples = 1,
  const float* limits = nullptr, int size = 33)
{
  Film film;
  film.resize(size, size, Film::Id | Film::Normal);
  RayCaster caster(scene);
  caster.setLimits(limits);
  for (int k = 0; k < samples; ++k)
    EXPECT_TRUE(caster.addSample(camera, film));
  return film;
}

const float* at(const Film& film, int x, int y)
{
  return film.color() + 4 * (static_cast<std::size_t>(y) * film.width() + x);
}

constexpr double none = 1.0 - double(0.2F);

} // namespace

TEST(VolumeScene, ACloudIsItsChord)
{
  Scene scene;
  scene.clouds.push_back(cube(0.2F, Vec3f(1, 0.5F, 0)));
  const Film film = traced(scene, along());
  EXPECT_NEAR(at(film, 16, 16)[3], 1.0 - std::pow(none, 4.0), 1e-6);
  EXPECT_NEAR(at(film, 16, 16)[0], 1.0 - std::pow(none, 4.0), 1e-6);
  EXPECT_NEAR(at(film, 16, 16)[1], 0.5 * (1.0 - std::pow(none, 4.0)), 1e-6);
  EXPECT_EQ(at(film, 0, 0)[3], 0.0f);
  EXPECT_EQ(film.depth()[16 * 33 + 16], INFINITY); // a cloud has no surface
  EXPECT_EQ(film.object()[16 * 33 + 16], -1);
}

TEST(VolumeScene, OpaqueParticlesEndIt)
{
  Scene scene;
  Particles particles;
  particles.add(Vec3d(0.0), 1.0);
  addTo(scene, objectOf(particles));
  scene.surfaces[0].coloring.constant = Vec4f(0, 0, 1, 1);
  scene.surfaces[0].material.ambient = 1.0f;
  scene.surfaces[0].material.diffuse = 0.0f;
  scene.clouds.push_back(cube(0.2F, Vec3f(1, 0, 0)));
  const Film film = traced(scene, along());
  const float* c = at(film, 16, 16);
  EXPECT_NEAR(c[0], 1.0 - none, 1e-6); // 1 in front of the sphere
  EXPECT_NEAR(c[2], none, 1e-6);
  EXPECT_NEAR(c[3], 1.0, 1e-6);
  EXPECT_NEAR(film.depth()[16 * 33 + 16], 19.0, 1e-5);
  EXPECT_EQ(film.id()[16 * 33 + 16], 0U);
  EXPECT_NEAR(at(film, 16, 24)[3], 1.0 - std::pow(none, 4.0), 1e-6); // beside it
}

TEST(VolumeScene, LimitsEndAllRays)
{
  Scene scene;
  Particles particles;
  particles.add(Vec3d(0.0, 0.0, -1.5), 0.2);
  addTo(scene, objectOf(particles));
  scene.clouds.push_back(cube(0.2F, Vec3f(1, 0, 0)));
  std::vector<float> limits(33 * 33, INFINITY);
  limits[16 * 33 + 16] = 19.5f; // 1.5 into the cube, before the particle
  limits[16 * 33 + 17] = 10.0f;
  const Film film = traced(scene, along(), 2, limits.data());
  EXPECT_NEAR(at(film, 16, 16)[3], 1.0 - std::pow(none, 1.5), 1e-6);
  EXPECT_EQ(film.object()[16 * 33 + 16], -1);
  EXPECT_EQ(at(film, 17, 16)[3], 0.0f);
  EXPECT_NEAR(at(film, 24, 16)[3], 1.0 - std::pow(none, 4.0), 1e-6);
}

TEST(VolumeScene, SeveralAreInOrderWhereverTheyStandInTheList)
{
  const Mat4d front = glm::translate(Mat4d(1.0), Vec3d(0, 0, 4.0));
  const double two = 1.0 - std::pow(none, 4.0);
  for (const bool frontFirst : {true, false})
  {
    Scene scene;
    scene.clouds.push_back(
      cube(0.2F, frontFirst ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0), frontFirst ? front : Mat4d(1.0)));
    scene.clouds.push_back(
      cube(0.2F, frontFirst ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0), frontFirst ? Mat4d(1.0) : front));
    const Film film = traced(scene, along());
    EXPECT_NEAR(at(film, 16, 16)[0], two, 1e-6);
    EXPECT_NEAR(at(film, 16, 16)[1], (1.0 - two) * two, 1e-6);
    EXPECT_NEAR(at(film, 16, 16)[3], 1.0 - std::pow(none, 8.0), 1e-6);
  }
}

TEST(VolumeScene, ARingAroundAnotherVolumeIsBeforeAndBehindIt)
{
  // As the diffuser of a pump around its rotor.
  Scene scene;
  scene.clouds.push_back(cube(0.2F, Vec3f(0, 1, 0), glm::scale(Mat4d(1.0), Vec3d(0.25))));
  const auto ring = hexRing({4, 40, 4, 2.0, 3.0, 1.0}).mesh();
  TransferFunction red;
  red.knots = {{0.0, Vec4f(1, 0, 0, 0.2F)}};
  CloudObject outer = volumeOf(ring, std::vector<double>(ring->pointCount(), 0.0), red);
  outer.toWorld = glm::translate(Mat4d(1.0), Vec3d(0, 0, -0.5));
  scene.clouds.push_back(outer);
  Camera camera = lookAt({20, 0.01, 0.02}, Vec3d(0.0), 20.0);
  const Film film = traced(scene, camera);
  const double part = 1.0 - none; // each is passed for a length of about 1
  const float* c = at(film, 16, 16);
  EXPECT_NEAR(c[0], part + none * none * part, 2e-3);
  EXPECT_NEAR(c[1], none * part, 2e-3);
}

TEST(VolumeScene, IsoSurfacesAreOpaqueAndHaveDepthNormalAndCell)
{
  HexCells cells = hexBlock(4, 4, 4);
  cells.move([](const Vec3d& p) { return p - Vec3d(2.0); });
  const auto mesh = cells.mesh();
  TransferFunction f;
  f.knots = {{-2.0, Vec4f(1, 0, 0, 0)}, {2.0, Vec4f(0, 1, 0, 0)}};
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.z; }), f);
  volume.id = 7;
  Scene scene;
  scene.surfaces = {isoSurfacesOf(volume, {0.5})};
  for (const bool cloud : {true, false}) // which is clear
  {
    scene.clouds.assign(cloud ? 1 : 0, volume);
    const Film film = traced(scene, along());
    const std::size_t pixel = 16 * 33 + 16;
    EXPECT_NEAR(film.depth()[pixel], 19.5, 1e-5);
    EXPECT_EQ(film.object()[pixel], 7);
    EXPECT_LT(film.id()[pixel], mesh->cellCount());
    EXPECT_NEAR(film.normal()[3 * pixel + 2], 1.0, 1e-6);
    EXPECT_NEAR(at(film, 16, 16)[0], 0.375, 1e-5); // faces the headlight
    EXPECT_NEAR(at(film, 16, 16)[1], 0.625, 1e-5);
    EXPECT_NEAR(at(film, 16, 16)[3], 1.0, 1e-6);
    EXPECT_EQ(film.depth()[0], INFINITY);
  }
  // Particles before and behind it.
  Particles particles;
  particles.add(Vec3d(0.0, 0.0, 1.5), 0.5);
  particles.add(Vec3d(0.0, 1.0, -1.0), 0.5);
  addTo(scene, objectOf(particles));
  const Film film = traced(scene, along());
  EXPECT_EQ(film.object()[16 * 33 + 16], 1);
  EXPECT_NEAR(film.depth()[16 * 33 + 16], 18.0, 1e-5);
  EXPECT_EQ(film.object()[21 * 33 + 16], 7);
  EXPECT_NEAR(film.depth()[21 * 33 + 16], 19.5, 1e-5);
}

TEST(VolumeScene, IsoSurfacesTakeShadowsAndOcclusion)
{
  HexCells cells = hexBlock(8, 8, 4);
  cells.move([](const Vec3d& p) { return p - Vec3d(4.0, 4.0, 2.0); });
  const auto mesh = cells.mesh();
  Scene scene;
  scene.surfaces = {isoSurfacesOf(
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.z; }), evenTransfer(0.5F)),
    {0.0})};
  Particles particles;
  particles.add(Vec3d(1.5, 0.0, 1.0), 0.5);
  addTo(scene, objectOf(particles));
  Light light;
  light.kind = Light::Kind::Directional;
  light.vector = Vec3d(-1, 0, -1);
  light.shadows = true;
  scene.lights = {light};
  const Film lit = traced(scene, along());
  EXPECT_EQ(at(lit, 19, 16)[0], 0.0f); // where the sphere's shadow falls: x = 0.5
  EXPECT_NEAR(at(lit, 16, 24)[0], std::sqrt(0.5), 1e-5);
  scene.lights.clear();
  scene.surfaces[0].material.ambient = 1.0f;
  scene.occlusion = {64, 4.0};
  const Film dark = traced(scene, along(), 4);
  EXPECT_LT(at(dark, 22, 16)[0], 0.95f);
  EXPECT_GT(at(dark, 5, 5)[0], 0.99f);
}

TEST(VolumeScene, CloudsAreLitByTheirGradient)
{
  HexCells cells = hexBlock(4, 4, 4);
  cells.move([](const Vec3d& p) { return p - Vec3d(2.0); });
  const auto mesh = cells.mesh();
  for (const VolumeIntegrator integrator :
    {VolumeIntegrator::Trilinear, VolumeIntegrator::CellByCell})
  {
    Scene scene;
    scene.clouds.push_back(volumeOf(
      mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x + p.z; }), evenTransfer(0.2F)));
    scene.clouds[0].shade = true;
    scene.clouds[0].sampling.integrator = integrator;
    scene.clouds[0].material.ambient = 0.1f;
    scene.clouds[0].material.diffuse = 0.8f;
    const Film film = traced(scene, along());
    const double alpha = 1.0 - std::pow(none, 4.0);
    EXPECT_NEAR(at(film, 16, 16)[0], alpha * (0.1 + 0.8 * std::sqrt(0.5)), 1e-5);
    EXPECT_NEAR(at(film, 16, 16)[3], alpha, 1e-5);
  }
}

TEST(VolumeScene, NearLightsCountInTheMiddleOfEachCell)
{
  HexCells cells = hexBlock(4, 4, 4);
  cells.move([](const Vec3d& p) { return p - Vec3d(2.0); });
  const auto mesh = cells.mesh();
  const Vec3d light(1.5, -0.5, 2.6), normal = glm::normalize(Vec3d(1.0, 0.0, 1.0));
  const double x = -3.0 + 19.5 * 6.0 / 33.0; // of the ray, and its y
  double wanted = 0.0, passed = 1.0;
  for (const double z : {1.5, 0.5, -0.5, -1.5})
  {
    const double cosine = glm::dot(normal, glm::normalize(light - Vec3d(x, x, z)));
    wanted += passed * (1.0 - none) * (0.1 + 0.7 * std::max(0.0, cosine));
    passed *= none;
  }
  for (const bool isWalked : {false, true})
  {
    Scene scene;
    scene.clouds.push_back(volumeOf(
      mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x + p.z; }), evenTransfer(0.2F)));
    scene.clouds[0].sampling.integrator = VolumeIntegrator::CellByCell;
    if (isWalked)
      addWalk(scene.clouds[0]);
    scene.clouds[0].shade = true;
    scene.clouds[0].material.ambient = 0.1f;
    scene.clouds[0].material.diffuse = 0.7f;
    scene.lights = {{Light::Kind::Point, light, Vec3f(1.0f)}};
    EXPECT_NEAR(at(traced(scene, along()), 19, 19)[0], wanted, 1e-5) << isWalked;
  }
}

TEST(VolumeScene, EvenPlacesHaveNoNormalAndTakeAllLight)
{
  for (const float ambient : {0.1f, 0.75f})
  {
    Scene scene;
    scene.clouds.push_back(cube(0.2F, Vec3f(1.0f)));
    scene.clouds[0].shade = true;
    scene.clouds[0].material.ambient = ambient;
    scene.clouds[0].material.diffuse = 0.5f;
    const double alpha = 1.0 - std::pow(none, 4.0);
    EXPECT_NEAR(at(traced(scene, along()), 16, 16)[0], alpha * std::min(1.0, ambient + 0.5), 1e-5);
  }
}

TEST(VolumeScene, BoundsAndThreadsAndBundles)
{
  Scene scene;
  scene.clouds.push_back(cube(0.2F, Vec3f(1, 0, 0), glm::translate(Mat4d(1.0), Vec3d(5, 0, 0))));
  EXPECT_EQ(scene.bounds().lower, Vec3d(3, -2, -2));
  EXPECT_EQ(scene.bounds().upper, Vec3d(7, 2, 2));
  scene.clouds.push_back(cube(0.3F, Vec3f(0, 1, 0)));
  const Camera camera = lookAt({12, 9, 15}, Vec3d(2, 0, 0), 40.0);
  const Film film = traced(scene, camera, 2);
  for (const int side : {2, 16})
  {
    Film other;
    other.resize(33, 33);
    RayCaster caster(scene);
    caster.setThreads(1);
    caster.setBundleSide(side);
    caster.addSample(camera, other);
    caster.addSample(camera, other);
    for (std::size_t i = 0; i < 4 * film.pixels(); ++i)
      EXPECT_EQ(film.color()[i], other.color()[i]);
  }
}

TEST(VolumeScene, PathsAreBehindClouds)
{
  Scene scene;
  Particles particles;
  particles.add(Vec3d(0.0), 1.0);
  addTo(scene, objectOf(particles));
  scene.surfaces[0].coloring.constant = Vec4f(1.0f);
  scene.paths.bounces = 1;
  scene.lights.clear();
  const double open = at(traced(scene, along(), 4), 16, 16)[1]; // a white sphere under a white sky
  EXPECT_NEAR(open, 1.0, 1e-2);
  scene.clouds.push_back(cube(0.2F, Vec3f(0.0f)));
  const Film film = traced(scene, along(), 4);
  EXPECT_NEAR(at(film, 16, 16)[1], none * open, 1e-3); // samples beside the middle pass more of it
  EXPECT_NEAR(at(film, 16, 16)[3], 1.0, 1e-6);
}

TEST(VolumeScene, FilmsAreTheSameWhateverTheStructureAndTheBundles)
{
  const auto mesh = hexRing({6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3}).mesh();
  const auto values = pointValues(
    *mesh, [](const Vec3d& p) { return std::sin(3.0 * p.x) * std::cos(2.0 * p.y) + p.z; });
  TransferFunction f;
  f.knots = {{-0.5, Vec4f(0, 0.2F, 1, 0.9F)}, {0.3, Vec4f(1, 1, 0, 0)}, {0.8, Vec4f(1, 1, 1, 0)},
    {1.5, Vec4f(1, 0, 0, 1)}};
  const auto film = [&](HexStructureKind kind, VolumeIntegrator integrator, const Camera& camera,
                      double saturation, int side, bool isLit)
  {
    Scene scene;
    CloudObject volume = volumeOf(mesh, values, f, kind);
    volume.sampling.integrator = integrator;
    volume.sampling.saturation = saturation;
    volume.shade = isLit;
    scene.clouds.push_back(volume);
    if (isLit) // behind and within it, with a surface
    {
      volume.toWorld = glm::translate(Mat4d(1.0), Vec3d(0.4, 0.3, -0.5));
      scene.surfaces.push_back(isoSurfacesOf(volume, {1.0}));
      scene.clouds.push_back(volume);
    }
    Film film;
    film.resize(50, 37);
    RayCaster caster(scene);
    caster.setBundleSide(side);
    for (int k = 0; k < 2; ++k)
      EXPECT_TRUE(caster.addSample(camera, film));
    return std::vector<float>(film.color(), film.color() + 4 * film.pixels());
  };
  Camera flat = lookAt({3, 2, 5}, Vec3d(0.0), 50.0);
  flat.projection = Camera::Projection::Orthographic;
  flat.parallelScale = 2.5;
  for (const Camera& camera :
    {flat, lookAt({3, 2, 5}, Vec3d(0.0), 50.0), lookAt({1.4, 0.3, 0.7}, Vec3d(0.0), 120.0)})
    for (const auto integrator : {VolumeIntegrator::CellByCell, VolumeIntegrator::Trilinear})
      for (const double saturation : {0.5, 1.0})
        for (const bool isLit : {false, true})
        {
          const auto one =
            film(HexStructureKind::CylindricalBvh, integrator, camera, saturation, 8, isLit);
          EXPECT_GT(*std::max_element(one.begin(), one.end()), 0.1F);
          for (const int side : {0, 4, 8, 16})
          {
            const auto other =
              film(HexStructureKind::CartesianBvh, integrator, camera, saturation, side, isLit);
            // Surfaces lie where their bundle's numbers put them: the same to the last bit for the
            // same bundles, else to rounding.
            const float most = isLit && side != 8 ? 2e-6F : 0.0F;
            ASSERT_EQ(one.size(), other.size());
            for (std::size_t i = 0; i < one.size(); ++i)
              ASSERT_LE(std::abs(one[i] - other[i]), most) << "side " << side;
          }
        }
}
