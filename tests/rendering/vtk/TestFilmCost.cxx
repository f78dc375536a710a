// What films take, learned from films: few rays never decide alone, and true changes are followed.
#include "FilmCost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using mote::FilmCost;

namespace
{

constexpr double wanted = 0.08; // seconds a film
constexpr double pixels = 1 << 20, coarsest = pixels / (32 * 32);

/// Films that really take so long.
struct Machine
{
  double start, perRay;
  FilmCost cost{};

  double raysChosen() const { return std::clamp(cost.raysFor(wanted), coarsest, pixels); }

  /// A film as fine as the time allows, given up as FrameTracer does; its seconds.
  double film(double extra = 0.0)
  {
    const double rays = this->raysChosen();
    const double seconds = start + extra + perRay * rays;
    const bool complete = seconds < 3.0 * wanted || rays <= coarsest;
    const double spent = complete ? seconds : 3.0 * wanted;
    const double done = complete ? rays : std::max(1.0, (spent - start - extra) / perRay);
    cost.learn(spent, done, complete);
    return spent;
  }
  void films(int count)
  {
    for (int i = 0; i < count; ++i)
      this->film();
  }
};

} // namespace

TEST(FilmCost, FilmsComeToTakeTheirTime)
{
  for (const double perRay : {2e-7, 1e-6, 1e-5, 5e-5})
    for (const double start : {0.0, 0.01, 0.03})
    {
      Machine machine{start, perRay};
      machine.films(30);
      EXPECT_NEAR(machine.film(), std::min(wanted, start + perRay * pixels), 0.1 * wanted)
        << perRay << ' ' << start;
    }
}

TEST(FilmCost, AColdBeginningDoesNotDecide)
{
  for (const double perRay : {1e-6, 5e-6, 2e-5})
  {
    Machine machine{0.001, perRay};
    machine.films(10);
    const double before = machine.raysChosen();
    // Of a new time step, whatever it takes to touch its memory.
    for (const double cold : {0.02, 0.05, 0.1, 0.14})
    {
      machine.film(cold);
      EXPECT_GE(machine.raysChosen(), 0.2 * before) << perRay << ' ' << cold;
    }
    machine.films(10);
    EXPECT_GE(machine.raysChosen(), 0.85 * before) << "and is forgotten";
  }
}

TEST(FilmCost, ColdFilmsOfFewRaysOneAfterTheOtherKeepTheResolution)
{
  // As where time steps are played: each takes its beginning, which no resolution changes.
  Machine machine{0.002, 2.3e-6};
  machine.films(10);
  machine.start = 0.1;
  machine.films(50);
  EXPECT_GE(machine.raysChosen(), pixels / (10 * 10)) << "not 1/32 resolution";
}

TEST(FilmCost, FilmsBesideOtherWorkAreSeldomTheCoarsest)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> beginning(0.0, 0.2);
  Machine machine{0.002, 2.3e-6};
  machine.films(10);
  std::vector<double> rays;
  for (int i = 0; i < 501; ++i)
  {
    machine.film(beginning(random)); // of background threads that read and build
    rays.push_back(machine.raysChosen());
  }
  std::sort(rays.begin(), rays.end());
  EXPECT_GE(rays[250], pixels / (13 * 13));
}

TEST(FilmCost, FewRaysTellLittle)
{
  FilmCost cost;
  for (int i = 0; i < 20; ++i)
    cost.learn(0.08, 16000, true);
  const double before = cost.secondsPerRay();
  EXPECT_NEAR(before, 5e-6, 2e-7);
  FilmCost many = cost;
  cost.learn(0.06, 1024, true); // 12 times as long a ray
  EXPECT_LT(cost.secondsPerRay(), 1.1 * before);
  many.learn(0.16, 16000, true);
  EXPECT_GT(many.secondsPerRay(), 1.25 * before);
}

TEST(FilmCost, TrueChangesAreFollowed)
{
  for (const double factor : {100.0, 10.0, 3.0, 0.3, 0.1, 0.01})
  {
    Machine machine{0.001, factor > 1.0 ? 3e-7 : 5e-5};
    machine.films(10);
    machine.perRay *= factor;
    machine.films(6);
    const double rays = (wanted - machine.start) / machine.perRay;
    EXPECT_NEAR(
      std::log(machine.raysChosen()), std::log(std::clamp(rays, coarsest, pixels)), std::log(1.5))
      << factor;
  }
}

TEST(FilmCost, AnyFilmsLeaveAnEstimateWithinWhatFilmsTold)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-6.0, 2.0);
  std::uniform_real_distribution<double> count(0.0, 6.5);
  for (int round = 0; round < 200; ++round)
  {
    FilmCost cost;
    for (int i = 0; i < 50; ++i)
    {
      const double seconds = std::pow(10.0, exponent(random));
      const double rays = std::floor(std::pow(10.0, count(random)));
      cost.learn(seconds, rays, i % 3 != 0);
      ASSERT_TRUE(std::isfinite(cost.secondsPerRay()));
      ASSERT_GT(cost.secondsPerRay(), 0.0);
      ASSERT_LE(cost.secondsPerRay(), 1.0001 * seconds / rays) << "no ray took longer";
      ASSERT_GE(cost.seconds(rays), cost.secondsPerRay() * rays);
    }
    cost.learn(0.0, 100, true); // tells nothing
    cost.learn(0.1, 0, true);
    ASSERT_GT(cost.raysFor(wanted), 0.0);
    ASSERT_EQ(cost.raysFor(0.0), 0.0);
  }
}
