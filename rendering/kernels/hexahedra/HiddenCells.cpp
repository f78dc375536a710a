#include "HiddenCells.h"

#include "HexMesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace mote
{

HiddenCells::HiddenCells(const HexMesh& mesh, const unsigned char* isVisible)
  : words_((mesh.cellCount() + 63) / 64)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, words_.size(), 1 << 8),
    [&](const tbb::blocked_range<std::size_t>& block)
    {
      for (std::size_t w = block.begin(); w != block.end(); ++w)
        for (std::size_t c = 64 * w; c < std::min(64 * w + 64, mesh.cellCount()); ++c)
          words_[w] |= std::uint64_t(isVisible[mesh.inputCell(c)] == 0) << (c & 63);
    });
}

} // namespace mote
