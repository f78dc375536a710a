#include "detail/CloudSquare.h"

#include <algorithm>
#include <utility>

namespace mote
{

namespace
{

constexpr int blockSize = 16, partSize = 8;

} // namespace

CloudSquare::CloudSquare(int side, double tolerance, const Trace& trace)
{
  for (int y = 0; y <= side; y += partSize)
    for (int x = 0; x <= side; x += partSize)
      want(x, y);
  traceWanted(trace);
  std::vector<Part> uneven;
  const int block = std::min(side, blockSize);
  for (int y = 0; y < side; y += block)
    for (int x = 0; x < side; x += block)
    {
      const bool isEnough = block == blockSize && this->isEven({x, y, block}, tolerance);
      std::vector<Part>& to = isEnough ? even_ : uneven;
      for (int j = y; j < y + block; j += partSize)
        for (int i = x; i < x + block; i += partSize)
          to.push_back({i, j, partSize});
    }
  refine(std::move(uneven), tolerance, trace);
  for (const Part& part : even_)
    fill(part);
}

void CloudSquare::want(int x, int y)
{
  bool& known = known_[index(x, y)];
  if (!known)
    wanted_.push_back({x, y});
  known = true;
}

void CloudSquare::wantCorners(const Part& part)
{
  for (const int y : {part.y, part.y + part.size})
    for (const int x : {part.x, part.x + part.size})
      want(x, y);
}

void CloudSquare::traceWanted(const Trace& trace)
{
  std::array<RayColor, mostPixels> colors;
  for (std::size_t first = 0; first < wanted_.size(); first += mostPixels)
  {
    const std::size_t count = std::min<std::size_t>(mostPixels, wanted_.size() - first);
    trace(&wanted_[first], static_cast<int>(count), colors.data());
    for (std::size_t i = 0; i < count; ++i)
      colors_[index(wanted_[first + i].x, wanted_[first + i].y)] = colors[i];
  }
  wanted_.clear();
}

CloudSquare::Corners CloudSquare::cornersOf(const Part& part) const
{
  const auto& [x, y, size] = part;
  return {(*this)(x, y), (*this)(x + size, y), (*this)(x, y + size), (*this)(x + size, y + size)};
}

/// Whether interpolation between the corners of a block is good enough half-way.
bool CloudSquare::isEven(const Part& block, double tolerance) const
{
  const Corners corners = cornersOf(block);
  for (const auto& [x, y] : {std::pair(1, 1), {1, 0}, {0, 1}, {2, 1}, {1, 2}})
  {
    const RayColor& traced = (*this)(block.x + x * partSize, block.y + y * partSize);
    if (difference(traced, between(corners, 0.5 * x, 0.5 * y)) > tolerance)
      return false;
  }
  return true;
}

/// Halves parts, all of a size, until their middles are as interpolation says.
void CloudSquare::refine(std::vector<Part> parts, double tolerance, const Trace& trace)
{
  std::vector<Part> smaller;
  for (; !parts.empty(); parts.swap(smaller))
  {
    const int half = parts[0].size / 2;
    for (const Part& part : parts)
    {
      wantCorners(part);
      if (half > 0)
        want(part.x + half, part.y + half);
    }
    traceWanted(trace);
    if (half == 0)
      return;
    smaller.clear();
    for (const Part& part : parts)
      if (difference((*this)(part.x + half, part.y + half), between(cornersOf(part), 0.5, 0.5)) <=
          tolerance)
        even_.push_back(part);
      else
        for (int k = 0; k < 4; ++k)
          smaller.push_back({part.x + (k & 1) * half, part.y + (k >> 1) * half, half});
  }
}

/// Interpolates the pixels that are not traced, those on the far sides as well: what lies behind
/// them fills them again.
void CloudSquare::fill(const Part& part)
{
  const Corners corners = cornersOf(part);
  for (int j = 0; j <= part.size; ++j)
    for (int i = 0; i <= part.size; ++i)
      if (!known_[index(part.x + i, part.y + j)])
        colors_[index(part.x + i, part.y + j)] =
          between(corners, double(i) / part.size, double(j) / part.size);
}

RayColor CloudSquare::between(const Corners& corners, double u, double v)
{
  const double weights[4] = {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v};
  RayColor sum{Vec3d(0.0), 0.0};
  for (std::size_t i = 0; i < 4; ++i)
  {
    sum.color += weights[i] * corners[i].color;
    sum.transmittance += weights[i] * corners[i].transmittance;
  }
  return sum;
}

double CloudSquare::difference(const RayColor& a, const RayColor& b)
{
  const Vec3d d = glm::abs(a.color - b.color);
  return std::max({d.x, d.y, d.z, std::abs(a.transmittance - b.transmittance)});
}

} // namespace mote
