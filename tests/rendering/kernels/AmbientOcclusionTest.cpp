// The open share of the sky against closed forms and against brute force.

#include "ShadowParts.h"

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Makes red the open share of the sky.
void showOpenness(Scene& scene, int rays, double reach)
{
  for (SurfaceObject& object : scene.surfaces)
  {
    object.material.ambient = 1.0f;
    object.material.diffuse = 0.0f;
  }
  scene.lights.clear();
  scene.occlusion = {rays, reach};
}

/// Errors of red against what is wanted at the middle of each pixel that hits something.
struct Errors
{
  int pixels = 0;
  double mean = 0.0, rms = 0.0, most = 0.0;
};

using Wanted = std::function<double(const ScenePick&)>;

Errors errorsOf(const Scene& scene, const Camera& camera, int size, const Wanted& wanted)
{
  const Film film = tracedFilm(scene, camera, size);
  const CameraRays rays(camera, size, size);
  Errors errors;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
    {
      const auto at =
        pick(scene, rays.originAt(x + 0.5, y + 0.5), rays.directionAt(x + 0.5, y + 0.5));
      if (!at)
        continue;
      const double error =
        film.color()[4 * (std::size_t(y) * std::size_t(size) + std::size_t(x))] - wanted(*at);
      ++errors.pixels;
      errors.mean += error;
      errors.rms += error * error;
      errors.most = std::max(errors.most, std::abs(error));
    }
  errors.mean /= errors.pixels;
  errors.rms = std::sqrt(errors.rms / errors.pixels);
  return errors;
}

/// Two spheres, and the open share of either.
Scene pairOf(double radius, double otherRadius, double gap = 0.0)
{
  Particles particles;
  particles.add(Vec3d(0.0), radius);
  particles.add({radius + otherRadius + gap, 0.0, 0.0}, otherRadius);
  Scene scene;
  addTo(scene, objectOf(particles));
  return scene;
}

Wanted openBeside(double radius, double otherRadius, double gap = 0.0)
{
  return [=](const ScenePick& at)
  {
    const Vec3d other(radius + otherRadius + gap, 0.0, 0.0);
    return 1.0 - (at.id == 0 ? occlusionBySphere(at.position, at.normal, other, otherRadius)
                             : occlusionBySphere(at.position, at.normal, Vec3d(0.0), radius));
  };
}

/// The open share by brute force: 64 x 64 directions, every sphere of every object.
double bruteForceOpen(
  const Scene& scene, const std::vector<Particles>& objects, const ScenePick& at, double reach)
{
  Vec3d u, v;
  acrossAxes(at.normal, u, v);
  constexpr int side = 64;
  int open = 0;
  for (int i = 0; i < side * side; ++i)
  {
    const double share = (i % side + 0.5) / side, angle = 2.0 * M_PI * (i / side + 0.5) / side;
    const Vec3d way = std::sqrt(share) * (std::cos(angle) * u + std::sin(angle) * v) +
                      std::sqrt(1.0 - share) * at.normal;
    reference::Hit hit;
    for (std::size_t k = 0; k < objects.size() && !hit; ++k)
    {
      const Mat4d toLocal = glm::inverse(scene.surfaces[k].toWorld);
      const reference::Ray ray{
        transformPoint(toLocal, at.position), transformVector(toLocal, way), 0.0, reach};
      for (const reference::Sphere& sphere : reference::validSpheres(objects[k].set()))
        if (k != std::size_t(at.object) || sphere.particle != at.id)
          reference::meet(ray, sphere, hit);
    }
    open += !hit;
  }
  return double(open) / (side * side);
}

} // namespace

TEST(AmbientOcclusion, ALoneSphereIsOpenEverywhere)
{
  Random random(501);
  for (int k = 0; k < 12; ++k)
  {
    const double radius = std::pow(10.0, random(-6.0, 6.0));
    Scene scene = oneSphere(radius);
    scene.surfaces[0].toWorld =
      glm::scale(glm::translate(Mat4d(1.0), 5.0 * radius * random.direction()),
        k % 2 == 0 ? Vec3d(1.0) : random.inBox(Vec3d(0.5), Vec3d(1.5)));
    showOpenness(scene, 16, infinity);
    const Film film = tracedFilm(
      scene, lookAt(9.0 * radius * random.direction(), scene.bounds().center(), 30.0), 60);
    for (std::size_t i = 0; i < film.pixels(); ++i)
      EXPECT_EQ(film.color()[4 * i], film.color()[4 * i + 3]);
  }
}

TEST(AmbientOcclusion, GlassKeepsNothingOfTheSky)
{
  const auto openest = [](float opacity, bool castsShadows, std::optional<float> backOpacity)
  {
    Particles lit, other;
    lit.add(Vec3d(0.0), 1.0);
    other.add({2.1, 0.0, 0.0}, 1.0);
    Scene scene;
    addTo(scene, objectOf(lit));
    addTo(scene, objectOf(other));
    scene.surfaces[1].material.opacity = opacity;
    scene.surfaces[1].backOpacity = backOpacity;
    scene.surfaces[1].castsShadows = castsShadows;
    showOpenness(scene, 64, infinity);
    // What looks at the other sphere, and does not see it.
    const Film film = tracedFilm(scene, lookAt({1.1, 0.0, 0.0}, Vec3d(0.0), 5.0), 8);
    double open = 0.0;
    for (std::size_t i = 0; i < film.pixels(); ++i)
      open += film.color()[4 * i] / static_cast<double>(film.pixels());
    return open;
  };
  const double occluded = openest(1.0f, true, {});
  EXPECT_LT(occluded, 0.5);
  EXPECT_EQ(openest(1.0f, false, {}), occluded) << "what is opaque keeps the sky's light";
  EXPECT_EQ(openest(0.5f, true, {}), occluded) << "so does what casts shadows";
  EXPECT_EQ(openest(0.0f, false, 1.0f), occluded) << "and what is clear from one side alone";
  EXPECT_EQ(openest(0.5f, false, {}), 1.0);
}

TEST(AmbientOcclusion, TouchingSpheresHaveTheirFormFactor)
{
  Scene scene = pairOf(1.0, 1.0);
  showOpenness(scene, 1024, infinity);
  for (const Vec3d& eye : {Vec3d(1.0, 1.0, 9.0), Vec3d(6.0, 2.0, 7.0), Vec3d(1.0, -9.0, 0.5)})
  {
    const Errors errors =
      errorsOf(scene, lookAt(eye, {1.0, 0.0, 0.0}, 28.0), 40, openBeside(1.0, 1.0));
    EXPECT_GT(errors.pixels, 300);
    EXPECT_LT(errors.rms, 2e-3);
    EXPECT_LT(errors.most, 0.015);
    EXPECT_LT(std::abs(errors.mean), 1e-4);
  }
}

TEST(AmbientOcclusion, ASphereNearALargeOneHasItsFormFactor)
{
  for (const double gap : {0.0, 0.3, 2.0})
  {
    Scene scene = pairOf(0.5, 20.0, gap);
    showOpenness(scene, 1024, infinity);
    const Camera camera = lookAt({-3.0, 4.0, 5.0}, {0.5, 0.0, 0.0}, 40.0);
    const Errors errors = errorsOf(scene, camera, 40, openBeside(0.5, 20.0, gap));
    EXPECT_GT(errors.pixels, 300);
    EXPECT_LT(errors.rms, 2e-3);
    EXPECT_LT(std::abs(errors.mean), 1e-4);
  }
}

TEST(AmbientOcclusion, ErrorFallsWithTheNumberOfRays)
{
  Scene scene = pairOf(1.0, 1.0);
  const Camera camera = lookAt({6.0, 2.0, 7.0}, {1.0, 0.0, 0.0}, 28.0);
  double before = infinity;
  for (const int rays : {1, 4, 16, 64, 256})
  {
    showOpenness(scene, rays, infinity);
    const Errors errors = errorsOf(scene, camera, 64, openBeside(1.0, 1.0));
    std::printf("%4d rays: rms error %.4f, mean error %+.5f\n", rays, errors.rms, errors.mean);
    EXPECT_LT(errors.rms, 0.45 * before); // random rays: 0.5
    EXPECT_LT(std::abs(errors.mean), 4.0 * errors.rms / std::sqrt(errors.pixels));
    before = errors.rms;
  }
}

TEST(AmbientOcclusion, ManyFilmSamplesDoWhatManyRaysDo)
{
  Scene scene = pairOf(1.0, 1.0);
  const Camera camera = lookAt({6.0, 2.0, 7.0}, {1.0, 0.0, 0.0}, 28.0);
  showOpenness(scene, 32, infinity);
  const Film wanted = tracedFilm(scene, camera, 48, 48, {128, 0, 0});
  double before = infinity;
  for (const int samples : {1, 8, 64})
  {
    showOpenness(scene, 3, infinity);
    Film film = tracedFilm(scene, camera, 48, 48, {samples, 0, 0});
    // Edges are antialiased differently: their colour is taken without its coverage.
    for (std::size_t i = 0; i < film.pixels(); ++i)
      if (wanted.color()[4 * i + 3] < 1.0f || film.color()[4 * i + 3] < 1.0f)
        std::copy_n(wanted.color() + 4 * i, 4, film.color() + 4 * i);
    const double rms = rmsOf(film, wanted);
    EXPECT_LT(rms, 0.4 * before) << samples; // independent samples: 0.35
    before = rms;
  }
  EXPECT_LT(before, 0.02);
}

TEST(AmbientOcclusion, ErrorsOfNeighboursAreIndependent)
{
  // No pattern in the picture: of pixels, of their bundles or of rows.
  Scene scene = pairOf(0.5, 20.0, 0.1);
  showOpenness(scene, 4, infinity);
  Camera camera = lookAt({0.2, 3.0, 0.0}, {0.2, 0.0, 0.0}, 2.0);
  camera.up = {0.0, 0.0, 1.0};
  const int size = 64;
  const Film film = tracedFilm(scene, camera, size);
  const CameraRays rays(camera, size, size);
  std::vector<double> errors;
  const Wanted wanted = openBeside(0.5, 20.0, 0.1);
  for (int i = 0; i < size * size; ++i)
  {
    const double x = i % size + 0.5, y = i / size + 0.5;
    const auto at = pick(scene, rays.originAt(x, y), rays.directionAt(x, y));
    ASSERT_TRUE(at.has_value());
    errors.push_back(film.color()[4 * std::size_t(i)] - wanted(*at));
  }
  double variance = 0.0;
  for (const double error : errors)
    variance += error * error;
  ASSERT_GT(variance, 1.0);
  for (const int apart : {1, 2, 4, 8, 16, size, 2 * size, 4 * size, 16 * size})
  {
    double product = 0.0;
    for (std::size_t i = std::size_t(apart); i < errors.size(); ++i)
      product += errors[i] * errors[i - std::size_t(apart)];
    EXPECT_LT(std::abs(product / variance), 4.0 / size) << apart; // 4 standard errors
  }
}

TEST(AmbientOcclusion, RandomSpheresAgreeWithBruteForce)
{
  for (int k = 0; k < 4; ++k)
  {
    Random random(511 + std::uint64_t(k));
    std::vector<Particles> objects;
    Scene scene;
    for (int object = 0; object < 2; ++object)
    {
      objects.push_back(randomParticles(40, 521 + std::uint64_t(2 * k + object), 0.1, 0.3));
      Mat4d m = glm::translate(Mat4d(1.0), random.inBox(Vec3d(-0.5), Vec3d(0.5)));
      if (k % 2 == 1)
        m = glm::scale(glm::rotate(m, random(0.0, 6.0), random.direction()), Vec3d(0.6, 1.0, 1.4));
      addTo(scene, objectOf(objects.back(), m));
    }
    const double reach = k < 2 ? infinity : 0.4;
    showOpenness(scene, 1024, reach);
    const Errors errors = errorsOf(scene, lookAt(4.0 * random.direction(), Vec3d(0.0), 35.0), 13,
      [&](const ScenePick& at) { return bruteForceOpen(scene, objects, at, reach); });
    EXPECT_GT(errors.pixels, 50);
    EXPECT_LT(errors.rms, 6e-3);
    EXPECT_LT(errors.most, 0.03);
    EXPECT_LT(std::abs(errors.mean), 2e-3);
  }
}

TEST(AmbientOcclusion, CoincidentSpheresDoNotDarkenOneAnother)
{
  for (int k = 0; k < 4; ++k)
  {
    const Particles particles = randomParticles(50, 531 + std::uint64_t(k), 0.1, 0.3);
    Particles doubled = particles;
    for (std::size_t i = 0; i < particles.size(); ++i)
      doubled.add(particles.center(i), particles.radii[i]);
    Scene once, twice, apart;
    const Mat4d toWorld = glm::scale(Mat4d(1.0), Vec3d(0.6, 1.0, 1.4));
    once.surfaces = {objectOf(particles, toWorld)};
    twice.surfaces = {objectOf(doubled, toWorld)};
    apart.surfaces = {objectOf(particles, toWorld), objectOf(particles, toWorld)};
    for (Scene* scene : {&once, &twice, &apart})
      showOpenness(*scene, 8, 0.5);
    const Camera camera = lookAt({1.0, 2.0, 4.0}, Vec3d(0.0), 40.0);
    const Film wanted = tracedFilm(once, camera, 100);
    for (const Scene* scene : {&twice, &apart})
      EXPECT_LE(differenceOf(wanted, tracedFilm(*scene, camera, 100)).pixels, 3);
  }
}

TEST(AmbientOcclusion, FromWithinItsOwnSphereIsBeforeTheSurface)
{
  // In a unit sphere a ray at cosine c to the normal goes 2 c far: reach 1 leaves c > 1/2, 3/4.
  Scene scene = oneSphere();
  const Camera camera = lookAt({0.1, 0.2, 0.0}, {0.0, 0.0, -1.0}, 60.0);
  for (const auto& [reach, open] : {std::pair{1.0, 0.75}, {0.5, 15.0 / 16.0}, {infinity, 0.0}})
  {
    showOpenness(scene, 256, reach);
    const Errors errors =
      errorsOf(scene, camera, 20, [open = open](const ScenePick&) { return open; });
    EXPECT_EQ(errors.pixels, 400);
    EXPECT_LT(errors.most, 0.03);
    EXPECT_LT(std::abs(errors.mean), 1e-3);
  }
}

TEST(AmbientOcclusion, OnlyAmbientLightIsDarkened)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(200, 541, 0.05, 0.2)));
  const Camera camera = lookAt({1.0, 2.0, 4.0}, Vec3d(0.0), 40.0);
  showOpenness(scene, 16, 0.5);
  const Film sky = tracedFilm(scene, camera, 80);
  Material& material = scene.surfaces[0].material;
  material.ambient = 0.0f;
  material.diffuse = 0.6f;
  scene.lights = {shadowLight(Light::Kind::Point, {2.0, 3.0, 3.0}, 2, 0.5)};
  const Film direct = tracedFilm(scene, camera, 80);
  material.ambient = 0.3f;
  const Film both = tracedFilm(scene, camera, 80);
  for (std::size_t i = 0; i < both.pixels(); ++i)
    EXPECT_NEAR(both.color()[4 * i], direct.color()[4 * i] + 0.3f * sky.color()[4 * i], 1e-5f);
}

TEST(AmbientOcclusion, BundlesAndThreadsDoNotChangeThePicture)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(500, 551, 0.03, 0.1)));
  showOpenness(scene, 5, 0.0);
  const Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  const Film wanted = tracedFilm(scene, camera, 90, 70, {2, 1, 0});
  const Film threads = tracedFilm(scene, camera, 90, 70, {2, 2, 0});
  EXPECT_TRUE(std::equal(wanted.color(), wanted.color() + 4 * wanted.pixels(), threads.color()));
  for (const int side : {2, 4, 8, 16})
    EXPECT_LE(differenceOf(wanted, tracedFilm(scene, camera, 90, 70, {2, 1, side})).pixels, 10);
}

TEST(AmbientOcclusion, ReachIsInWorldUnitsAndBoundsTheRays)
{
  Scene scene = pairOf(1.0, 1.0, 0.5); // 4.5 long
  EXPECT_DOUBLE_EQ(occlusionReach(scene), 0.45);
  scene.surfaces[0].toWorld = glm::scale(Mat4d(1.0), Vec3d(10.0));
  EXPECT_DOUBLE_EQ(occlusionReach(scene), 4.5);
  scene.occlusion.reach = 7.0;
  EXPECT_EQ(occlusionReach(scene), 7.0);
  // The gap is 5 in the world: a shorter reach finds all open, a longer one does not.
  const Camera camera = lookAt({22.0, 40.0, 80.0}, {22.0, 0.0, 0.0}, 40.0);
  const auto darkPixels = [&](double reach)
  {
    showOpenness(scene, 64, reach);
    const Film film = tracedFilm(scene, camera, 64);
    int dark = 0;
    for (std::size_t i = 0; i < film.pixels(); ++i)
      dark += film.color()[4 * i] < film.color()[4 * i + 3];
    return dark;
  };
  EXPECT_EQ(darkPixels(4.9), 0);
  EXPECT_GT(darkPixels(8.0), 10);
}

TEST(AmbientOcclusion, ScenesFarFromTheOriginKeepTheirs)
{
  const Particles particles = randomParticles(300, 561, 0.05, 0.2);
  Scene here;
  here.surfaces.push_back(objectOf(particles));
  showOpenness(here, 8, 0.5);
  Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  const Film wanted = tracedFilm(here, camera, 80);
  const Vec3d by(6e5, -5e5, 3e5);
  Scene there = here;
  there.surfaces[0].toWorld = glm::translate(Mat4d(1.0), by);
  camera.position += by;
  EXPECT_LE(differenceOf(wanted, tracedFilm(there, camera, 80)).pixels, 20);
}
