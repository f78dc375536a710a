#include "CellGrid.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace mote::bench
{

double cellEdge(const Vec3d& size, double cells)
{
  std::array<double, 3> extents = {size.x, size.y, size.z};
  std::sort(extents.begin(), extents.end(), std::greater<>());
  double edge = 0.0;
  for (int dims = 3; dims >= 1; --dims)
  {
    double volume = 1.0;
    for (int k = 0; k < dims; ++k)
      volume *= extents[static_cast<std::size_t>(k)];
    edge = std::pow(volume / cells, 1.0 / dims);
    if (edge > 0.0 && extents[static_cast<std::size_t>(dims - 1)] >= edge)
      break;
  }
  return edge;
}

namespace
{

/// The sort: particles into slabs of rows, in parallel over chunks of the input, then every slab
/// into its cells. Both keep the order, so the result does not depend on the number of threads.
struct Builder
{
  CellGrid& grid;
  const ParticleSet& particles;
  std::size_t rows = 0, rowsPerSlab = 1, slabs = 1, chunkSize = 1, chunks = 1;
  std::vector<std::size_t> places{}; ///< by chunk and slab: where the next particle goes
  std::vector<std::size_t> slabStart{};
  RawVector<CellGrid::Record> bySlab{};

  void size(double lambda)
  {
    const ParticleStatistics s = examine(particles);
    const Vec3d size = s.centers.size();
    const double longest = std::max({size.x, size.y, size.z});
    double edge = cellEdge(size, lambda * static_cast<double>(s.valid));
    edge = std::max({edge, longest * std::ldexp(1.0, -20), s.largestRadius * 1e-3});
    grid.origin = s.centers.center();
    grid.unit = std::exp2(std::round(std::log2(edge)));
    grid.cellSize = static_cast<float>(edge / grid.unit);
    grid.lower = Vec3f((s.centers.lower - grid.origin) / grid.unit);
    for (int k = 0; k < 3; ++k)
      grid.resolution[k] = 1 + static_cast<int>(size[k] / (grid.unit * grid.cellSize));
    grid.largestRadius = static_cast<float>(s.largestRadius / grid.unit);
    grid.boxLower = Vec3f((s.bounds.lower - grid.origin) / grid.unit);
    grid.boxUpper = Vec3f((s.bounds.upper - grid.origin) / grid.unit);
    grid.count = s.valid;
  }

  void plan()
  {
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    rows =
      static_cast<std::size_t>(grid.resolution.y) * static_cast<std::size_t>(grid.resolution.z);
    slabs = std::min<std::size_t>({rows, 1024, 1 + grid.count / 512});
    rowsPerSlab = (rows + slabs - 1) / slabs;
    slabs = (rows + rowsPerSlab - 1) / rowsPerSlab;
    chunkSize = std::max<std::size_t>(4096, particles.count() / (4 * threads) + 1);
    chunks = (particles.count() + chunkSize - 1) / chunkSize;
  }

  std::size_t rowOf(const CellGrid::Record& p) const
  {
    return static_cast<std::size_t>(grid.cellAlong(p.z, 2)) * grid.resolution.y +
           grid.cellAlong(p.y, 1);
  }

  /// Calls visit(record, slab) for the valid particles of a chunk.
  template <typename Visit>
  void forChunk(std::size_t chunk, const Visit& visit) const
  {
    const std::size_t last = std::min(particles.count(), (chunk + 1) * chunkSize);
    for (std::size_t i = chunk * chunkSize; i < last; ++i)
    {
      const Vec3d p = particles.position(i);
      const double r = particles.radiusOf(i);
      if (!isValidParticle(p, r))
        continue;
      const Vec3f local((p - grid.origin) / grid.unit);
      const CellGrid::Record record{local.x, local.y, local.z, static_cast<float>(r / grid.unit)};
      visit(record, rowOf(record) / rowsPerSlab);
    }
  }

  void sortIntoSlabs()
  {
    places.assign(chunks * slabs, 0);
    tbb::parallel_for(std::size_t{0}, chunks,
      [&](std::size_t chunk)
      {
        forChunk(chunk,
          [&](const CellGrid::Record&, std::size_t slab) { ++places[chunk * slabs + slab]; });
      });
    slabStart.assign(slabs + 1, 0);
    std::size_t sum = 0;
    for (std::size_t slab = 0; slab < slabs; ++slab)
    {
      slabStart[slab] = sum;
      for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        sum += std::exchange(places[chunk * slabs + slab], sum);
    }
    slabStart[slabs] = sum;
    bySlab.resize(sum);
    tbb::parallel_for(std::size_t{0}, chunks,
      [&](std::size_t chunk)
      {
        forChunk(chunk, [&](const CellGrid::Record& p, std::size_t slab)
          { bySlab[places[chunk * slabs + slab]++] = p; });
      });
  }

  void sortSlab(std::size_t slab)
  {
    const std::size_t first = slab * rowsPerSlab, last = std::min(rows, first + rowsPerSlab);
    const auto width = static_cast<std::size_t>(grid.resolution.x) + 1;
    std::vector<std::size_t> next((last - first) * width, 0);
    const auto cell = [&](const CellGrid::Record& p)
    { return (rowOf(p) - first) * width + static_cast<std::size_t>(grid.cellAlong(p.x, 0)); };
    for (std::size_t i = slabStart[slab]; i < slabStart[slab + 1]; ++i)
      ++next[cell(bySlab[i])];
    std::size_t sum = slabStart[slab];
    for (std::size_t row = first; row < last; ++row)
    {
      grid.rowStart[row] = sum;
      for (std::size_t x = 0; x < width; ++x)
      {
        grid.cellStart[row * width + x] = static_cast<std::uint32_t>(sum - grid.rowStart[row]);
        sum += std::exchange(next[(row - first) * width + x], sum);
      }
    }
    for (std::size_t i = slabStart[slab]; i < slabStart[slab + 1]; ++i)
      grid.records[next[cell(bySlab[i])]++] = bySlab[i];
  }
};

} // namespace

void CellGrid::build(const ParticleSet& particles, double lambda)
{
  Builder builder{*this, particles};
  builder.size(lambda);
  builder.plan();
  builder.sortIntoSlabs();
  records.resize(count + paddingRecords);
  std::fill(records.begin() + static_cast<std::ptrdiff_t>(count), records.end(), Record{});
  cellStart.resize(builder.rows * (static_cast<std::size_t>(resolution.x) + 1));
  rowStart.resize(builder.rows + 1);
  rowStart[builder.rows] = count;
  tbb::parallel_for(
    std::size_t{0}, builder.slabs, [&](std::size_t slab) { builder.sortSlab(slab); });
}

std::size_t CellGrid::bytes() const
{
  return records.capacity() * sizeof(Record) + cellStart.capacity() * sizeof(std::uint32_t) +
         rowStart.capacity() * sizeof(std::uint64_t);
}

} // namespace mote::bench
