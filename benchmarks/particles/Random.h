#pragma once

#include <cstdint>

namespace mote::bench
{

/// A generator of numbers in [0, 1) whose k-th does not depend on those before it: the same come
/// out on any number of threads. Source: splitmix64, public domain, S. Vigna.
inline double uniform(std::uint64_t seed, std::uint64_t k)
{
  std::uint64_t z = seed + (k + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

} // namespace mote::bench
