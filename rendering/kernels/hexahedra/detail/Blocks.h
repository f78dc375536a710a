#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace mote
{

/// Calls visit(i) for all i below `count`, in parallel, thousands of them at a time.
template <typename Visit>
void forBlocks(std::size_t count, const Visit& visit)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1 << 13),
    [&](const tbb::blocked_range<std::size_t>& block)
    {
      for (std::size_t i = block.begin(); i < block.end(); ++i)
        visit(i);
    });
}

} // namespace mote
