#pragma once

#include "../../core/RawVector.h"
#include "../ParticleRanges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace mote
{

/// Makes `values` hold, for each of `count` slots, the attributes of the particle that
/// indexOf(slot) is the input index of, 0 where there are less than four; or nothing where there
/// are none.
template <typename IndexOf>
void keepAttributes(const std::vector<ParticleAttribute>& attributes, std::size_t count,
  RawVector<std::array<float, 4>>& values, const IndexOf& indexOf)
{
  values.clear();
  values.shrink_to_fit();
  if (!attributes.empty())
    values.resize(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), 4096),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t slot = range.begin(); slot != range.end(); ++slot)
      {
        values[slot].fill(0.0f);
        const std::uint64_t input = indexOf(slot);
        for (std::size_t k = 0; k < attributes.size(); ++k)
          values[slot][k] =
            static_cast<float>(attributes[k].values.value(input, attributes[k].component));
      }
    });
}

/// Makes `words` hold a bit for each of `count` slots, the first lowest, that says whether
/// accepts(slot); called from several threads.
template <typename Word, typename Accepts>
void findBits(std::size_t count, RawVector<Word>& words, const Accepts& accepts)
{
  constexpr std::size_t bits = 8 * sizeof(Word);
  words.resize((count + bits - 1) / bits);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, words.size(), 16384 / bits),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t w = range.begin(); w != range.end(); ++w)
      {
        std::uint64_t found = 0;
        const std::size_t first = bits * w, last = std::min(count, first + bits);
        for (std::size_t slot = first; slot < last; ++slot)
          found |= static_cast<std::uint64_t>(accepts(slot)) << (slot - first);
        words[w] = static_cast<Word>(found);
      }
    });
}

/// What setVisibility() keeps: the bits of findBits(), or, for an empty function, none and no
/// memory.
template <typename Word>
void keepVisibility(
  const std::function<bool(std::size_t)>& shown, std::size_t count, RawVector<Word>& words)
{
  if (shown && count > 0)
    findBits(count, words, shown);
  else
    RawVector<Word>().swap(words);
}

/// How many of `count` slots have their bits set; all where there are no bits. Those past the last
/// slot are not set.
template <typename Word>
std::size_t countBits(const RawVector<Word>& words, std::size_t count)
{
  if (words.empty())
    return count;
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, words.size(), 16384), std::size_t{0},
    [&](const tbb::blocked_range<std::size_t>& range, std::size_t sum)
    {
      for (std::size_t w = range.begin(); w != range.end(); ++w)
        sum += static_cast<std::size_t>(std::popcount(words[w]));
      return sum;
    },
    std::plus<>());
}

} // namespace mote
