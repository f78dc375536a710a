#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

class vtkDataSet;

namespace mote::app
{

/// What something takes in memory: what there is, and how many bytes it has. Time steps share
/// some of it, a mesh and its structure above all.
using MemoryPieces = std::vector<std::pair<const void*, std::size_t>>;

/// Adds the arrays of a data set, and what it has besides.
void addMemory(MemoryPieces& pieces, vtkDataSet* data);

/// Adds up memory; what is shared counts once.
class MemorySum
{
public:
  /// How much more it is with these.
  std::uint64_t more(const MemoryPieces& pieces) const;
  void add(const MemoryPieces& pieces);
  std::uint64_t bytes() const { return bytes_; }

private:
  std::unordered_set<const void*> counted_;
  std::uint64_t bytes_ = 0;
};

} // namespace mote::app
