#include "detail/OcclusionSamples.h"

#include "../shading/SampleSequence.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Brings the points of blocks [first, last) of `blocks` into an order in which each block lies
/// together. Block k has the points from k * points / blocks on.
void gather(std::vector<Vec3f>& points, std::size_t first, std::size_t last, std::size_t blocks)
{
  if (last - first < 2)
    return;
  const auto at = [&](std::size_t block)
  { return points.begin() + static_cast<std::ptrdiff_t>(block * points.size() / blocks); };
  Vec3f least(2.0f), most(-2.0f);
  for (auto p = at(first); p != at(last); ++p)
  {
    least = glm::min(least, *p);
    most = glm::max(most, *p);
  }
  const Vec3f size = most - least;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = (first + last) / 2;
  std::nth_element(at(first), at(middle), at(last),
    [axis](const Vec3f& a, const Vec3f& b) { return a[axis] < b[axis]; });
  gather(points, first, middle, blocks);
  gather(points, middle, last, blocks);
}

} // namespace

OcclusionDirections::OcclusionDirections(int count, int period, bool others)
{
  std::vector<Vec3f> points;
  const double turn = M_PI * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i)
  {
    if ((i % period == period / 2) == others)
      continue;
    const double height = 1.0 - (2.0 * i + 1.0) / count, around = turn * i;
    const double off = std::sqrt(1.0 - height * height);
    points.emplace_back(off * std::cos(around), off * std::sin(around), height);
  }
  blocks = (static_cast<int>(points.size()) + lanes - 1) / lanes;
  const auto parts = static_cast<std::size_t>(blocks);
  gather(points, 0, parts, parts);
  for (std::vector<float>* all : {&x, &y, &z})
    all->assign(parts * lanes, 0.0f);
  for (std::size_t block = 0; block < parts; ++block)
  {
    const std::size_t first = block * points.size() / parts;
    const std::size_t end = (block + 1) * points.size() / parts;
    for (std::size_t i = first; i < end; ++i)
    {
      const std::size_t to = block * lanes + i - first;
      x[to] = points[i].x;
      y[to] = points[i].y;
      z[to] = points[i].z;
    }
  }
}

void OcclusionDirections::turn(std::uint32_t seed, OcclusionDirections& turned) const
{
  // K. Shoemake, "Uniform random rotations", Graphics Gems III, 1992.
  const glm::dvec2 a = samplePoint(0, mixedBits(seed, 1)), b = samplePoint(0, mixedBits(seed, 2));
  const double one = std::sqrt(1.0 - a.x), other = std::sqrt(a.x);
  const double angle1 = 2.0 * M_PI * a.y, angle2 = 2.0 * M_PI * b.x;
  const glm::mat3 m(glm::mat3_cast(glm::dquat(other * std::cos(angle2), one * std::sin(angle1),
    one * std::cos(angle1), other * std::sin(angle2))));
  turned.blocks = blocks;
  turned.x.resize(x.size());
  turned.y.resize(y.size());
  turned.z.resize(z.size());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    turned.x[i] = m[0].x * x[i] + m[1].x * y[i] + m[2].x * z[i];
    turned.y[i] = m[0].y * x[i] + m[1].y * y[i] + m[2].y * z[i];
    turned.z[i] = m[0].z * x[i] + m[1].z * y[i] + m[2].z * z[i];
  }
}

OcclusionPlaces::OcclusionPlaces(int mapSide)
  : side(mapSide)
  , texels(mapSide * mapSide)
{
  const auto place = [this](double row, double column)
  {
    const double polar = M_PI * row / side, around = 2.0 * M_PI * column / side;
    return Vec3f(
      std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
  };
  // Z order: one bit of the column, one of the row, and so on.
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(texels); ++i)
  {
    std::uint32_t row = 0, column = 0;
    for (std::uint32_t bit = 0; bit < 5; ++bit)
    {
      column |= (i >> (2 * bit) & 1) << bit;
      row |= (i >> (2 * bit + 1) & 1) << bit;
    }
    order.push_back(row * static_cast<std::uint32_t>(side) + column);
  }
  for (int texel = 0; texel < texels; ++texel)
  {
    const int row = texel / side, column = texel % side;
    middles.push_back(place(row + 0.5, column + 0.5));
    // As many a row of texels' area.
    const double upper = std::cos(M_PI * row / side), lower = std::cos(M_PI * (row + 1) / side);
    const auto first = static_cast<std::ptrdiff_t>(jittered.size());
    for (std::uint32_t k = 0; k < jitters; ++k)
    {
      const glm::dvec2 at = samplePoint(
        k, mixedBits(static_cast<std::uint32_t>(texel), static_cast<std::uint32_t>(side)));
      jittered.push_back(
        place(std::acos(upper + at.y * (lower - upper)) * side / M_PI, column + at.x));
    }
    std::sort(jittered.begin() + first, jittered.end(),
      [this](const Vec3f& a, const Vec3f& b)
      { return glm::dot(a, middles.back()) > glm::dot(b, middles.back()); });
  }
}

} // namespace mote
