#include "SampleSequence.h"

namespace mote
{

namespace
{

std::uint32_t reversed(std::uint32_t x)
{
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

/// Flips each bit or not, as the seed and the bits above it decide (Burley, section 3).
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed)
{
  x = reversed(x) + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reversed(x);
}

/// The second dimension of Sobol's sequence; the first is reversed().
std::uint32_t sobol(std::uint32_t index)
{
  std::uint32_t bits = 0;
  for (std::uint32_t v = 1u << 31; index != 0; index >>= 1, v ^= v >> 1)
    if (index & 1u)
      bits ^= v;
  return bits;
}

} // namespace

std::uint32_t mixedBits(std::uint32_t a, std::uint32_t b)
{
  // The finalizer of SplitMix64 (Steele, Lea, Flood, 2014).
  std::uint64_t x = (std::uint64_t(a) << 32 | b) + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::uint32_t>((x ^ (x >> 31)) >> 32);
}

glm::dvec2 samplePoint(std::uint32_t index, std::uint32_t seed)
{
  // The order is shuffled, too: else points of the same index would belong together.
  index = scrambled(index, seed);
  return {0x1p-32 * scrambled(reversed(index), mixedBits(seed, 1)),
    0x1p-32 * scrambled(sobol(index), mixedBits(seed, 2))};
}

} // namespace mote
