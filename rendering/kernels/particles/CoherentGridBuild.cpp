#include "CoherentGrid.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mote
{

namespace
{

constexpr std::size_t paddingRecords = 16; // what one SIMD load may read past the last particle

/// Edge of cubic cells that cut a box of this size into about `cells` cells. Directions thinner
/// than a cell count as one cell, so flat and linear sets get as many cells as others.
double cellEdge(const Vec3d& size, double cells)
{
  std::array<double, 3> extents = {size.x, size.y, size.z};
  std::sort(extents.begin(), extents.end(), std::greater<>());
  double edge = 0.0;
  for (int dims = 3; dims >= 1; --dims)
  {
    double measure = 1.0;
    for (int k = 0; k < dims; ++k)
      measure *= extents[k] > 0.0 ? std::pow(extents[k] / cells, 1.0 / dims) : 0.0;
    // measure = (product / cells^dims)^(1/dims), formed so that no product over- or underflows.
    edge = measure * std::pow(cells, (dims - 1.0) / dims);
    if (edge > 0.0 && extents[dims - 1] >= edge)
      break;
  }
  return edge;
}

} // namespace

/// One build of one grid: sizes it, sorts the particles into slabs of rows (in parallel over chunks
/// of the input), then each slab into its cells (in parallel over slabs). No locks, and both sorts
/// are stable, so the order within a cell is that of the input on any number of threads.
struct CoherentGridBuilder
{
  CoherentGrid& grid;
  const ParticleSet& particles;
  const CoherentGridOptions& options;
  const Progress& progress;

  std::size_t rows = 0;
  std::size_t rowsPerSlab = 1;
  std::size_t slabs = 1;
  std::size_t chunkSize = 1;
  std::size_t chunks = 1;
  std::vector<std::size_t> offsets{}; ///< chunk-major: first place of a chunk's particles in a slab
  std::vector<std::size_t> slabStart{};
  RawVector<CoherentGrid::Record> sortedRecords{}; ///< by slab
  RawVector<std::uint64_t> sortedIndices{};        ///< by slab; empty where indices are not kept

  bool report(double done) const { return !progress || progress(done); }

  void sizeGrid()
  {
    const ParticleStatistics& s = grid.statistics_;
    grid.origin_ = s.centers.center();
    const Vec3d size = s.centers.size();
    const double lambda = std::clamp(options.cellsPerParticle, 0.2, 5.0);
    double edge = cellEdge(size, lambda * static_cast<double>(s.valid));
    const double longest = std::max({size.x, size.y, size.z});
    // Finer cells float could not tell apart; where all centres coincide any size will do.
    edge = std::max({edge, longest * std::ldexp(1.0, -20), s.largestRadius * 1e-3});
    grid.unit_ = std::exp2(std::round(std::log2(edge)));
    grid.cellSize_ = static_cast<float>(edge / grid.unit_);
    grid.lower_ = Vec3f((s.centers.lower - grid.origin_) / grid.unit_);
    for (int k = 0; k < 3; ++k)
    {
      grid.resolution_[k] = 1 + static_cast<int>(size[k] / grid.cellSize());
      grid.macroResolution_[k] =
        (grid.resolution_[k] + CoherentGrid::macrocellSize - 1) / CoherentGrid::macrocellSize;
    }
    grid.largestRadius_ = static_cast<float>(s.largestRadius / grid.unit_);
  }

  void planSort()
  {
    const std::size_t n = particles.count();
    const int threads = tbb::this_task_arena::max_concurrency();
    rows = static_cast<std::size_t>(grid.resolution_.y) * grid.resolution_.z;
    slabs = std::min<std::size_t>({rows, 1024, 1 + grid.statistics_.valid / 512});
    rowsPerSlab = (rows + slabs - 1) / slabs;
    slabs = (rows + rowsPerSlab - 1) / rowsPerSlab;
    chunkSize = std::max<std::size_t>(4096, n / (4 * static_cast<std::size_t>(threads)) + 1);
    chunks = (n + chunkSize - 1) / chunkSize;
  }

  bool record(std::size_t i, CoherentGrid::Record& out) const
  {
    const Vec3d p = particles.position(i);
    const double r = particles.radiusOf(i);
    if (!isValidParticle(p, r))
      return false;
    const Vec3f local((p - grid.origin_) / grid.unit_);
    out = {local.x, local.y, local.z, static_cast<float>(r / grid.unit_)};
    return true;
  }

  int cellAlong(float local, int axis) const
  {
    const int c = static_cast<int>((local - grid.lower_[axis]) / grid.cellSize_);
    return std::clamp(c, 0, grid.resolution_[axis] - 1);
  }
  std::size_t rowOf(const CoherentGrid::Record& p) const
  {
    return static_cast<std::size_t>(cellAlong(p.z, 2)) * grid.resolution_.y + cellAlong(p.y, 1);
  }

  template <typename Visit>
  void forChunk(std::size_t chunk, const Visit& visit) const
  {
    const std::size_t last = std::min(particles.count(), (chunk + 1) * chunkSize);
    CoherentGrid::Record p;
    for (std::size_t i = chunk * chunkSize; i < last; ++i)
      if (record(i, p))
        visit(i, p, rowOf(p) / rowsPerSlab);
  }

  void sortIntoSlabs()
  {
    offsets.assign(chunks * slabs, 0);
    tbb::parallel_for(std::size_t{0}, chunks,
      [&](std::size_t chunk)
      {
        forChunk(chunk,
          [&](std::size_t, const auto&, std::size_t slab) { ++offsets[chunk * slabs + slab]; });
      });
    slabStart.assign(slabs + 1, 0);
    std::size_t sum = 0;
    for (std::size_t slab = 0; slab < slabs; ++slab)
    {
      slabStart[slab] = sum;
      for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        sum += std::exchange(offsets[chunk * slabs + slab], sum);
    }
    slabStart[slabs] = sum;
    grid.count_ = sum;

    sortedRecords.resize(sum);
    sortedIndices.resize(options.keepIndices ? sum : 0);
    tbb::parallel_for(std::size_t{0}, chunks,
      [&](std::size_t chunk)
      {
        forChunk(chunk,
          [&](std::size_t i, const auto& p, std::size_t slab)
          {
            const std::size_t place = offsets[chunk * slabs + slab]++;
            sortedRecords[place] = p;
            if (!sortedIndices.empty())
              sortedIndices[place] = i;
          });
      });
  }

  void allocate()
  {
    const std::size_t n = grid.count_;
    grid.records_.resize(n + paddingRecords);
    std::fill(grid.records_.begin() + n, grid.records_.end(), CoherentGrid::Record{});
    grid.cellStart_.resize(rows * (static_cast<std::size_t>(grid.resolution_.x) + 1));
    grid.rowStart_.resize(rows + 1);
    grid.rowStart_[rows] = n;
    const bool narrow = particles.count() <= std::numeric_limits<std::uint32_t>::max();
    grid.index32_.resize(options.keepIndices && narrow ? n : 0);
    grid.index64_.resize(options.keepIndices && !narrow ? n : 0);
  }

  void sortSlab(std::size_t slab)
  {
    const std::size_t firstRow = slab * rowsPerSlab;
    const std::size_t lastRow = std::min(rows, firstRow + rowsPerSlab);
    const std::size_t width = static_cast<std::size_t>(grid.resolution_.x) + 1;
    std::vector<std::size_t> next((lastRow - firstRow) * width, 0);
    const auto cell = [&](const CoherentGrid::Record& p)
    { return (rowOf(p) - firstRow) * width + cellAlong(p.x, 0); };

    for (std::size_t i = slabStart[slab]; i < slabStart[slab + 1]; ++i)
      ++next[cell(sortedRecords[i])];
    std::size_t sum = slabStart[slab];
    for (std::size_t row = firstRow; row < lastRow; ++row)
    {
      grid.rowStart_[row] = sum;
      std::size_t* counts = &next[(row - firstRow) * width];
      std::uint32_t* starts = &grid.cellStart_[row * width];
      for (std::size_t x = 0; x < width; ++x)
      {
        const std::size_t start = sum - grid.rowStart_[row];
        if (start > std::numeric_limits<std::uint32_t>::max())
          throw Error("More than 2^32 particles lie in one row of the grid.");
        starts[x] = static_cast<std::uint32_t>(start);
        sum += std::exchange(counts[x], sum);
      }
    }
    for (std::size_t i = slabStart[slab]; i < slabStart[slab + 1]; ++i)
    {
      const std::size_t place = next[cell(sortedRecords[i])]++;
      grid.records_[place] = sortedRecords[i];
      if (!grid.index32_.empty())
        grid.index32_[place] = static_cast<std::uint32_t>(sortedIndices[i]);
      else if (!grid.index64_.empty())
        grid.index64_[place] = sortedIndices[i];
    }
  }

  bool run()
  {
    grid.statistics_ = examine(particles);
    if (!report(0.2))
      return false;
    if (grid.statistics_.valid == 0)
      return true;
    sizeGrid();
    planSort();
    sortIntoSlabs();
    if (!report(0.7))
      return false;
    allocate();
    tbb::parallel_for(std::size_t{0}, slabs, [&](std::size_t slab) { sortSlab(slab); });
    grid.markMacrocells();
    return report(1.0);
  }
};

void CoherentGrid::build(
  const ParticleSet& particles, const CoherentGridOptions& options, const Progress& progress)
{
  clear();
  CoherentGridBuilder builder{*this, particles, options, progress};
  bool complete = false;
  try
  {
    complete = builder.run();
  }
  catch (...)
  {
    clear();
    throw;
  }
  if (!complete)
    clear();
}

} // namespace mote
