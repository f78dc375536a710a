#pragma once

#include "../core/Vec.h"

#include <cstddef>

namespace mote
{

/// Particles that nobody holds: whoever looks at some asks for them, and gets the same ones every
/// time. All functions are called from several threads at once.
class ParticleSource
{
public:
  virtual ~ParticleSource() = default;

  virtual std::size_t count() const = 0;

  /// Writes the centres of particles first, first + 1, ..., last - 1 to `positions`.
  virtual void positions(std::size_t first, std::size_t last, Vec3d* positions) const = 0;

  /// Whether radii differ: then radii() tells them, and radius() is a factor on all.
  virtual bool hasRadii() const { return false; }
  /// Writes the radii of particles first, first + 1, ..., last - 1 to `radii`; 1 unless overridden.
  virtual void radii(std::size_t first, std::size_t last, double* radii) const
  {
    for (std::size_t i = first; i < last; ++i)
      radii[i - first] = 1.0;
  }
  virtual double radius() const { return 1.0; }
};

} // namespace mote
