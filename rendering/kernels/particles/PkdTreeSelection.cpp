// Which particles of a PkdTree are shown: a bit for each, made when visibility or ranges change,
// and one for each child of each node, or a tree of those that are shown.

#include "PkdTree.h"

#include "detail/ParticleAttributes.h"
#include "detail/StoredRanges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace mote
{

namespace
{

constexpr std::size_t bucketsATask = 1024;

/// Gives the memory back.
template <typename Vector>
void release(Vector& vector)
{
  Vector().swap(vector);
}

} // namespace

void PkdTree::setVisibility(const std::function<bool(std::size_t)>& shown)
{
  keepVisibility(shown, count_, visible_);
  findShown();
}

void PkdTree::setAttributes(const std::vector<ParticleAttribute>& attributes)
{
  checkAttributes(attributes, knowsInput());
  keepAttributes(
    attributes, count_, values_, [this](std::size_t slot) { return inputIndex(slot); });
  release(valueBounds_);
  if (!values_.empty())
    findValueBounds();
  findShown();
}

void PkdTree::setRanges(const ParticleRanges& ranges)
{
  keepRanges(ranges);
  findShown();
}

std::size_t PkdTree::shownCount() const
{
  return countBits(shown_, count_);
}

void PkdTree::findShown()
{
  const StoredRanges stored(ranges_, origin_, unit_, !values_.empty());
  nodeShown_.clear();
  nodeWhole_.clear();
  met_.clear();
  sparse_.reset();
  const bool hides = count_ > 0 && (stored.limits > 0 || !visible_.empty());
  if (!hides)
    release(shown_);
  else if (stored.limits == 0)
    shown_ = visible_;
  else
    findInRange(stored);
  leaveOutRepeats();
  if (met().empty())
  {
    release(nodeShown_);
    release(nodeWhole_);
    return;
  }
  makeSparse();
  if (!sparse_)
    findNodesShown();
  if (!sparse_ && hides && hasLods())
    findNodesWhole();
}

/// Fills met_ where there are repeats.
void PkdTree::leaveOutRepeats()
{
  if (repeats_.empty())
    return release(met_);
  if (shown_.empty())
    findBits(count_, met_, [](std::size_t) { return true; });
  else
    met_ = shown_;
  repeats_.leaveFirst(met_, [this](std::size_t slot) { return inputIndex(slot); });
}

/// The bits of a bucket's particles that are there and that visibility leaves.
PkdTree::Bits PkdTree::visibleIn(std::size_t bucket) const
{
  if (!visible_.empty())
    return visible_[bucket];
  const std::size_t count = count_ - bucket * bucketSize;
  return count >= bucketSize ? Bits{0xffff} : static_cast<Bits>((1u << count) - 1);
}

/// Fills bits for the children of all nodes: those of buckets by ofBucket(bucket), and those of
/// nodes by ofNode(bits, children) of the child.
template <typename OfBucket, typename OfNode>
void PkdTree::fillNodeBits(
  RawVector<Bits>& bits, const OfBucket& ofBucket, const OfNode& ofNode) const
{
  bits.resize(nodes_.size());
  for (std::size_t k = 0; k < levels_.size(); ++k)
  {
    const std::size_t count = k == 0 ? buckets() : levels_[k - 1].count;
    const std::size_t below = k == 0 ? 0 : k == 1 ? buckets() : levels_[k - 2].count;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, levels_[k].count, bucketsATask),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
        {
          unsigned found = 0;
          const std::size_t first = fanout * i, last = std::min<std::size_t>(count, first + fanout);
          for (std::size_t child = first; child < last; ++child)
          {
            const bool is = k == 0 ? ofBucket(child)
                                   : ofNode(bits[levels_[k - 1].first + child],
                                       std::min<std::size_t>(fanout, below - fanout * child));
            found |= static_cast<unsigned>(is) << (child - first);
          }
          bits[levels_[k].first + i] = static_cast<Bits>(found);
        }
      });
  }
}

void PkdTree::findNodesShown()
{
  fillNodeBits(
    nodeShown_, [this](std::size_t bucket) { return met()[bucket] != 0; },
    [](Bits bits, std::size_t) { return bits != 0; });
}

void PkdTree::findNodesWhole()
{
  const auto all = [](std::size_t count) { return 0xffffu >> (16 - count); };
  fillNodeBits(
    nodeWhole_,
    [&](std::size_t bucket)
    { return shown_[bucket] == all(std::min<std::size_t>(16, count_ - bucket * bucketSize)); },
    [&](Bits bits, std::size_t children) { return bits == all(children); });
}

} // namespace mote
