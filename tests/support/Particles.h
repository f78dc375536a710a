#pragma once

#include <kernels/particles/ParticleSet.h>

#include <cstdint>
#include <random>
#include <vector>

namespace mote::testing
{

/// Evenly distributed numbers that are the same on every machine.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : engine_(seed)
  {
  }
  double operator()(double from = 0.0, double to = 1.0)
  {
    return from + (to - from) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Vec3d inBox(const Vec3d& lower, const Vec3d& upper)
  {
    const double x = (*this)(lower.x, upper.x), y = (*this)(lower.y, upper.y);
    return {x, y, (*this)(lower.z, upper.z)};
  }
  /// Evenly over the unit sphere.
  Vec3d direction();

private:
  std::mt19937_64 engine_;
};

/// Particles in double that own their numbers.
struct Particles
{
  std::vector<double> positions;
  std::vector<double> radii;

  void add(const Vec3d& center, double radius);
  std::size_t size() const { return radii.size(); }
  Vec3d center(std::size_t i) const
  {
    return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
  }
  /// A view: valid until particles are added.
  ParticleSet set() const;
  void move(const Vec3d& by);
};

/// `count` particles evenly in a box, with radii evenly in a range.
Particles randomParticles(std::size_t count, std::uint64_t seed, double smallest, double largest,
  const Vec3d& lower = Vec3d(-1.0), const Vec3d& upper = Vec3d(1.0));

} // namespace mote::testing
