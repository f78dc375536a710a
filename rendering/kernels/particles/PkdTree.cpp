#include "PkdTree.h"

#include "detail/RadiusGroups.h"

#include <algorithm>
#include <bit>

namespace mote
{

const std::vector<std::string>& pkdTreeFormNames()
{
  static const std::vector<std::string> names = {"exact", "8-byte", "4-byte"};
  return names;
}

float PkdTree::number(std::size_t slot, int row) const
{
  return std::bit_cast<float>(bucketOf(slot)[row].words[slot % bucketSize]);
}

Vec3f PkdTree::place(std::size_t slot) const
{
  if (placeRows_ == 3)
    return {number(slot, 0), number(slot, 1), number(slot, 2)};
  const std::uint32_t a = bucketOf(slot)[0].words[slot % bucketSize];
  const auto step = static_cast<float>(step_ / unit_);
  if (placeRows_ == 2)
  {
    const std::uint32_t b = bucketOf(slot)[1].words[slot % bucketSize];
    return step * Vec3f(a & 0xfffff, b & 0xfffff, (a >> 20) | (b >> 20 << 12));
  }
  Vec3f place;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int steps = static_cast<std::int32_t>(a << (22 - 10 * k)) >> 22;
    place[static_cast<int>(k)] =
      treeletOf(slot).middle(k, slot / bucketSize % fanout) + step * static_cast<float>(steps);
  }
  return place;
}

Vec3d PkdTree::center(std::size_t slot) const
{
  const std::array<float, 3>& corner = treeletOf(slot).corner;
  return origin_ + unit_ * (Vec3d(corner[0], corner[1], corner[2]) + Vec3d(place(slot)));
}

double PkdTree::positionError() const
{
  return 0.5 * (step_ + unit_ * double(coarse_) / (1 << cornerBits));
}

double PkdTree::radius(std::size_t slot) const
{
  return unit_ * storedRadius(slot);
}

std::uint64_t PkdTree::inputIndex(std::size_t slot) const
{
  if (indexWords_ == 0)
    return slot;
  const Row* row = bucketOf(slot) + rowsABucket_ - static_cast<std::size_t>(indexWords_);
  std::uint64_t index = row[0].words[slot % bucketSize];
  if (indexWords_ == 2)
    index = index << 32 | row[1].words[slot % bucketSize];
  return index;
}

std::size_t PkdTree::bytes() const
{
  const auto bytesOf = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return nodes_.bytes() + rows_.bytes() + bytesOf(levels_) + bytesOf(values_) + bytesOf(visible_) +
         bytesOf(shown_) + bytesOf(met_) + repeats_.bytes() + bytesOf(nodeShown_) +
         bytesOf(valueBounds_) + bytesOf(nodeWhole_) + lods_.bytes() +
         (sparse_ ? bytesOf(sparse_->levels) + bytesOf(sparse_->nodes) + bytesOf(sparse_->rows) +
                      bytesOf(sparse_->slots)
                  : 0);
}

void PkdTree::clear()
{
  StoredParticles::clear();
  step_ = 1.0;
  inOrder_ = false;
  levels_.clear();
  nodes_.clear();
  rows_.clear();
  placeRows_ = 3;
  visible_.clear();
  shown_.clear();
  repeats_.clear();
  met_.clear();
  nodeShown_.clear();
  nodeWhole_.clear();
  lods_.clear();
  storedMeans_.reset();
  valueBounds_.clear();
  sparse_.reset();
}

int PkdTree::bundleSide(const CameraRays& rays, int x0, int y0, int size, double poe) const
{
  if (count_ == 0)
    return 16;
  Vec3d extent = statistics_.centers.size();
  if (sparse_)
    for (int k = 0; k < 3; ++k)
    {
      const auto axis = static_cast<std::size_t>(k);
      extent[k] = unit_ * (sparse_->bounds.upper[axis] - sparse_->bounds.lower[axis]);
    }
  const double spacing = particleGridEdge(
    extent, static_cast<double>(sparse_ ? sparse_->count : count_), statistics_.largestRadius);
  const int side = suitingBundleSide(rays, statistics_.bounds, spacing, x0, y0, size);
  // What boxes stand for is no smaller than that.
  return poe > 0.0 && hasLods() && !sparse_ ? std::max(side, poe < 0.5 ? 8 : 16) : side;
}

} // namespace mote
