// Queries of a P-k-d tree: each particle is shown or not as its own values say, whatever is decided
// for many at once, and a tree of the shown particles alone answers as the whole one does.

#include <kernels/particles/PkdTree.h>

#include <support/CastOracle.h>
#include <support/Particles.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

/// Particles with four attributes: a function of the place, one of no place, one with values that
/// are no numbers, and one with few values.
struct Queried
{
  Particles particles;
  std::vector<float> attributes[4];

  Queried(std::size_t count, double smallest, double largest)
    : particles(randomParticles(count, 77, smallest, largest))
  {
    Random random(78);
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vec3d p = particles.center(i);
      attributes[0].push_back(static_cast<float>(p.x * p.x + p.y * p.y + p.z * p.z));
      attributes[1].push_back(static_cast<float>(random()));
      attributes[2].push_back(p.x > 0.5           ? notANumber
                              : random() < 0.0005 ? notANumber
                              : random() < 0.1    ? (random() < 0.5 ? -infinite : infinite)
                                                  : static_cast<float>(p.y));
      attributes[3].push_back(std::floor(static_cast<float>(5.0 * p.z)));
    }
  }

  float value(std::size_t i, int k) const { return attributes[k][i]; }

  void build(PkdTree& tree, const PkdTreeOptions& options) const
  {
    tree.build(particles.set(), options);
    std::vector<ParticleAttribute> all;
    for (const auto& values : attributes)
      all.push_back({ArrayView(values.data(), values.size(), 1)});
    tree.setAttributes(all);
  }

  /// One to three ranges, of any width, or with nothing in them.
  ParticleRanges randomRanges(Random& random) const
  {
    ParticleRanges ranges;
    for (int n = static_cast<int>(random(1.0, 4.0)); n > 0; --n)
    {
      const auto k = static_cast<std::size_t>(random(0.0, 8.0));
      const auto some = [&]
      {
        const auto i = static_cast<std::size_t>(random(0.0, double(particles.size())));
        return k < 3    ? particles.center(i)[static_cast<int>(k)] + 1e-6
               : k == 3 ? particles.radii[i] * 1.000001
                        : double(value(i, static_cast<int>(k) - 4));
      };
      const double kind = random();
      if (kind < 0.8)
        ranges.lower[k] = some();
      if (kind > 0.2)
        ranges.upper[k] = some();
      if (ranges.lower[k] > ranges.upper[k] && random() < 0.9)
        std::swap(ranges.lower[k], ranges.upper[k]);
    }
    return ranges;
  }

  bool isIn(const ParticleRanges& ranges, std::size_t i) const
  {
    for (std::size_t k = 0; k < 8; ++k)
    {
      const double v = k < 3    ? particles.center(i)[static_cast<int>(k)]
                       : k == 3 ? particles.radii[i]
                                : double(value(i, static_cast<int>(k) - 4));
      if (ranges.isLimited(static_cast<int>(k)) && !(v >= ranges.lower[k] && v <= ranges.upper[k]))
        return false;
    }
    return true;
  }
};

/// Whether rays at the centres of the particles, which are far apart, meet them.
std::vector<bool> shownParticles(const PkdTree& tree)
{
  std::vector<bool> shown(tree.size(), false);
  RayPacket packet;
  for (std::size_t first = 0; first < tree.size(); first += RayPacket::capacity)
  {
    packet.count =
      static_cast<int>(std::min<std::size_t>(RayPacket::capacity, tree.size() - first));
    for (int i = 0; i < packet.count; ++i)
    {
      const std::size_t slot = first + static_cast<std::size_t>(i);
      const Vec3d from = tree.center(slot) + Vec3d(0.0, 0.0, 2.0 * tree.radius(slot));
      for (int k = 0; k < 3; ++k)
      {
        packet.origin[k][i] = from[k];
        packet.direction[k][i] = k == 2 ? -1.0 : 0.0;
      }
      packet.tMin[i] = 0.0;
      packet.t[i] = 2.0 * tree.radius(slot);
      packet.slot[i] = RayPacket::noHit;
      packet.object[i] = -1;
    }
    tree.cast(packet, 0);
    for (int i = 0; i < packet.count; ++i)
      shown[tree.inputIndex(first + static_cast<std::size_t>(i))] =
        packet.slot[i] == first + static_cast<std::size_t>(i);
  }
  return shown;
}

/// Random rays, from particles where `slots` are known, into the set.
RayPacket randomPacket(Random& random, const PkdTree& tree, bool fromParticles)
{
  RayPacket packet;
  packet.count = RayPacket::capacity;
  for (int i = 0; i < packet.count; ++i)
  {
    const auto slot = static_cast<std::size_t>(random(0.0, double(tree.size())));
    const Vec3d way = random.direction();
    const Vec3d from = fromParticles ? tree.center(slot) + tree.radius(slot) * way : -3.0 * way;
    for (int k = 0; k < 3; ++k)
    {
      packet.origin[k][i] = from[k];
      packet.direction[k][i] = way[k] + (fromParticles ? 0.0 : random(-0.2, 0.2));
    }
    packet.tMin[i] = 0.0;
    packet.t[i] = i % 2 == 0 ? std::numeric_limits<double>::infinity() : 3.0;
    packet.slot[i] = fromParticles ? slot : RayPacket::noHit;
    packet.object[i] = fromParticles ? 4 : -1;
  }
  return packet;
}

template <typename Rays>
void expectSame(const Rays& a, const Rays& b, std::size_t& hits)
{
  for (int i = 0; i < a.count; ++i)
  {
    ASSERT_EQ(a.object[i], b.object[i]);
    ASSERT_EQ(a.slot[i], b.slot[i]);
    ASSERT_EQ(a.t[i], b.t[i]);
    hits += a.object[i] == 4 || a.t[i] < 0.0;
  }
}

/// Expects the same answers of both, to the last bit.
void expectSame(const PkdTree& a, const PkdTree& b, std::uint64_t seed, std::size_t& hits)
{
  Random random(seed);
  for (int k = 0; k < 8; ++k)
  {
    const RayPacket packet = randomPacket(random, a, k % 2 == 1);
    for (const bool any : {false, true})
    {
      RayPacket one = packet, other = packet;
      any ? a.occlude(one, 4) : a.cast(one, 4);
      any ? b.occlude(other, 4) : b.cast(other, 4);
      expectSame(one, other, hits);
    }
  }
  const CameraRays rays(
    lookAt(random(1.2, 3.0) * random.direction(), 0.3 * random.direction(), 45.0), 128, 128);
  for (int y = 0; y < 128; y += 16)
    for (int x = 0; x < 128; x += 16)
      for (const bool any : {false, true})
      {
        RayBundle one, other;
        rays.fillBundle(one, 16, x, y, 0.0, 0.0);
        other = one;
        any ? a.occlude(one, 4) : a.cast(one, 4);
        any ? b.occlude(other, 4) : b.cast(other, 4);
        expectSame(one, other, hits);
      }
}

std::size_t count(const std::vector<bool>& bits)
{
  return static_cast<std::size_t>(std::count(bits.begin(), bits.end(), true));
}

} // namespace

TEST(PkdTreeQuery, EachParticleIsShownAsItsOwnValuesSay)
{
  const Queried q(9001, 1e-5, 2e-5);
  Random random(5);
  std::size_t some = 0;
  for (const std::size_t sparseShare : {0u, 1u, 8u})
  {
    PkdTreeOptions options;
    options.sparseShare = sparseShare;
    PkdTree tree;
    q.build(tree, options);
    ASSERT_EQ(count(shownParticles(tree)), q.particles.size());
    for (int k = 0; k < 60; ++k)
    {
      const ParticleRanges ranges = q.randomRanges(random);
      const bool third = k % 3 == 0;
      tree.setVisibility(third ? [&](std::size_t slot) { return tree.inputIndex(slot) % 3 == 0; }
                               : std::function<bool(std::size_t)>());
      tree.setRanges(ranges);
      const std::vector<bool> shown = shownParticles(tree);
      for (std::size_t i = 0; i < shown.size(); ++i)
        ASSERT_EQ(shown[i], q.isIn(ranges, i) && (!third || i % 3 == 0)) << i;
      some += count(shown) > 0 && count(shown) < shown.size();
    }
    tree.setVisibility({});
    tree.setRanges({});
    ASSERT_EQ(count(shownParticles(tree)), q.particles.size());
  }
  EXPECT_GT(some, 60u);
}

TEST(PkdTreeQuery, TheTreeOfFewAnswersAsTheWholeOne)
{
  Queried q(40000, 0.004, 0.03);
  // Pairs that coincide: the first of the input is hit.
  for (std::size_t i = 0; i < 4000; i += 2)
  {
    std::copy_n(q.particles.positions.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
      q.particles.positions.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
    q.particles.radii[i + 1] = q.particles.radii[i];
  }
  for (const auto form :
    {PkdTreeOptions::Form::Exact, PkdTreeOptions::Form::Bytes8, PkdTreeOptions::Form::Bytes4})
    for (const bool mixed : {true, false})
    {
      const std::vector<double> radii = q.particles.radii;
      if (!mixed)
        std::fill(q.particles.radii.begin(), q.particles.radii.end(), 0.012);
      PkdTreeOptions options;
      options.form = form;
      options.mostError = 1.0;
      PkdTree few, whole;
      q.build(few, options);
      options.sparseShare = 0;
      q.build(whole, options);
      const std::size_t bytes = few.bytes();
      Random random(6);
      std::size_t sparse = 0, hits = 0;
      for (int k = 0; k < 24; ++k)
      {
        ParticleRanges ranges = k % 2 == 0 ? ParticleRanges() : q.randomRanges(random);
        ranges.lower[5] = random(0.0, 0.9);
        ranges.upper[5] = ranges.lower[5] + std::exp(random(-9.0, -2.0));
        few.setRanges(ranges);
        whole.setRanges(ranges);
        sparse += few.bytes() > whole.bytes() + 1000;
        expectSame(few, whole, static_cast<std::uint64_t>(k), hits);
        if (HasFatalFailure())
          return;
      }
      EXPECT_GT(sparse, 10u);
      EXPECT_GT(hits, 10000u);
      few.setRanges({});
      EXPECT_EQ(few.bytes(), bytes); // all else is given back
      q.particles.radii = radii;
    }
}
