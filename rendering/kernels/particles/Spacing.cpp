#include "ParticleSet.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace mote
{

namespace
{

/// Places whose nearest particles are looked for, found by the cell they lie in.
class Probes
{
public:
  Probes(const std::vector<Vec3d>& places, const Vec3d& lower, double cell)
    : lower_(lower)
    , cellsPerUnit_(1.0 / cell)
    , places_(places)
  {
    for (std::size_t probe = 0; probe < places.size(); ++probe)
    {
      const Vec3i c = cellOf(places[probe]);
      for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
          {
            const std::uint64_t k = key(c + Vec3i(dx, dy, dz));
            near_[k].push_back(probe);
            maybe_[bitOf(k) / 64] |= std::uint64_t{1} << bitOf(k) % 64;
          }
    }
    best_ = std::vector<std::atomic<double>>(places.size());
    for (auto& b : best_)
      b.store(std::numeric_limits<double>::infinity());
  }

  /// Offers a particle at `p` as a neighbour to the probes in the cells around it.
  void offer(const Vec3d& p)
  {
    if (!isValidParticle(p, 1.0))
      return;
    const std::uint64_t k = key(cellOf(p));
    if ((maybe_[bitOf(k) / 64] >> bitOf(k) % 64 & 1) == 0)
      return;
    const auto found = near_.find(k);
    if (found == near_.end())
      return;
    for (const std::size_t probe : found->second)
    {
      const Vec3d d = p - places_[probe];
      const double d2 = glm::dot(d, d);
      double old = best_[probe].load(std::memory_order_relaxed);
      while (d2 > 0.0 && d2 < old && !best_[probe].compare_exchange_weak(old, d2))
      {
      }
    }
  }

  /// For each place the distance to the nearest other particle that was offered; where it is more
  /// than a cell there may be a nearer one.
  std::vector<double> distances() const
  {
    std::vector<double> all;
    for (const auto& best : best_)
      all.push_back(std::sqrt(best.load()));
    return all;
  }

private:
  /// Nothing good lies below lower_, so that to cut off is to round down.
  Vec3i cellOf(const Vec3d& p) const { return Vec3i((p - lower_) * cellsPerUnit_); }
  static std::uint64_t key(const Vec3i& c)
  {
    // 21 bits an axis: cells are never smaller than 2^-18 of the bounds.
    const auto bits = [](int v) { return static_cast<std::uint64_t>(v + 2) & 0x1fffff; };
    return bits(c.x) | (bits(c.y) << 21) | (bits(c.z) << 42);
  }

  static std::size_t bitOf(std::uint64_t key)
  {
    return static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> (64 - maybeBits));
  }

  static constexpr int maybeBits = 19; // 64 kB, of which probes fill one bit in 75

  Vec3d lower_;
  double cellsPerUnit_;
  const std::vector<Vec3d>& places_;
  std::vector<std::atomic<double>> best_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> near_;
  /// Whether a cell can be in near_, by a hash: what most particles need not look up.
  std::vector<std::uint64_t> maybe_ = std::vector<std::uint64_t>((1u << maybeBits) / 64);
};

/// Edge of the cells in which evenly spread particles would lie one by one.
double meanSpacing(const Vec3d& size, std::size_t count)
{
  // Directions in which the set is thinner than the spacing found so far do not count.
  double spacing = std::max({size.x, size.y, size.z});
  for (int dims = 3; dims >= 1; --dims)
  {
    double extents[3] = {size.x, size.y, size.z};
    std::sort(extents, extents + 3, std::greater<>());
    double measure = 1.0;
    for (int k = 0; k < dims; ++k)
      measure *= extents[k];
    spacing = std::pow(measure / static_cast<double>(count), 1.0 / dims);
    if (extents[dims - 1] >= spacing)
      break;
  }
  return spacing;
}

/// One process with all of the particles.
class AllParticles : public ParticleParts
{
public:
  void sum(std::vector<double>&) const override {}
  void least(std::vector<double>&) const override {}
  double before(double) const override { return 0.0; }
};

/// How many particles the parts have together, how many of them are valid, and their bounds.
struct Together
{
  std::size_t count = 0, valid = 0;
  std::size_t before = 0; ///< in the parts before this one
  Vec3d lower{0.0}, size{0.0};
};

Together lookAt(const ParticleSet& set, const ParticleParts& parts)
{
  const ParticleStatistics own = examine(set);
  const auto count = static_cast<double>(set.count());
  std::vector<double> counts = {count, static_cast<double>(own.valid)};
  parts.sum(counts);
  const Vec3d &lower = own.centers.lower, &upper = own.centers.upper;
  std::vector<double> ends = {lower.x, lower.y, lower.z, -upper.x, -upper.y, -upper.z};
  parts.least(ends);
  Together all;
  all.count = static_cast<std::size_t>(counts[0]);
  all.valid = static_cast<std::size_t>(counts[1]);
  all.before = static_cast<std::size_t>(parts.before(count));
  all.lower = Vec3d(ends[0], ends[1], ends[2]);
  all.size = -Vec3d(ends[3], ends[4], ends[5]) - all.lower;
  return all;
}

/// The places of an even sample of the particles, without those that are not valid.
std::vector<Vec3d> sampleOf(const ParticleSet& set, const Together& all, const ParticleParts& parts)
{
  const std::size_t n = all.count, samples = std::min<std::size_t>(256, n);
  std::vector<double> places(4 * samples, 0.0); // and whether it is there
  for (std::size_t k = 0; k < samples; ++k)
  {
    const std::size_t i =
      std::min(n - 1, (2 * k + 1) * (n / (2 * samples)) + k * (n % (2 * samples)) / samples);
    if (i < all.before || i - all.before >= set.count())
      continue;
    const Vec3d place = set.position(i - all.before);
    if (!isValidParticle(place, 1.0))
      continue;
    for (int axis = 0; axis < 3; ++axis)
      places[4 * k + static_cast<std::size_t>(axis)] = place[axis];
    places[4 * k + 3] = 1.0;
  }
  parts.sum(places); // each has its own, and zeros
  std::vector<Vec3d> sample;
  for (std::size_t k = 0; k < samples; ++k)
    if (places[4 * k + 3] > 0.0)
      sample.emplace_back(places[4 * k], places[4 * k + 1], places[4 * k + 2]);
  return sample;
}

} // namespace

double estimateSpacing(const ParticleSet& particles, const ParticleParts* given)
{
  const AllParticles alone;
  const ParticleParts& parts = given ? *given : alone;
  ParticleSet set; // without radii, which might be bad where positions are good
  set.positions = particles.positions;
  set.source = particles.source;
  const Together all = lookAt(set, parts);
  const double longest = std::max({all.size.x, all.size.y, all.size.z});
  if (all.valid < 2 || !(longest > 0.0))
    return 1.0;
  std::vector<Vec3d> open = sampleOf(set, all, parts);

  // What is found within a cell is nearer than all that is not: once more than half of the probes
  // have found their neighbour, the median is among those found.
  std::vector<double> distances;
  const std::size_t middle = open.size() / 2;
  double cell = std::max(2.0 * meanSpacing(all.size, all.valid), longest * std::ldexp(1.0, -18));
  while (!open.empty() && distances.size() <= middle)
  {
    Probes probes(open, all.lower, cell);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, set.count(), 1 << 14),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        set.forRange(range.begin(), range.end(),
          [&](std::size_t, const Vec3d& p, double) { probes.offer(p); });
      });
    std::vector<double> found = probes.distances();
    parts.least(found);
    std::vector<Vec3d> left;
    for (std::size_t k = 0; k < found.size(); ++k)
      if (found[k] <= cell)
        distances.push_back(found[k]);
      else
        left.push_back(open[k]);
    open = std::move(left);
    if (cell > 2.0 * longest)
      break;
    cell *= 4.0;
  }
  if (distances.empty())
    return 1.0;
  const auto median = distances.begin() + std::min(middle, distances.size() - 1);
  std::nth_element(distances.begin(), median, distances.end());
  return *median;
}

} // namespace mote
