#include "CoherentGrid.h"

#include <algorithm>
#include <cmath>

namespace mote
{

std::size_t CoherentGrid::bytes() const
{
  const auto bytesOf = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytesOf(records_) + bytesOf(cellStart_) + bytesOf(rowStart_) + bytesOf(index32_) +
         bytesOf(index64_) + bytesOf(shown_) + bytesOf(values_) + bytesOf(macroBounds_) +
         bytesOf(macrocellOccupied_) + bytesOf(macrocellShown_) + bytesOf(layers_);
}

void CoherentGrid::clear()
{
  statistics_ = {};
  origin_ = Vec3d(0.0);
  unit_ = 1.0;
  count_ = 0;
  ranges_ = {};
  layers_.clear();
  records_.clear();
  cellStart_.clear();
  rowStart_.clear();
  index32_.clear();
  index64_.clear();
  shown_.clear();
  values_.clear();
  macroBounds_.clear();
  macrocellOccupied_.clear();
  macrocellShown_.clear();
}

int CoherentGrid::bundleSide(const CameraRays& rays, int x0, int y0, int size) const
{
  if (layers_.empty())
    return 16;
  // Pixels that one cell covers where the tile's middle ray passes the middle of the data, or, from
  // within, a quarter of the data's size in front of the eye.
  const double x = x0 + 0.5 * size, y = y0 + 0.5 * size;
  const Vec3d direction = rays.directionAt(x, y), toMiddle = origin_ - rays.originAt(x, y);
  const double along = glm::dot(toMiddle, direction) / glm::dot(direction, direction);
  const Vec3d extent = statistics_.bounds.size();
  const double quarter = 0.25 * std::max({extent.x, extent.y, extent.z}) / glm::length(direction);
  const double t = std::max({along, quarter, rays.tMin});
  const double pixel =
    std::max(glm::length(rays.ox + t * rays.dx), glm::length(rays.oy + t * rays.dy));
  // The layer of most particles decides: it has most to look at.
  const auto largest = std::max_element(layers_.begin(), layers_.end(),
    [](const Layer& a, const Layer& b) { return a.count < b.count; });
  const double cell = unit_ * largest->cellSize / pixel;
  return cell > 4.0 ? 16 : cell > 1.0 ? 8 : cell > 0.25 ? 4 : 2;
}

} // namespace mote
