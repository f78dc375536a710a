#pragma once

#include "../core/ArrayView.h"
#include "../core/Box.h"
#include "ParticleSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace mote
{

/// The particles as the user gave them: a view, nothing is copied.
///
/// Particle i is a sphere about positions[i] with radius radiusScale * radii[i], or radiusScale *
/// radius where `radii` is empty. A `source` tells positions instead of `positions`, and where
/// `radiiOfSource` radii instead of `radii`. Particles with a coordinate or a radius that is not
/// finite, or with a radius not above zero, are left out by every structure and counted.
struct ParticleSet
{
  ArrayView positions; ///< three components, any type
  ArrayView radii;     ///< one component, or empty: then `radius` holds for all
  double radius = 1.0;
  double radiusScale = 1.0;
  std::shared_ptr<const ParticleSource> source;
  bool radiiOfSource = false;

  /// All that a source tells.
  static ParticleSet of(std::shared_ptr<const ParticleSource> source)
  {
    ParticleSet set;
    set.radiiOfSource = source->hasRadii();
    (set.radiiOfSource ? set.radiusScale : set.radius) = source->radius();
    set.source = std::move(source);
    return set;
  }

  /// Whether radiusScale * radius is everybody's.
  bool hasOneRadius() const { return !radiiOfSource && radii.empty(); }
  std::size_t count() const { return source ? source->count() : positions.count(); }
  Vec3d position(std::size_t i) const
  {
    if (!source)
      return {positions.value(i, 0), positions.value(i, 1), positions.value(i, 2)};
    Vec3d position;
    source->positions(i, i + 1, &position);
    return position;
  }
  double radiusOf(std::size_t i) const { return radiusScale * unscaledRadius(i); }
  double unscaledRadius(std::size_t i) const
  {
    double r = radius;
    if (radiiOfSource)
      source->radii(i, i + 1, &r);
    return radiiOfSource || radii.empty() ? r : radii.value(i);
  }

  /// Calls visit(i, position(i), radiusOf(i)) for first <= i < last. Where all types are the usual
  /// ones they are looked at once, not for every number.
  template <typename Visit>
  void forRange(std::size_t first, std::size_t last, const Visit& visit) const
  {
    if (source)
    {
      this->forRangeOfSource(first, last, visit);
      return;
    }
    const auto walk = [&](const auto& at)
    {
      if (radii.empty())
        for (std::size_t i = first; i < last; ++i)
          visit(i, at(i), radiusScale * radius);
      else
        for (std::size_t i = first; i < last; ++i)
          visit(i, at(i), radiusScale * radii.value(i));
    };
    const auto tuples = [&](const auto* v)
    { walk([v](std::size_t i) { return Vec3d(v[3 * i], v[3 * i + 1], v[3 * i + 2]); }); };
    if (positions.type() == ArrayView::Type::Float32)
      tuples(static_cast<const float*>(positions.data()));
    else if (positions.type() == ArrayView::Type::Float64)
      tuples(static_cast<const double*>(positions.data()));
    else
      walk([this](std::size_t i) { return position(i); });
  }

private:
  template <typename Visit>
  void forRangeOfSource(std::size_t first, std::size_t last, const Visit& visit) const
  {
    constexpr std::size_t piece = 256;
    std::array<Vec3d, piece> places;
    std::array<double, piece> sizes;
    sizes.fill(radius);
    for (; first < last; first += std::min(piece, last - first))
    {
      const std::size_t end = std::min(last, first + piece);
      source->positions(first, end, places.data());
      if (radiiOfSource)
        source->radii(first, end, sizes.data());
      for (std::size_t i = first; i < end; ++i)
        visit(i, places[i - first],
          radiusScale * (radiiOfSource || radii.empty() ? sizes[i - first] : radii.value(i)));
    }
  }
};

/// What a look over all particles found.
struct ParticleStatistics
{
  Box centers;               ///< of the centres of the valid particles
  Box bounds;                ///< of their spheres
  double largestRadius = 0;  ///< 0 where there is none
  double smallestRadius = 0; ///< 0 where there is none
  std::size_t valid = 0;
  std::size_t badPositions = 0; ///< not finite
  std::size_t badRadii = 0;     ///< not finite or not above zero, position being good
};

/// Throws Error where `positions` has not three components or `radii` has another count than
/// `positions`.
void checkParticles(const ParticleSet& particles);

/// Looks over all particles, in parallel. Throws Error as checkParticles() does.
ParticleStatistics examine(const ParticleSet& particles);

/// Whether every structure takes this particle.
inline bool isValidParticle(const Vec3d& position, double radius)
{
  return std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z) &&
         std::isfinite(radius) && radius > 0.0;
}

/// Several processes, each with a part of the particles: what one calls all must call.
class ParticleParts
{
public:
  virtual ~ParticleParts() = default;

  /// Replaces each number by the sum, or the least, of those of all processes.
  virtual void sum(std::vector<double>& values) const = 0;
  virtual void least(std::vector<double>& values) const = 0;
  /// The sum of those of the processes before this one.
  virtual double before(double value) const = 0;
};

/// The typical distance between neighbours, whatever their radii: the median, over an even sample
/// of up to 256 particles, of the distance to the nearest other particle. Coincident particles do
/// not count as neighbours. For one particle, or when all coincide, the answer is 1.
///
/// With parts it is that of all of them together, one after the other, on every process: wherever
/// neighbours are. Where these throw, so does it.
double estimateSpacing(const ParticleSet& particles, const ParticleParts* parts = nullptr);

} // namespace mote
