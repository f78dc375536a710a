#include "RlodTree.h"

#include "detail/RlodTreeArrays.h"

#include <glm/geometric.hpp>

namespace mote
{

RlodTree::RlodTree()
  : arrays_(std::make_unique<Arrays>())
{
}

RlodTree::~RlodTree() = default;
RlodTree::RlodTree(RlodTree&&) noexcept = default;
RlodTree& RlodTree::operator=(RlodTree&&) noexcept = default;

void RlodTree::clear()
{
  *this = RlodTree();
}

std::size_t RlodTree::size() const
{
  return arrays_->ids.size();
}

std::size_t RlodTree::nodeCount() const
{
  return arrays_->nodes.size();
}

std::size_t RlodTree::clusterCount() const
{
  return arrays_->clusters.size();
}

Box RlodTree::bounds() const
{
  Box box;
  if (size() > 0)
    box = {origin_ + unit_ * Vec3d(lower_), origin_ + unit_ * Vec3d(upper_)};
  return box;
}

std::size_t RlodTree::bytes() const
{
  return arrays_->nodes.capacity() * sizeof(RlodNode) +
         arrays_->clusters.capacity() * sizeof(TriangleCluster) +
         arrays_->ids.capacity() * sizeof(std::uint32_t);
}

std::uint64_t RlodTree::inputIndex(std::uint64_t slot) const
{
  const TriangleCluster& cluster = arrays_->clusters[slot / trianglesPerCluster];
  return arrays_->ids[cluster.firstId + slot % trianglesPerCluster];
}

std::array<Vec3f, 3> RlodTree::localCorners(std::uint64_t slot) const
{
  const TriangleCluster& cluster = arrays_->clusters[slot / trianglesPerCluster];
  std::array<Vec3f, 3> corners;
  for (int k = 0; k < 3; ++k)
  {
    const unsigned p = cluster.corner(static_cast<int>(slot % trianglesPerCluster), k);
    corners[k] = {cluster.point[0][p], cluster.point[1][p], cluster.point[2][p]};
  }
  return corners;
}

Vec3f RlodTree::normal(std::uint64_t slot) const
{
  const auto [a, b, c] = localCorners(slot);
  return glm::cross(b - a, c - a);
}

void RlodTree::prefetch(std::uint64_t slot) const
{
  const TriangleCluster& cluster = arrays_->clusters[slot / trianglesPerCluster];
  for (std::size_t byte = 0; byte < sizeof(TriangleCluster); byte += 64)
    __builtin_prefetch(reinterpret_cast<const char*>(&cluster) + byte);
}

} // namespace mote
