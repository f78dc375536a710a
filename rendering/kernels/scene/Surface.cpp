#include "Surface.h"

#include <algorithm>

namespace mote
{

namespace
{

void setColor(const Vec4f& color, float* out)
{
  std::copy_n(&color.x, 4, out);
}

void fillDirect(const ArrayView& from, const std::uint64_t* indices, int count, float (*colors)[4])
{
  const int n = from.components();
  const bool isGrey = n < 3, hasAlpha = n == 2 || n == 4;
  for (int k = 0; k < count; ++k)
  {
    const auto channel = [&](int c)
    { return static_cast<float>(from.value(indices[k], c) / 255.0); };
    const float first = channel(0);
    setColor({first, isGrey ? first : channel(1), isGrey ? first : channel(2),
               hasAlpha ? channel(n - 1) : 1.0f},
      colors[k]);
  }
}

template <typename ValueOf>
void fillMapped(const ValueOf& valueOf, const ColorMap& map, const std::uint64_t* indices,
  int count, float (*colors)[4])
{
  // Values come from anywhere in memory: with nothing else in the loop many are on their way.
  double found[HitBlock::capacity];
  for (int k = 0; k < count; ++k)
    found[k] = valueOf(indices[k]);
  map.map(found, count, colors);
}

} // namespace

void SurfaceColoring::fill(const std::uint64_t* indices, int count, float (*colors)[4]) const
{
  if (!direct.empty())
    return fillDirect(direct, indices, count, colors);
  if (!values.empty() && along == Vec3d(0.0))
    return fillMapped(
      [this](std::uint64_t i) { return values.value(i, component); }, map, indices, count, colors);
  if (!values.empty())
    return fillMapped(
      [this](std::uint64_t i) { return this->valueOf(i); }, map, indices, count, colors);
  for (int k = 0; k < count; ++k)
    setColor(palette.empty() ? constant : palette[indices[k]], colors[k]);
}

void SurfaceColoring::fill(const ColorMix& mix, int count, float (*colors)[4]) const
{
  if (direct.empty() && !values.empty())
  {
    double found[HitBlock::capacity] = {};
    for (int corner = 0; corner < ColorMix::corners; ++corner)
      for (int k = 0; k < count; ++k)
        if (mix.share[corner][k] > 0.0) // else a value that is NaN does not count
          found[k] += mix.share[corner][k] * this->valueOf(mix.index[corner][k]);
    return map.map(found, count, colors);
  }
  float part[HitBlock::capacity][4];
  for (int corner = 0; corner < ColorMix::corners; ++corner)
  {
    this->fill(mix.index[corner], count, part);
    for (int k = 0; k < count; ++k)
      for (int c = 0; c < 4; ++c)
        colors[k][c] = (corner > 0 ? colors[k][c] : 0.0f) +
                       static_cast<float>(mix.share[corner][k]) * part[k][c];
  }
}

void SurfaceColoring::fillMeans(const std::uint64_t* places, int count, float (*colors)[4]) const
{
  if (!direct.empty())
    return fillDirect(means, places, count, colors);
  fillMapped([this](std::uint64_t i) { return means.value(i, 0); }, map, places, count, colors);
}

bool SurfaceColoring::mayBeTransparent() const
{
  const auto isClear = [](const Vec4f& color) { return color.a < 1.0f; };
  if (!direct.empty())
    return direct.components() % 2 == 0;
  if (!values.empty() || !map.knots.empty())
    return std::any_of(map.table.begin(), map.table.end(), isClear) || isClear(map.nan) ||
           (map.useBelow && isClear(map.below)) || (map.useAbove && isClear(map.above));
  return palette.empty() ? isClear(constant) : std::any_of(palette.begin(), palette.end(), isClear);
}

} // namespace mote
