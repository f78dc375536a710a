#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace mote
{

/// Nodes in the left subtree of a left-balanced binary tree of `count` > 0 nodes: all levels are
/// full but the last, whose nodes stand as far left as they may.
inline std::size_t leftSubtreeSize(std::size_t count)
{
  const std::size_t above = std::bit_floor(count) - 1; // nodes before the last level
  const std::size_t half = (above + 1) / 2;            // the last level's room in a subtree
  return above == 0 ? 0 : half - 1 + std::min(count - above, half);
}

/// Brings the nodes of a left-balanced binary tree, which stand in order (left subtree, node, right
/// subtree), into heap order: the children of node i at 2i + 1 and 2i + 2. In place but for a small
/// buffer a task, and in parallel.
///
/// Counted from 1, the place in order of a node of a tree whose levels are all full has the bits
/// p 1 0..0, and its place in heap order the bits 0..0 1 p, p being the way to it from the root. So
/// reversing all bits and then those behind the leading one, both exchanges of pairs, leads from
/// one to the other. Nodes of an incomplete last level are taken out before.
///
/// Source: Berney, Casanova, Higuchi, Karsin, Sitchinava, "Beyond Binary Search: Parallel In-Place
/// Construction of Implicit Search Tree Layouts", IPDPS 2018.
template <typename Record>
class HeapOrder
{
public:
  static void run(Record* nodes, std::size_t count)
  {
    const int levels = std::bit_width(count + 1) - 1; // full ones
    const std::size_t full = (std::size_t{1} << levels) - 1, last = count - full;
    unzip(nodes, last);
    rotate(nodes + last, nodes + 2 * last, nodes + count);
    forPairs(
      full, [&](std::size_t i) { return reversed(i, levels); }, nodes);
    forPairs(
      full,
      [](std::size_t i)
      {
        const std::size_t leading = std::bit_floor(i);
        return leading | reversed(i - leading, std::bit_width(i) - 1);
      },
      nodes);
  }

private:
  static constexpr std::size_t few = 512;   ///< pairs that a buffer takes
  static constexpr std::size_t task = 8192; ///< records a task

  /// The lowest `bits` bits of `i`, which has no others, in reverse.
  static std::size_t reversed(std::size_t i, int bits)
  {
    std::size_t r = 0;
    for (int k = 0; k < bits; ++k, i >>= 1)
      r = r << 1 | (i & 1);
    return r;
  }

  /// Exchanges the records i and partner(i), counted from 1 to `count`, where `partner` is its own
  /// inverse.
  template <typename Partner>
  static void forPairs(std::size_t count, const Partner& partner, Record* nodes)
  {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(1, count + 1, task),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          if (const std::size_t other = partner(i); i < other)
            std::swap(nodes[i - 1], nodes[other - 1]);
      });
  }

  /// Makes of a0 b0 a1 b1 ... the order b0 b1 ... a0 a1 ...
  static void unzip(Record* first, std::size_t pairs)
  {
    if (pairs <= few)
    {
      std::vector<Record> leaves(pairs);
      for (std::size_t k = 0; k < pairs; ++k)
      {
        leaves[k] = first[2 * k];
        first[k] = first[2 * k + 1];
      }
      std::copy(leaves.begin(), leaves.end(), first + pairs);
      return;
    }
    const std::size_t half = pairs / 2;
    tbb::parallel_invoke(
      [=] { unzip(first, half); }, [=] { unzip(first + 2 * half, pairs - half); });
    rotate(first + half, first + 2 * half, first + half + pairs);
  }

  /// Puts what is at [middle, last) before what is at [first, middle).
  static void rotate(Record* first, Record* middle, Record* last)
  {
    if (static_cast<std::size_t>(last - first) < 2 * task)
    {
      std::rotate(first, middle, last);
      return;
    }
    reverse(first, middle);
    reverse(middle, last);
    reverse(first, last);
  }

  static void reverse(Record* first, Record* last)
  {
    const auto pairs = static_cast<std::size_t>(last - first) / 2;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs, task),
      [=](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          std::swap(first[i], *(last - 1 - i));
      });
  }
};

} // namespace mote
