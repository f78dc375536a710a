#pragma once

#include "../core/Vec.h"

#include <vector>

namespace mote
{

/// A map from a value to a colour: a table over a range, as VTK's lookup tables and transfer
/// functions define it.
struct ColorMap
{
  enum class Interpolation
  {
    Nearest, ///< entry i covers the i-th of table.size() equal parts of the range
    Linear   ///< entry i holds at lower + i/(table.size()-1) of the range
  };

  std::vector<Vec4f> table = {Vec4f(1.0f)}; ///< at least one; RGBA in [0, 1]
  /// Empty, or an ascending value for each entry, at which it holds, with colours linear between
  /// them in place of even steps from `lower` to `upper`. Of two entries at one value the second
  /// holds from it on.
  std::vector<double> knots;
  Interpolation interpolation = Interpolation::Linear;
  double lower = 0.0; ///< value at the table's begin, or its base-10 logarithm where `logarithmic`
  double upper = 1.0;
  bool logarithmic = false;                ///< then the value's logarithm is looked up
  bool useBelow = false, useAbove = false; ///< otherwise the first and last entry go on
  Vec4f below{0.0f, 0.0f, 0.0f, 1.0f};
  Vec4f above{1.0f};
  Vec4f nan{0.5f, 0.0f, 0.0f, 1.0f};

  Vec4f operator()(double value) const;

  /// The colours of `count` values, the same as one by one, as red, green, blue and alpha.
  void map(const double* values, int count, float (*colors)[4]) const;

  bool operator==(const ColorMap&) const = default;
};

} // namespace mote
