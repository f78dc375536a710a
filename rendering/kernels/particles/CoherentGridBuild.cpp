#include "CoherentGrid.h"

#include "../core/Error.h"
#include "detail/BuildOrClear.h"
#include "detail/RadiusGroups.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>
#include <thread>
#include <tuple>

namespace mote
{

namespace
{

constexpr std::size_t paddingRecords = 16; // what one SIMD load may read past the last particle

/// Octave of a radius: its exponent as a float, in [0, 256).
int octaveOf(float radius)
{
  return static_cast<int>(std::bit_cast<std::uint32_t>(radius) >> 23);
}

bool areSame(const CoherentGrid::Record& a, const CoherentGrid::Record& b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z && a.r == b.r;
}

/// Some order in which those that are the same are neighbours.
bool isBefore(const CoherentGrid::Record& a, const CoherentGrid::Record& b)
{
  return std::tie(a.x, a.y, a.z, a.r) < std::tie(b.x, b.y, b.z, b.r);
}

/// Whether of some records, taken at even distances, two are the same: cells may be crowded for
/// other reasons, and sorting them would take long.
bool areLikelyRepeated(
  const RawVector<CoherentGrid::Record>& records, std::size_t first, std::size_t last)
{
  const std::size_t most = 2 * RepeatedSpheres::smallest, step = (last - first + most - 1) / most;
  std::vector<CoherentGrid::Record> some;
  for (std::size_t i = first; i < last; i += step)
    some.push_back(records[i]);
  std::sort(some.begin(), some.end(), isBefore);
  return std::adjacent_find(some.begin(), some.end(), areSame) != some.end();
}

/// Adds the groups of one sphere among the records of a cell.
void findRepeatedRecords(const RawVector<CoherentGrid::Record>& records, std::size_t first,
  std::size_t last, RepeatedSpheres& repeats)
{
  if (!areLikelyRepeated(records, first, last))
    return;
  std::vector<std::size_t> slots(last - first);
  std::iota(slots.begin(), slots.end(), first);
  const auto differs = [&](std::size_t slot) { return !areSame(records[slot], records[first]); };
  if (std::any_of(slots.begin(), slots.end(), differs))
    tbb::parallel_sort(slots.begin(), slots.end(),
      [&](std::size_t a, std::size_t b)
      {
        const CoherentGrid::Record &p = records[a], &q = records[b];
        return isBefore(p, q) || (!isBefore(q, p) && a < b);
      });
  for (std::size_t i = 0, end = 0; i < slots.size(); i = end)
  {
    for (end = i + 1; end < slots.size() && areSame(records[slots[i]], records[slots[end]]);)
      ++end;
    if (end - i < RepeatedSpheres::smallest)
      continue;
    repeats.addGroup();
    for (std::size_t j = i; j < end; ++j)
      repeats.addRun(slots[j], slots[j] + 1);
  }
}

} // namespace

/// One build of one grid: sizes its layers, sorts the particles into slabs of rows (in parallel
/// over chunks of the input), then each slab into its cells (in parallel over slabs). No locks, and
/// both sorts are stable, so the order within a cell is that of the input on any number of threads.
struct CoherentGrid::Builder
{
  CoherentGrid& grid;
  const ParticleSet& particles;
  const CoherentGridOptions& options;
  const Progress& progress;

  const double cellsPerParticle = std::clamp(options.cellsPerParticle, 0.2, 5.0);

  /// Neighbouring rows of one layer, sorted into cells by one task.
  struct Slab
  {
    std::size_t layer, firstRow, lastRow; ///< rows within the layer
  };

  std::array<std::uint8_t, 256> layerOfOctave{};
  std::vector<std::uint32_t> slabOfRow{}; ///< as rowStart_ is ordered: dividing would take longer
  std::vector<std::size_t> firstSlab{};   ///< by layer
  std::vector<Slab> slabs{};
  std::size_t chunkSize = 1;
  std::size_t chunks = 1;
  std::vector<std::size_t> offsets{}; ///< chunk-major: first place of a chunk's particles in a slab
  std::vector<std::size_t> slabStart{};
  RawVector<Record> sortedRecords{};        ///< by slab
  RawVector<std::uint64_t> sortedIndices{}; ///< by slab; empty where indices are not kept

  std::vector<RepeatedSpheres> repeats{}; ///< by slab

  bool report(double done) const { return !progress || progress(done); }

  /// Calls body(i) for i < count, in parallel, and tells, on the calling thread, how the share done
  /// goes from one to the other. False where it was asked to stop, which it does soon.
  template <typename Body>
  bool forEach(std::size_t count, double from, double to, const Body& body) const
  {
    const auto caller = std::this_thread::get_id();
    std::atomic<std::size_t> done{0};
    std::atomic<bool> goesOn{true};
    bool reporting = false; // who is told may work in parallel, and this thread then lend a hand
    tbb::parallel_for(std::size_t{0}, count,
      [&](std::size_t i)
      {
        if (!goesOn)
          return;
        body(i);
        const double share = double(++done) / double(count);
        if (std::this_thread::get_id() != caller || reporting)
          return;
        reporting = true;
        goesOn = report(from + share * (to - from));
        reporting = false;
      });
    return goesOn;
  }

  template <typename Visit>
  void forChunk(std::size_t chunk, const Visit& visit) const
  {
    const std::size_t last = std::min(particles.count(), (chunk + 1) * chunkSize);
    const Vec3d origin = grid.origin_;
    const double perUnit = 1.0 / grid.unit_; // exact: a power of two
    particles.forRange(chunk * chunkSize, last,
      [&](std::size_t i, const Vec3d& p, double r)
      {
        if (!isValidParticle(p, r))
          return;
        const Vec3f local((p - origin) * perUnit);
        visit(i, Record{local.x, local.y, local.z, static_cast<float>(r * perUnit)});
      });
  }

  void planChunks()
  {
    const std::size_t n = particles.count();
    const int threads = tbb::this_task_arena::max_concurrency();
    chunkSize = std::max<std::size_t>(4096, n / (4 * static_cast<std::size_t>(threads)) + 1);
    chunks = (n + chunkSize - 1) / chunkSize;
  }

  /// What the radii ask for: one layer mostly, and no look at them then.
  std::vector<RadiusGroup> groups()
  {
    const ParticleStatistics& s = grid.statistics_;
    RadiusGroup all;
    all.count = s.valid;
    all.centers.add(Vec3d(Vec3f((s.centers.lower - grid.origin_) / grid.unit_)));
    all.centers.add(Vec3d(Vec3f((s.centers.upper - grid.origin_) / grid.unit_)));
    all.largestRadius = static_cast<float>(s.largestRadius / grid.unit_);
    all.octave = octaveOf(static_cast<float>(s.largestRadius / grid.unit_));
    if (octaveOf(static_cast<float>(s.smallestRadius / grid.unit_)) == all.octave)
      return {all};
    std::vector<RadiusGroup> found;
    for (const RadiusGroup& octave : octaves())
      if (octave.count > 0)
        found.push_back(octave);
    std::reverse(found.begin(), found.end());
    return mergedGroups(found, cellsPerParticle);
  }

  std::vector<RadiusGroup> octaves() const
  {
    return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, chunks, 1), std::vector<RadiusGroup>(256),
      [&](const tbb::blocked_range<std::size_t>& range, std::vector<RadiusGroup> found)
      {
        for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk)
          forChunk(chunk,
            [&](std::size_t, const Record& p)
            {
              const int octave = octaveOf(p.r);
              found[octave].add({1, {Vec3d(p.x, p.y, p.z), Vec3d(p.x, p.y, p.z)}, p.r, octave});
            });
        return found;
      },
      [](std::vector<RadiusGroup> a, const std::vector<RadiusGroup>& b)
      {
        for (std::size_t k = 0; k < a.size(); ++k)
          a[k].add(b[k]);
        return a;
      });
  }

  void addLayer(const RadiusGroup& group)
  {
    Layer layer;
    const Vec3d size = group.centers.size();
    const double edge = particleGridEdge(
      size, cellsPerParticle * static_cast<double>(group.count), group.largestRadius);
    layer.cellSize = static_cast<float>(edge);
    layer.cellsPerUnit = 1.0f / layer.cellSize;
    layer.lower = Vec3f(group.centers.lower);
    layer.largestRadius = group.largestRadius;
    for (int k = 0; k < 3; ++k)
    {
      constexpr int m = macrocellSize;
      layer.resolution[k] = 1 + static_cast<int>(size[k] / layer.cellSize);
      layer.macroResolution[k] = (layer.resolution[k] + m - 1) / m;
    }
    if (!grid.layers_.empty())
    {
      const Layer& last = grid.layers_.back();
      layer.firstRow = last.firstRow + last.rows() + 1;
      layer.firstCell = last.firstCell + last.rows() * last.rowWidth();
      layer.firstMacrocell = last.firstMacrocell + last.macrocells();
    }
    grid.layers_.push_back(layer);
  }

  void addLayers()
  {
    const std::vector<RadiusGroup> found = groups();
    int octave = 255;
    for (const RadiusGroup& group : found)
    {
      for (; octave >= group.octave; --octave)
        layerOfOctave[static_cast<std::size_t>(octave)] =
          static_cast<std::uint8_t>(grid.layers_.size());
      addLayer(group);
    }
    // Rounding may carry a radius over the edge of the least octave.
    for (; octave >= 0; --octave)
      layerOfOctave[static_cast<std::size_t>(octave)] =
        static_cast<std::uint8_t>(grid.layers_.size() - 1);
    for (std::size_t k = 0; k < found.size(); ++k)
      addSlabs(k, found[k].count);
  }

  void addSlabs(std::size_t layer, std::size_t count)
  {
    const std::size_t rows = grid.layers_[layer].rows();
    const std::size_t wanted = std::min<std::size_t>({rows, 1024, 1 + count / 512});
    const std::size_t each = (rows + wanted - 1) / wanted;
    firstSlab.push_back(slabs.size());
    slabOfRow.resize(grid.layers_[layer].firstRow + rows);
    for (std::size_t row = 0; row < rows; row += each)
    {
      const std::size_t last = std::min(rows, row + each);
      const auto begin =
        slabOfRow.begin() + static_cast<std::ptrdiff_t>(grid.layers_[layer].firstRow);
      std::fill(begin + static_cast<std::ptrdiff_t>(row), begin + static_cast<std::ptrdiff_t>(last),
        static_cast<std::uint32_t>(slabs.size()));
      slabs.push_back({layer, row, last});
    }
  }

  static int cellAlong(const Layer& layer, float local, int axis)
  {
    const int c = static_cast<int>((local - layer.lower[axis]) * layer.cellsPerUnit);
    return std::clamp(c, 0, layer.resolution[axis] - 1);
  }
  static std::size_t rowOf(const Layer& layer, const Record& p)
  {
    return static_cast<std::size_t>(cellAlong(layer, p.z, 2)) * layer.resolution.y +
           cellAlong(layer, p.y, 1);
  }
  std::size_t slabOf(const Record& p) const
  {
    const std::size_t layer = layerOfOctave[static_cast<std::size_t>(octaveOf(p.r))];
    const Layer& l = grid.layers_[layer];
    return slabOfRow[l.firstRow + rowOf(l, p)];
  }

  bool sortIntoSlabs()
  {
    offsets.assign(chunks * slabs.size(), 0);
    const bool counted = forEach(chunks, 0.1, 0.3,
      [&](std::size_t chunk)
      {
        std::size_t* counts = &offsets[chunk * slabs.size()];
        forChunk(chunk, [&](std::size_t, const Record& p) { ++counts[slabOf(p)]; });
      });
    if (!counted)
      return false;
    slabStart.assign(slabs.size() + 1, 0);
    std::size_t sum = 0;
    for (std::size_t slab = 0; slab < slabs.size(); ++slab)
    {
      slabStart[slab] = sum;
      for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        sum += std::exchange(offsets[chunk * slabs.size() + slab], sum);
    }
    slabStart.back() = sum;
    grid.count_ = sum;

    sortedRecords.resize(sum);
    sortedIndices.resize(options.keepIndices ? sum : 0);
    return forEach(chunks, 0.3, 0.7,
      [&](std::size_t chunk)
      {
        std::size_t* places = &offsets[chunk * slabs.size()];
        forChunk(chunk,
          [&](std::size_t i, const Record& p)
          {
            const std::size_t place = places[slabOf(p)]++;
            sortedRecords[place] = p;
            if (!sortedIndices.empty())
              sortedIndices[place] = options.indices.empty() ? i : options.indices[i];
          });
      });
  }

  void allocate()
  {
    const std::size_t n = grid.count_;
    const Layer& last = grid.layers_.back();
    grid.records_.resize(n + paddingRecords);
    std::fill(
      grid.records_.begin() + static_cast<std::ptrdiff_t>(n), grid.records_.end(), Record{});
    grid.cellStart_.resize(last.firstCell + last.rows() * last.rowWidth());
    grid.rowStart_.resize(last.firstRow + last.rows() + 1);
    for (std::size_t k = 0; k < grid.layers_.size(); ++k)
    {
      Layer& layer = grid.layers_[k];
      const bool isLast = k + 1 == grid.layers_.size();
      const std::size_t end = isLast ? n : slabStart[firstSlab[k + 1]];
      layer.firstSlot = slabStart[firstSlab[k]];
      layer.count = end - layer.firstSlot;
      grid.rowStart_[layer.firstRow + layer.rows()] = end;
    }
    const bool narrow = grid.inputs_ <= std::numeric_limits<std::uint32_t>::max();
    grid.index32_.resize(options.keepIndices && narrow ? n : 0);
    grid.index64_.resize(options.keepIndices && !narrow ? n : 0);
  }

  void sortSlab(std::size_t k)
  {
    const Slab slab = slabs[k];
    const Layer& layer = grid.layers_[slab.layer];
    const std::size_t width = layer.rowWidth();
    std::vector<std::size_t> next((slab.lastRow - slab.firstRow) * width, 0);
    const auto cell = [&](const Record& p)
    { return (rowOf(layer, p) - slab.firstRow) * width + cellAlong(layer, p.x, 0); };

    for (std::size_t i = slabStart[k]; i < slabStart[k + 1]; ++i)
      ++next[cell(sortedRecords[i])];
    std::size_t sum = slabStart[k];
    for (std::size_t row = slab.firstRow; row < slab.lastRow; ++row)
    {
      const std::size_t rowStart = sum;
      grid.rowStart_[layer.firstRow + row] = rowStart;
      std::size_t* counts = &next[(row - slab.firstRow) * width];
      std::uint32_t* starts = &grid.cellStart_[layer.firstCell + row * width];
      for (std::size_t x = 0; x < width; ++x)
      {
        const std::size_t start = sum - rowStart;
        if (start > std::numeric_limits<std::uint32_t>::max())
          throw Error("More than 2^32 particles lie in one row of the grid.");
        starts[x] = static_cast<std::uint32_t>(start);
        sum += std::exchange(counts[x], sum);
      }
    }
    for (std::size_t i = slabStart[k]; i < slabStart[k + 1]; ++i)
    {
      const std::size_t place = next[cell(sortedRecords[i])]++;
      grid.records_[place] = sortedRecords[i];
      if (!grid.index32_.empty())
        grid.index32_[place] = static_cast<std::uint32_t>(sortedIndices[i]);
      else if (!grid.index64_.empty())
        grid.index64_[place] = sortedIndices[i];
    }
  }

  /// Looks for repeats in the cells of a slab that are crowded.
  void findRepeats(std::size_t k)
  {
    const Slab slab = slabs[k];
    const Layer& layer = grid.layers_[slab.layer];
    for (std::size_t row = slab.firstRow; row < slab.lastRow; ++row)
    {
      const std::uint64_t base = grid.rowStart_[layer.firstRow + row];
      const std::uint32_t* start = &grid.cellStart_[layer.firstCell + row * layer.rowWidth()];
      if (start[layer.resolution.x] - start[0] < RepeatedSpheres::smallest)
        continue;
      for (int x = 0; x < layer.resolution.x; ++x)
        if (start[x + 1] - start[x] >= RepeatedSpheres::smallest)
          findRepeatedRecords(grid.records_, base + start[x], base + start[x + 1], repeats[k]);
    }
  }

  bool run()
  {
    grid.statistics_ = examine(particles);
    grid.inputs_ = options.indices.empty() ? particles.count() : options.inputs;
    if (!report(0.1))
      return false;
    if (grid.statistics_.valid == 0)
      return true;
    planChunks();
    grid.placeByCells(cellsPerParticle * static_cast<double>(grid.statistics_.valid));
    addLayers();
    if (!sortIntoSlabs())
      return false;
    allocate();
    repeats.resize(slabs.size());
    const auto finishSlab = [&](std::size_t slab)
    {
      sortSlab(slab);
      findRepeats(slab);
    };
    if (!forEach(slabs.size(), 0.7, 1.0, finishSlab))
      return false;
    for (const RepeatedSpheres& found : repeats)
      grid.repeats_.add(found);
    grid.findOccupied();
    grid.findShown();
    return report(1.0);
  }
};

void CoherentGrid::build(
  const ParticleSet& particles, const CoherentGridOptions& options, const Progress& progress)
{
  buildOrClear([this] { clear(); },
    [&] {
      return Builder{*this, particles, options, progress}.run();
    });
}

} // namespace mote
