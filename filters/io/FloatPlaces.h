#ifndef MoteFloatPlaces_h
#define MoteFloatPlaces_h

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mote
{

/// Whether float would move points, x, y and z of one after the other, by more than a millionth of
/// what they take up.
inline bool needDouble(const std::vector<double>& places)
{
  double largest = 0.0, side = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = axis; i < places.size(); i += 3)
      if (std::isfinite(places[i]))
      {
        low = std::min(low, places[i]);
        high = std::max(high, places[i]);
      }
    if (low > high)
      continue;
    largest = std::max({largest, std::abs(low), std::abs(high)});
    side = std::max(side, high - low);
  }
  return largest * std::numeric_limits<float>::epsilon() > 1e-6 * side;
}

} // namespace mote

#endif
