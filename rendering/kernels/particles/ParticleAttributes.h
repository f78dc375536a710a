#pragma once

#include "../core/RawVector.h"
#include "ParticleRanges.h"
#include "ParticleSet.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <vector>

namespace mote
{

/// Throws Error where a structure over particles with these statistics cannot take the attributes:
/// more than four, not one tuple a particle of the input, no such component, no way back from its
/// particles to the input. `inputs`: particles of the input; 0: as many as the statistics count.
void checkAttributes(const std::vector<ParticleAttribute>& attributes,
  const ParticleStatistics& statistics, bool hasIndices, std::size_t inputs = 0);

/// Throws Error where a range is set on an attribute and there are none.
void checkRanges(const ParticleRanges& ranges, bool hasAttributes);

/// Fills values[slot] with the attributes of the particle that indexOf(slot) is the input index of;
/// 0 where there are less than four.
template <typename IndexOf>
void fillAttributes(const std::vector<ParticleAttribute>& attributes,
  RawVector<std::array<float, 4>>& values, const IndexOf& indexOf)
{
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

} // namespace mote
