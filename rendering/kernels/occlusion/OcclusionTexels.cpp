#include "detail/OcclusionTexels.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// A coarse map's value at the middle of a finer map's texel.
float lookUp(const OcclusionTexels& map, int side, int row, int column)
{
  const float scale = static_cast<float>(map.side) / static_cast<float>(side);
  const float v = (static_cast<float>(row) + 0.5f) * scale - 0.5f;
  const float u = (static_cast<float>(column) + 0.5f) * scale - 0.5f;
  const float r = std::floor(v), c = std::floor(u);
  const auto at = [&](int i, int k)
  {
    return map.value[static_cast<std::size_t>(
      OcclusionTexels::texelAt(map.side, static_cast<int>(r) + i, static_cast<int>(c) + k))];
  };
  const float down = v - r, along = u - c;
  const float upper = at(0, 0) + along * (at(0, 1) - at(0, 0));
  const float lower = at(1, 0) + along * (at(1, 1) - at(1, 0));
  return upper + down * (lower - upper);
}

} // namespace

int OcclusionTexels::texelAt(int side, int row, int column)
{
  if (row < 0 || row >= side)
    column += side / 2;
  return std::clamp(row, 0, side - 1) * side + (column & (side - 1));
}

float OcclusionTexels::area(int side, int row)
{
  const double step = M_PI / side;
  return static_cast<float>((std::cos(row * step) - std::cos((row + 1) * step)) / (2.0 * side));
}

void OcclusionTexels::dilate()
{
  std::array<float, largestSide* largestSide> filled = value;
  std::array<bool, largestSide * largestSide> known, next;
  int unknown = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count()); ++i)
    unknown += !(known[i] = weight[i] > 0.0f);
  while (unknown > 0 && unknown < count())
  {
    next = known;
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
      {
        const auto here = static_cast<std::size_t>(row * side + column);
        if (known[here])
          continue;
        float sum = 0.0f;
        int from = 0;
        for (int k = 0; k < 9; ++k)
        {
          const auto beside =
            static_cast<std::size_t>(texelAt(side, row + k / 3 - 1, column + k % 3 - 1));
          if (known[beside])
          {
            sum += value[beside];
            ++from;
          }
        }
        if (from == 0)
          continue;
        filled[here] = sum / static_cast<float>(from);
        next[here] = true;
        --unknown;
      }
    value = filled;
    known = next;
  }
}

OcclusionTexels OcclusionTexels::coarser() const
{
  OcclusionTexels coarse;
  coarse.side = side / 2;
  for (int row = 0; row < coarse.side; ++row)
    for (int column = 0; column < coarse.side; ++column)
    {
      float sum = 0.0f, parts = 0.0f, weights = 0.0f;
      for (int k = 0; k < 4; ++k)
      {
        const auto from = static_cast<std::size_t>((2 * row + k / 2) * side + 2 * column + k % 2);
        // Places count as in error(); the dark ones a little, too.
        const float part = weight[from] * (value[from] + 1e-3f);
        sum += part * value[from];
        parts += part;
        weights += weight[from];
      }
      const auto to = static_cast<std::size_t>(row * coarse.side + column);
      coarse.value[to] = parts > 0.0f ? sum / parts : 0.0f;
      coarse.weight[to] = weights;
    }
  coarse.dilate();
  return coarse;
}

double OcclusionTexels::error(const OcclusionTexels& coarse, float brightest) const
{
  double sum = 0.0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
    {
      const auto here = static_cast<std::size_t>(row * side + column);
      const float off = (value[here] - lookUp(coarse, side, row, column)) / brightest;
      sum += double(weight[here] * value[here] / brightest * off * off);
    }
  return std::sqrt(sum);
}

void OcclusionTexels::append(const OcclusionMaps& coding, RawVector<std::uint8_t>& texels) const
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(count()); ++i)
    texels.push_back(coding.encoded(value[i]));
}

} // namespace mote
