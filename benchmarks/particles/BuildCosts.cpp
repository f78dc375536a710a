#include "BuildCosts.h"

#include "../PeakMemory.h"

namespace mote::bench
{

namespace
{

/// One who builds a new object, builds into it again, and lets go of it: no object outlives its
/// turn, because Embree's settle how many threads the whole process may use.
class Builder
{
public:
  Builder(const ParticleMethodEntry& entry, MethodOptions options, const ParticleInput& input,
    int threads)
    : entry_(entry)
    , options_(options)
    , input_(input)
    , threads_(threads)
  {
    options_.threads = threads;
  }

  /// Enters the race twice; the object is made and let go of outside of the time.
  void enter(Race& race)
  {
    first_ = race.addTimed(
      [this]
      {
        made_ = entry_.make(options_);
        return timed(threads_, [this] { made_->build(input_); });
      });
    again_ = race.addTimed(
      [this]
      {
        const double seconds = timed(threads_, [this] { made_->build(input_); });
        made_.reset();
        return seconds;
      });
  }

  BuildCost cost(const Race& race) const
  {
    BuildCost cost{entry_.name, threads_, race.seconds(first_), race.least(first_),
      race.most(first_), race.seconds(again_)};
    const auto particles = static_cast<double>(input_.statistics.valid);
    const std::unique_ptr<ParticleMethod> made = entry_.make(options_);
    cost.peakBytesPerParticle =
      peakExtraBytes([&] { timed(threads_, [&] { made->build(input_); }); }) / particles;
    cost.bytesPerParticle = static_cast<double>(made->bytes()) / particles;
    return cost;
  }

private:
  const ParticleMethodEntry& entry_;
  MethodOptions options_;
  const ParticleInput& input_;
  int threads_;
  std::unique_ptr<ParticleMethod> made_;
  std::size_t first_ = 0, again_ = 0; ///< places in the race
};

/// Time of the peer on as many threads, or 0 where it took no part.
double peerSeconds(const std::vector<BuildCost>& costs, int threads)
{
  for (const BuildCost& cost : costs)
    if (cost.method == "embree" && cost.threads == threads)
      return cost.first;
  return 0.0;
}

} // namespace

std::vector<int> threadCounts(int threads)
{
  return threads > 1 ? std::vector<int>{1, threads} : std::vector<int>{1};
}

std::vector<BuildCost> measureBuilds(const std::vector<const ParticleMethodEntry*>& methods,
  const MethodOptions& options, const ParticleInput& input, const std::vector<int>& threads,
  int repeat)
{
  std::vector<Builder> builders;
  for (const int count : threads)
    for (const ParticleMethodEntry* method : methods)
      builders.emplace_back(*method, options, input, count);
  Race race;
  for (Builder& builder : builders)
    builder.enter(race);
  progress("building %d rounds of %zu", repeat, builders.size());
  race.run(repeat);
  std::vector<BuildCost> costs;
  for (const Builder& builder : builders)
    costs.push_back(builder.cost(race));
  return costs;
}

Section buildSection(const std::vector<BuildCost>& costs)
{
  Section section;
  section.table.add({"method", "threads", "ms", "(min - max)", "embree / this", "again ms",
    "bytes/particle", "at most"});
  for (const BuildCost& cost : costs)
  {
    const double peer = peerSeconds(costs, cost.threads);
    section.table.add({cost.method, format("%d", cost.threads), format("%.1f", 1e3 * cost.first),
      format("%.1f - %.1f", 1e3 * cost.least, 1e3 * cost.most),
      peer > 0.0 ? format("%.2f", peer / cost.first) : "-", format("%.1f", 1e3 * cost.again),
      format("%.1f", cost.bytesPerParticle), format("%.1f", cost.peakBytesPerParticle)});
  }
  section.notes.push_back(
    "ms: first build of a new object; again: a second build into it. at most: most bytes a "
    "particle at any time during the first build.");
  return section;
}

Measurement toMeasurement(const BuildCost& cost, const ParticleInput& input, int repeat)
{
  Measurement m = measurementOf(input, 0, 0, cost.threads, repeat);
  m.method = cost.method;
  m.buildSeconds = cost.first;
  m.bytesPerParticle = cost.bytesPerParticle;
  m.more = {{"build_s_min", cost.least}, {"build_s_max", cost.most}, {"build_again_s", cost.again},
    {"peak_build_bytes_per_particle", cost.peakBytesPerParticle}};
  return m;
}

} // namespace mote::bench
