#pragma once

#include <cstddef>
#include <cstdint>

namespace mote
{

/// A fingerprint of numbers in memory. Contents that differ in one word of eight bytes always have
/// different ones; others have the same one with odds of about 2^-128. No guard against somebody
/// who looks for a pair.
struct ContentHash
{
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  bool operator==(const ContentHash&) const = default;
};

/// Of `bytes` bytes, in parallel; the same for any number of threads.
ContentHash hashOf(const void* data, std::size_t bytes);

/// Of one content and then another.
ContentHash combine(const ContentHash& first, const ContentHash& second);

} // namespace mote
