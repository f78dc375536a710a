#include "ContentHash.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

namespace mote
{

namespace
{

/// Words go round robin through `lanes` chains, so that their multiplications overlap.
constexpr std::size_t lanes = 4;
constexpr std::size_t blockBytes = std::size_t(1) << 16U;

// Odd, and half of their bits are set: digits of the golden ratio and of roots.
constexpr std::uint64_t factors[2] = {0x9e3779b97f4a7c15ULL, 0xd6e8feb86659fd93ULL};
constexpr int turns[2] = {29, 41};

/// One to one in the word and in the state, each: a word that differs leaves a state that differs.
/// The turn brings what multiplying moves up down again.
template <int Half>
std::uint64_t mixed(std::uint64_t state, std::uint64_t word)
{
  return std::rotl((state ^ word) * factors[Half], turns[Half]);
}

void mix(ContentHash& hash, std::uint64_t word)
{
  hash.low = mixed<0>(hash.low, word);
  hash.high = mixed<1>(hash.high, word);
}

/// Spreads each bit over all others, one to one (the finalizer of MurmurHash3, A. Appleby).
std::uint64_t spread(std::uint64_t x)
{
  x = (x ^ (x >> 33U)) * 0xff51afd7ed558ccdULL;
  x = (x ^ (x >> 33U)) * 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33U);
}

ContentHash hashOfBlock(const unsigned char* data, std::size_t bytes)
{
  ContentHash chains[lanes];
  for (std::size_t lane = 0; lane < lanes; ++lane)
    chains[lane] = {factors[0] * (2 * lane + 1), factors[1] * (2 * lane + 1)};
  std::size_t at = 0;
  for (; at + 8 * lanes <= bytes; at += 8 * lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      std::uint64_t word;
      std::memcpy(&word, data + at + 8 * lane, 8);
      mix(chains[lane], word);
    }
  for (; at < bytes; at += 8)
  {
    std::uint64_t word = 0;
    std::memcpy(&word, data + at, std::min<std::size_t>(8, bytes - at));
    mix(chains[0], word);
  }
  ContentHash hash{bytes, bytes};
  for (const ContentHash& chain : chains)
    hash = combine(hash, chain);
  return hash;
}

} // namespace

ContentHash combine(const ContentHash& first, const ContentHash& second)
{
  return {spread(mixed<0>(first.low, spread(second.low))),
    spread(mixed<1>(first.high, spread(second.high)))};
}

ContentHash hashOf(const void* data, std::size_t bytes)
{
  const auto* begin = static_cast<const unsigned char*>(data);
  std::vector<ContentHash> blocks((bytes + blockBytes - 1) / blockBytes);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size(), 4),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        blocks[i] =
          hashOfBlock(begin + i * blockBytes, std::min(blockBytes, bytes - i * blockBytes));
    });
  ContentHash hash{bytes, ~static_cast<std::uint64_t>(bytes)};
  for (const ContentHash& block : blocks)
    hash = combine(hash, block);
  return hash;
}

} // namespace mote
