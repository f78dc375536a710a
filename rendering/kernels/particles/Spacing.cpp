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

/// Probes placed on an even sample of the particles, found by the cell they lie in.
class Probes
{
public:
  Probes(const ParticleSet& particles, const std::vector<std::size_t>& indices, const Vec3d& lower,
    double cell)
    : lower_(lower)
    , cellsPerUnit_(1.0 / cell)
    , cell_(cell)
  {
    for (const std::size_t i : indices)
    {
      probes_.push_back({particles.position(i), i});
      const Vec3i c = cellOf(probes_.back().position);
      for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
          {
            const std::uint64_t k = key(c + Vec3i(dx, dy, dz));
            near_[k].push_back(probes_.size() - 1);
            maybe_[bitOf(k) / 64] |= std::uint64_t{1} << bitOf(k) % 64;
          }
    }
    best_ = std::vector<std::atomic<double>>(probes_.size());
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
      const Vec3d d = p - probes_[probe].position;
      const double d2 = glm::dot(d, d);
      double old = best_[probe].load(std::memory_order_relaxed);
      while (d2 > 0.0 && d2 < old && !best_[probe].compare_exchange_weak(old, d2))
      {
      }
    }
  }

  /// Moves the distances found within reach (one cell) to `distances`, and the indices of the
  /// probes that found no neighbour there to `left`.
  void collect(std::vector<double>& distances, std::vector<std::size_t>& left) const
  {
    for (std::size_t k = 0; k < probes_.size(); ++k)
    {
      const double d = std::sqrt(best_[k].load());
      if (d <= cell_)
        distances.push_back(d);
      else
        left.push_back(probes_[k].index);
    }
  }

private:
  struct Probe
  {
    Vec3d position;
    std::size_t index;
  };

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
  double cell_;
  std::vector<Probe> probes_;
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

} // namespace

double estimateSpacing(const ParticleSet& particles)
{
  ParticleSet set; // without radii, which might be bad where positions are good
  set.positions = particles.positions;
  set.source = particles.source;
  const ParticleStatistics statistics = examine(set);
  const Vec3d size = statistics.centers.size();
  const double longest = std::max({size.x, size.y, size.z});
  if (statistics.valid < 2 || !(longest > 0.0))
    return 1.0;

  const std::size_t n = set.count();
  std::vector<std::size_t> open;
  const std::size_t samples = std::min<std::size_t>(256, n);
  for (std::size_t k = 0; k < samples; ++k)
  {
    const std::size_t i = (2 * k + 1) * (n / (2 * samples)) + k * (n % (2 * samples)) / samples;
    if (isValidParticle(set.position(std::min(i, n - 1)), 1.0))
      open.push_back(std::min(i, n - 1));
  }

  // What is found within a cell is nearer than all that is not: once more than half of the probes
  // have found their neighbour, the median is among those found.
  std::vector<double> distances;
  const std::size_t middle = open.size() / 2;
  double cell = std::max(2.0 * meanSpacing(size, statistics.valid), longest * std::ldexp(1.0, -18));
  while (!open.empty() && distances.size() <= middle)
  {
    Probes probes(set, open, statistics.centers.lower, cell);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1 << 14),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        set.forRange(range.begin(), range.end(),
          [&](std::size_t, const Vec3d& p, double) { probes.offer(p); });
      });
    open.clear();
    probes.collect(distances, open);
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
