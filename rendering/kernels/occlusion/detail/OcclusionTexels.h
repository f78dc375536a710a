#pragma once

#include "../OcclusionMaps.h"

#include <array>

namespace mote
{

/// One particle's map while it is baked, in floating point.
struct OcclusionTexels
{
  static constexpr int largestSide = 32;

  int side = 1;
  /// By row and column: the value, and how much of the sphere's area it stands for, less what lies
  /// inside of other particles; 0 where nothing is known of it.
  std::array<float, largestSide * largestSide> value, weight;

  int count() const { return side * side; }
  /// Fills texels of no weight from those around, and those from theirs, until all are filled. At
  /// least one must have a weight.
  void dilate();
  /// The map of half as many texels a side that stands best for this one.
  OcclusionTexels coarser() const;
  /// How far a coarser map, looked up at the middles of these texels, differs from them: root mean
  /// square, in which each texel counts by its weight and its share of the brightest value.
  double error(const OcclusionTexels& coarse, float brightest) const;
  /// Adds the bytes that stand for the values.
  void append(const OcclusionMaps& coding, RawVector<std::uint8_t>& texels) const;

  /// Number of the texel at a row, which may lie one beyond a pole, and a column, which may lie
  /// one all the way round.
  static int texelAt(int side, int row, int column);
  /// Share of a sphere's area that a texel of each row has.
  static float area(int side, int row);
};

} // namespace mote
