#include "CoherentGrid.h"

#include <algorithm>
#include <cmath>

namespace mote
{

std::size_t CoherentGrid::bytes() const
{
  const auto bytesOf = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytesOf(records_) + bytesOf(cellStart_) + bytesOf(rowStart_) + bytesOf(index32_) +
         bytesOf(index64_) + bytesOf(shown_) + bytesOf(met_) + bytesOf(metWords_) +
         repeats_.bytes() + bytesOf(values_) + bytesOf(macroBounds_) + bytesOf(macroHasNaN_) +
         bytesOf(macrocellOccupied_) + bytesOf(macrocellShown_) + bytesOf(layers_);
}

void CoherentGrid::clear()
{
  StoredParticles::clear();
  inputs_ = 0;
  layers_.clear();
  records_.clear();
  cellStart_.clear();
  rowStart_.clear();
  index32_.clear();
  index64_.clear();
  repeats_.clear();
  shown_.clear();
  met_.clear();
  metWords_.clear();
  macroBounds_.clear();
  macrocellOccupied_.clear();
  macrocellShown_.clear();
}

int CoherentGrid::bundleSide(const CameraRays& rays, int x0, int y0, int size) const
{
  if (layers_.empty())
    return 16;
  // The layer of most particles decides: it has most to look at.
  const auto largest = std::max_element(layers_.begin(), layers_.end(),
    [](const Layer& a, const Layer& b) { return a.count < b.count; });
  return suitingBundleSide(rays, statistics_.bounds, unit_ * largest->cellSize, x0, y0, size);
}

} // namespace mote
