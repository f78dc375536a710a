// One ray through a scene.

#include "SceneParts.h"

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

using namespace mote;
using namespace mote::testing;

TEST(Pick, NamesTheParticleThatTheReferenceNames)
{
  const Particles particles = randomParticles(500, 121, 0.02, 0.1);
  Scene scene;
  addTo(scene, objectOf(particles));
  const reference::SphereTree tree(particles.set());
  Random random(122);
  int hits = 0, differing = 0;
  for (int k = 0; k < 2000; ++k)
  {
    reference::Ray ray{3.0 * random.direction(), Vec3d(0.0)};
    ray.direction = random(0.1, 9.0) * (0.7 * random.direction() - ray.origin);
    const reference::Hit wanted = tree.cast(ray);
    const std::optional<ScenePick> found = pick(scene, ray.origin, ray.direction);
    if (found.has_value() != static_cast<bool>(wanted) || (found && found->id != wanted.particle))
    {
      ++differing; // a silhouette
      continue;
    }
    if (!found)
      continue;
    ++hits;
    EXPECT_EQ(found->object, 0);
    EXPECT_NEAR(glm::length(found->position - (ray.origin + found->t * ray.direction)), 0.0, 1e-12);
    const Vec3d outwards = found->position - particles.center(found->id);
    EXPECT_NEAR(glm::length(outwards), particles.radii[found->id], 1e-6);
    EXPECT_NEAR(glm::length(found->normal), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(found->normal, outwards), particles.radii[found->id], 1e-6);
  }
  EXPECT_GT(hits, 500);
  EXPECT_LE(differing, 1);
}

TEST(Pick, GoesThroughTransforms)
{
  Particles particles;
  particles.add({1.0, 0.0, 0.0}, 0.5);
  particles.add({-1.0, 0.0, 0.0}, 0.5);
  const Mat4d right = glm::translate(Mat4d(1.0), Vec3d(10.0, 0.0, 0.0));
  const Mat4d turned = glm::rotate(right, M_PI / 2.0, Vec3d(0.0, 0.0, 1.0));
  Scene scene;
  addTo(scene, objectOf(particles));
  addTo(scene, objectOf(particles, turned)); // the spheres stand at (10, +-1, 0)
  const auto found = pick(scene, {10.0, 1.0, 5.0}, {0.0, 0.0, -2.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->object, 1);
  EXPECT_EQ(found->id, 0u);
  EXPECT_NEAR(found->t, 2.25, 1e-6);
  EXPECT_NEAR(found->normal.z, 1.0, 1e-6);
  EXPECT_FALSE(pick(scene, {11.0, 0.0, 5.0}, {0.0, 0.0, -2.0}));
  // Along x both objects stand in the way.
  const auto first = pick(scene, {-5.0, 0.2, 0.0}, {1.0, 0.0, 0.0});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->object, 0);
  EXPECT_EQ(first->id, 1u);
  const auto beyond = pick(scene, {-5.0, 0.8, 0.0}, {1.0, 0.0, 0.0});
  ASSERT_TRUE(beyond);
  EXPECT_EQ(beyond->object, 1);
}

TEST(Pick, EllipsoidsHaveTheirNormals)
{
  Particles particles;
  particles.add(Vec3d(0.0), 1.0);
  const Vec3d axes(1.0, 2.0, 3.0);
  Scene scene;
  addTo(scene, objectOf(particles, glm::scale(Mat4d(1.0), axes)));
  Random random(123);
  for (int k = 0; k < 200; ++k)
  {
    const Vec3d eye = 10.0 * random.direction();
    const auto found = pick(scene, eye, 0.5 * random.direction() - eye);
    ASSERT_TRUE(found);
    const Vec3d p = found->position / axes;
    EXPECT_NEAR(glm::length(p), 1.0, 1e-5);
    const Vec3d gradient = glm::normalize(p / axes);
    EXPECT_NEAR(glm::dot(found->normal, gradient), 1.0, 1e-6);
  }
}

TEST(Pick, RespectsTheInterval)
{
  const Scene scene = oneSphere();
  const Vec3d eye(0.0, 0.0, 5.0), direction(0.0, 0.0, -1.0);
  EXPECT_NEAR(pick(scene, eye, direction)->t, 4.0, 1e-6);
  EXPECT_NEAR(pick(scene, eye, direction, 4.5)->t, 6.0, 1e-6); // from within, the far side
  EXPECT_NEAR(pick(scene, Vec3d(0.0), direction)->t, 1.0, 1e-6);
  EXPECT_FALSE(pick(scene, eye, direction, 6.5));
  EXPECT_FALSE(pick(scene, eye, direction, 0.0, 3.5));
  EXPECT_TRUE(pick(scene, eye, direction, 0.0, 4.5));
}

TEST(Pick, FindsNothingInAnEmptyScene)
{
  EXPECT_FALSE(pick(Scene(), Vec3d(0.0), Vec3d(1.0, 0.0, 0.0)));
  EXPECT_TRUE(Scene().bounds().empty());
}

TEST(Pick, BoundsOfASceneEncloseItsTransformedObjects)
{
  Particles particles;
  particles.add({1.0, 0.0, 0.0}, 0.5);
  Scene scene;
  addTo(scene, objectOf(particles, glm::translate(Mat4d(1.0), Vec3d(0.0, 7.0, 0.0))));
  addTo(scene, objectOf(Particles()));
  const Box bounds = scene.bounds();
  EXPECT_NEAR(glm::length(bounds.lower - Vec3d(0.5, 6.5, -0.5)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(bounds.upper - Vec3d(1.5, 7.5, 0.5)), 0.0, 1e-12);
}
