// What lights with size send, and lights and eyes in odd places.

#include "ShadowParts.h"

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <set>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr auto point = Light::Kind::Point;
constexpr auto directional = Light::Kind::Directional;

/// A sphere of radius 0.1 hangs over one of radius 100 whose top is the origin.
struct Hanging
{
  Particles particles;
  Scene scene;
  static constexpr double height = 0.5, radius = 0.1, lightHeight = 1.5, edge = 0.3;

  Hanging()
  {
    particles.add({0.0, -100.0, 0.0}, 100.0);
    particles.add({0.0, height, 0.0}, radius);
    addTo(scene, objectOf(particles));
    // The middle of the bounds is far below: the square lies flat.
    scene.lights = {shadowLight(point, {0.0, lightHeight, 0.0}, 16, edge)};
  }

  /// Red at the point of the large sphere above (x, z), seen from aside.
  double lightAt(double x, double z, int samples = 1) const
  {
    const Vec3d at = 100.0 * glm::normalize(Vec3d(x, 100.0, z)) - Vec3d(0.0, 100.0, 0.0);
    const Camera camera = lookAt({0.3, 0.2, 2.0}, at, 1e-4);
    return tracedFilm(scene, camera, 1, 1, {samples, 1, 0}).color()[0];
  }

  /// The share of the light's square that the point sees, times the cosine, by brute force.
  double wantedAt(double x, double z) const
  {
    const Vec3d at = 100.0 * glm::normalize(Vec3d(x, 100.0, z)) - Vec3d(0.0, 100.0, 0.0);
    const Vec3d normal = (at + Vec3d(0.0, 100.0, 0.0)) / 100.0;
    const std::vector<reference::Sphere> spheres = {{particles.center(1), radius, 1}};
    double sum = 0.0;
    const int n = 256;
    for (int i = 0; i < n * n; ++i)
    {
      const Vec3d light(
        edge * ((i % n + 0.5) / n - 0.5), lightHeight, edge * ((i / n + 0.5) / n - 0.5));
      if (!reference::bruteForce(spheres, {light, at - light, 0.0, 1.0}))
        sum += glm::dot(normal, glm::normalize(light - at));
    }
    return sum / (n * n);
  }
};

bool isSane(const Film& film)
{
  for (std::size_t i = 0; i < 4 * film.pixels(); ++i)
    if (!(film.color()[i] >= 0.0f && film.color()[i] <= 1.0f))
      return false;
  return true;
}

} // namespace

TEST(ShadowLight, UmbraAndPenumbraEndWhereGeometrySays)
{
  // In the plane through the light's middle along one edge, points at the ground under height 0:
  // the sphere's tangents through the square's near and far side bound umbra and penumbra.
  const double h = Hanging::height, l = Hanging::lightHeight, half = 0.5 * Hanging::edge;
  const auto groundOf = [&](double from, double towards)
  {
    // The tangent from (from, l) past the sphere at (0, h), on the side `towards`, down to 0.
    const double way = std::hypot(from, l - h);
    const double angle = std::atan2(-from, l - h) + towards * std::asin(Hanging::radius / way);
    return from + l * std::tan(angle);
  };
  const double umbra = groundOf(half, 1.0), penumbra = groundOf(-half, 1.0);
  ASSERT_GT(umbra, 0.02);
  Hanging hanging;
  EXPECT_EQ(hanging.lightAt(0.0, 0.0), 0.0);
  EXPECT_EQ(hanging.lightAt(0.5 * umbra, 0.0), 0.0);
  EXPECT_GT(hanging.lightAt(umbra + 0.05 * (penumbra - umbra), 0.0), 0.0);
  EXPECT_LT(hanging.lightAt(umbra + 0.05 * (penumbra - umbra), 0.0), 0.1);
  const double inside = penumbra - 0.1 * (penumbra - umbra), outside = penumbra + 0.01;
  EXPECT_LT(hanging.lightAt(inside, 0.0), hanging.wantedAt(outside, 0.0) - 1e-3);
  EXPECT_NEAR(hanging.lightAt(outside, 0.0), hanging.wantedAt(outside, 0.0), 1e-4);
}

TEST(ShadowLight, PenumbraIsTheShareOfTheSquareThatIsSeen)
{
  Hanging hanging;
  Random random(331);
  double worst = 0.0, worstOfMany = 0.0;
  for (int k = 0; k < 40; ++k)
  {
    const double x = random(-0.3, 0.3), z = random(-0.3, 0.3);
    const double wanted = hanging.wantedAt(x, z);
    worst = std::max(worst, std::abs(hanging.lightAt(x, z) - wanted));
    worstOfMany = std::max(worstOfMany, std::abs(hanging.lightAt(x, z, 16) - wanted));
  }
  EXPECT_LT(worst, 0.02);        // 16 x 16 samples
  EXPECT_LT(worstOfMany, 0.003); // moved on with each of 16 film samples
}

TEST(ShadowLight, ErrorFallsWithTheNumberOfSamples)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(300, 341, 0.05, 0.15)));
  const Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  for (const auto kind : {point, directional})
  {
    scene.lights = {kind == point ? shadowLight(point, {1.5, 3.0, 2.0}, 32, 0.6)
                                  : shadowLight(directional, {-1.0, -2.0, -1.0}, 32, 10.0)};
    const Film wanted = tracedFilm(scene, camera, 96);
    double last = 1.0;
    for (const int samples : {1, 2, 4, 8})
    {
      scene.lights[0].samples = samples;
      const double error = rmsOf(tracedFilm(scene, camera, 96), wanted);
      std::cout << (kind == point ? "point" : "directional") << ' ' << samples << " x " << samples
                << " samples: RMS error " << error << '\n';
      EXPECT_LT(error, 0.65 * last) << samples;
      last = error;
    }
    EXPECT_LT(last, 0.01);
  }
}

TEST(ShadowLight, FarPointsAreDirections)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(300, 351, 0.05, 0.15)));
  const Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  const Vec3d towards = glm::normalize(Vec3d(1.0, 2.0, 1.0));
  for (const double distance : {1e5, 1e8})
    for (const int samples : {1, 3})
    {
      const Vec3d middle = scene.bounds().center();
      const double edge = 2.0 * distance * std::tan(2.5 * M_PI / 180.0);
      scene.lights = {shadowLight(directional, -towards, samples, 5.0)};
      const Film far = tracedFilm(scene, camera, 96);
      scene.lights = {shadowLight(point, middle + distance * towards, samples, edge)};
      const Film near = tracedFilm(scene, camera, 96);
      const FilmDifference difference = differenceOf(far, near);
      EXPECT_LE(difference.pixels, 5) << distance << ' ' << samples;
      EXPECT_LE(difference.rest, 1e-2);
    }
}

TEST(ShadowLight, SamplesFillTheSquareThatFacesTheScene)
{
  const Vec3d place(3.0, -1.0, 2.0), faced(0.5, 1.0, 0.0);
  const Vec3d normal = glm::normalize(faced - place);
  for (const int n : {2, 4, 8})
    for (const int filmSample : {0, 1, 7})
    {
      const auto samples = lightSamples(shadowLight(point, place, n, 0.5), faced, filmSample);
      ASSERT_EQ(samples.size(), std::size_t(n * n));
      Vec3d u, v;
      acrossAxes(normal, u, v);
      std::set<int> strata, columns, rows;
      double sumA = 0.0, sumB = 0.0;
      for (const LightSample& sample : samples)
      {
        const Vec3d from = sample.place - place;
        EXPECT_NEAR(glm::dot(from, normal), 0.0, 1e-12);
        const double a = glm::dot(from, u) / 0.5 + 0.5, b = glm::dot(from, v) / 0.5 + 0.5;
        ASSERT_GT(std::min(a, b), -1e-9);
        ASSERT_LT(std::max(a, b), 1.0 + 1e-9);
        columns.insert(int(std::round(a * n * n * 100.0)));
        rows.insert(int(std::round(b * n * n * 100.0)));
        sumA += a;
        sumB += b;
        if (filmSample == 0)
          strata.insert(int(a * n) + n * int(b * n));
      }
      // Every distance from an edge but once: an edge's shadow has n * n steps, not n.
      EXPECT_EQ(columns.size(), samples.size());
      EXPECT_EQ(rows.size(), samples.size());
      if (filmSample == 0)
      {
        EXPECT_EQ(strata.size(), samples.size());
        EXPECT_NEAR(sumA / (n * n), 0.5, 1e-9);
        EXPECT_NEAR(sumB / (n * n), 0.5, 1e-9);
      }
    }
}

TEST(ShadowLight, OneSampleStandsInTheMiddle)
{
  const Vec3d place(3.0, -1.0, 2.0);
  for (const int filmSample : {0, 5})
  {
    for (const Light& light :
      {shadowLight(point, place, 1, 0.5), shadowLight(point, place, 4, 0.0)})
    {
      const auto samples = lightSamples(light, Vec3d(0.0), filmSample);
      ASSERT_EQ(samples.size(), 1u);
      EXPECT_EQ(samples[0].place, place);
    }
    Light shadowless = shadowLight(directional, 1e200 * Vec3d(0.0, 0.0, -2.0), 4, 5.0);
    shadowless.shadows = false;
    const auto samples = lightSamples(shadowless, Vec3d(0.0), filmSample);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].place, Vec3d(0.0, 0.0, 1.0));
  }
}

TEST(ShadowLight, HeadlightsCastNone)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(100, 361, 0.05, 0.2)));
  const Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  const Film wanted = tracedFilm(scene, camera, 64);
  scene.lights[0].shadows = true;
  scene.lights[0].samples = 4;
  scene.lights[0].size = 1.0;
  const Film found = tracedFilm(scene, camera, 64);
  EXPECT_TRUE(std::equal(wanted.color(), wanted.color() + 4 * wanted.pixels(), found.color()));
}

TEST(ShadowLight, ShadowTakesHighlightsAndLeavesAmbientLight)
{
  Particles particles;
  particles.add({0.0, 0.0, 0.0}, 1.0);
  particles.add({0.0, 3.0, 3.0}, 0.9); // between the light and the top of the first
  Scene scene;
  addTo(scene, objectOf(particles));
  Material& material = scene.surfaces[0].material;
  material.ambient = 0.2f;
  material.diffuse = 0.3f;
  material.specular = 0.5f;
  material.specularPower = 3.0f;
  scene.lights = {shadowLight(point, {0.0, 6.0, 6.0})};
  const Camera camera = lookAt({5.0, 2.0, 2.0}, {0.0, M_SQRT1_2, M_SQRT1_2}, 1e-3);
  EXPECT_NEAR(tracedFilm(scene, camera, 1).color()[0], 0.2f, 1e-6f);
  scene.lights[0].shadows = false;
  EXPECT_GT(tracedFilm(scene, camera, 1).color()[0], 0.4f);
  // However little of the other is seen: what lets light through casts a full shadow.
  scene.lights[0].shadows = true;
  Scene apart = scene;
  Particles first, second;
  first.add(particles.center(0), 1.0);
  second.add(particles.center(1), 0.9);
  apart.surfaces = {objectOf(first), objectOf(second)};
  apart.surfaces[0].material = material;
  apart.surfaces[1].material.opacity = 0.1f;
  EXPECT_NEAR(tracedFilm(apart, camera, 1).color()[0], 0.2f, 1e-6f);
}

TEST(ShadowLight, FromWithinASphereOnlyLightWithinIsSeen)
{
  Scene scene = oneSphere();
  Camera camera = lookAt({0.1, 0.2, 0.0}, {0.0, 0.0, -1.0}, 60.0);
  scene.lights = {shadowLight(point, {0.3, 0.4, 0.5})}; // inside: all is lit, as without shadows
  Film with = tracedFilm(scene, camera, 48);
  scene.lights[0].shadows = false;
  FilmDifference difference = differenceOf(with, tracedFilm(scene, camera, 48));
  EXPECT_EQ(difference.pixels, 0);
  EXPECT_LE(difference.rest, 1e-6);
  EXPECT_GT(with.color()[0], 0.1f);
  for (const Light& light :
    {shadowLight(point, {0.0, 0.5, 3.0}), shadowLight(directional, {0.0, -0.2, -1.0})})
  {
    scene.lights = {light};
    const Film dark = tracedFilm(scene, camera, 48);
    EXPECT_EQ(*std::max_element(dark.color(), dark.color() + 3), 0.0f);
    EXPECT_EQ(dark.color()[3], 1.0f);
  }
  // And what lies within shadows what lies behind it.
  Particles nested;
  nested.add(Vec3d(0.0), 1.0);
  nested.add({0.3, 0.3, 0.0}, 0.2);
  ShadowOracle oracle(2e-6);
  oracle.add(nested);
  oracle.scene().lights = {shadowLight(point, {0.5, 0.5, 0.5})};
  camera = lookAt({-0.5, 0.0, 0.2}, {0.3, 0.0, -0.3}, 120.0);
  const ShadowReport report = oracle.judge(camera, 48, 48);
  EXPECT_EQ(report.wrong, 0) << report.complaint;
  EXPECT_GT(report.shadowed, 50);
}

TEST(ShadowLight, LightsWithinASphereStayThere)
{
  Particles particles;
  particles.add(Vec3d(0.0), 1.0);
  particles.add({3.0, 0.0, 0.0}, 1.0);
  Scene scene;
  addTo(scene, objectOf(particles));
  scene.lights = {shadowLight(point, {0.5, 0.1, 0.0}, 2, 0.1)};
  const Film film = tracedFilm(scene, lookAt({1.5, 0.0, 9.0}, {1.5, 0.0, 0.0}, 40.0), 64);
  EXPECT_TRUE(isSane(film));
  for (std::size_t i = 0; i < film.pixels(); ++i)
    EXPECT_EQ(film.color()[4 * i], 0.0f);
}

TEST(ShadowLight, OddLightsGiveSanePictures)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(50, 371, 0.1, 0.3)));
  scene.surfaces[0].material.specular = 0.3f;
  scene.surfaces[0].material.specularPower = 7.0f;
  const Camera camera = lookAt({0.0, 0.0, 4.0}, Vec3d(0.0), 40.0);
  const double nan = std::nan(""), infinity = INFINITY;
  const Vec3d onSurface = pick(scene, camera.position, camera.forward).value().position;
  const auto middle = scene.bounds().center();
  std::vector<Light> lights;
  for (const Vec3d& place : {onSurface, middle, camera.position, Vec3d(1e30), Vec3d(nan, 0.0, 0.0),
         Vec3d(infinity, 0.0, 0.0), Vec3d(1e-300), Vec3d(1e300, 0.0, 0.0)})
    for (const double size : {0.0, 0.5, -1.0, nan, infinity, 1e4, 1e-30})
      for (const auto kind : {point, directional})
        lights.push_back(shadowLight(kind, place, 2, size));
  for (const int samples : {-3, 0, 100})
    lights.push_back(shadowLight(point, {1.0, 2.0, 3.0}, samples, 0.5));
  lights.push_back(shadowLight(directional, Vec3d(0.0)));
  for (const Light& light : lights)
  {
    scene.lights = {light};
    EXPECT_TRUE(isSane(tracedFilm(scene, camera, 17)))
      << light.vector.x << ' ' << light.size << ' ' << light.samples;
  }
}

TEST(ShadowLight, PointsOnBothSidesOfALightAreSeenEach)
{
  // Two hits in one bundle, seen from the light in opposite directions; a sphere hides one of them.
  for (const double side : {1.0, -1.0})
  {
    Particles particles;
    particles.add({-3.0, 0.0, 0.0}, 1.0);
    particles.add({3.0, 0.0, 0.0}, 1.0);
    particles.add({1.5 * side, 0.0, 1.1}, 0.1);
    Scene scene;
    addTo(scene, objectOf(particles));
    scene.lights = {shadowLight(point, {0.0, 0.0, 1.2})};
    Camera camera = lookAt({0.0, 0.0, 9.0}, Vec3d(0.0), 20.0);
    camera.projection = Camera::Projection::Orthographic;
    camera.parallelScale = 3.0;
    const Film film =
      tracedFilm(scene, camera, 2, 1); // the middles of the pixels lie at x = -3 and 3
    const float left = film.color()[0], right = film.color()[4];
    EXPECT_EQ(side > 0.0 ? right : left, 0.0f);
    EXPECT_NEAR(side > 0.0 ? left : right, 0.2 / std::hypot(3.0, 0.2), 1e-5);
  }
}

TEST(ShadowLight, ALightAtTheEyeSeesWhatTheEyeSees)
{
  // A point light in the eye casts shadows that nobody sees.
  Scene scene;
  addTo(scene, objectOf(randomParticles(500, 381, 0.02, 0.1)));
  const Camera camera = lookAt({1.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  const Film wanted = tracedFilm(scene, camera, 100);
  scene.lights = {shadowLight(point, camera.position)};
  const FilmDifference difference = differenceOf(wanted, tracedFilm(scene, camera, 100));
  EXPECT_LE(difference.pixels, 3);
  EXPECT_LE(difference.rest, 1e-5);
}
