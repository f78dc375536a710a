#pragma once

#include "../PkdTree.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mote
{

/// What the traversal needs of a tree, without the vectors that own it.
struct PkdTreeView
{
  using Node = PkdTree::Node;
  using Row = PkdTree::Row;
  using Lods = PkdTree::Lods;
  static constexpr std::uint8_t noLod = PkdTree::noLod;

  const PkdTree& tree;
  const Node* nodes;
  const PkdTree::Level* levels;
  const Row* rows;
  const std::uint16_t* shown;           ///< null: all are
  const std::uint16_t* nodeShown;       ///< null likewise
  const Lods* lods;                     ///< of each node; null: there are none
  const std::uint16_t* nodeWhole;       ///< null: nothing is hidden
  const std::uint64_t* slots = nullptr; ///< by place in `rows`; null: they are the places
  std::size_t rowsABucket;
  float radius;
  bool ownRadii;
  int placeRows;
  float step; ///< in unit()
  std::size_t lastBucket;
  unsigned lastShown; ///< bits of its particles
  float coarse;
  int top;           ///< level of the root
  Vec3d least, most; ///< bounds of all spheres, in unit() from origin()

  static constexpr bool hasTies = true;

  /// Of what rays may meet, or `whole`, of all.
  explicit PkdTreeView(const PkdTree& t, bool whole = false)
    : tree(t)
    , nodes(t.nodes_.data())
    , levels(t.levels_.data())
    , rows(t.rows_.data())
    , shown(whole || t.met().empty() ? nullptr : t.met().data())
    , nodeShown(whole || t.nodeShown_.empty() ? nullptr : t.nodeShown_.data())
    , lods(t.lods_.empty() ? nullptr : t.lods_.data())
    , nodeWhole(whole || t.nodeWhole_.empty() ? nullptr : t.nodeWhole_.data())
    , rowsABucket(t.rowsABucket_)
    , radius(t.radius_)
    , ownRadii(t.ownRadii_)
    , placeRows(t.placeRows_)
    , step(static_cast<float>(t.step_ / t.unit_))
    , coarse(t.coarse_)
    , top(t.levels() - 1)
  {
    const Box& bounds = t.statistics_.bounds;
    const Vec3d size = bounds.size() / t.unit_;
    const Vec3d margin(1e-6 * std::max({size.x, size.y, size.z}));
    least = (bounds.lower - t.origin_) / t.unit_ - margin;
    most = (bounds.upper - t.origin_) / t.unit_ + margin;
    std::size_t count = t.count_;
    if (t.sparse_ && !whole)
    {
      const PkdTree::Sparse& sparse = *t.sparse_;
      nodes = sparse.nodes.data();
      levels = sparse.levels.data();
      rows = sparse.rows.data();
      shown = nodeShown = nodeWhole = nullptr;
      lods = nullptr;
      placeRows = 3;
      rowsABucket = 6 + ownRadii;
      top = static_cast<int>(sparse.levels.size()) - 1;
      slots = sparse.slots.data();
      count = sparse.count;
    }
    lastBucket = (count - 1) / PkdTree::bucketSize;
    lastShown = 0xffffu >> (PkdTree::bucketSize - 1 - (count - 1) % PkdTree::bucketSize);
  }

  /// The particle's slot in the tree whose place in `rows` is given.
  std::uint64_t slotOf(std::uint64_t place) const
  {
    return slots == nullptr ? place : slots[place];
  }

  /// Rows of the corners that the particles of a bucket count from, or null where the corner of
  /// their treelet in `nodes` is that of all.
  const Row* cornersOf(std::size_t bucket) const
  {
    return slots == nullptr ? nullptr : &rows[(bucket + 1) * rowsABucket - 3];
  }

  /// Of equally near hits that on the particle given first counts.
  bool takesTie(std::uint64_t slot, std::uint64_t before) const
  {
    return tree.inputIndex(slot) < tree.inputIndex(before);
  }

  /// Whether two particles are the same sphere; `b` may be a box that stands for many.
  bool coincide(std::uint64_t a, std::uint64_t b) const
  {
    return !PkdTree::isLod(b) && tree.center(a) == tree.center(b) &&
           tree.radius(a) == tree.radius(b);
  }

  const Node& node(int level, std::size_t i) const { return nodes[levels[level].first + i]; }

  /// The bits of children that hold anything shown.
  unsigned shownOf(const Node& of) const
  {
    return nodeShown == nullptr ? 0xffffu : nodeShown[&of - nodes];
  }
  /// The bits of children below which nothing is hidden.
  unsigned wholeOf(const Node& of) const
  {
    return nodeWhole == nullptr ? 0xffffu : nodeWhole[&of - nodes];
  }
  /// The bits of a bucket's particles that are shown.
  unsigned shownIn(std::size_t bucket) const
  {
    const unsigned some = shown == nullptr ? 0xffffu : shown[bucket];
    return bucket == lastBucket ? some & lastShown : some;
  }
};

/// A bound's step of a node along an axis.
inline float stepOf(const PkdTreeView::Node& node, std::size_t axis)
{
  return std::bit_cast<float>(std::uint32_t{node.exponent[axis]} << 23);
}

/// What errors of a node's levels of detail are counted in.
inline float lodStep(const PkdTreeView::Node& node)
{
  return std::max({stepOf(node, 0), stepOf(node, 1), stepOf(node, 2)});
}

} // namespace mote
