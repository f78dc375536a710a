// Paths against closed forms: furnaces, an integrating sphere, and what local shading knows.

#include "ShadowParts.h"

#include <kernels/shading/Reflectance.h>
#include <kernels/shading/SampleSequence.h>
#include <kernels/tracing/Refinement.h>

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr auto point = Light::Kind::Point;
constexpr auto directional = Light::Kind::Directional;
const Vec3f black(0.0f);

/// Turns a scene to paths under an even sky, without lights.
void trace(Scene& scene, int bounces, float sky = 1.0f)
{
  scene.lights.clear();
  scene.paths.bounces = bounces;
  scene.sky.top = scene.sky.bottom = Vec3f(sky);
}

Scene randomSpheres(std::uint64_t seed, std::size_t count = 200)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(count, seed, 0.05, 0.25)));
  return scene;
}

/// Extremes and mean of red over alpha where the film is covered.
struct Range
{
  double least = INFINITY, most = -INFINITY, mean = 0.0;
  int pixels = 0;
};

Range rangeOf(const Film& film)
{
  Range range;
  for (std::size_t i = 0; i < film.pixels(); ++i)
    if (film.color()[4 * i + 3] > 0.0f)
    {
      const double red = film.color()[4 * i] / film.color()[4 * i + 3];
      range.least = std::min(range.least, red);
      range.most = std::max(range.most, red);
      range.mean += red;
      ++range.pixels;
    }
  range.mean /= std::max(1, range.pixels);
  return range;
}

const Camera camera = lookAt({1.0, 2.0, 4.0}, Vec3d(0.0), 40.0);

} // namespace

TEST(PathTracer, ALoneSphereInAFurnaceSendsBackItsAlbedo)
{
  Random random(701);
  for (int k = 0; k < 40; ++k)
  {
    const double radius = std::pow(10.0, random(-6.0, 6.0));
    const float albedo = k % 3 == 0 ? 1.0f : static_cast<float>(random());
    Scene scene = oneSphere(radius);
    trace(scene, 16);
    scene.surfaces[0].coloring.constant = Vec4f(Vec3f(albedo), 1.0f);
    scene.surfaces[0].toWorld =
      glm::scale(glm::translate(Mat4d(1.0), 5.0 * radius * random.direction()),
        k % 2 == 0 ? Vec3d(1.0) : random.inBox(Vec3d(0.5), Vec3d(1.5)));
    const double distance = radius * std::pow(10.0, random(1.0, 4.0));
    const Camera view = lookAt(scene.bounds().center() + distance * random.direction(),
      scene.bounds().center(), 200.0 * radius / distance);
    const Range range = rangeOf(tracedFilm(scene, view, 60, 60, {3, 0, 0}));
    EXPECT_GT(range.pixels, 50);
    EXPECT_NEAR(range.least, albedo, 1e-6);
    EXPECT_NEAR(range.most, albedo, 1e-6);
  }
}

TEST(PathTracer, WhiteSpheresVanishInAFurnace)
{
  // However often light goes to and fro, nothing is lost: all pixels are 1 from the first sample.
  Scene scene = randomSpheres(711);
  trace(scene, 1000);
  const Range range = rangeOf(tracedFilm(scene, camera, 100));
  EXPECT_GT(range.pixels, 3000);
  EXPECT_NEAR(range.least, 1.0, 1e-5);
  EXPECT_NEAR(range.most, 1.0, 1e-5);
}

TEST(PathTracer, EnergyIsNeverGained)
{
  for (const float metallic : {0.0f, 0.5f, 1.0f})
    for (const float roughness : {0.0f, 0.3f, 1.0f})
    {
      Scene scene = randomSpheres(721);
      trace(scene, 16);
      Material& material = scene.surfaces[0].material;
      material.metallic = metallic;
      material.roughness = roughness;
      material.diffuse = 5.0f; // which is 1 at most
      EXPECT_LE(rangeOf(tracedFilm(scene, camera, 60, 60, {4, 0, 0})).most, 1.0 + 1e-5);
    }
}

TEST(PathTracer, WhiteMetalLosesLittle)
{
  Scene scene = oneSphere();
  trace(scene, 16);
  Material& material = scene.surfaces[0].material;
  material.metallic = 1.0f;
  // The mean over the sphere's disc of the albedo of GGX with Smith's masking, by integration over
  // 200 x 200 directions at 10 cosines.
  for (const auto& [roughness, wanted] : {std::pair{0.0f, 1.0}, {0.5f, 0.8823}, {1.0f, 0.4098}})
  {
    material.roughness = roughness;
    const Range range = rangeOf(tracedFilm(scene, camera, 60, 60, {16, 0, 0}));
    EXPECT_NEAR(range.mean, wanted, 0.02) << roughness;
  }
}

TEST(PathTracer, ASmoothMetalMirrorsTheSky)
{
  Scene scene = oneSphere();
  trace(scene, 4);
  scene.sky = {Vec3f(1.0f), black, {0.0, 1.0, 0.0}};
  scene.surfaces[0].material.metallic = 1.0f;
  scene.surfaces[0].material.roughness = 0.0f;
  const int size = 40;
  const Film film = tracedFilm(scene, camera, size, size, {16, 0, 0});
  const CameraRays rays(camera, size, size);
  int pixels = 0;
  for (int i = 0; i < size * size; ++i)
  {
    const Vec3d way = rays.directionAt(i % size + 0.5, i / size + 0.5);
    const auto at = pick(scene, camera.position, way);
    if (!at || glm::dot(at->normal, glm::normalize(way)) > -0.3)
      continue; // towards the silhouette what is mirrored changes fast
    const Vec3d mirrored = glm::reflect(glm::normalize(way), at->normal);
    EXPECT_NEAR(film.color()[4 * i], 0.5 + 0.5 * mirrored.y, 0.09);
    ++pixels;
  }
  EXPECT_GT(pixels, 200);
}

TEST(PathTracer, ATwoColouredSkyFollowsTheCosine)
{
  // The cosine-weighted mean of 1/2 + d.up / 2 about a normal n is 1/2 + n.up / 3.
  Scene scene = oneSphere();
  trace(scene, 1);
  scene.sky = {{1.0f, 0.8f, 0.5f}, {0.0f, 0.2f, 0.5f}, {0.0, 0.0, 1.0}};
  const int size = 32;
  const Film film = tracedFilm(scene, camera, size, size, {256, 0, 0});
  const CameraRays rays(camera, size, size);
  for (int i = 0; i < size * size; ++i)
  {
    const auto at = pick(scene, camera.position, rays.directionAt(i % size + 0.5, i / size + 0.5));
    if (!at || film.color()[4 * i + 3] < 1.0f)
      continue;
    const double share = 0.5 + at->normal.z / 3.0;
    EXPECT_NEAR(film.color()[4 * i], share, 0.025);
    EXPECT_NEAR(film.color()[4 * i + 1], 0.2 + 0.6 * share, 0.02);
    EXPECT_NEAR(film.color()[4 * i + 2], 0.5, 1e-5);
  }
}

TEST(PathTracer, OneBounceIsAmbientOcclusionOfUnlimitedReach)
{
  Scene paths = randomSpheres(731);
  paths.surfaces[0].coloring.constant = {0.7f, 0.7f, 0.7f, 1.0f};
  Scene local = paths;
  trace(paths, 1);
  local.lights.clear();
  local.surfaces[0].material.ambient = 1.0f;
  local.occlusion = {4, INFINITY};
  const Film a = tracedFilm(paths, camera, 48, 48, {256, 0, 0});
  const Film b = tracedFilm(local, camera, 48, 48, {64, 0, 0});
  EXPECT_LT(rmsOf(a, b), 0.02);
  EXPECT_NEAR(rangeOf(a).mean, rangeOf(b).mean, 3e-3);
  EXPECT_LT(rangeOf(a).mean, 0.6) << "and much is hidden";
}

TEST(PathTracer, LightsAloneAreLocalShadingWithShadows)
{
  // One bounce, a black sky, and lights of no size: the same numbers without any noise.
  const std::vector<Light> lights = {shadowLight(point, {2.0, 1.0, 2.0}),
    shadowLight(directional, {1.0, -1.0, -0.2}), shadowLight(point, {-1.0, 2.0, 1.0})};
  Scene paths = randomSpheres(741);
  paths.lights = lights;
  for (Light& light : paths.lights)
    light.color = {0.3f, 0.2f, 0.1f};
  Scene local = paths;
  paths.paths.bounces = 1;
  paths.sky = {black, black};
  const FilmDifference difference =
    differenceOf(tracedFilm(local, camera, 100), tracedFilm(paths, camera, 100));
  EXPECT_LE(difference.pixels, 10);
  EXPECT_LE(difference.rest, 1e-3);
  // Here all lights cast shadows.
  for (Light& light : paths.lights)
    light.shadows = false;
  EXPECT_LE(
    differenceOf(tracedFilm(local, camera, 100), tracedFilm(paths, camera, 100)).pixels, 10);
}

TEST(PathTracer, LightsWithSizeTendToLocalSoftShadows)
{
  for (const Light& light : {shadowLight(point, {2.0, 2.0, 2.0}, 4, 1.0),
         shadowLight(directional, {-1.0, -1.0, -0.5}, 4, 30.0)})
  {
    Scene paths = randomSpheres(751);
    paths.lights = {light};
    Scene local = paths;
    paths.paths.bounces = 1;
    paths.sky = {black, black};
    const Film a = tracedFilm(local, camera, 48, 48, {64, 0, 0});
    const Film b = tracedFilm(paths, camera, 48, 48, {256, 0, 0});
    EXPECT_LT(rmsOf(a, b), 0.012);
    EXPECT_NEAR(rangeOf(a).mean, rangeOf(b).mean, 1e-3);
  }
}

TEST(PathTracer, HeadlightsStandInTheEye)
{
  for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic})
  {
    Scene paths = randomSpheres(761);
    paths.sky = {black, black};
    Scene local = paths;
    paths.paths.bounces = 1;
    Camera view = camera;
    view.projection = projection;
    view.parallelScale = 1.3;
    const FilmDifference difference =
      differenceOf(tracedFilm(local, view, 100), tracedFilm(paths, view, 100));
    EXPECT_LE(difference.pixels, 5);
    EXPECT_LE(difference.rest, 1e-3);
  }
}

TEST(PathTracer, AnIntegratingSphereGathersItsBounces)
{
  // A light in the middle of a white cavity: bounce by bounce a, a^2, a^3 ... everywhere.
  Scene scene = oneSphere();
  const float a = 0.6f;
  scene.surfaces[0].coloring.constant = {a, a, a, 1.0f};
  scene.sky = {Vec3f(1.0f), Vec3f(1.0f)}; // which nobody within sees
  Light light;
  light.kind = point;
  light.vector = Vec3d(0.0);
  scene.lights = {light};
  const Camera view = lookAt({0.3, 0.2, 0.1}, {0.0, 0.0, -1.0}, 80.0);
  for (const int bounces : {1, 2, 3, 40})
  {
    scene.paths.bounces = bounces;
    const double wanted = a * (1.0 - std::pow(a, bounces)) / (1.0 - a);
    const Range range = rangeOf(tracedFilm(scene, view, 32, 32, {64, 0, 0}));
    EXPECT_EQ(range.pixels, 32 * 32);
    EXPECT_NEAR(range.mean, wanted, 3e-3) << bounces;
    if (bounces <= 3) // then nothing is left to chance
    {
      EXPECT_NEAR(range.least, wanted, 1e-4);
      EXPECT_NEAR(range.most, wanted, 1e-4);
    }
  }
}

TEST(PathTracer, ColoursBleedFromOneParticleToAnother)
{
  Particles particles;
  particles.add(Vec3d(0.0), 1.0);
  particles.add({2.0, 0.0, 0.0}, 1.0);
  Scene scene;
  addTo(scene, objectOf(particles));
  const std::vector<double> values = {0.0, 1.0};
  scene.surfaces[0].coloring.values = ArrayView(values.data(), 2, 1);
  scene.surfaces[0].coloring.map.table = {{0.8f, 0.8f, 0.8f, 1.0f}, {0.8f, 0.0f, 0.0f, 1.0f}};
  trace(scene, 8);
  const Film film =
    tracedFilm(scene, lookAt({0.7, 0.0, 9.0}, {0.7, 0.0, 0.0}, 1.0), 8, 8, {64, 0, 0});
  double red = 0.0, blue = 0.0;
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    ASSERT_EQ(film.id()[i], 0u);
    red += film.color()[4 * i];
    blue += film.color()[4 * i + 2];
  }
  EXPECT_GT(red, 1.02 * blue);
  EXPECT_GT(blue, 0.5 * red);
}

TEST(PathTracer, UnlitSurfacesShine)
{
  Scene scene = oneSphere();
  Particles other;
  other.add({2.1, 0.0, 0.0}, 1.0);
  addTo(scene, objectOf(other));
  scene.surfaces[0].coloring.constant = {0.25f, 0.5f, 0.75f, 1.0f};
  scene.surfaces[0].material.ambient = 1.0f;
  scene.surfaces[0].material.diffuse = 0.0f;
  trace(scene, 4, 0.0f);
  const Film film = tracedFilm(scene, lookAt({1.0, 0.0, 9.0}, {1.0, 0.0, 0.0}, 30.0), 60);
  double lit = 0.0;
  for (std::size_t i = 0; i < film.pixels(); ++i)
    if (film.object()[i] == 0)
      EXPECT_FLOAT_EQ(film.color()[4 * i + 1], 0.5f);
    else if (film.object()[i] == 1)
      lit += film.color()[4 * i + 1];
  EXPECT_GT(lit, 5.0) << "and light what is beside them";
}

TEST(PathTracer, OpacityIsThatOfThePictureAlone)
{
  Scene scene = oneSphere();
  trace(scene, 4);
  scene.surfaces[0].coloring.constant = {1.0f, 1.0f, 1.0f, 0.5f};
  scene.surfaces[0].material.opacity = 0.5f;
  const Film film = tracedFilm(scene, camera, 1);
  EXPECT_FLOAT_EQ(film.color()[3], 0.25f);
  EXPECT_FLOAT_EQ(film.color()[0], 0.25f);
}

TEST(PathTracer, PathsGoThroughGlass)
{
  // A white sphere in a furnace is as bright as the sky, and darker within another that is grey.
  const auto brightness = [](float opacity, bool castsShadows)
  {
    Particles shell;
    shell.add(Vec3d(0.0), 3.0);
    Scene scene = oneSphere();
    addTo(scene, objectOf(shell));
    trace(scene, 8);
    scene.surfaces[0].coloring.constant = Vec4f(1.0f);
    scene.surfaces[1].coloring.constant = {0.1f, 0.1f, 0.1f, 1.0f};
    scene.surfaces[1].material.opacity = opacity;
    scene.surfaces[1].castsShadows = castsShadows;
    return rangeOf(tracedFilm(scene, lookAt({0.0, 0.0, 2.0}, Vec3d(0.0), 20.0), 8)).mean;
  };
  EXPECT_LT(brightness(0.5f, true), 0.3);
  EXPECT_NEAR(brightness(0.0f, false), 1.0, 1e-5);
}

TEST(PathTracer, BundlesAndThreadsDoNotChangeThePicture)
{
  Scene scene = randomSpheres(771);
  trace(scene, 4);
  scene.surfaces[0].material.metallic = 0.3f;
  scene.surfaces[0].coloring.constant = {0.7f, 0.6f, 0.5f, 1.0f};
  scene.lights = {shadowLight(point, {2.0, 2.0, 2.0}, 4, 1.0)};
  const Film wanted = tracedFilm(scene, camera, 90, 70, {2, 1, 0});
  const Film threads = tracedFilm(scene, camera, 90, 70, {2, 2, 0});
  EXPECT_TRUE(std::equal(wanted.color(), wanted.color() + 4 * wanted.pixels(), threads.color()));
  for (const int side : {2, 4, 8, 16})
    EXPECT_LE(differenceOf(wanted, tracedFilm(scene, camera, 90, 70, {2, 1, side})).pixels, 60);
}

TEST(PathTracer, EveryStructureGivesTheSamePicture)
{
  const Particles particles = randomParticles(300, 791, 0.05, 0.2);
  ParticleStructureOptions options;
  options.kind = ParticleStructureKind::CoherentGrid;
  Scene grid;
  grid.surfaces.resize(1);
  grid.surfaces[0].surface = ParticleSurface(makeParticleStructure(particles.set(), options));
  grid.surfaces[0].material.ambient = 0.8f;
  grid.surfaces[0].coloring.constant = {0.7f, 0.7f, 0.7f, 1.0f};
  Scene tree = grid;
  options.kind = ParticleStructureKind::PkdTree;
  tree.surfaces[0].surface = ParticleSurface(makeParticleStructure(particles.set(), options));
  for (const bool paths : {false, true})
  {
    for (Scene* scene : {&grid, &tree})
    {
      scene->occlusion = {8, 0.5};
      scene->paths.bounces = paths ? 8 : 0;
    }
    const Film wanted = tracedFilm(grid, camera, 90), film = tracedFilm(tree, camera, 90);
    EXPECT_LE(differenceOf(wanted, film).pixels, paths ? 60 : 10); // paths part at a hair
  }
}

TEST(PathTracer, ErrorFallsWithTheNumberOfSamples)
{
  Scene scene = randomSpheres(781);
  trace(scene, 16);
  scene.surfaces[0].coloring.constant = {0.8f, 0.8f, 0.8f, 1.0f};
  scene.sky.bottom = Vec3f(0.3f);
  scene.lights = {shadowLight(directional, {-1.0, -1.0, -1.0}, 1, 15.0)};
  Film wanted, film;
  wanted.resize(64, 64, Film::Id);
  film.resize(64, 64, Film::Id | Film::Variance);
  const RayCaster caster(scene);
  for (int k = 0; k < 2048; ++k)
    caster.addSample(camera, wanted);
  double before = INFINITY;
  for (const int samples : {4, 16, 64, 256})
  {
    while (film.samples() < samples)
      caster.addSample(camera, film);
    const double error = rmsOf(film, wanted);
    std::printf(
      "%4d samples: rms error %.4f, standard error %.4f\n", samples, error, standardError(film));
    EXPECT_LT(error, 0.55 * before); // random samples: 0.5
    EXPECT_LT(error, 1.3 * standardError(film));
    before = error;
  }
}

TEST(Reflectance, SamplesAreWorthWhatTheyStandFor)
{
  // The mean weight of scatter() is the integral of shine() / pi over all directions of light.
  const Vec3f normal = glm::normalize(Vec3f(0.3f, -0.5f, 0.8f));
  Vec3d u, v;
  acrossAxes(Vec3d(normal), u, v);
  for (const float metallic : {0.0f, 0.4f, 1.0f})
    for (const float slope : {0.1f, 0.3f, 1.0f})
      for (const float tilt : {0.0f, 0.8f, 1.4f})
      {
        const Reflectance r{{0.9f, 0.6f, 0.2f}, metallic, slope};
        const Vec3f out = std::cos(tilt) * normal + std::sin(tilt) * Vec3f(u);
        const int count = 1 << 14;
        Vec3d sampled(0.0), integral(0.0);
        for (int k = 0; k < count; ++k)
        {
          const auto index = static_cast<std::uint32_t>(k);
          const glm::dvec2 at = samplePoint(index, 5);
          const auto found = r.scatter(normal, out, at, samplePoint(index, 6).x);
          EXPECT_LE(std::max({found.weight.x, found.weight.y, found.weight.z}), 1.0f + 1e-5f);
          sampled += Vec3d(found.weight) / double(count);
        }
        const int side = 600; // of directions even in solid angle
        for (int k = 0; k < side * side; ++k)
        {
          const double cosine = (k % side + 0.5) / side, angle = 2.0 * M_PI * (k / side) / side;
          const double sine = std::sqrt(1.0 - cosine * cosine);
          const Vec3d in =
            sine * (std::cos(angle) * u + std::sin(angle) * v) + cosine * Vec3d(normal);
          integral += 2.0 / (side * side) * Vec3d(r.shine(normal, out, Vec3f(in)));
        }
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(sampled[c], integral[c], 0.01) << metallic << ' ' << slope << ' ' << tilt;
      }
}
