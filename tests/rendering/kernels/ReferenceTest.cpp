// The oracle itself: against formulas, and its tree against trying every sphere.

#include <support/CastOracle.h>
#include <support/Particles.h>
#include <support/SphereTree.h>

#include <gtest/gtest.h>

using namespace mote;
using namespace mote::reference;
using mote::testing::Particles;
using mote::testing::Random;
using mote::testing::randomParticles;

TEST(Reference, MeetsOneSphereWhereGeometrySays)
{
  Random random(1);
  for (int k = 0; k < 1000; ++k)
  {
    // A ray that passes the centre at distance `beside` meets the sphere at distance -+ root.
    const double radius = random(0.1, 2.0), beside = radius * random(0.0, 0.99);
    const Vec3d center = random.inBox(Vec3d(-5.0), Vec3d(5.0)), along = random.direction();
    const Vec3d across = glm::normalize(glm::cross(along, random.direction()));
    const double away = random(3.0, 9.0), length = random(0.1, 10.0);
    const double root = std::sqrt(radius * radius - beside * beside);
    const Sphere sphere{center, radius, 7};
    Ray ray{center + beside * across - away * along, length * along, 0.0};
    Hit hit;
    meet(ray, sphere, hit);
    ASSERT_EQ(hit.particle, 7u);
    EXPECT_NEAR(hit.t * length, away - root, 1e-13);
    ray.tMin = hit.t; // the near side does not count any more
    Hit farther;
    meet(ray, sphere, farther);
    EXPECT_NEAR(farther.t * length, away + root, 1e-13);
    ray.tMin = farther.t;
    Hit none;
    meet(ray, sphere, none);
    EXPECT_FALSE(none);
    ray = {center + 1.000001 * radius * across - away * along, along, 0.0};
    meet(ray, sphere, none);
    EXPECT_FALSE(none);
  }
}

TEST(Reference, TakesTheSmallestIndexOfEqualSpheres)
{
  const std::vector<Sphere> spheres = {
    {Vec3d(0.0), 1.0, 5}, {Vec3d(0.0), 1.0, 3}, {Vec3d(0.0), 1.0, 4}};
  const Ray ray{{0.1, 0.2, -5.0}, {0.0, 0.0, 1.0}};
  EXPECT_EQ(bruteForce(spheres, ray).particle, 3u);
  EXPECT_EQ(SphereTree(spheres).cast(ray).particle, 3u);
}

TEST(Reference, LeavesOutWhatIsNotASphere)
{
  Particles particles;
  particles.add({0.0, 0.0, 0.0}, -1.0);
  particles.add({0.0, std::nan(""), 0.0}, 1.0);
  particles.add({0.0, 0.0, 1.0}, 1.0);
  particles.add({0.0, 0.0, 0.0}, INFINITY);
  const std::vector<Sphere> spheres = validSpheres(particles.set());
  ASSERT_EQ(spheres.size(), 1u);
  EXPECT_EQ(spheres[0].particle, 2u);
}

TEST(Reference, TreeAnswersAsBruteForceDoes)
{
  for (const std::size_t count : {0, 1, 7, 8, 9, 100, 3000})
  {
    const Particles particles = randomParticles(count, 10 + count, 0.001, 0.1);
    const std::vector<Sphere> spheres = validSpheres(particles.set());
    const SphereTree tree(spheres);
    Random random(count);
    std::size_t hits = 0;
    for (int k = 0; k < 2000; ++k)
    {
      Ray ray{random.inBox(Vec3d(-3.0), Vec3d(3.0)), random.direction()};
      if (k % 4 == 1) // along an axis, from within
        ray = {random.inBox(Vec3d(-1.0), Vec3d(1.0)), Vec3d(0.0)}, ray.direction[k % 3] = -2.0;
      if (k % 4 == 2)
        ray.tMin = random(0.0, 2.0), ray.tMax = ray.tMin + random(0.0, 2.0);
      if (k % 4 == 3) // towards the middle: more hits
        ray.direction = -ray.origin;
      const Hit all = bruteForce(spheres, ray), found = tree.cast(ray);
      ASSERT_EQ(found.particle, all.particle);
      ASSERT_EQ(found.t, all.t);
      hits += static_cast<bool>(all);
    }
    EXPECT_GE(hits, count == 3000 ? 500u : 0u);
  }
}
