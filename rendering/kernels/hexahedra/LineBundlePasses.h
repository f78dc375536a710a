#pragma once

// What LineBundle's test of a cell in SIMD finds. Only for LineBundle*.cpp.

#include "LineBundle.h"

namespace mote
{

/// How the lines of a bundle pass a cell: a bit for each line, and of those of `passed`, each of
/// which is in the cell once, where.
struct BundlePasses
{
  std::uint64_t passed = 0;
  std::uint64_t seldom = 0; ///< lines that must be looked at one at a time
  std::array<double, LineBundle::capacity> in, out, valueIn, valueOut;
  std::array<std::uint8_t, LineBundle::capacity> inFace, outFace;
};

/// Whether passesOf() is there for this machine.
bool hasBundlePasses();

/// Tests the lines of `wanted`. `values` are of the cell's corners, or null.
void passesOf(const LineBundle::Lanes& lanes, const HexCorners& corners, const CornerValues* values,
  std::uint64_t wanted, BundlePasses& passes);

} // namespace mote
