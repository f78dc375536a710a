// Every SIMD instruction set of this machine gives the same answer.

#include <kernels/particles/CoherentGrid.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <hwy/highway.h>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Lets Highway choose among `targets` only, until it goes.
class OnlyTargets
{
public:
  explicit OnlyTargets(std::int64_t targets) { set(targets); }
  ~OnlyTargets() { set(0); }
  OnlyTargets(const OnlyTargets&) = delete;
  OnlyTargets& operator=(const OnlyTargets&) = delete;

private:
  static void set(std::int64_t targets)
  {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().DeInit();
  }
};

std::vector<RayPacket> questions()
{
  std::vector<RayPacket> packets;
  Random random(101);
  for (int k = 0; k < 60; ++k)
  {
    const CameraRays rays(lookAt(random(1.0, 4.0) * random.direction(), Vec3d(0.0), 50.0), 32, 32);
    packets.emplace_back();
    rays.fillBlock(packets.back(), 8 * (k % 4), 8, 0.0, 0.0);
    packets.back().count = k % 3 == 0 ? 1 + k : 64;
  }
  for (int k = 0; k < 20; ++k)
  {
    packets.push_back(emptyPacket());
    for (int i = 0; i < 64; ++i)
      addRay(packets.back(), random.inBox(Vec3d(-1.0), Vec3d(1.0)), random.direction(), 0.1, 2.0);
  }
  return packets;
}

} // namespace

TEST(CoherentGridTargets, EveryInstructionSetAgreesWithTheReference)
{
  const Particles particles = randomParticles(2000, 102, 0.01, 0.08);
  CoherentGrid grid;
  grid.build(particles.set());
  const CastOracle oracle = CastOracle::forFloat(particles.set());
  const std::vector<RayPacket> packets = questions();

  std::vector<std::int64_t> targets;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
    targets.push_back(left & -left);
  ASSERT_FALSE(targets.empty());
  std::vector<RayPacket> first;
  for (const std::int64_t target : targets)
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    CastReport report;
    std::size_t differing = 0, rays = 0;
    std::vector<RayPacket> answers = packets;
    for (std::size_t k = 0; k < packets.size(); ++k)
    {
      report.add(checkPacket(grid, oracle, packets[k]));
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
  RecordProperty("targets", static_cast<int>(targets.size()));
}
