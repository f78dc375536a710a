#include "PkdTree.h"

#include <algorithm>
#include <bit>

namespace mote
{

float PkdTree::number(std::size_t slot, int row) const
{
  return std::bit_cast<float>(bucketOf(slot)[row].words[slot % bucketSize]);
}

Vec3d PkdTree::center(std::size_t slot) const
{
  const Node& treelet = nodes_[levels_.front().first + slot / treeletSize];
  Vec3d local;
  for (int k = 0; k < 3; ++k)
    local[k] = double(treelet.corner[static_cast<std::size_t>(k)]) + double(number(slot, k));
  return origin_ + unit_ * local;
}

double PkdTree::radius(std::size_t slot) const
{
  return unit_ * (ownRadii_ ? number(slot, 3) : radius_);
}

std::uint64_t PkdTree::inputIndex(std::size_t slot) const
{
  if (indexRows_ == 0)
    return slot;
  const Row* row = bucketOf(slot) + rowsABucket_ - static_cast<std::size_t>(indexRows_);
  std::uint64_t index = row[0].words[slot % bucketSize];
  if (indexRows_ == 2)
    index = index << 32 | row[1].words[slot % bucketSize];
  return index;
}

std::size_t PkdTree::bytes() const
{
  const auto bytesOf = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return nodes_.bytes() + rows_.bytes() + bytesOf(levels_) + bytesOf(values_) + bytesOf(visible_) +
         bytesOf(shown_) + bytesOf(nodeShown_);
}

void PkdTree::clear()
{
  statistics_ = {};
  origin_ = Vec3d(0.0);
  unit_ = step_ = 1.0;
  count_ = 0;
  inOrder_ = false;
  levels_.clear();
  nodes_.clear();
  rows_.clear();
  ranges_ = {};
  values_.clear();
  visible_.clear();
  shown_.clear();
  nodeShown_.clear();
}

std::size_t PkdTree::planLevels()
{
  levels_.clear();
  std::size_t count = buckets(), nodes = 0;
  do
  {
    count = (count + fanout - 1) / fanout;
    levels_.push_back({0, count});
    nodes += count;
  } while (count > 1);
  std::size_t first = 0;
  for (std::size_t k = levels_.size(); k-- > 0; first += levels_[k].count)
    levels_[k].first = first;
  return nodes;
}

int PkdTree::bundleSide(const CameraRays& rays, int x0, int y0, int size) const
{
  if (count_ == 0)
    return 16;
  // Pixels that the space of one particle covers where the tile's middle ray passes the middle of
  // the data, or, from within, a quarter of the data's size in front of the eye.
  const double x = x0 + 0.5 * size, y = y0 + 0.5 * size;
  const Vec3d direction = rays.directionAt(x, y), toMiddle = origin_ - rays.originAt(x, y);
  const double along = glm::dot(toMiddle, direction) / glm::dot(direction, direction);
  const Vec3d extent = statistics_.bounds.size();
  const double quarter = 0.25 * std::max({extent.x, extent.y, extent.z}) / glm::length(direction);
  const double t = std::max({along, quarter, rays.tMin});
  const double pixel =
    std::max(glm::length(rays.ox + t * rays.dx), glm::length(rays.oy + t * rays.dy));
  const double spacing = unit_ / pixel;
  return spacing > 4.0 ? 16 : spacing > 1.0 ? 8 : spacing > 0.25 ? 4 : 2;
}

} // namespace mote
