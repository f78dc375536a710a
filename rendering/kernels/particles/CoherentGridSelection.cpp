// Which particles of a CoherentGrid are shown: by a bit each, and by ranges of their values.

#include "CoherentGrid.h"

#include "detail/CoherentGridView.h"
#include "detail/ParticleAttributes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

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

/// Calls visit(layer, macrocell, forRows) for every macrocell, in parallel; forRows(f) calls
/// f(first, last) for the particles of each row of cells in it.
template <typename Visit>
void CoherentGrid::forMacrocells(const Visit& visit) const
{
  constexpr int m = macrocellSize;
  for (const Layer& layer : layers_)
  {
    const Vec3i macro = layer.macroResolution;
    const auto cells = [&](int axis, int c)
    { return std::pair(c * m, std::min(layer.resolution[axis], (c + 1) * m)); };
    tbb::parallel_for(0, macro.y * macro.z,
      [&](int row)
      {
        const auto [y0, y1] = cells(1, row % macro.y);
        const auto [z0, z1] = cells(2, row / macro.y);
        for (int x = 0; x < macro.x; ++x)
        {
          const auto [x0, x1] = cells(0, x);
          const auto forRows = [&, x0 = x0, x1 = x1, y0 = y0, y1 = y1, z0 = z0, z1 = z1](
                                 const auto& f)
          {
            for (int z = z0; z < z1; ++z)
              for (int y = y0; y < y1; ++y)
              {
                const std::size_t r = static_cast<std::size_t>(z) * layer.resolution.y + y;
                const std::uint32_t* start = &cellStart_[layer.firstCell + r * layer.rowWidth()];
                const std::uint64_t base = rowStart_[layer.firstRow + r];
                f(base + start[x0], base + start[x1]);
              }
          };
          visit(layer.firstMacrocell + static_cast<std::size_t>(row) * macro.x + x, forRows);
        }
      });
  }
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
  forMacrocells(
    [&](std::size_t macrocell, const auto& forRows)
    {
      MacroBounds& bounds = macroBounds_[macrocell];
      bounds.least.fill(std::numeric_limits<float>::infinity());
      bounds.greatest.fill(-std::numeric_limits<float>::infinity());
      // Comparisons with NaN fail: it widens no bounds.
      const auto add = [&](int k, float v)
      {
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

void CoherentGrid::findShown()
{
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
