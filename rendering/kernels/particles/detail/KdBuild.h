#pragma once

#include "../../core/Progress.h"
#include "../ParticleSet.h"
#include "MedianSplit.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <numeric>

namespace mote
{

/// Progress of a work on many threads: may be told from any of them, passes on nothing less than
/// what it passed on before, and remembers that the work shall stop.
class SharedProgress
{
public:
  explicit SharedProgress(const Progress& progress)
    : progress_(progress)
  {
  }

  /// False where the work shall stop. While somebody is told, others are not, and do not wait: who
  /// is told may work in parallel, and come here again by way of that.
  bool report(double done)
  {
    if (!progress_ || stopped_ || telling_.exchange(true))
      return !stopped_;
    reported_ = std::max(reported_, done);
    if (!stopped_ && !progress_(reported_))
      stopped_ = true;
    telling_ = false;
    return !stopped_;
  }

  bool stopped() const { return stopped_; }

private:
  const Progress& progress_;
  std::atomic<bool> telling_{false};
  double reported_ = 0.0;
  std::atomic<bool> stopped_{false};
};

/// Where records lie: bounds of their coordinates, both ends included.
struct KdRegion
{
  std::array<std::uint32_t, 3> low, high;

  KdRegion() = default;

  /// Of one record or more.
  template <int WORDS>
  KdRegion(const KdRecord<WORDS>* first, const KdRecord<WORDS>* last)
    : low{first->words[0], first->words[1], first->words[2]}
    , high(low)
  {
    for (; first != last; ++first)
      for (std::size_t k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], first->words[k]);
        high[k] = std::max(high[k], first->words[k]);
      }
  }
};

/// Particles up to which a split is worth a look at where they lie: above, the splits before tell
/// well enough.
constexpr std::size_t tightKdCount = std::size_t{1} << 16;

/// Writes recordOf(index, position, radius) of the valid particles, `valid` in number, to `to`, in
/// parallel and in the order of the input.
template <int WORDS, typename RecordOf>
void fillKdRecords(
  const ParticleSet& particles, std::size_t valid, KdRecord<WORDS>* to, const RecordOf& recordOf)
{
  constexpr std::size_t chunk = 1 << 16;
  const std::size_t n = particles.count(), chunks = (n + chunk - 1) / chunk;
  std::vector<std::size_t> place(chunks + 1, 0);
  const auto forChunk = [&](std::size_t c, const auto& visit)
  {
    particles.forRange(c * chunk, std::min(n, (c + 1) * chunk),
      [&](std::size_t i, const Vec3d& p, double r)
      {
        if (isValidParticle(p, r))
          visit(i, p, r);
      });
  };
  for (std::size_t c = 0; c < chunks; ++c)
    place[c] = c * chunk;
  if (valid != n)
  {
    tbb::parallel_for(std::size_t{0}, chunks,
      [&](std::size_t c)
      {
        std::size_t count = 0;
        forChunk(c, [&](std::size_t, const Vec3d&, double) { ++count; });
        place[c] = count;
      });
    std::exclusive_scan(place.begin(), place.end(), place.begin(), std::size_t{0});
  }
  tbb::parallel_for(std::size_t{0}, chunks,
    [&](std::size_t c)
    {
      KdRecord<WORDS>* next = to + place[c];
      forChunk(c, [&](std::size_t i, const Vec3d& p, double r) { *next++ = recordOf(i, p, r); });
    });
}

} // namespace mote
