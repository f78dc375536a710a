#pragma once

#include "../core/Vec.h"

#include <cstdint>
#include <limits>

namespace mote
{

/// A ray through cells: origin + t direction for tMin <= t < tMax; the direction may have any
/// length but 0.
struct HexRay
{
  Vec3d origin{0.0};
  Vec3d direction{0.0, 0.0, 1.0};
  double tMin = 0.0;
  double tMax = std::numeric_limits<double>::infinity();
};

/// Stands for no face where faces of cells are numbered 0 to 5, see CrossingLine.
inline constexpr std::uint8_t noFace = 6;

/// The part [tIn, tOut) of a ray in a cell, and the faces by which it comes and goes: noFace where
/// the ray itself begins or ends. CrossingLine::entry() and exit() tell where on a face.
struct CellSpan
{
  std::uint32_t cell = 0;
  double tIn = 0.0;
  double tOut = 0.0;
  std::uint8_t inFace = noFace;
  std::uint8_t outFace = noFace;

  bool operator==(const CellSpan&) const = default;
};

/// The least and greatest value of a scalar in a region; empty while lower > upper.
struct ScalarRange
{
  float lower = std::numeric_limits<float>::infinity();
  float upper = -std::numeric_limits<float>::infinity();

  void add(const ScalarRange& r)
  {
    lower = r.lower < lower ? r.lower : lower;
    upper = r.upper > upper ? r.upper : upper;
  }
};

/// What a query looked at. Pass NoCounts where nobody asks: counting then costs nothing.
struct WalkCounts
{
  std::uint64_t cells = 0; ///< intersected, or asked for a point
  std::uint64_t nodes = 0; ///< nodes of a hierarchy or leaves of a grid

  void addCell() { ++cells; }
  void addNode() { ++nodes; }
};
struct NoCounts
{
  void addCell() const {}
  void addNode() const {}
};

/// Keeps every region, whatever its values.
struct KeepAll
{
  static constexpr bool always = true;
  bool operator()(const ScalarRange&) const { return true; }
};

} // namespace mote
