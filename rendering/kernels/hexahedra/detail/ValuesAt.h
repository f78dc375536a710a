#pragma once

#include "../CellSampler.h"

#include <cstdint>
#include <limits>

namespace mote
{

/// Values of a field, as the user's scalar has them, at points in cells that the lower halves of
/// slots name; NaN where the cell has one.
inline void valuesAt(const HexMesh& mesh, const HexField& field, const std::uint64_t* slots,
  const Vec3d* points, int count, double* values)
{
  CellSampler cell(mesh, field);
  for (int k = 0; k < count; ++k)
  {
    cell.enter(static_cast<std::uint32_t>(slots[k]));
    values[k] = cell.isNaN() ? std::numeric_limits<double>::quiet_NaN()
                             : field.offset() + cell.trilinear(points[k]);
  }
}

} // namespace mote
