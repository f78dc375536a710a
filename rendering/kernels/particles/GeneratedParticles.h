#pragma once

#include "ParticleSource.h"

#include <cstdint>
#include <memory>
#include <string>

namespace mote
{

/// A generator of numbers in [0, 1) whose k-th does not depend on those before it: the same come
/// out on any number of threads. Source: splitmix64, public domain, S. Vigna.
inline double uniformNumber(std::uint64_t seed, std::uint64_t k)
{
  std::uint64_t z = seed + (k + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

/// Whether a name is meant as particles that are made, such as "lattice:1000000": whether one of
/// the words that makeParticles() knows and a colon begin it.
bool namesGeneratedParticles(const std::string& name);

/// Particles in the unit cube, worked out whenever they are looked at, with coordinates and radii
/// of float. `specification` is one of
/// - lattice:N, a cubic lattice of the n^3 particles nearest to N, each moved by up to 0.2 spacings
///   an axis, radius half a spacing;
/// - random:N:R, N particles evenly at random, radius R;
/// - varied:N, N particles evenly at random, radii log-uniform over four decades. They cover as
///   much as N spheres of equalRadius(N) do: then a ray meets as many of them.
/// N is up to PkdTree::mostParticles. Throws Error with a sentence for any other.
std::shared_ptr<const ParticleSource> makeParticles(const std::string& specification);

/// Radius of the random:N:R that covers as much as varied:N does.
double equalRadius(std::size_t count);

} // namespace mote
