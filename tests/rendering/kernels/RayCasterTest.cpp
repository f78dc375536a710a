// What a traced film holds.

#include "SceneParts.h"

#include <kernels/tracing/RayCaster.h>

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

using namespace mote;
using namespace mote::testing;

namespace
{

Mat4d somewhere(Random& random)
{
  const Mat4d moved = glm::translate(Mat4d(1.0), random.inBox(Vec3d(-1.0), Vec3d(1.0)));
  return glm::scale(
    glm::rotate(moved, random(0.0, 6.0), random.direction()), Vec3d(random(0.5, 2.0)));
}

Film traced(
  const Scene& scene, const Camera& camera, int width, int height, int samples = 1, int threads = 0)
{
  Film film;
  film.resize(width, height, Film::Id | Film::Normal);
  RayCaster caster(scene);
  caster.setThreads(threads);
  for (int k = 0; k < samples; ++k)
    EXPECT_TRUE(caster.addSample(camera, film));
  EXPECT_EQ(film.samples(), samples);
  return film;
}

} // namespace

TEST(RayCaster, EveryPixelHoldsWhatAPickThroughItsCentreFinds)
{
  // Three objects, turned, moved and scaled, through one another: each occludes the others.
  Random random(131);
  Scene scene;
  for (int k = 0; k < 3; ++k)
    addTo(
      scene, objectOf(randomParticles(150, 132 + std::uint64_t(k), 0.05, 0.2), somewhere(random)));
  const int width = 67, height = 45; // no whole number of blocks
  for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic})
  {
    Camera camera = lookAt({4.0, 3.0, 5.0}, Vec3d(0.0), 40.0);
    camera.projection = projection;
    camera.parallelScale = 2.0;
    const Film film = traced(scene, camera, width, height);
    const CameraRays rays(camera, width, height);
    int differing = 0;
    std::vector<int> seen(3, 0);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
      {
        const std::size_t i = static_cast<std::size_t>(y) * width + x;
        const auto found =
          pick(scene, rays.originAt(x + 0.5, y + 0.5), rays.directionAt(x + 0.5, y + 0.5));
        const std::int32_t object = found ? static_cast<std::int32_t>(found->object) : -1;
        if (object != film.object()[i] || film.id()[i] != (found ? found->id : Film::noId))
        {
          ++differing; // on a silhouette
          continue;
        }
        if (!found)
        {
          EXPECT_EQ(film.depth()[i], INFINITY);
          continue;
        }
        ++seen[std::size_t(found->object)];
        EXPECT_NEAR(film.depth()[i], found->t, 1e-4);
        const float* n = film.normal() + 3 * i;
        EXPECT_NEAR(glm::dot(found->normal, Vec3d(n[0], n[1], n[2])), 1.0, 1e-3);
      }
    EXPECT_LE(differing, 2);
    for (const int count : seen)
      EXPECT_GT(count, 100);
  }
}

TEST(RayCaster, TransformedObjectsLookLikeTransformedParticles)
{
  Random random(141);
  const Particles particles = randomParticles(300, 142, 0.05, 0.15);
  const Mat4d toWorld = somewhere(random);
  const double scale = glm::length(transformVector(toWorld, Vec3d(1.0, 0.0, 0.0)));
  Particles moved;
  for (std::size_t i = 0; i < particles.size(); ++i)
    moved.add(transformPoint(toWorld, particles.center(i)), scale * particles.radii[i]);
  Scene one, other;
  one.surfaces.push_back(objectOf(particles, toWorld));
  other.surfaces.push_back(objectOf(moved));
  const Camera camera = lookAt({3.0, 4.0, 5.0}, Vec3d(0.0), 50.0);
  const Film a = traced(one, camera, 96, 96), b = traced(other, camera, 96, 96);
  int differing = 0;
  for (std::size_t i = 0; i < a.pixels(); ++i)
    if (a.id()[i] != b.id()[i])
      ++differing;
    else if (a.object()[i] >= 0)
    {
      EXPECT_NEAR(a.depth()[i], b.depth()[i], 2e-3); // depth is steep at silhouettes
      EXPECT_NEAR(a.color()[4 * i], b.color()[4 * i], 2e-2);
    }
  EXPECT_LE(differing, 3);
}

TEST(RayCaster, ThreadsDoNotChangeTheImage)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(500, 151, 0.05, 0.15)));
  const Camera camera = lookAt({3.0, 1.0, 2.0}, Vec3d(0.0), 50.0);
  const Film one = traced(scene, camera, 120, 90, 3, 1), two = traced(scene, camera, 120, 90, 3, 2);
  EXPECT_TRUE(std::equal(one.color(), one.color() + 4 * one.pixels(), two.color()));
  EXPECT_TRUE(std::equal(one.depth(), one.depth() + one.pixels(), two.depth()));
  EXPECT_TRUE(std::equal(one.id(), one.id() + one.pixels(), two.id()));
}

TEST(RayCaster, AnEmptySceneIsEmpty)
{
  Scene objectless, hollow;
  hollow.surfaces.push_back(objectOf(Particles()));
  for (const Scene* scene : {&objectless, &hollow})
  {
    const Film film = traced(*scene, Camera(), 33, 17, 2);
    for (std::size_t i = 0; i < film.pixels(); ++i)
    {
      ASSERT_EQ(film.depth()[i], INFINITY);
      ASSERT_EQ(film.nearestDepth()[i], INFINITY);
      ASSERT_EQ(film.id()[i], Film::noId);
      ASSERT_EQ(film.object()[i], -1);
      for (int c = 0; c < 4; ++c)
        ASSERT_EQ(film.color()[4 * i + std::size_t(c)], 0.0f);
    }
  }
}

TEST(RayCaster, LaterSamplesKeepTheFirstDepthAndLowerTheNearest)
{
  const Scene scene = oneSphere();
  const Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0);
  const Film first = traced(scene, camera, 32, 32, 1), many = traced(scene, camera, 32, 32, 8);
  int lowered = 0, closed = 0;
  for (std::size_t i = 0; i < first.pixels(); ++i)
  {
    EXPECT_EQ(many.depth()[i], first.depth()[i]);
    EXPECT_EQ(many.id()[i], first.id()[i]);
    EXPECT_LE(many.nearestDepth()[i], first.depth()[i]);
    lowered += many.nearestDepth()[i] < first.depth()[i];
    closed += std::isinf(first.depth()[i]) && std::isfinite(many.nearestDepth()[i]);
  }
  EXPECT_GT(lowered, 300);
  EXPECT_GT(closed, 10); // at the rim, where only some samples hit
}

TEST(RayCaster, NearAndFarDistancesCut)
{
  const Scene scene = oneSphere();
  Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 5.0);
  camera.nearDistance = 4.5; // within: the far side is seen
  EXPECT_NEAR(traced(scene, camera, 1, 1).depth()[0], 6.0f, 1e-5f);
  camera.farDistance = 5.5;
  EXPECT_EQ(traced(scene, camera, 1, 1).depth()[0], INFINITY);
  camera.nearDistance = 0.0;
  EXPECT_NEAR(traced(scene, camera, 1, 1).depth()[0], 4.0f, 1e-5f);
}

TEST(RayCaster, ProgressCanStopTheTracing)
{
  const Scene scene = oneSphere();
  Film film;
  film.resize(200, 200);
  RayCaster caster(scene);
  caster.setThreads(2);
  std::vector<double> told;
  const Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0);
  EXPECT_TRUE(caster.addSample(camera, film,
    [&](double done)
    {
      told.push_back(done);
      return true;
    }));
  EXPECT_EQ(film.samples(), 1);
  ASSERT_FALSE(told.empty());
  for (const double share : told)
  {
    EXPECT_GT(share, 0.0);
    EXPECT_LE(share, 1.0);
  }
  int calls = 0;
  EXPECT_FALSE(caster.addSample(camera, film, [&](double) { return ++calls < 3; }));
  EXPECT_EQ(film.samples(), 0);
  EXPECT_LE(calls, 3 + 1); // threads that are in a tile may finish and tell
}

TEST(RayCaster, AStoppedSampleGoesOnWithTheTilesThatAreLeft)
{
  const Scene scene = oneSphere();
  const Camera camera = lookAt({0.0, 0.0, 5.0}, Vec3d(0.0), 30.0);
  const int width = 100, height = 70; // 4 x 3 tiles
  const Film atOnce = traced(scene, camera, width, height, 3);
  Film film;
  film.resize(width, height, Film::Id | Film::Normal);
  RayCaster caster(scene);
  caster.setThreads(1);
  TilesDone tiles;
  int calls = 0;
  for (int samples = 0; samples < 3; ++samples)
  {
    std::size_t done = 0;
    while (!caster.addSample(
      camera, film, [](double) { return false; }, &tiles))
    {
      ASSERT_LT(++calls, 100);
      EXPECT_EQ(film.samples(), samples);
      const std::size_t now = pixelsDone(tiles, width, height);
      EXPECT_GT(now, done) << "each call does some";
      EXPECT_LE(now, done + tileSize * tileSize) << "and does not finish against the wish";
      done = now;
    }
    EXPECT_EQ(film.samples(), samples + 1) << "the last tile completes it";
    EXPECT_TRUE(tiles.empty());
  }
  EXPECT_EQ(calls, 3 * 11);
  const auto n = static_cast<std::size_t>(width) * height;
  EXPECT_TRUE(std::equal(film.color(), film.color() + 4 * n, atOnce.color()));
  EXPECT_TRUE(std::equal(film.depth(), film.depth() + n, atOnce.depth()));
  EXPECT_TRUE(std::equal(film.nearestDepth(), film.nearestDepth() + n, atOnce.nearestDepth()));
  EXPECT_TRUE(std::equal(film.id(), film.id() + n, atOnce.id()));
}

TEST(RayCaster, SampleOffsetsFillThePixelEvenly)
{
  double x = 1.0, y = 1.0;
  RayCaster::sampleOffset(0, x, y);
  EXPECT_EQ(x, 0.0);
  EXPECT_EQ(y, 0.0);
  // Any prefix: the share of samples in every quarter and in every box [-1/2, a) x [-1/2, b) is
  // near its area (star discrepancy on a grid of corners).
  for (const int count : {16, 64, 256, 1024})
  {
    double worst = 0.0;
    for (int a = 1; a <= 16; ++a)
      for (int b = 1; b <= 16; ++b)
      {
        int inside = 0;
        for (int k = 0; k < count; ++k)
        {
          RayCaster::sampleOffset(k, x, y);
          ASSERT_GE(std::min(x, y), -0.5);
          ASSERT_LT(std::max(x, y), 0.5);
          inside += x + 0.5 < a / 16.0 && y + 0.5 < b / 16.0;
        }
        worst = std::max(worst, std::abs(double(inside) / count - a * b / 256.0));
      }
    EXPECT_LT(worst, 3.0 / count * std::log2(double(count)) / 2.0) << count;
  }
}
