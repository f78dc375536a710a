#pragma once

#include "HitBlock.h"

#include <cstdint>

namespace mote
{

/// What the colours of hits are mixed from where one index does not tell them: those of the corners
/// of the triangles that were hit.
struct ColorMix
{
  static constexpr int corners = 3;
  std::uint64_t index[corners][HitBlock::capacity]; ///< of the surface's colouring
  double share[corners][HitBlock::capacity];        ///< not below 0, together 1 for each hit
};

} // namespace mote
