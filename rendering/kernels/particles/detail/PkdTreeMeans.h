#pragma once

#include "../../core/WeightedSum.h"
#include "../PkdTree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mote
{

/// Means of up to WeightedSum::most numbers of particles over those below each child of a tree's
/// nodes. Buckets are given in any pieces, each once; what is above them is carried up in the end.
class PkdTreeMeans
{
public:
  /// The mean of number c at place p of the tree's lodPlace() is written to
  /// means[p * perPlace + c * perNumber].
  PkdTreeMeans(
    const PkdTree& tree, int numbers, float* means, std::size_t perPlace, std::size_t perNumber);

  /// Buckets from `first` to before `last`: sumOf(bucket) is a WeightedSum. In parallel.
  template <typename SumOf>
  void add(std::size_t first, std::size_t last, const SumOf& sumOf)
  {
    constexpr std::size_t each = PkdTree::fanout;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(first / each, (last + each - 1) / each, 64),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t treelet = range.begin(); treelet != range.end(); ++treelet)
          for (std::size_t bucket = std::max(first, treelet * each);
               bucket < std::min(last, (treelet + 1) * each); ++bucket)
          {
            const WeightedSum sum = sumOf(bucket);
            this->put(0, bucket, sum);
            sums_[treelet].add(sum);
          }
      });
  }
  /// After all buckets.
  void finish();

private:
  void put(std::size_t level, std::size_t child, const WeightedSum& sum);

  const PkdTree& tree_;
  int numbers_;
  float* means_;
  std::size_t perPlace_, perNumber_;
  std::vector<WeightedSum> sums_; ///< of treelets
};

} // namespace mote
