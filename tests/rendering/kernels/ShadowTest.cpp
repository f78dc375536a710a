// Shadows against brute force: every pixel of small scenes, in long double.

#include "ShadowParts.h"

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr auto point = Light::Kind::Point;
constexpr auto directional = Light::Kind::Directional;

/// Shadows must be found in plenty, and nearly everywhere without doubt.
void expectRight(const ShadowReport& report, double doubtful = 0.02)
{
  EXPECT_EQ(report.wrong, 0) << report.complaint;
  EXPECT_GT(report.shadowed, report.pixels / 20);
  EXPECT_LE(report.ambiguous, doubtful * report.pixels);
  EXPECT_GT(report.pixels, 400);
}

/// A light that shines on what the eye sees from aside; both look at the origin.
Light lightFromAside(Random& random, int k, const Vec3d& eye, int samples = 1, double size = 0.0)
{
  const Vec3d aside = glm::normalize(glm::cross(eye, random.direction()));
  const Vec3d towards = glm::normalize(2.0 * aside + glm::normalize(eye));
  return k % 2 == 0 ? shadowLight(point, random(1.5, 4.0) * towards, samples, size)
                    : shadowLight(directional, -towards, samples, size);
}

} // namespace

TEST(Shadow, HardShadowsOfRandomParticlesAgreeWithBruteForce)
{
  for (int k = 0; k < 6; ++k)
  {
    Random random(201 + std::uint64_t(k));
    ShadowOracle oracle(2e-6);
    oracle.add(randomParticles(k < 3 ? 60 : 400, 211 + std::uint64_t(k), 0.03, 0.2));
    const Vec3d eye = 4.0 * random.direction();
    oracle.scene().lights = {lightFromAside(random, k, eye)};
    Camera camera = lookAt(eye, Vec3d(0.0), 40.0);
    camera.projection =
      k % 3 == 0 ? Camera::Projection::Orthographic : Camera::Projection::Perspective;
    camera.parallelScale = 1.3;
    expectRight(oracle.judge(camera, 67, 45));
  }
}

TEST(Shadow, LightsAmidTheParticlesAgreeWithBruteForce)
{
  // The hits surround the light, so that their bundles must be split.
  for (int k = 0; k < 4; ++k)
  {
    Random random(221 + std::uint64_t(k));
    ShadowOracle oracle(2e-6);
    oracle.add(randomParticles(150, 231 + std::uint64_t(k), 0.02, 0.1));
    oracle.scene().lights = {shadowLight(point, random.inBox(Vec3d(-0.6), Vec3d(0.6)))};
    expectRight(oracle.judge(lookAt(3.0 * random.direction(), Vec3d(0.0), 50.0), 61, 60));
  }
}

TEST(Shadow, ObjectsWithUnevenTransformsShadowOneAnother)
{
  for (int k = 0; k < 4; ++k)
  {
    Random random(241 + std::uint64_t(k));
    ShadowOracle oracle(3e-6);
    for (int object = 0; object < 3; ++object)
      oracle.add(randomParticles(60, 251 + std::uint64_t(3 * k + object), 0.03, 0.2),
        unevenTransform(random));
    const Vec3d eye = 4.0 * random.direction();
    oracle.scene().lights = {lightFromAside(random, k, eye)};
    expectRight(oracle.judge(lookAt(eye, Vec3d(0.0), 45.0), 50, 50));
  }
}

TEST(Shadow, SoftShadowsAgreeWithBruteForceSampleBySample)
{
  for (int k = 0; k < 4; ++k)
  {
    Random random(261 + std::uint64_t(k));
    ShadowOracle oracle(2e-6);
    oracle.add(randomParticles(80, 271 + std::uint64_t(k), 0.03, 0.2));
    const Vec3d eye = 4.0 * random.direction();
    oracle.scene().lights = {lightFromAside(random, k, eye, 2 + k, k % 2 == 0 ? 0.7 : 20.0)};
    expectRight(oracle.judge(lookAt(eye, Vec3d(0.0), 40.0), 40, 40), 0.1);
  }
}

TEST(Shadow, SeveralLightsCastTheirShadowsEach)
{
  ShadowOracle oracle(2e-6);
  oracle.add(randomParticles(100, 281, 0.03, 0.2));
  oracle.scene().lights = {shadowLight(point, {2.0, 1.0, 1.0}),
    shadowLight(directional, {1.0, -1.0, -0.2}), shadowLight(point, {-1.0, 2.0, 1.0}, 2, 0.3)};
  for (Light& light : oracle.scene().lights)
    light.color = Vec3f(1.0f);
  expectRight(oracle.judge(lookAt({1.0, 1.0, 4.0}, Vec3d(0.0), 40.0), 60, 60), 0.05);
}

TEST(Shadow, ATouchingLatticeHasNoSpeckles)
{
  Particles lattice;
  for (int i = 0; i < 512; ++i)
    lattice.add(0.25 * Vec3d(i % 8, i / 8 % 8, i / 64) - Vec3d(0.875), 0.125);
  for (const Light& light : {shadowLight(point, {1.0, 2.5, 3.0}),
         shadowLight(directional, {-0.3, -1.0, -0.6}), shadowLight(point, {1.2, 1.1, 1.0}, 2, 0.4)})
  {
    ShadowOracle oracle(2e-6);
    oracle.add(lattice);
    oracle.scene().lights = {light};
    expectRight(oracle.judge(lookAt({1.5, 2.0, 3.5}, Vec3d(0.0), 40.0), 96, 96));
  }
}

TEST(Shadow, ALoneSphereNeverShadowsItself)
{
  Random random(291);
  for (int k = 0; k < 12; ++k)
  {
    const double radius = std::pow(10.0, random(-6.0, 6.0));
    Scene scene = oneSphere(radius);
    const double distance = radius * (1.0 + std::pow(10.0, random(-4.0, 3.0)));
    scene.lights = {
      shadowLight(k % 2 == 0 ? point : directional, distance * random.direction(), 1 + k % 3, 0.0)};
    const Camera camera = lookAt(3.0 * radius * random.direction(), Vec3d(0.0), 45.0);
    const Film with = tracedFilm(scene, camera, 80);
    scene.lights[0].shadows = false;
    const Film without = tracedFilm(scene, camera, 80);
    const FilmDifference difference = differenceOf(with, without);
    EXPECT_EQ(difference.pixels, 0);
    EXPECT_LE(difference.rest, 1e-6);
  }
}

TEST(Shadow, CoincidentSpheresDoNotShadowOneAnother)
{
  for (int k = 0; k < 6; ++k)
  {
    Random random(401 + std::uint64_t(k));
    const Particles particles = randomParticles(50, 411 + std::uint64_t(k), 0.1, 0.3);
    Particles doubled = particles;
    for (std::size_t i = 0; i < particles.size(); ++i)
      doubled.add(particles.center(i), particles.radii[i]);
    const Vec3d eye = 4.0 * random.direction();
    Scene once, twice, apart;
    const Mat4d toWorld = unevenTransform(random);
    once.surfaces = {objectOf(particles, toWorld)};
    twice.surfaces = {objectOf(doubled, toWorld)};
    apart.surfaces = {objectOf(particles, toWorld), objectOf(particles, toWorld)};
    once.lights = twice.lights = apart.lights = {lightFromAside(random, k, eye)};
    const Camera camera = lookAt(eye, Vec3d(0.0), 45.0);
    const Film wanted = tracedFilm(once, camera, 150);
    for (const Scene* scene : {&twice, &apart})
    {
      const FilmDifference difference = differenceOf(wanted, tracedFilm(*scene, camera, 150));
      EXPECT_LE(difference.pixels, 1);
      EXPECT_LE(difference.rest, 1e-3);
    }
  }
}

TEST(Shadow, BundlesOfAnySideGiveTheSamePicture)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(3000, 301, 0.02, 0.08)));
  scene.lights = {shadowLight(point, {1.5, 3.0, 2.0}, 2, 0.5),
    shadowLight(directional, {-1.0, -1.0, -1.0}), shadowLight(point, {0.1, 0.2, 0.3})};
  for (Light& light : scene.lights)
    light.color = Vec3f(0.3f);
  const Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  const Film wanted = tracedFilm(scene, camera, 150, 101);
  for (const int side : {2, 4, 8, 16})
  {
    const FilmDifference difference =
      differenceOf(wanted, tracedFilm(scene, camera, 150, 101, {1, 0, side}));
    EXPECT_LE(difference.pixels, 10) << side; // at silhouettes and at the edges of shadows
    EXPECT_LE(difference.rest, 1e-2) << side;
  }
  RayCaster caster(scene);
  for (const int side : {-1, 1, 3, 32})
    EXPECT_THROW(caster.setBundleSide(side), std::exception);
}

TEST(Shadow, ThreadsDoNotChangeTheShadows)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(800, 311, 0.03, 0.1)));
  scene.lights = {
    shadowLight(point, {1.5, 3.0, 2.0}), shadowLight(directional, {-1.0, -1.0, -1.0}, 2, 5.0)};
  const Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  const Film one = tracedFilm(scene, camera, 120, 90, {2, 1, 0});
  const Film two = tracedFilm(scene, camera, 120, 90, {2, 2, 0});
  EXPECT_TRUE(std::equal(one.color(), one.color() + 4 * one.pixels(), two.color()));
}

TEST(Shadow, ScenesFarFromTheOriginKeepTheirs)
{
  const Particles particles = randomParticles(400, 321, 0.03, 0.15);
  for (const auto kind : {point, directional})
  {
    Scene here;
    here.surfaces.push_back(objectOf(particles));
    here.lights = {shadowLight(kind, kind == point ? Vec3d(1.5, 3.0, 2.0) : Vec3d(-1.0), 2, 0.4)};
    Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
    const Film wanted = tracedFilm(here, camera, 100);
    for (const double distance : {1e6, 1e9})
    {
      const Vec3d by = distance * Vec3d(0.6, -0.5, 0.3);
      Particles moved = particles;
      moved.move(by);
      Scene there = here;
      there.surfaces = {objectOf(moved)};
      there.lights[0].vector += kind == point ? by : Vec3d(0.0);
      Camera away = camera;
      away.position += by;
      FilmDifference difference = differenceOf(wanted, tracedFilm(there, away, 100));
      EXPECT_LE(difference.pixels, distance > 1e8 ? 20 : 3) << distance;
      // The same by a transform instead of by the particles' own numbers.
      there.surfaces = here.surfaces;
      there.surfaces[0].toWorld = glm::translate(Mat4d(1.0), by);
      difference = differenceOf(wanted, tracedFilm(there, away, 100));
      EXPECT_LE(difference.pixels, distance > 1e8 ? 20 : 3) << distance;
    }
  }
}
