#include "Particles.h"

#include <cmath>

namespace mote::testing
{

Vec3d Random::direction()
{
  const double z = (*this)(-1.0, 1.0), angle = (*this)(0.0, 2.0 * M_PI);
  const double flat = std::sqrt(1.0 - z * z);
  return {flat * std::cos(angle), flat * std::sin(angle), z};
}

void Particles::add(const Vec3d& center, double radius)
{
  positions.insert(positions.end(), {center.x, center.y, center.z});
  radii.push_back(radius);
}

ParticleSet Particles::set() const
{
  ParticleSet set;
  set.positions = ArrayView(positions.data(), size(), 3);
  set.radii = ArrayView(radii.data(), size(), 1);
  return set;
}

void Particles::move(const Vec3d& by)
{
  for (std::size_t k = 0; k < positions.size(); ++k)
    positions[k] += by[static_cast<int>(k % 3)];
}

Particles randomParticles(std::size_t count, std::uint64_t seed, double smallest, double largest,
  const Vec3d& lower, const Vec3d& upper)
{
  Random random(seed);
  Particles particles;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3d center = random.inBox(lower, upper);
    particles.add(center, random(smallest, largest));
  }
  return particles;
}

} // namespace mote::testing
