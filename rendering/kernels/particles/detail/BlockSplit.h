#pragma once

#include "MedianSplit.h"

#include <cstddef>
#include <cstdint>

namespace mote
{

/// Most records of a block: what splitBlock() needs for them stays in a core's cache.
constexpr std::size_t blockCapacity = 16384;

/// A run of records that a k-d tree splits down to its buckets.
template <int WORDS>
struct KdBlock
{
  KdRecord<WORDS>* first;
  std::size_t count; ///< at most blockCapacity
  std::size_t size;  ///< of children, the last of which may be smaller: buckets by powers of fanout
  std::size_t bucket; ///< records of a bucket
  std::size_t fanout; ///< children of children
  bool byExtent;      ///< split across the longest side; else round robin
  int axis;           ///< the first of the round

  std::uint32_t treeletExtent = 0; ///< longest side of what holds `fanout` buckets: the answer
};

/// Puts the records of a block in the order of the tree, many at a time; on one thread. Which
/// record goes into which bucket, and their order there, is the same for every instruction set.
void splitBlock(KdBlock<3>& block);
void splitBlock(KdBlock<4>& block);
void splitBlock(KdBlock<5>& block);
void splitBlock(KdBlock<6>& block);

} // namespace mote
