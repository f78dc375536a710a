// Silhouettes of films: what films keep of their latest sample, and the mean over samples.

#include "SceneParts.h"

#include <kernels/tracing/RayCaster.h>
#include <kernels/tracing/SilhouetteFilm.h>

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numeric>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr int width = 83, height = 61; // no whole number of bundles

Camera cameraOf(Camera::Projection projection)
{
  Camera camera = lookAt({2.0, 1.5, 4.0}, Vec3d(0.0), 40.0);
  camera.projection = projection;
  camera.parallelScale = 1.7;
  camera.centerX = 0.2;
  camera.centerY = -0.1;
  return camera;
}

/// A film of some samples and its silhouettes.
struct Traced
{
  Film film;
  SilhouetteFilm silhouettes;

  void trace(const Scene& scene, const Camera& camera, int samples,
    const SilhouetteOptions& options = {}, const SilhouetteGroups& groups = {},
    const float* limits = nullptr, int threads = 0)
  {
    film.resize(width, height, groups.channels());
    silhouettes.clear();
    RayCaster caster(scene);
    caster.setLimits(limits);
    for (int k = 0; k < samples; ++k)
    {
      ASSERT_TRUE(caster.addSample(camera, film));
      silhouettes.add(film, camera, options, groups, limits, threads);
    }
    EXPECT_EQ(silhouettes.samples(), samples);
  }
  std::vector<float> coverage() const
  {
    std::vector<float> shares(film.pixels(), 0.0f);
    silhouettes.forCovered(
      0, film.height(), [&](std::size_t pixel, float share) { shares[pixel] = share; });
    return shares;
  }
  float at(int x, int y) const { return this->coverage()[y * width + x]; }
  double sum() const
  {
    const std::vector<float> shares = this->coverage();
    return std::accumulate(shares.begin(), shares.end(), 0.0);
  }
};

SilhouetteOptions anyStep(double step = 0.1)
{
  SilhouetteOptions options;
  options.step = step;
  options.stepInPixels = 0.0;
  return options;
}

} // namespace

TEST(SilhouetteFilm, FilmsKeepWhatTheLatestRaysMet)
{
  Scene scene;
  for (int k = 0; k < 2; ++k)
    addTo(scene, objectOf(randomParticles(60, 41 + std::uint64_t(k), 0.1, 0.3)));
  for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic})
  {
    const Camera camera = cameraOf(projection);
    const CameraRays rays(camera, width, height);
    Film film;
    film.resize(width, height, Film::LatestDepth | Film::LatestId);
    const RayCaster caster(scene);
    for (int sample = 0; sample < 4; ++sample)
    {
      ASSERT_TRUE(caster.addSample(camera, film));
      double jitterX = 0.0, jitterY = 0.0;
      RayCaster::sampleOffset(sample, jitterX, jitterY);
      int different = 0, hits = 0;
      for (int i = 0; i < width * height; ++i)
      {
        const double x = i % width + 0.5 + jitterX, y = i / width + 0.5 + jitterY;
        const auto found = pick(scene, rays.originAt(x, y), rays.directionAt(x, y));
        hits += found ? 1 : 0;
        // Rays that graze a sphere may miss it by a rounding.
        if (!found || film.latestObject()[i] < 0)
        {
          different += found.has_value() != (film.latestObject()[i] >= 0) ? 1 : 0;
          EXPECT_EQ(std::isfinite(film.latestDepth()[i]), film.latestObject()[i] >= 0);
          continue;
        }
        different += std::abs(film.latestDepth()[i] - found->t) > 1e-3 ||
                     film.latestId()[i] != found->id ||
                     film.latestObject()[i] != int(found->object);
      }
      EXPECT_GT(hits, 1000);
      EXPECT_LE(different, 4) << sample;
    }
  }
}

TEST(SilhouetteFilm, DepthImagesLookAlongTheRays)
{
  const Camera camera = cameraOf(Camera::Projection::Perspective);
  const CameraRays rays(camera, width, height);
  const std::vector<float> depth(width * height, 1.0f);
  for (const int sample : {0, 1, 7})
  {
    const DepthImage image = depthImageOf(depth.data(), width, height, camera, sample);
    double jitterX = 0.0, jitterY = 0.0;
    RayCaster::sampleOffset(sample, jitterX, jitterY);
    for (const auto& [x, y] : {std::pair(0, 0), {width - 1, 0}, {31, 17}})
      EXPECT_NEAR(
        glm::length(Vec3d(image.x0 + (x + 0.5) * image.dx, image.y0 + (y + 0.5) * image.dy, 1.0)),
        glm::length(rays.directionAt(x + 0.5 + jitterX, y + 0.5 + jitterY)), 1e-12);
  }
  const Camera parallel = cameraOf(Camera::Projection::Orthographic);
  const DepthImage image = depthImageOf(depth.data(), width, height, parallel);
  EXPECT_EQ(image.dx, 0.0);
  EXPECT_NEAR(image.pixelSize, 2.0 * 1.7 / height, 1e-12);
}

namespace
{

/// A sphere's outline in the middle of a picture: how far the middle of the line is from where it
/// should be, root mean square over short pieces of it, and how wide the line is; in pixels.
struct Outline
{
  double error = 0.0, width = 0.0;

  Outline(int samples, const SilhouetteOptions& options)
  {
    constexpr int sectors = 72;
    const double radius = height / 3.0;
    Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0);
    camera.projection = Camera::Projection::Orthographic;
    camera.parallelScale = 1.5;
    Traced traced;
    traced.trace(oneSphere(), camera, samples, options);
    const std::vector<float> coverage = traced.coverage();
    double weight[sectors] = {}, distance[sectors] = {};
    for (int i = 0; i < ::width * height; ++i)
    {
      const double x = i % ::width + 0.5 - 0.5 * ::width, y = i / ::width + 0.5 - 0.5 * height;
      const int sector =
        static_cast<int>((std::atan2(y, x) / (2.0 * M_PI) + 0.5) * sectors) % sectors;
      weight[sector] += coverage[i];
      distance[sector] += coverage[i] * std::hypot(x, y);
    }
    for (int k = 0; k < sectors; ++k)
      error += std::pow(distance[k] / weight[k] - radius, 2.0) / sectors;
    error = std::sqrt(error);
    width = traced.sum() / (2.0 * M_PI * radius);
  }
};

} // namespace

TEST(SilhouetteFilm, LinesLieOnTheOutlineAndAreAsWideAsAsked)
{
  for (const double thickness : {0.5, 1.0, 2.0, 3.0})
  {
    SilhouetteOptions options = anyStep();
    options.thickness = thickness;
    const Outline outline(16, options);
    EXPECT_LT(outline.error, 0.2) << thickness;
    EXPECT_NEAR(outline.width, thickness, 0.15 * thickness);
  }
}

TEST(SilhouetteFilm, SamplesSmoothLines)
{
  const Outline one(1, anyStep()), many(16, anyStep());
  EXPECT_LT(one.error, 0.35);
  EXPECT_LT(many.error, 0.7 * one.error);
}

TEST(SilhouetteFilm, GroupsHaveLinesBetweenThem)
{
  // Two spheres that overlap hardly differ in depth where they meet.
  Particles particles;
  particles.add({-0.5, 0.0, 0.0}, 0.8);
  particles.add({0.5, 0.0, 0.0}, 0.8);
  Scene scene;
  addTo(scene, objectOf(particles));
  const Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0);
  const auto crossing = [&](const SilhouetteGroups& groups)
  {
    Traced traced;
    traced.trace(scene, camera, 4, anyStep(), groups);
    double most = 0.0;
    for (int x = width / 2 - 2; x <= width / 2 + 2; ++x)
      most = std::max(most, double(traced.at(x, height / 2)));
    return most;
  };
  const float same[] = {2.5f, 2.5f}, zeros[] = {0.0f, -0.0f}, other[] = {2.5f, 3.5f};
  SilhouetteGroups groups;
  EXPECT_EQ(groups.channels(), unsigned(Film::LatestDepth));
  EXPECT_EQ(crossing(groups), 0.0);
  groups.by = SilhouetteGroups::By::Object;
  EXPECT_EQ(crossing(groups), 0.0) << "of one object";
  groups.by = SilhouetteGroups::By::Particle;
  EXPECT_GT(crossing(groups), 0.3);
  groups.by = SilhouetteGroups::By::Value;
  groups.values = {ArrayView(same, 2, 1)};
  EXPECT_EQ(crossing(groups), 0.0);
  groups.values = {ArrayView(zeros, 2, 1)};
  EXPECT_EQ(crossing(groups), 0.0);
  groups.values = {ArrayView(other, 2, 1)};
  EXPECT_GT(crossing(groups), 0.3);
  groups.values = {ArrayView()};
  EXPECT_EQ(crossing(groups), 0.0) << "an object without values is one group";
  groups.values.clear();
  EXPECT_EQ(crossing(groups), 0.0);
}

TEST(SilhouetteFilm, WhatEndsRaysHidesLinesAndIsNotOutlined)
{
  // The sphere's front is 4 from the eye, its outline nearly 5.
  const Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0);
  const auto sumBefore = [&](float limit)
  {
    const std::vector<float> limits(width * height, limit);
    Traced traced;
    traced.trace(oneSphere(), camera, 2, anyStep(0.3), {}, limits.data());
    return traced.sum();
  };
  const double all = sumBefore(std::numeric_limits<float>::infinity());
  EXPECT_GT(all, 100.0);
  EXPECT_EQ(sumBefore(20.0f), all);
  EXPECT_EQ(sumBefore(4.4f), 0.0) << "cuts the sphere before its outline";
  EXPECT_EQ(sumBefore(3.0f), 0.0) << "hides it";
}

TEST(SilhouetteFilm, ThreadsDoNotMatterNorWhatWasThereBefore)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(200, 7, 0.05, 0.2)));
  const Camera camera = cameraOf(Camera::Projection::Perspective);
  Traced a, b;
  a.trace(scene, camera, 3, anyStep(), {}, nullptr, 1);
  b.trace(oneSphere(), camera, 2, anyStep());
  b.trace(scene, camera, 3, anyStep(), {}, nullptr, 3);
  EXPECT_EQ(a.coverage(), b.coverage());
}

TEST(SilhouetteFilm, WhatIsPassedOverHasNoSilhouettes)
{
  // A film of two large steps, small ones all over and much background.
  Scene scene;
  addTo(scene, objectOf(randomParticles(3000, 11, 0.01, 0.03)));
  for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic})
    for (const double step : {0.02, 0.3, 1.5})
    {
      const Camera camera = cameraOf(projection);
      Traced traced;
      traced.trace(scene, camera, 1, anyStep(step));
      std::vector<float> whole(traced.film.pixels(), 0.0f);
      findSilhouettes(
        depthImageOf(traced.film.depth(), width, height, camera), anyStep(step), whole.data());
      EXPECT_EQ(traced.coverage(), whole) << step;
      EXPECT_GT(traced.sum(), 0.0) << step;
    }
}

TEST(SilhouetteFilm, LinesReachNoFartherFromWhatTheyBelongToThanTheySay)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(40, 9, 0.05, 0.3)));
  const Camera camera = cameraOf(Camera::Projection::Perspective);
  for (const double thickness : {0.5, 1.0, 1.5, 2.0, 3.0, 5.0})
    for (const bool centered : {true, false})
    {
      SilhouetteOptions options = anyStep();
      options.thickness = thickness;
      options.centered = centered;
      Traced traced;
      traced.trace(scene, camera, 1, options);
      const float* depth = traced.film.depth();
      const int reach = traced.silhouettes.reach();
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          ASSERT_TRUE(
            traced.at(x, y) == 0.0f || std::isfinite(nearSide(depth, width, height, x, y, reach)))
            << thickness << centered << " at " << x << " " << y;
    }
}

TEST(SilhouetteFilm, TypicalRadiusHalvesTheCrossSection)
{
  EXPECT_EQ(typicalRadius({}), 0.0);
  EXPECT_DOUBLE_EQ(typicalRadius(oneSphere(0.25)), 0.25);
  // A thousand small spheres have more of it than a large one, or less.
  Particles particles = randomParticles(1000, 3, 0.01, 0.01);
  particles.add({2.0, 0.0, 0.0}, 0.1);
  Scene scene;
  addTo(scene, objectOf(particles));
  EXPECT_NEAR(typicalRadius(scene), 0.01, 1e-6);
  // In the world: objects are scaled, and each counts with all of its particles.
  scene.surfaces[0].toWorld = glm::scale(Mat4d(1.0), Vec3d(3.0));
  EXPECT_NEAR(typicalRadius(scene), 0.03, 1e-6);
  Particles large;
  large.add(Vec3d(0.0), 2.0);
  addTo(scene, objectOf(large));
  EXPECT_NEAR(typicalRadius(scene), 2.0, 1e-6);
}
