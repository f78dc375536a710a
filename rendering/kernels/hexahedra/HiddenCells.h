#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mote
{

class HexMesh;

/// Which cells of a mesh are hidden, a bit each: what is seen is what would be seen if the mesh did
/// not have them.
class HiddenCells
{
public:
  /// Hides the cells whose `isVisible` is 0, of which there is one for each cell of the mesh's
  /// input. In parallel.
  HiddenCells(const HexMesh& mesh, const unsigned char* isVisible);

  bool operator[](std::uint32_t cell) const { return (words_[cell >> 6] >> (cell & 63) & 1) != 0; }
  std::size_t bytes() const { return words_.size() * sizeof(std::uint64_t); }

private:
  std::vector<std::uint64_t> words_;
};

} // namespace mote
