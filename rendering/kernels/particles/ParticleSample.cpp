#include "ParticleSample.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Scrambles a number so that all bits of it matter to all bits of the answer.
/// Source: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
std::uint64_t hashed(std::uint64_t k)
{
  k += 0x9e3779b97f4a7c15u;
  k = (k ^ (k >> 30)) * 0xbf58476d1ce4e5b9u;
  k = (k ^ (k >> 27)) * 0x94d049bb133111ebu;
  return k ^ (k >> 31);
}

} // namespace

ParticleSample::ParticleSample(const ParticleSet& particles, std::size_t wanted)
  : inputs_(particles.count())
{
  checkParticles(particles);
  const std::size_t count = std::min(wanted, inputs_);
  if (count == 0)
    return;
  enlargement_ = std::cbrt(static_cast<double>(inputs_) / static_cast<double>(count));
  const std::size_t each = inputs_ / count, rest = inputs_ % count;
  indices_.resize(count);
  positions_.resize(3 * count);
  radii_.resize(particles.hasOneRadius() ? 0 : count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t k = range.begin(); k != range.end(); ++k)
      {
        // The first `rest` stretches are one longer than the others.
        const std::size_t i =
          k * each + std::min(k, rest) + hashed(k) % (each + (k < rest ? 1 : 0));
        indices_[k] = i;
        const Vec3d p = particles.position(i);
        for (int axis = 0; axis < 3; ++axis)
          positions_[3 * k + static_cast<std::size_t>(axis)] = p[axis];
        if (!radii_.empty())
          radii_[k] = particles.unscaledRadius(i);
      }
    });
  set_.positions = ArrayView(positions_.data(), count, 3);
  if (!radii_.empty())
    set_.radii = ArrayView(radii_.data(), count, 1);
  set_.radius = particles.radius;
  set_.radiusScale = particles.radiusScale * enlargement_;
}

CoherentGridOptions ParticleSample::gridOptions() const
{
  CoherentGridOptions options;
  options.indices = indices_;
  options.inputs = inputs_;
  return options;
}

} // namespace mote
