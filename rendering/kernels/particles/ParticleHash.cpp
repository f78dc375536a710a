#include "ParticleHash.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace mote
{

ContentHash hashOf(const ParticleSet& particles)
{
  constexpr std::size_t piece = 2048;
  const std::size_t count = particles.count();
  std::vector<ContentHash> pieces((count + piece - 1) / piece);
  tbb::parallel_for(std::size_t{0}, pieces.size(),
    [&](std::size_t k)
    {
      std::vector<double> numbers;
      numbers.reserve(4 * piece);
      particles.forRange(k * piece, std::min(count, (k + 1) * piece),
        [&](std::size_t, const Vec3d& position, double radius) {
          numbers.insert(numbers.end(), {position.x, position.y, position.z, radius});
        });
      pieces[k] = hashOf(numbers.data(), numbers.size() * sizeof(double));
    });
  ContentHash hash{count, ~static_cast<std::uint64_t>(count)};
  for (const ContentHash& one : pieces)
    hash = combine(hash, one);
  return hash;
}

} // namespace mote
