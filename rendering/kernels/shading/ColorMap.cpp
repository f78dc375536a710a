#include "ColorMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

/// What a look-up needs of a map, worked out once for many values.
class Lookup
{
public:
  explicit Lookup(const ColorMap& map)
    : map_(map)
    , last_(map.table.size() - 1)
    , isNearest_(map.interpolation == ColorMap::Interpolation::Nearest)
  {
    const double width = map.upper - map.lower;
    const auto steps = static_cast<double>(isNearest_ ? map.table.size() : last_);
    steps_ = width > 0.0 ? steps / width : 0.0;
    offset_ = width > 0.0 ? 0.0 : 0.5 * steps; // a range of no width shows its middle
  }

  Vec4f operator()(double value) const
  {
    if (!map_.knots.empty())
      return betweenKnots(value);
    if (map_.logarithmic && !std::isnan(value))
      value = value > 0.0 ? std::log10(value) : -std::numeric_limits<double>::infinity();
    if (!(value >= map_.lower && value <= map_.upper))
      return outside(value);
    const double place = (value - map_.lower) * steps_ + offset_;
    if (!(place < static_cast<double>(last_)))
      return map_.table.back();
    const auto entry = static_cast<std::size_t>(place);
    if (isNearest_)
      return map_.table[entry];
    const auto blend = static_cast<float>(place - static_cast<double>(entry));
    return glm::mix(map_.table[entry], map_.table[entry + 1], blend);
  }

private:
  Vec4f betweenKnots(double value) const
  {
    if (std::isnan(value))
      return map_.nan;
    const auto above = std::upper_bound(map_.knots.begin(), map_.knots.end(), value);
    const auto next = static_cast<std::size_t>(above - map_.knots.begin());
    if (next == 0 || next == map_.knots.size())
      return next == 0 ? map_.table.front() : map_.table.back();
    const double from = map_.knots[next - 1];
    const double blend = (value - from) / (map_.knots[next] - from);
    return glm::mix(map_.table[next - 1], map_.table[next], static_cast<float>(blend));
  }
  Vec4f outside(double value) const
  {
    if (std::isnan(value))
      return map_.nan;
    if (value < map_.lower)
      return map_.useBelow ? map_.below : map_.table.front();
    return map_.useAbove ? map_.above : map_.table.back();
  }

  const ColorMap& map_;
  std::size_t last_;
  bool isNearest_;
  double steps_, offset_;
};

} // namespace

Vec4f ColorMap::operator()(double value) const
{
  return Lookup(*this)(value);
}

void ColorMap::map(const double* values, int count, float (*colors)[4]) const
{
  const Lookup look(*this);
  for (int k = 0; k < count; ++k)
  {
    const Vec4f color = look(values[k]);
    std::copy_n(&color.x, 4, colors[k]);
  }
}

} // namespace mote
