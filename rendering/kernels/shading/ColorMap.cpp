#include "ColorMap.h"

#include <algorithm>
#include <cmath>

namespace mote
{

Vec4f ColorMap::operator()(double value) const
{
  if (std::isnan(value))
    return nan;
  if (logarithmic)
    value = value > 0.0 ? std::log10(value) : -std::numeric_limits<double>::infinity();
  if (value < lower)
    return useBelow ? below : table.front();
  if (value > upper)
    return useAbove ? above : table.back();
  const double width = upper - lower;
  const double share = width > 0.0 ? (value - lower) / width : 0.5;
  const auto last = static_cast<double>(table.size() - 1);
  if (interpolation == Interpolation::Nearest)
    return table[static_cast<std::size_t>(
      std::min(share * static_cast<double>(table.size()), last))];
  const double place = share * last;
  const auto i = static_cast<std::size_t>(std::min(place, std::max(0.0, last - 1.0)));
  const auto blend = static_cast<float>(place - static_cast<double>(i));
  return glm::mix(table[i], table[std::min(i + 1, table.size() - 1)], blend);
}

} // namespace mote
