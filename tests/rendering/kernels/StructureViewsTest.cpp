// The grid against the reference over random sets, cameras and projections.

#include <support/Structure.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A set, its grid and its oracle.
template <typename Structure>
struct Fixture
{
  explicit Fixture(Particles p)
    : particles(std::move(p))
    , oracle(CastOracle::forFloat(particles.set()))
  {
    grid.build(particles.set());
  }
  Particles particles;
  CastOracle oracle;
  Structure grid;
};

template <typename Structure>
void expectRight(
  const Fixture<Structure>& f, const Camera& camera, bool expectHits = true, int size = 40)
{
  for (const int side : {2, 4, 8, 16})
  {
    const CastReport report = checkImage(f.grid, f.oracle, camera, size, size, side);
    EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays in bundles of " << side << "x"
                                << side << "; " << report.complaint;
    if (expectHits)
    {
      EXPECT_GT(report.hits, report.rays / 50);
    }
  }
}

} // namespace

template <typename Structure>
using StructureViews = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureViews, ParticleStructures, StructureName);

TYPED_TEST(StructureViews, RandomSetsInPerspective)
{
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    const Fixture<TypeParam> f(randomParticles(200 * seed * seed, seed, 0.005, 0.4 / double(seed)));
    Random random(seed);
    for (int k = 0; k < 6; ++k)
    {
      const Vec3d eye = random(1.0, 6.0) * random.direction();
      expectRight(f, lookAt(eye, 0.3 * random.direction(), random(20.0, 60.0)));
    }
  }
}

TYPED_TEST(StructureViews, RandomSetsInOrthographicProjection)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const Fixture<TypeParam> f(randomParticles(1000, 20 + seed, 0.01, 0.1));
    Random random(seed);
    for (int k = 0; k < 6; ++k)
    {
      Camera camera = lookAt(4.0 * random.direction(), Vec3d(0.0));
      camera.projection = Camera::Projection::Orthographic;
      camera.parallelScale = random(0.2, 2.0);
      expectRight(f, camera);
    }
  }
}

TYPED_TEST(StructureViews, SixDirectionsAlongTheAxes)
{
  const Fixture<TypeParam> f(randomParticles(2000, 31, 0.01, 0.08));
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
    {
      Vec3d eye(0.0);
      eye[axis] = 4.0 * sign;
      Camera camera = lookAt(eye, Vec3d(0.0), 40.0);
      expectRight(f, camera);
      // All rays parallel to the axis: two components of every direction are zero.
      camera.projection = Camera::Projection::Orthographic;
      expectRight(f, camera);
    }
}

TYPED_TEST(StructureViews, DiagonalsWhereTheMajorAxisChangesWithinAPacket)
{
  const Fixture<TypeParam> f(randomParticles(2000, 32, 0.01, 0.08));
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3d eye(corner & 1 ? 2.0 : -2.0, corner & 2 ? 2.0 : -2.0, corner & 4 ? 2.0 : -2.0);
    expectRight(f, lookAt(eye, Vec3d(0.0), 50.0));
  }
}

TYPED_TEST(StructureViews, CameraAmongTheParticles)
{
  const Fixture<TypeParam> f(randomParticles(3000, 33, 0.005, 0.05));
  Random random(5);
  for (int k = 0; k < 20; ++k)
  {
    const Vec3d eye = random.inBox(Vec3d(-0.9), Vec3d(0.9));
    expectRight(f, lookAt(eye, eye + random.direction(), random(30.0, 90.0)));
  }
}

TYPED_TEST(StructureViews, CameraInsideASphere)
{
  Particles particles = randomParticles(500, 34, 0.01, 0.1);
  particles.add({0.2, 0.1, -0.1}, 0.7);
  const Fixture<TypeParam> f(particles);
  for (const Vec3d& eye : {Vec3d(0.2, 0.1, -0.1), Vec3d(0.5, 0.1, 0.0), Vec3d(0.2, 0.7, -0.1)})
  {
    Camera camera = lookAt(eye, {1.0, -0.3, 0.4}, 60.0);
    expectRight(f, camera);
    const CastReport report = checkImage(f.grid, f.oracle, camera, 16, 16);
    EXPECT_EQ(report.hits, report.rays); // there is no way out of a sphere
  }
}

TYPED_TEST(StructureViews, SpheresBehindTheEyeThatReachBeforeIt)
{
  // Spheres as large as the distance between them, and rays that spread as widely as they may in
  // one packet: what they meet beside the eye may be centred behind it.
  const Fixture<TypeParam> f(randomParticles(40, 37, 0.2, 0.6));
  Random random(10);
  for (int k = 0; k < 200; ++k)
  {
    const Vec3d eye = random.inBox(Vec3d(-1.3), Vec3d(1.3));
    Vec3d axis(0.0);
    axis[k % 3] = k % 2 == 0 ? 1.0 : -1.0;
    expectRight(
      f, lookAt(eye, eye + axis + 0.2 * random.direction(), random(80.0, 120.0)), false, 8);
  }
}

TYPED_TEST(StructureViews, WideAnglesSplitPackets)
{
  const Fixture<TypeParam> f(randomParticles(1000, 35, 0.02, 0.1));
  Random random(6);
  for (const double angle : {60.0, 100.0, 150.0, 179.0})
    for (int k = 0; k < 6; ++k)
    {
      const Vec3d eye = random.inBox(Vec3d(-1.5), Vec3d(1.5));
      // Few pixels: a packet spans most of the view.
      for (const int size : {8, 16, 24})
        expectRight(f, lookAt(eye, eye + random.direction(), angle), false, size);
    }
}

TYPED_TEST(StructureViews, NarrowAngles)
{
  const Fixture<TypeParam> f(randomParticles(4000, 36, 0.02, 0.08));
  Random random(7);
  for (const double angle : {1.0, 1e-2, 1e-4})
    for (int k = 0; k < 6; ++k)
    {
      // The eye goes back so that the view holds a few particles.
      const double distance = 0.3 / std::tan(angle * M_PI / 360.0);
      expectRight(f, lookAt(distance * random.direction(), Vec3d(0.0), angle));
      expectRight(f, lookAt(3.0 * random.direction(), Vec3d(0.0), angle), false, 16);
    }
}

TYPED_TEST(StructureViews, RadiiOverManyOrders)
{
  Random random(8);
  Particles particles;
  for (int i = 0; i < 3000; ++i)
    particles.add(random.inBox(Vec3d(-1.0), Vec3d(1.0)), std::pow(10.0, random(-4.0, -0.7)));
  const Fixture<TypeParam> f(particles);
  for (int k = 0; k < 8; ++k)
    expectRight(f, lookAt(random(1.2, 5.0) * random.direction(), Vec3d(0.0), 40.0));
}

TYPED_TEST(StructureViews, ClustersWithEmptySpaceBetween)
{
  // Most macrocells are empty and are jumped over, from every side and for both signs.
  Random random(9);
  Particles particles;
  for (int cluster = 0; cluster < 12; ++cluster)
  {
    const Vec3d middle = random.inBox(Vec3d(-1.0), Vec3d(1.0));
    for (int i = 0; i < 400; ++i)
      particles.add(middle + 0.02 * random(0.0, 1.0) * random.direction(), 0.004);
  }
  const Fixture<TypeParam> f(particles);
  for (int k = 0; k < 30; ++k)
    expectRight(f, lookAt(2.5 * random.direction(), 0.5 * random.direction(), 50.0), false, 64);
}
