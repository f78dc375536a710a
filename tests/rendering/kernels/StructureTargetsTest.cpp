// Every SIMD instruction set of this machine gives the same answer.

#include <support/Structure.h>

#include <support/CastOracle.h>
#include <support/Particles.h>
#include <support/Targets.h>

#include <gtest/gtest.h>

using namespace mote;
using namespace mote::testing;

namespace
{

std::vector<RayBundle> questions()
{
  std::vector<RayBundle> bundles;
  Random random(101);
  for (int k = 0; k < 60; ++k)
  {
    Camera camera = lookAt(random(1.0, 4.0) * random.direction(), Vec3d(0.0), 50.0);
    if (k % 5 == 4)
      camera.projection = Camera::Projection::Orthographic;
    const CameraRays rays(camera, 32, 32);
    bundles.emplace_back();
    rays.fillBundle(bundles.back(), 2 << (k % 4), 16 * (k / 4 % 2), 8, 0.0, 0.0);
    if (k % 3 == 0) // rays anywhere
    {
      bundles.back().count = std::min(bundles.back().count, 1 + 2 * k);
      bundles.back().side = 0;
    }
  }
  return bundles;
}

} // namespace

template <typename Structure>
using StructureTargets = StructureTest<Structure>;
TYPED_TEST_SUITE(StructureTargets, ParticleStructures, StructureName);

TYPED_TEST(StructureTargets, EveryInstructionSetAgreesWithTheReference)
{
  const Particles particles = randomParticles(2000, 102, 0.01, 0.08);
  TypeParam grid;
  grid.build(particles.set());
  const CastOracle oracle = CastOracle::forFloat(particles.set());
  const std::vector<RayBundle> bundles = questions();

  const std::vector<std::int64_t> targets = everyTarget();
  ASSERT_FALSE(targets.empty());
  std::vector<RayBundle> first;
  for (const std::int64_t target : targets)
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    CastReport report;
    std::size_t differing = 0, rays = 0;
    std::vector<RayBundle> answers = bundles;
    for (std::size_t k = 0; k < bundles.size(); ++k)
    {
      report.add(checkBundle(grid, oracle, bundles[k]));
      grid.cast(answers[k], 0);
      if (!first.empty())
        for (int i = 0; i < answers[k].count; ++i, ++rays)
          differing += answers[k].slot[i] != first[k].slot[i] ||
                       std::abs(answers[k].t[i] - first[k].t[i]) > 1e-5;
    }
    EXPECT_EQ(report.wrong, 0u) << "of " << report.rays << " rays; " << report.complaint;
    EXPECT_GT(report.hits, report.rays / 4);
    // Fused and separate multiply-add round differently: a silhouette may fall to either side.
    EXPECT_LE(differing, rays / 1000);
    if (first.empty())
      first = answers;
  }
  this->RecordProperty("targets", static_cast<int>(targets.size()));
}
