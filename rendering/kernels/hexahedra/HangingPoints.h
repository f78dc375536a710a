#pragma once

#include "HexMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mote
{

/// A point on a face, or on its side, of a coarser cell whose corner it is not: a hanging node.
struct HangingPoint
{
  std::uint32_t point = 0;
  std::array<std::uint32_t, 4> corners{}; ///< of the face; those of a triangle with the last twice
  std::array<float, 4> weights{};         ///< of these at the point; together 1
};

/// Those of a mesh, in an order in which corners that hang themselves come first. Values that
/// follow these weights are continuous where cells of different sizes meet. In parallel.
std::vector<HangingPoint> hangingPointsOf(const HexMesh& mesh);

} // namespace mote
