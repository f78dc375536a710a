#include "ParticleSet.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

void addParticle(ParticleStatistics& s, const Vec3d& p, double r)
{
  if (!isValidParticle(p, 1.0))
  {
    ++s.badPositions;
    return;
  }
  if (!isValidParticle(p, r))
  {
    ++s.badRadii;
    return;
  }
  s.centers.add(p);
  s.bounds.add(p - Vec3d(r));
  s.bounds.add(p + Vec3d(r));
  s.largestRadius = std::max(s.largestRadius, r);
  s.smallestRadius = s.valid == 0 ? r : std::min(s.smallestRadius, r);
  ++s.valid;
}

/// The same for particles of one good radius, many times as fast.
ParticleStatistics examineRange(
  const ParticleSet& particles, std::size_t first, std::size_t last, double radius)
{
  ParticleStatistics s;
  particles.forRange(first, last,
    [&s](std::size_t, const Vec3d& p, double)
    {
      if (isValidParticle(p, 1.0))
        s.centers.add(p);
      else
        ++s.badPositions;
    });
  s.valid = last - first - s.badPositions;
  if (s.valid == 0)
    return s;
  s.bounds = s.centers.expanded(radius);
  s.largestRadius = s.smallestRadius = radius;
  return s;
}

ParticleStatistics merged(const ParticleStatistics& a, const ParticleStatistics& b)
{
  ParticleStatistics s = a;
  s.centers.add(b.centers);
  s.bounds.add(b.bounds);
  s.largestRadius = std::max(a.largestRadius, b.largestRadius);
  if (b.valid > 0)
    s.smallestRadius =
      a.valid == 0 ? b.smallestRadius : std::min(a.smallestRadius, b.smallestRadius);
  s.valid += b.valid;
  s.badPositions += b.badPositions;
  s.badRadii += b.badRadii;
  return s;
}

} // namespace

void checkParticles(const ParticleSet& particles)
{
  const std::size_t n = particles.count();
  if (n > 0 && !particles.source && particles.positions.components() != 3)
    throw Error("Particle positions need three components.");
  if (!particles.radiiOfSource && !particles.radii.empty() && particles.radii.count() != n)
    throw Error("There are " + std::to_string(particles.radii.count()) + " radii for " +
                std::to_string(n) + " particles.");
}

ParticleStatistics examine(const ParticleSet& particles)
{
  checkParticles(particles);
  const double radius = particles.radiusScale * particles.radius;
  const bool alike = particles.hasOneRadius() && isValidParticle(Vec3d(0.0), radius);
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, particles.count(), 1 << 15), ParticleStatistics{},
    [&](const tbb::blocked_range<std::size_t>& range, ParticleStatistics s)
    {
      if (alike)
        return merged(s, examineRange(particles, range.begin(), range.end(), radius));
      particles.forRange(range.begin(), range.end(),
        [&](std::size_t, const Vec3d& p, double r) { addParticle(s, p, r); });
      return s;
    },
    merged);
}

} // namespace mote
