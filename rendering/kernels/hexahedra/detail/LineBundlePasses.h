#pragma once

// What LineBundle's test of a cell in SIMD finds. Only for LineBundle*.cpp.

#include "../LineBundle.h"

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

/// The winding numbers of a face about 64 lines.
struct FaceWindings
{
  std::uint64_t plus = 0, minus = 0; ///< where they are 1 and -1
};

/// Lines that pass a face, side by side.
struct FacePassing
{
  alignas(64) std::array<double, LineBundle::capacity> originX, originY, originZ, shearX, shearY,
    inverse, sign;
  alignas(64) std::array<double, LineBundle::capacity> t, value;
  std::array<std::uint8_t, LineBundle::capacity> line;
  std::size_t count = 0;
};

/// Whether passesOf() is there for this machine.
bool hasBundlePasses();

/// Tests the lines of `wanted`. `values` are of the cell's corners, or null.
void passesOf(const LineBundle::Lanes& lanes, const HexCorners& corners, const CornerValues* values,
  std::uint64_t wanted, BundlePasses& passes);

} // namespace mote
