// The R-LODs of an RlodTree: planes that stand for all triangles below a node's children.
//
// Sums are carried from the clusters up, so this takes time linear in the triangles: every cluster
// is looked at once for its own plane and once for that of the node above it, and every node once
// for the one above.

#include "RlodTree.h"

#include "detail/PatchSums.h"
#include "detail/RlodTreeArrays.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace mote
{

namespace
{

using Range = tbb::blocked_range<std::size_t>;

constexpr int fanout = RlodNode::fanout;

/// All that stands for a patch, and what the patch above needs of it.
struct Patch
{
  PatchSums sums;
  Vec3f normal;
  float offset, deviation;
  double evenness;
  Vec3f middle;          ///< of a sphere about the triangles
  float radius;          ///< of that sphere
  std::uint32_t cluster; ///< that speaks for it
};

/// Rounds a bound up to float, with what rounding has taken on the way.
float above(double v)
{
  return static_cast<float>(v * (1.0 + 0x1p-20) + 0x1p-22);
}

/// Fits a patch's plane to its sums. Points of a strip that is narrower than it is bent are nearest
/// to a plane that stands across the surface: the more its triangles look one way, the more planes
/// count as worse that look another way.
void fitPlane(Patch& patch)
{
  const PatchSums& sums = patch.sums;
  const Vec3d& n = sums.normal;
  const double length = glm::length(n), evenness = sums.weight > 0.0 ? length / sums.weight : 0.0;
  double moments[6];
  std::copy_n(sums.moments, 6, moments);
  if (evenness > 0.0)
  {
    const double size = moments[0] + moments[1] + moments[2];
    const double penalty = 0.1 * size * std::pow(evenness, 4.0),
                 share = penalty / (length * length);
    const double along[6] = {n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z};
    for (int i = 0; i < 6; ++i)
      moments[i] += (i < 3 ? penalty : 0.0) - share * along[i];
  }
  patch.evenness = std::clamp(evenness, 0.25, 1.0);
  patch.normal = Vec3f(leastAxis(moments, n));
  patch.offset = static_cast<float>(glm::dot(Vec3d(patch.normal), patch.sums.middle));
}

/// How far a part's points are from a plane, at most: they lie near the part's own plane and in its
/// sphere, so where the planes are nearly parallel this is nearly exact.
double fromPlane(const Patch& part, const Vec3d& normal, double offset)
{
  const Vec3d own(part.normal), middle(part.middle);
  const double height = glm::dot(normal, middle) - offset;
  const double cosine = glm::dot(normal, own), sine = glm::length(normal - cosine * own);
  // From the middle: along the part's normal within [low, high], across it within the radius.
  const double low = part.offset - glm::dot(own, middle) - part.deviation;
  const double high = low + 2.0 * part.deviation;
  const double bySlab =
    std::max(std::abs(height + cosine * low), std::abs(height + cosine * high)) +
    sine * part.radius;
  return std::min(bySlab, std::abs(height) + part.radius);
}

/// Makes the R-LODs of a tree's nodes, their words still without levels.
class LodMaker
{
public:
  /// Of the nodes and clusters of `tree`, into `planes` and `words`.
  LodMaker(const RlodTreeArrays& tree, RlodPlanes* planes, RlodWords* words)
    : tree_(tree)
    , nodes_(tree.nodes.data())
    , clusters_(tree.clusters.data())
    , planes_(planes)
    , words_(words)
    , patches_(tree.nodes.size())
    , errors_(tree.nodes.size())
  {
  }

  /// Makes those of all children of a node, and what the node above needs. Child nodes come first.
  void make(std::size_t index)
  {
    const RlodNode& node = nodes_[index];
    planes_[index] = {};
    words_[index] = {};
    errors_[index] = {};
    const auto count = static_cast<int>(node.children), clusters = static_cast<int>(node.clusters);
    PatchSums sums[fanout];
    sumClusters(clusters_ + node.firstCluster, clusters, sums);
    for (int k = 0; k < count; ++k)
    {
      if (k < clusters)
        keep(patchOf(node, k, sums[k]), index, k);
      else
      {
        const Patch& patch = patches_[node.nodeOf(static_cast<unsigned>(k))];
        sums[k] = patch.sums;
        keep(patch, index, k);
      }
    }
    Patch& whole = patches_[index];
    whole.sums = PatchSums::joined(sums, count);
    const auto distance = [&](const PatchSums& s)
    { return glm::length(s.middle - whole.sums.middle); };
    const auto* nearest = std::min_element(sums, sums + count,
      [&](const PatchSums& a, const PatchSums& b) { return distance(a) < distance(b); });
    whole.cluster = words_[index].word[nearest - sums];
    measure(node, whole);
  }

  /// Gives the words levels, once all planes are made.
  ErrorLevels finish()
  {
    float least = std::numeric_limits<float>::infinity(), most = 0.0f;
    for (std::size_t index = 0; index < errors_.size(); ++index)
    {
      const float* errors = errors_[index].data();
      const auto [low, high] = std::minmax_element(errors, errors + nodes_[index].children);
      least = std::min(least, *low);
      most = std::max(most, *high);
    }
    const ErrorLevels levels(least, most);
    tbb::parallel_for(Range(0, errors_.size(), 1 << 12),
      [&](const Range& range)
      {
        for (std::size_t index = range.begin(); index != range.end(); ++index)
          for (std::uint32_t k = 0; k < nodes_[index].children; ++k)
            words_[index].word[k] |= levels.levelOf(errors_[index][k]) << RlodWords::indexBits;
      });
    return levels;
  }

private:
  /// A patch of one cluster.
  Patch patchOf(const RlodNode& node, int child, const PatchSums& sums) const
  {
    Patch patch;
    patch.sums = sums;
    patch.cluster = node.firstCluster + static_cast<std::uint32_t>(child);
    fitPlane(patch);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int ends = node.low(axis)[child] + node.high(axis)[child];
      patch.middle[axis] = node.origin[axis] + 0.5f * static_cast<float>(ends) * node.scale[axis];
    }
    const PatchExtent extent = extentOfClusters(
      clusters_ + patch.cluster, 1, &patch.normal.x, patch.offset, &patch.middle.x);
    patch.deviation = extent.fromPlane;
    patch.radius = extent.fromMiddle;
    return patch;
  }

  /// Fits a node's plane, and finds how far its points are from it.
  void measure(const RlodNode& node, Patch& patch) const
  {
    fitPlane(patch);
    const Vec3d scale(node.scale[0], node.scale[1], node.scale[2]);
    const Vec3d middle = Vec3d(node.origin[0], node.origin[1], node.origin[2]) + 127.5 * scale;
    patch.middle = Vec3f(middle);
    const PatchExtent extent = extentOfClusters(clusters_ + node.firstCluster,
      static_cast<int>(node.clusters), &patch.normal.x, patch.offset, &patch.middle.x);
    double deviation = extent.fromPlane, radius = extent.fromMiddle;
    for (std::uint32_t k = node.clusters; k < node.children; ++k)
    {
      const Patch& part = patches_[node.nodeOf(k)];
      deviation = std::max(deviation, fromPlane(part, Vec3d(patch.normal), patch.offset));
      const double away = glm::length(Vec3d(part.middle) - Vec3d(patch.middle));
      radius = std::max(radius, away + part.radius);
    }
    patch.deviation = above(deviation);
    patch.radius = above(std::min(radius, 127.5 * glm::length(scale)));
  }

  void keep(const Patch& patch, std::size_t index, int child)
  {
    RlodPlanes& planes = planes_[index];
    const auto length = static_cast<float>(patch.evenness);
    for (int axis = 0; axis < 3; ++axis)
      planes.normal[axis][child] = patch.normal[axis] * length;
    planes.offset[child] = patch.offset * length;
    planes.deviation[child] = above(double(patch.deviation) * length);
    const TriangleCluster& speaker = clusters_[patch.cluster];
    planes.triangle[child] =
      static_cast<std::uint32_t>(tree_.idOf(speaker.firstId + speaker.count / 2U));
    words_[index].word[child] = patch.cluster;
    errors_[index][static_cast<std::size_t>(child)] = above(double(patch.radius) + patch.deviation);
  }

  const RlodTreeArrays& tree_;
  const RlodNode* nodes_;
  const TriangleCluster* clusters_;
  RlodPlanes* planes_;
  RlodWords* words_;
  std::vector<Patch> patches_;                    ///< of nodes
  std::vector<std::array<float, fanout>> errors_; ///< radii of the R-LODs of nodes' children
};

} // namespace

namespace
{

/// From 1 where all triangles look away from the middle of all to -1 where they look towards it,
/// and near 0 where neither: of planes of clusters, in proportion to the squares of their error
/// radii.
double outwardness(const RlodTreeArrays& a)
{
  double sum = 0.0, most = 0.0;
  for (std::size_t k = 0; k < a.nodes.size(); ++k)
  {
    const RlodNode& node = a.nodes[k];
    for (unsigned child = 0; child < node.clusters; ++child)
    {
      Vec3d normal, middle;
      for (int axis = 0; axis < 3; ++axis)
      {
        normal[axis] = a.planes[k].normal[axis][child];
        const double steps = 0.5 * (double(node.low(axis)[child]) + double(node.high(axis)[child]));
        middle[axis] = double(node.origin[axis]) + double(node.scale[axis]) * steps;
      }
      const double radius = a.levels.radius(a.words[k].level(child));
      sum += radius * radius * glm::dot(normal, middle);
      most += radius * radius * glm::length(normal) * glm::length(middle);
    }
  }
  return most > 0.0 ? sum / most : 0.0;
}

/// Which side of a plane near an outline is seen can only be told where planes look outwards: in
/// meshes whose triangles look inwards all are turned.
void turnOutwards(RlodTreeArrays& a)
{
  constexpr double clearly = -0.1;
  if (outwardness(a) > clearly)
    return;
  RlodPlanes* planes = a.planes.own();
  for (std::size_t k = 0; k < a.nodes.size(); ++k)
    for (int child = 0; child < RlodNode::fanout; ++child)
    {
      for (auto& normal : planes[k].normal)
        normal[child] = -normal[child];
      planes[k].offset[child] = -planes[k].offset[child];
    }
}

} // namespace

void RlodTree::makeLods()
{
  RlodTreeArrays& a = *arrays_;
  a.planes.resize(a.nodes.size());
  a.words.resize(a.nodes.size());
  if (a.nodes.empty())
    return;
  LodMaker maker(a, a.planes.own(), a.words.own());
  // Nodes of clusters alone, nearly all, depend on no other node.
  const auto isBottom = [&](std::size_t k) { return a.nodes[k].clusters == a.nodes[k].children; };
  tbb::parallel_for(Range(0, a.nodes.size(), 1 << 7),
    [&](const Range& range)
    {
      for (std::size_t k = range.begin(); k != range.end(); ++k)
        if (isBottom(k))
          maker.make(k);
    });
  // Children come after their parents.
  for (std::size_t k = a.nodes.size(); k-- > 0;)
    if (!isBottom(k))
      maker.make(k);
  a.levels = maker.finish();
  turnOutwards(a);
}

void RlodTree::dropLods()
{
  arrays_->planes = {};
  arrays_->words = {};
}

bool RlodTree::hasLods() const
{
  return !arrays_->words.empty();
}

RlodTree::Lod RlodTree::lod(std::uint64_t slot) const
{
  const std::uint64_t index = (slot & ~lodBit) / trianglesPerCluster;
  const auto child = static_cast<unsigned>(slot % trianglesPerCluster);
  const RlodPlanes& planes = arrays_->planes[index];
  const Vec3f normal = this->normal(slot);
  const float evenness = glm::length(normal), perHeight = 1.0f / evenness;
  return {normal * perHeight, evenness, planes.offset[child] * perHeight,
    planes.deviation[child] * perHeight,
    arrays_->levels.radius(arrays_->words[index].level(child))};
}

std::vector<std::uint64_t> RlodTree::lodSlots() const
{
  std::vector<std::uint64_t> slots;
  for (std::size_t index = 0; index < arrays_->words.size(); ++index)
    for (unsigned k = 0; k < arrays_->nodes[index].children; ++k)
      slots.push_back(lodSlot(index, k));
  return slots;
}

std::vector<std::uint64_t> RlodTree::slotsBelow(std::uint64_t slot) const
{
  if (!isLod(slot))
    return {slot};
  std::vector<std::uint64_t> slots, waiting = {slot};
  while (!waiting.empty())
  {
    const std::uint64_t next = waiting.back();
    waiting.pop_back();
    const RlodNode& node = arrays_->nodes[(next & ~lodBit) / trianglesPerCluster];
    const auto child = static_cast<unsigned>(next % trianglesPerCluster);
    if (child < node.clusters)
    {
      const std::uint64_t cluster = node.firstCluster + child;
      for (unsigned k = 0; k < arrays_->clusters[cluster].count; ++k)
        slots.push_back(cluster * trianglesPerCluster + k);
      continue;
    }
    const std::uint32_t below = node.nodeOf(child);
    for (unsigned k = 0; k < arrays_->nodes[below].children; ++k)
      waiting.push_back(lodSlot(below, k));
  }
  return slots;
}

} // namespace mote
