#include "RlodTree.h"

#include "detail/RlodTreeArrays.h"

#include <glm/geometric.hpp>

namespace mote
{

RlodTree::RlodTree()
  : arrays_(std::make_unique<RlodTreeArrays>())
{
}

RlodTree::~RlodTree() = default;
RlodTree::RlodTree(RlodTree&&) noexcept = default;
RlodTree& RlodTree::operator=(RlodTree&&) noexcept = default;

void RlodTree::clear()
{
  *this = RlodTree();
}

RlodTree RlodTree::copyWithoutLods() const
{
  RlodTree copy;
  copy.arrays_->nodes = arrays_->nodes;
  copy.arrays_->clusters = arrays_->clusters;
  copy.arrays_->ids = arrays_->ids;
  copy.arrays_->triangles = arrays_->triangles;
  copy.origin_ = origin_;
  copy.unit_ = unit_;
  copy.lower_ = lower_;
  copy.upper_ = upper_;
  copy.depth_ = depth_;
  copy.cost_ = cost_;
  copy.sparesMemory_ = sparesMemory_;
  return copy;
}

std::size_t RlodTree::size() const
{
  return arrays_->triangles - arrays_->hidden;
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
  const RlodTreeArrays& a = *arrays_;
  const std::size_t own = a.nodes.bytes() + a.clusters.bytes() + a.complete.bytes();
  return whole_ ? own : own + a.planes.bytes() + a.words.bytes() + a.ids.bytes();
}

/// The slot of the triangle that speaks for an R-LOD; that of a triangle itself.
std::uint64_t RlodTree::triangleOf(std::uint64_t slot) const
{
  if (!isLod(slot))
    return slot;
  const RlodWords& words = arrays_->words[(slot & ~lodBit) / trianglesPerCluster];
  const std::uint64_t cluster =
    std::min<std::uint64_t>(words.cluster(static_cast<unsigned>(slot % trianglesPerCluster)),
      arrays_->clusters.size() - 1); // whatever a damaged file says
  return cluster * trianglesPerCluster +
         std::min(arrays_->clusters[cluster].count / 2U, TriangleCluster::capacity - 1U);
}

std::uint64_t RlodTree::inputIndex(std::uint64_t slot) const
{
  if (isLod(slot)) // not from the cluster, which nobody else may need
    return arrays_->inRange(
      arrays_->planes[(slot & ~lodBit) / trianglesPerCluster].triangle[slot % trianglesPerCluster]);
  const TriangleCluster& cluster = arrays_->clusters[slot / trianglesPerCluster];
  return arrays_->idOf(cluster.firstId + slot % trianglesPerCluster);
}

std::array<Vec3f, 3> RlodTree::localCorners(std::uint64_t slot) const
{
  slot = triangleOf(slot);
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
  if (isLod(slot))
  {
    const RlodPlanes& planes = arrays_->planes[(slot & ~lodBit) / trianglesPerCluster];
    const auto child = slot % trianglesPerCluster;
    return {planes.normal[0][child], planes.normal[1][child], planes.normal[2][child]};
  }
  const auto [a, b, c] = localCorners(slot);
  return glm::cross(b - a, c - a);
}

namespace
{

/// Whether any of some slots is that of an R-LOD: asked once for all, since asking for each costs
/// as much as the answers.
bool anyLod(const std::uint64_t* slots, int count)
{
  std::uint64_t bits = 0;
  for (int k = 0; k < count; ++k)
    bits |= slots[k];
  return RlodTree::isLod(bits);
}

} // namespace

void RlodTree::normals(const std::uint64_t* slots, int count, float* const normals[3]) const
{
  if (anyLod(slots, count))
  {
    for (int k = 0; k < count; ++k)
    {
      const Vec3f own = normal(slots[k]);
      for (int axis = 0; axis < 3; ++axis)
        normals[axis][k] = own[axis];
    }
    return;
  }
  for (int k = 0; k < count; ++k)
  {
    const TriangleCluster& cluster = arrays_->clusters[slots[k] / trianglesPerCluster];
    const auto triangle = static_cast<int>(slots[k] % trianglesPerCluster);
    const unsigned a = cluster.corner(triangle, 0), b = cluster.corner(triangle, 1),
                   c = cluster.corner(triangle, 2);
    float u[3], v[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const float* points = cluster.point[axis];
      u[axis] = points[b] - points[a];
      v[axis] = points[c] - points[a];
    }
    normals[0][k] = u[1] * v[2] - u[2] * v[1];
    normals[1][k] = u[2] * v[0] - u[0] * v[2];
    normals[2][k] = u[0] * v[1] - u[1] * v[0];
  }
}

void RlodTree::inputIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const
{
  const TriangleCluster* clusters = arrays_->clusters.data();
  const std::uint32_t* ids = arrays_->ids.data();
  if (arrays_->ids.empty() || anyLod(slots, count))
    for (int k = 0; k < count; ++k)
      indices[k] = inputIndex(slots[k]);
  else
    for (int k = 0; k < count; ++k)
      indices[k] =
        ids[clusters[slots[k] / trianglesPerCluster].firstId + slots[k] % trianglesPerCluster];
}

} // namespace mote
