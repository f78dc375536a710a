#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace mote
{

/// Sums of up to four numbers of things that count differently, for their means. What is not finite
/// does not count.
struct WeightedSum
{
  static constexpr int most = 4;
  std::array<double, most> value{}, weight{};

  /// The first `count` of the values, of one thing.
  void add(const double* values, double by, int count)
  {
    for (std::size_t c = 0; c < static_cast<std::size_t>(count); ++c)
      if (std::isfinite(values[c]))
      {
        value[c] += by * values[c];
        weight[c] += by;
      }
  }
  void add(const WeightedSum& part)
  {
    for (std::size_t c = 0; c < most; ++c)
    {
      value[c] += part.value[c];
      weight[c] += part.weight[c];
    }
  }
  /// NaN where nothing counts.
  float mean(int k) const
  {
    const auto c = static_cast<std::size_t>(k);
    return weight[c] > 0.0 ? static_cast<float>(value[c] / weight[c])
                           : std::numeric_limits<float>::quiet_NaN();
  }
};

} // namespace mote
