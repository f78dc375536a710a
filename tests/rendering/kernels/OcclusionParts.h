#pragma once

#include "SceneParts.h"

#include <kernels/occlusion/OcclusionBake.h>

#include <support/Structure.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace mote::testing
{

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr auto kinds = particleKinds;

inline std::shared_ptr<ParticleStructure> structureOf(
  const Particles& particles, ParticleStructureKind kind = ParticleStructureKind::Automatic)
{
  ParticleStructureOptions options;
  options.kind = kind;
  return makeParticleStructure(particles.set(), options);
}

/// Maps by input index.
inline OcclusionMaps baked(const Particles& particles, const OcclusionBakeOptions& options,
  ParticleStructureKind kind = ParticleStructureKind::Automatic,
  OcclusionBakeStatistics* statistics = nullptr)
{
  const auto structure = structureOf(particles, kind);
  return bakeOcclusion(*structure, options, {}, statistics)
    .inInputOrder(*structure, particles.size());
}

inline bool isSame(const OcclusionMaps& a, const OcclusionMaps& b)
{
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a.level(k) != b.level(k))
      return false;
  return a.size() == b.size() &&
         std::equal(a.texels().begin(), a.texels().end(), b.texels().begin(), b.texels().end());
}

inline OcclusionBakeOptions fullMaps(int side, int samples, double reach = infinity)
{
  OcclusionBakeOptions options;
  options.side = side;
  options.samples = samples;
  options.reach = reach;
  options.adaptive = false;
  return options;
}

inline Vec3d directionAt(double row, double column, int side)
{
  const double theta = M_PI * row / side, phi = 2.0 * M_PI * column / side;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline double areaOf(int side, int row)
{
  return (std::cos(M_PI * row / side) - std::cos(M_PI * (row + 1) / side)) / (2.0 * side);
}

using Wanted = std::function<double(const Vec3d& normal)>;

/// Root mean square, over the sphere, of the difference of a map's texels from the means of what is
/// wanted over them. `outside` says which places count; a texel counts for the share of them.
inline double rmsOf(
  const OcclusionMaps& maps, std::size_t particle, const Wanted& wanted,
  const std::function<bool(const Vec3d&)>& outside = [](const Vec3d&) { return true; })
{
  constexpr int parts = 1;
  const int side = OcclusionMaps::side(maps.level(particle));
  double sum = 0.0, weights = 0.0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
    {
      double mean = 0.0;
      int places = 0;
      for (int k = 0; k < parts * parts; ++k)
      {
        const Vec3d normal =
          directionAt(row + (k / parts + 0.5) / parts, column + (k % parts + 0.5) / parts, side);
        if (!outside(normal))
          continue;
        mean += wanted(normal);
        ++places;
      }
      if (places == 0)
        continue;
      const auto texel = static_cast<std::size_t>(row * side + column);
      const double off = maps.decoded(maps.texels(particle)[texel]) - mean / places;
      const double weight = areaOf(side, row) * places;
      sum += weight * off * off;
      weights += weight;
    }
  return std::sqrt(sum / weights);
}

/// A sphere about the origin and one that touches it on the side of `way`.
inline Particles touching(double radius, double otherRadius, const Vec3d& way)
{
  Particles particles;
  particles.add(Vec3d(0.0), radius);
  particles.add((radius + otherRadius) * way, otherRadius);
  return particles;
}

/// RMS error of the two maps' texels against the closed form.
inline double touchingError(const Particles& particles, const OcclusionMaps& maps)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const double rms = rmsOf(maps, k,
      [&](const Vec3d& normal)
      {
        return 1.0 - occlusionBySphere(particles.center(k) + particles.radii[k] * normal, normal,
                       particles.center(1 - k), particles.radii[1 - k]);
      });
    sum += 0.5 * rms * rms;
  }
  return std::sqrt(sum);
}

} // namespace mote::testing
