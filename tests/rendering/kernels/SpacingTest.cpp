// The typical distance between neighbours.

#include <kernels/core/Error.h>
#include <kernels/particles/ParticleSet.h>

#include <support/Particles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <cmath>
#include <functional>
#include <numeric>
#include <thread>

using namespace mote;
using namespace mote::testing;

namespace
{

double spacingOf(const Particles& particles)
{
  return estimateSpacing(particles.set());
}

Particles lattice(int nx, int ny, int nz, double spacing, const Vec3d& corner = Vec3d(0.0))
{
  Particles particles;
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        particles.add(corner + spacing * Vec3d(x, y, z), 1.0);
  return particles;
}

} // namespace

TEST(Spacing, OfALatticeIsExact)
{
  for (const double spacing : {1e-9, 0.5, 3.0, 1e6})
    for (const int n : {2, 3, 10, 30})
      EXPECT_NEAR(spacingOf(lattice(n, n, n, spacing)), spacing, 1e-12 * spacing) << n;
}

TEST(Spacing, OfFlatAndLinearSets)
{
  EXPECT_NEAR(spacingOf(lattice(40, 30, 1, 0.25)), 0.25, 1e-12);
  EXPECT_NEAR(spacingOf(lattice(1, 40, 30, 0.25)), 0.25, 1e-12);
  EXPECT_NEAR(spacingOf(lattice(1, 1000, 1, 0.25)), 0.25, 1e-12);
  EXPECT_NEAR(spacingOf(lattice(2, 1, 1, 7.0)), 7.0, 1e-12);
}

TEST(Spacing, FarFromTheOrigin)
{
  EXPECT_NEAR(spacingOf(lattice(10, 10, 10, 0.5, Vec3d(1e9, -1e9, 1e8))), 0.5, 1e-6);
}

TEST(Spacing, OfClustersIsThatWithinThem)
{
  Random random(111);
  Particles particles;
  for (int cluster = 0; cluster < 20; ++cluster)
  {
    const Particles part = lattice(6, 6, 6, 0.001, random.inBox(Vec3d(-50.0), Vec3d(50.0)));
    for (std::size_t i = 0; i < part.size(); ++i)
      particles.add(part.center(i), 1.0);
  }
  EXPECT_NEAR(spacingOf(particles), 0.001, 1e-9);
}

TEST(Spacing, IsTheMedianOfNearestDistances)
{
  const Particles particles = randomParticles(200, 112, 0.1, 0.1);
  std::vector<double> nearest;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    double least = INFINITY;
    for (std::size_t k = 0; k < particles.size(); ++k)
      if (k != i)
        least = std::min(least, glm::length(particles.center(i) - particles.center(k)));
    nearest.push_back(least);
  }
  std::sort(nearest.begin(), nearest.end());
  const double found = spacingOf(particles);
  EXPECT_GE(found, nearest[98] * (1.0 - 1e-12));
  EXPECT_LE(found, nearest[101] * (1.0 + 1e-12));
}

TEST(Spacing, OfRandomSetsIsNearTheExpectedOne)
{
  // For evenly random points of density d the median is (3 ln 2 / (4 pi d))^(1/3).
  const std::size_t count = 100000;
  const double expected = std::cbrt(3.0 * std::log(2.0) / (4.0 * M_PI * double(count) / 8.0));
  EXPECT_NEAR(spacingOf(randomParticles(count, 113, 0.1, 0.1)), expected, 0.1 * expected);
}

TEST(Spacing, DuplicatesAreNoNeighbours)
{
  Particles particles;
  for (int copy = 0; copy < 4; ++copy)
  {
    const Particles part = lattice(8, 8, 8, 2.0);
    for (std::size_t i = 0; i < part.size(); ++i)
      particles.add(part.center(i), 1.0);
  }
  EXPECT_NEAR(spacingOf(particles), 2.0, 1e-12);
}

TEST(Spacing, IsOneWhereThereIsNone)
{
  Particles particles;
  EXPECT_EQ(estimateSpacing(ParticleSet{}), 1.0);
  particles.add({3.0, 4.0, 5.0}, 1.0);
  EXPECT_EQ(spacingOf(particles), 1.0);
  for (int i = 0; i < 100; ++i)
    particles.add({3.0, 4.0, 5.0}, 1.0);
  EXPECT_EQ(spacingOf(particles), 1.0);
}

TEST(Spacing, PassesOverBadPositions)
{
  Particles particles = lattice(10, 10, 10, 0.5);
  for (int i = 0; i < 400; ++i)
    particles.add({std::nan(""), 0.0, i % 2 == 0 ? INFINITY : 1.0}, 1.0);
  EXPECT_NEAR(spacingOf(particles), 0.5, 1e-12);
  Particles bad;
  bad.add({std::nan(""), 0.0, 0.0}, 1.0);
  bad.add({INFINITY, 0.0, 0.0}, 1.0);
  EXPECT_EQ(spacingOf(bad), 1.0);
}

namespace
{

/// Threads in place of processes.
struct Board
{
  explicit Board(int count)
    : meeting(count)
    , said(static_cast<std::size_t>(count))
  {
  }
  std::barrier<> meeting;
  std::vector<std::vector<double>> said;
};

class ThreadPart : public ParticleParts
{
public:
  ThreadPart(Board& board, std::size_t number)
    : board_(board)
    , number_(number)
  {
  }
  void sum(std::vector<double>& values) const override
  {
    this->reduce(values, [](double a, double b) { return a + b; });
  }
  void least(std::vector<double>& values) const override
  {
    this->reduce(values, [](double a, double b) { return std::min(a, b); });
  }
  double before(double value) const override
  {
    board_.said[number_] = {value};
    board_.meeting.arrive_and_wait();
    double all = 0.0;
    for (std::size_t i = 0; i < number_; ++i)
      all += board_.said[i].front();
    board_.meeting.arrive_and_wait();
    return all;
  }

private:
  void reduce(
    std::vector<double>& values, const std::function<double(double, double)>& operation) const
  {
    board_.said[number_] = values;
    board_.meeting.arrive_and_wait();
    for (std::size_t i = 0; i < board_.said.size(); ++i)
      for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = i == 0 ? board_.said[0][k] : operation(values[k], board_.said[i][k]);
    board_.meeting.arrive_and_wait();
  }
  Board& board_;
  std::size_t number_;
};

/// What each of the parts says, which have so many particles one after the other.
std::vector<double> spacingsOf(const Particles& whole, const std::vector<std::size_t>& sizes)
{
  std::vector<Particles> parts(sizes.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    for (std::size_t i = 0; i < sizes[k]; ++i)
      parts[k].add(whole.center(next++), 1.0);
  Board board(static_cast<int>(sizes.size()));
  std::vector<double> spacings(sizes.size());
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    threads.emplace_back(
      [&, k]
      {
        const ThreadPart part(board, k);
        spacings[k] = estimateSpacing(parts[k].size() > 0 ? parts[k].set() : ParticleSet{}, &part);
      });
  for (std::thread& thread : threads)
    thread.join();
  return spacings;
}

} // namespace

TEST(Spacing, OfPartsIsThatOfTheWhole)
{
  // In no order: neighbours are with others.
  Random random(5);
  Particles whole;
  for (int i = 0; i < 3000; ++i)
    whole.add(random.inBox({0.0, 0.0, 0.0}, {5.0, 3.0, 1.0}), 1.0);
  whole.add({std::nan(""), 0.0, 0.0}, 1.0);
  const double expected = spacingOf(whole);
  for (const std::vector<std::size_t>& sizes : std::vector<std::vector<std::size_t>>{
         {3001}, {1500, 1501}, {0, 3001}, {1, 0, 3000}, {1000, 1, 1000, 1000}, {3000, 1}})
  {
    ASSERT_EQ(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), 3001u);
    for (const double spacing : spacingsOf(whole, sizes))
      EXPECT_EQ(spacing, expected) << sizes.size();
  }
  EXPECT_EQ(spacingsOf(Particles(), {0, 0}), (std::vector<double>{1.0, 1.0}));
  Particles two;
  two.add({0.0, 0.0, 0.0}, 1.0);
  two.add({0.0, 3.0, 0.0}, 1.0);
  EXPECT_EQ(spacingsOf(two, {1, 1}), (std::vector<double>{3.0, 3.0}));
}

TEST(Spacing, RefusesTwoComponents)
{
  const double numbers[] = {0.0, 1.0, 2.0, 3.0};
  ParticleSet flat;
  flat.positions = ArrayView(numbers, 2, 2);
  EXPECT_THROW(estimateSpacing(flat), Error);
}
