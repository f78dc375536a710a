#include "ReferenceGrid.h"

#include <kernels/core/Error.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mote::bench
{

namespace
{

/// Calls visit(slab) in parallel for slabs of a few layers of cells.
template <typename Visit>
void forSlabs(int layers, const Visit& visit)
{
  const int threads = tbb::this_task_arena::max_concurrency();
  const int count = std::max(1, std::min(layers / 4, 8 * threads));
  tbb::parallel_for(0, count, [&](int k) { visit(layers * k / count, layers * (k + 1) / count); });
}

} // namespace

void ReferenceGrid::size(const CellGrid& centers, double lambda)
{
  origin_ = centers.origin;
  unit_ = centers.unit;
  largestRadius_ = centers.largestRadius;
  const Vec3f size = centers.boxUpper - centers.boxLower;
  const float longest = std::max({size.x, size.y, size.z});
  // Rounding may put no hit outside the box.
  const Vec3f margin(1e-5f * longest);
  lower_ = centers.boxLower - margin;
  upper_ = centers.boxUpper + margin;
  const Vec3d extent(upper_ - lower_);
  const double edge = std::max(
    cellEdge(extent, lambda * static_cast<double>(centers.count)), longest * std::ldexp(1.0, -20));
  cellSize_ = static_cast<float>(edge);
  for (int k = 0; k < 3; ++k)
  {
    resolution_[k] = 1 + static_cast<int>(extent[k] / edge);
    macroResolution_[k] = (resolution_[k] + macrocellSide - 1) / macrocellSide;
  }
}

/// Calls visit(x, y, z, place) for every cell of the slab and every sphere that overlaps it.
template <typename Visit>
void ReferenceGrid::forReferences(const CellGrid& centers, Slab slab, const Visit& visit) const
{
  const auto cellOf = [&](float v, int axis)
  {
    const float cell = std::floor((v - lower_[axis]) / cellSize_);
    return static_cast<int>(std::clamp(cell, 0.0f, static_cast<float>(resolution_[axis] - 1)));
  };
  // Squared distance from a coordinate to a cell's extent.
  const auto outside = [&](float v, int cell, int axis)
  {
    const float low = lower_[axis] + static_cast<float>(cell) * cellSize_;
    const float d = std::max({low - v, v - low - cellSize_, 0.0f});
    return d * d;
  };
  // Particles lie in the order of their centres' layers: only those near the slab are looked at.
  const float reach = largestRadius_ * 1.0001f + cellSize_;
  const float from = lower_.z + static_cast<float>(slab.first) * cellSize_ - reach;
  const float to = lower_.z + static_cast<float>(slab.last) * cellSize_ + reach;
  const auto rows = static_cast<std::size_t>(centers.resolution.y);
  const auto first = static_cast<std::size_t>(centers.rowStart[rows * centers.cellAlong(from, 2)]);
  const auto last =
    static_cast<std::size_t>(centers.rowStart[rows * (centers.cellAlong(to, 2) + 1)]);
  // Nor may it put one into a cell that has no reference to its sphere.
  const Vec3f box = upper_ - lower_;
  const float margin = 3e-6f * std::max({box.x, box.y, box.z});
  for (std::size_t i = first; i < last; ++i)
  {
    const CellGrid::Record& p = centers.records[i];
    const float r = p.r * 1.00001f + margin;
    const int z0 = std::max(slab.first, cellOf(p.z - r, 2));
    const int z1 = std::min(slab.last - 1, cellOf(p.z + r, 2));
    const int y0 = cellOf(p.y - r, 1), y1 = cellOf(p.y + r, 1);
    const int x0 = cellOf(p.x - r, 0), x1 = cellOf(p.x + r, 0);
    for (int z = z0; z <= z1; ++z)
      for (int y = y0; y <= y1; ++y)
      {
        const float left = r * r - outside(p.z, z, 2) - outside(p.y, y, 1);
        for (int x = x0; x <= x1; ++x)
          if (outside(p.x, x, 0) <= left)
            visit(x, y, z, i);
      }
  }
}

void ReferenceGrid::count(const CellGrid& centers, Slab slab)
{
  const auto width = static_cast<std::size_t>(resolution_.x) + 1;
  const auto rows = static_cast<std::size_t>(resolution_.y);
  const std::size_t firstRow = rows * static_cast<std::size_t>(slab.first);
  const std::size_t lastRow = rows * static_cast<std::size_t>(slab.last);
  std::fill(&cellStart_[firstRow * width], cellStart_.data() + lastRow * width, 0u);
  forReferences(centers, slab,
    [&](int x, int y, int z, std::size_t)
    { ++cellStart_[(rows * z + y) * width + static_cast<std::size_t>(x)]; });
  for (std::size_t row = firstRow; row < lastRow; ++row)
  {
    std::uint64_t sum = 0;
    for (std::size_t x = 0; x < width; ++x)
    {
      const std::uint64_t start = sum;
      sum += cellStart_[row * width + x];
      cellStart_[row * width + x] = static_cast<std::uint32_t>(start);
    }
    if (sum > std::numeric_limits<std::uint32_t>::max())
      throw Error("More than 2^32 references lie in one row of the grid of references.");
    rowStart_[row] = sum;
  }
}

void ReferenceGrid::fill(const CellGrid& centers, Slab slab)
{
  const auto width = static_cast<std::size_t>(resolution_.x) + 1;
  const auto rows = static_cast<std::size_t>(resolution_.y);
  const std::size_t firstRow = rows * static_cast<std::size_t>(slab.first);
  const std::size_t lastRow = rows * static_cast<std::size_t>(slab.last);
  std::vector<std::uint32_t> next(
    &cellStart_[firstRow * width], cellStart_.data() + lastRow * width);
  forReferences(centers, slab,
    [&](int x, int y, int z, std::size_t i)
    {
      const std::size_t row = rows * z + y;
      const std::uint32_t at = next[(row - firstRow) * width + static_cast<std::size_t>(x)]++;
      references_[rowStart_[row] + at] = static_cast<std::uint32_t>(i);
    });
}

void ReferenceGrid::markMacrocells()
{
  const Vec3i n = macroResolution_;
  macrocellUsed_.assign(static_cast<std::size_t>(n.x) * n.y * n.z, 0);
  const auto width = static_cast<std::size_t>(resolution_.x) + 1;
  tbb::parallel_for(0, n.z,
    [&](int layer)
    {
      const int last = std::min(resolution_.z, (layer + 1) * macrocellSide);
      for (int z = layer * macrocellSide; z < last; ++z)
        for (int y = 0; y < resolution_.y; ++y)
        {
          const std::size_t row = static_cast<std::size_t>(resolution_.y) * z + y;
          const std::uint32_t* start = &cellStart_[row * width];
          std::uint8_t* used =
            &macrocellUsed_[(static_cast<std::size_t>(layer) * n.y + y / macrocellSide) * n.x];
          for (int x = 0; x < resolution_.x; ++x)
            used[x / macrocellSide] |= start[x] < start[x + 1];
        }
    });
}

void ReferenceGrid::build(const ParticleSet& particles, double lambda)
{
  CellGrid centers;
  centers.build(particles, lambda);
  size(centers, lambda);
  const std::size_t rows =
    static_cast<std::size_t>(resolution_.y) * static_cast<std::size_t>(resolution_.z);
  cellStart_.resize(rows * (static_cast<std::size_t>(resolution_.x) + 1));
  rowStart_.resize(rows);
  forSlabs(resolution_.z, [&](int first, int last) { count(centers, {first, last}); });
  std::uint64_t sum = 0;
  for (std::uint64_t& start : rowStart_)
    sum += std::exchange(start, sum);
  references_.resize(sum);
  forSlabs(resolution_.z, [&](int first, int last) { fill(centers, {first, last}); });
  markMacrocells();
  records_ = std::move(centers.records);
}

std::size_t ReferenceGrid::bytes() const
{
  return records_.capacity() * sizeof(CellGrid::Record) +
         (references_.capacity() + cellStart_.capacity()) * sizeof(std::uint32_t) +
         rowStart_.capacity() * sizeof(std::uint64_t) + macrocellUsed_.capacity();
}

} // namespace mote::bench
