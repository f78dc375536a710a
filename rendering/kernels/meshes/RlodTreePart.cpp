// Trees of some of a tree's triangles.

#include "RlodTree.h"

#include "detail/RlodTreeArrays.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <glm/common.hpp>

#include <cstring>

namespace mote
{

namespace
{

/// What there is to see of a cluster or a node.
enum class Seen : std::uint8_t
{
  None,
  Some,
  All
};

/// What there is to see of many clusters.
struct SeenSum
{
  std::size_t triangles = 0;
  Vec3f lower{2.0f}, upper{-2.0f};

  void add(const TriangleCluster& cluster, int triangle)
  {
    ++triangles;
    for (int which = 0; which < 3; ++which)
    {
      const unsigned p = cluster.corner(triangle, which);
      const Vec3f at(cluster.point[0][p], cluster.point[1][p], cluster.point[2][p]);
      lower = glm::min(lower, at);
      upper = glm::max(upper, at);
    }
  }
  void add(const SeenSum& other)
  {
    triangles += other.triangles;
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
};

/// Triangles with all corners at one point are met by no ray.
void hideTriangle(TriangleCluster& cluster, int triangle)
{
  cluster.corners01[triangle] = 0;
  std::uint8_t& third = cluster.corner2[triangle % 8];
  third = static_cast<std::uint8_t>(third & (triangle < 8 ? 0xf0 : 0x0f));
}

/// Gives a cluster the corners that it has in the whole tree, but for hidden triangles.
Seen chooseIn(const TriangleCluster& whole, const RlodTreeArrays& arrays,
  const RlodTree::TriangleChoice& isVisible, TriangleCluster& part, SeenSum& sum)
{
  std::memcpy(part.corners01, whole.corners01, sizeof whole.corners01);
  std::memcpy(part.corner2, whole.corner2, sizeof whole.corner2);
  int seen = 0;
  for (int t = 0; t < int(whole.count); ++t)
  {
    if (isVisible(arrays.idOf(std::uint64_t{whole.firstId} + static_cast<unsigned>(t))))
    {
      ++seen;
      sum.add(whole, t);
    }
    else
      hideTriangle(part, t);
  }
  return seen == 0 ? Seen::None : seen < int(whole.count) ? Seen::Some : Seen::All;
}

/// Gives a node boxes of those children alone in which there is something to see, and tells which
/// children have all their triangles.
Seen chooseIn(const RlodNode& whole, const std::vector<Seen>& clusters,
  const std::vector<Seen>& nodes, RlodNode& part, std::uint16_t& complete)
{
  part = whole;
  complete = 0;
  bool any = false;
  for (unsigned k = 0; k < whole.children; ++k)
  {
    const Seen seen =
      k < whole.clusters ? clusters[whole.firstCluster + k] : nodes[whole.nodeOf(k)];
    if (seen == Seen::All)
      complete = static_cast<std::uint16_t>(complete | 1U << k);
    any = any || seen != Seen::None;
    for (int axis = 0; seen == Seen::None && axis < 3; ++axis)
    {
      part.low(axis)[k] = 255;
      part.high(axis)[k] = 0;
    }
  }
  const bool all = complete == (1U << whole.children) - 1U;
  return all ? Seen::All : any ? Seen::Some : Seen::None;
}

} // namespace

std::shared_ptr<RlodTree> RlodTree::partOf(std::shared_ptr<const RlodTree> whole,
  const TriangleChoice& isVisible, std::shared_ptr<RlodTree> last)
{
  const RlodTreeArrays& from = *whole->arrays_;
  const bool isOfSame = last && last.use_count() == 1 && last->whole_ == whole;
  auto part = isOfSame ? std::move(last) : std::make_shared<RlodTree>();
  RlodTreeArrays& to = *part->arrays_;
  to.nodes.resize(from.nodes.size());
  to.clusters.resize(from.clusters.size());
  to.complete.resize(from.nodes.size());
  TriangleCluster* const clusters = to.clusters.own();
  std::vector<Seen> ofClusters(from.clusters.size()), ofNodes(from.nodes.size());
  using Range = tbb::blocked_range<std::size_t>;
  const SeenSum sum = tbb::parallel_reduce(
    Range(0, from.clusters.size(), 1024), SeenSum(),
    [&](const Range& range, SeenSum found)
    {
      for (std::size_t c = range.begin(); c != range.end(); ++c)
      {
        if (!isOfSame) // else all but the corners is there
          clusters[c] = from.clusters[c];
        ofClusters[c] = chooseIn(from.clusters[c], from, isVisible, clusters[c], found);
      }
      return found;
    },
    [](SeenSum a, const SeenSum& b)
    {
      a.add(b);
      return a;
    });
  for (std::size_t n = from.nodes.size(); n-- > 0;) // children come after their parents
    ofNodes[n] =
      chooseIn(from.nodes[n], ofClusters, ofNodes, to.nodes.own()[n], to.complete.own()[n]);

  to.ids.view(from.ids.data(), from.ids.size(), whole);
  to.triangles = from.triangles;
  to.hidden = from.triangles - sum.triangles;
  part->origin_ = whole->origin_;
  part->unit_ = whole->unit_;
  part->lower_ = sum.lower;
  part->upper_ = sum.upper;
  part->depth_ = whole->depth_;
  part->cost_ = whole->cost_;
  part->sparesMemory_ = whole->sparesMemory_;
  part->whole_ = std::move(whole);
  part->takeLodsOfWhole();
  return part;
}

void RlodTree::takeLodsOfWhole()
{
  const RlodTreeArrays& from = *whole_->arrays_;
  arrays_->planes.view(from.planes.data(), from.planes.size(), whole_);
  arrays_->words.view(from.words.data(), from.words.size(), whole_);
  arrays_->levels = from.levels;
  arrays_->means = from.means;
}

} // namespace mote
