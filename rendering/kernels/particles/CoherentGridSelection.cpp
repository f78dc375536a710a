// Which particles of a CoherentGrid are shown: by a bit each, and by ranges of their values.

#include "CoherentGrid.h"

#include "detail/CoherentGridView.h"
#include "detail/ParticleAttributes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace mote
{

void CoherentGrid::setVisibility(const std::function<bool(std::size_t)>& shown)
{
  keepVisibility(shown, count_, shown_);
  findOccupied();
  findShown();
}

void CoherentGrid::setAttributes(const std::vector<ParticleAttribute>& attributes)
{
  checkAttributes(attributes, !index32_.empty() || !index64_.empty(), inputs_);
  macroBounds_.clear();
  keepAttributes(
    attributes, count_, values_, [this](std::size_t slot) { return inputIndex(slot); });
  findShown();
}

void CoherentGrid::setRanges(const ParticleRanges& ranges)
{
  keepRanges(ranges);
  findShown();
}

/// Calls f(start, base) for the rows of cells of a row of macrocells: the particles of the cells
/// from x0 to before x1 are those from base + start[x0] to before base + start[x1].
template <typename Use>
void CoherentGrid::forRowsOf(const Layer& layer, int macroRow, const Use& f) const
{
  const auto cells = [&](int axis, int c) {
    return std::pair(c * macrocellSize, std::min(layer.resolution[axis], (c + 1) * macrocellSize));
  };
  const auto [y0, y1] = cells(1, macroRow % layer.macroResolution.y);
  const auto [z0, z1] = cells(2, macroRow / layer.macroResolution.y);
  for (int z = z0; z < z1; ++z)
    for (int y = y0; y < y1; ++y)
    {
      const std::size_t r = static_cast<std::size_t>(z) * layer.resolution.y + y;
      f(&cellStart_[layer.firstCell + r * layer.rowWidth()], rowStart_[layer.firstRow + r]);
    }
}

/// Calls visit(macrocell, forRows) for every macrocell, in parallel; forRows(f) calls f(first,
/// last) for the particles of each row of cells in it.
template <typename Visit>
void CoherentGrid::forMacrocells(const Visit& visit) const
{
  for (const Layer& layer : layers_)
    tbb::parallel_for(0, layer.macroResolution.y * layer.macroResolution.z,
      [&](int row)
      {
        for (int x = 0; x < layer.macroResolution.x; ++x)
        {
          const int x0 = x * macrocellSize, x1 = std::min(layer.resolution.x, x0 + macrocellSize);
          const auto forRows = [&](const auto& f)
          {
            forRowsOf(layer, row,
              [&](const std::uint32_t* start, std::uint64_t base)
              { f(base + start[x0], base + start[x1]); });
          };
          visit(layer.firstMacrocell + static_cast<std::size_t>(row) * layer.macroResolution.x + x,
            forRows);
        }
      });
}

void CoherentGrid::findOccupied()
{
  const auto isAnyShown = [&](std::uint64_t first, std::uint64_t last)
  {
    if (shown_.empty())
      return first < last;
    for (std::uint64_t slot = first; slot < last; ++slot)
      if ((shown_[slot / 64] >> (slot % 64)) & 1)
        return true;
    return false;
  };
  macrocellOccupied_.resize(
    layers_.empty() ? 0 : layers_.back().firstMacrocell + layers_.back().macrocells());
  forMacrocells(
    [&](std::size_t macrocell, const auto& forRows)
    {
      bool any = false;
      forRows(
        [&](std::uint64_t first, std::uint64_t last) { any = any || isAnyShown(first, last); });
      macrocellOccupied_[macrocell] = any;
    });
}

void CoherentGrid::findMacroBounds()
{
  macroBounds_.resize(macrocellOccupied_.size());
  macroHasNaN_.assign(macroBounds_.size(), 0);
  forMacrocells(
    [&](std::size_t macrocell, const auto& forRows)
    {
      MacroBounds& bounds = macroBounds_[macrocell];
      bounds.least.fill(std::numeric_limits<float>::infinity());
      bounds.greatest.fill(-std::numeric_limits<float>::infinity());
      // Comparisons with NaN fail: it widens no bounds.
      const auto add = [&](int k, float v)
      {
        macroHasNaN_[macrocell] |= std::uint8_t(v != v);
        bounds.least[k] = v < bounds.least[k] ? v : bounds.least[k];
        bounds.greatest[k] = v > bounds.greatest[k] ? v : bounds.greatest[k];
      };
      forRows(
        [&](std::uint64_t first, std::uint64_t last)
        {
          for (std::uint64_t slot = first; slot < last; ++slot)
          {
            const Record& p = records_[slot];
            add(0, p.x);
            add(1, p.y);
            add(2, p.z);
            add(3, p.r);
            for (int k = 0; k < 4 && !values_.empty(); ++k)
              add(4 + k, values_[slot][k]);
          }
        });
    });
}

/// Runs of the slots in the macrocells that accepts(macrocell).
template <typename Accepts>
std::vector<SlotRun> CoherentGrid::runsOf(const Accepts& accepts) const
{
  std::vector<SlotRun> runs;
  std::vector<std::pair<int, int>> stretches; // of cells along x, in a row of macrocells
  for (const Layer& layer : layers_)
    for (int macroRow = 0; macroRow < layer.macroResolution.y * layer.macroResolution.z; ++macroRow)
    {
      stretches.clear();
      for (int x = 0; x < layer.macroResolution.x; ++x)
        if (accepts(layer.firstMacrocell +
                    static_cast<std::size_t>(macroRow) * layer.macroResolution.x + x))
        {
          const int begin = x * macrocellSize;
          if (stretches.empty() || stretches.back().second != begin)
            stretches.emplace_back(begin, begin);
          stretches.back().second = std::min(layer.resolution.x, begin + macrocellSize);
        }
      if (!stretches.empty())
        forRowsOf(layer, macroRow,
          [&](const std::uint32_t* start, std::uint64_t base)
          {
            for (const auto& [begin, end] : stretches)
              addRun(runs, base + start[begin], base + start[end]);
          });
    }
  return runs;
}

std::vector<SlotRun> CoherentGrid::slotsBetween(int k, double low, double high) const
{
  if (macroBounds_.empty())
    return StoredParticles::slotsBetween(k, low, high);
  const double shift = k < 3 ? origin_[k] : 0.0;
  return runsOf(
    [&](std::size_t i)
    {
      return shift + unit_ * double(macroBounds_[i].greatest[k]) >= low &&
             shift + unit_ * double(macroBounds_[i].least[k]) <= high;
    });
}

std::size_t CoherentGrid::shownCount() const
{
  const CoherentGridView view(*this, true);
  if (view.ranges.limits == 0)
    return countBits(shown_, count_);
  const auto isAllShown = [&](std::size_t i)
  {
    bool all = shown_.empty() && macroHasNaN_[i] == 0;
    for (int k = 0; k < view.ranges.limits && all; ++k)
    {
      const int value = view.ranges.value[k];
      all = macroBounds_[i].least[value] >= view.ranges.lower[k] &&
            macroBounds_[i].greatest[value] <= view.ranges.upper[k];
    }
    return all;
  };
  std::size_t count = 0;
  for (const SlotRun& run :
    runsOf([&](std::size_t i) { return macrocellShown_[i] && isAllShown(i); }))
    count += run.last - run.first;
  const auto mixed = runsOf([&](std::size_t i) { return macrocellShown_[i] && !isAllShown(i); });
  return count + tbb::parallel_reduce(
                   tbb::blocked_range<std::size_t>(0, mixed.size(), 64), std::size_t{0},
                   [&](const tbb::blocked_range<std::size_t>& range, std::size_t sum)
                   {
                     for (std::size_t r = range.begin(); r != range.end(); ++r)
                       for (std::size_t slot = mixed[r].first; slot < mixed[r].last; ++slot)
                         sum += static_cast<std::size_t>(view.isShown(slot));
                     return sum;
                   },
                   std::plus<>());
}

/// Fills met_ where there are repeats. All that are one sphere lie in one cell, so that macrocells
/// are empty as before.
void CoherentGrid::leaveOutRepeats()
{
  if (repeats_.empty())
  {
    RawVector<std::uint64_t>().swap(met_);
    RawVector<std::uint64_t>().swap(metWords_);
    return;
  }
  const CoherentGridView view(*this, true);
  findBits(count_, met_, [&](std::size_t slot) { return view.isShown(slot); });
  // Particles of a cell are in the order of the input.
  repeats_.leaveFirst(met_, [](std::size_t slot) { return slot; });
  findBits(met_.size(), metWords_, [this](std::size_t word) { return met_[word] != 0; });
}

void CoherentGrid::findShown()
{
  leaveOutRepeats();
  const StoredRanges stored(ranges_, origin_, unit_, !values_.empty());
  macrocellShown_ = macrocellOccupied_;
  if (stored.limits == 0)
    return;
  if (macroBounds_.empty())
    findMacroBounds();
  for (std::size_t i = 0; i < macrocellShown_.size(); ++i)
    for (int k = 0; k < stored.limits && macrocellShown_[i]; ++k)
    {
      const int value = stored.value[k];
      macrocellShown_[i] = macroBounds_[i].greatest[value] >= stored.lower[k] &&
                           macroBounds_[i].least[value] <= stored.upper[k];
    }
}

} // namespace mote
