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
  sparse_.reset();
  if (count_ == 0 || (stored.limits == 0 && visible_.empty()))
  {
    release(shown_);
    release(nodeShown_);
    return;
  }
  if (stored.limits == 0)
    shown_ = visible_;
  else
    findInRange(stored);
  makeSparse();
  if (!sparse_)
    findNodesShown();
}

void PkdTree::findNodesShown()
{
  nodeShown_.resize(nodes_.size());
  const Bits* below = shown_.data();
  std::size_t count = shown_.size();
  for (const Level& level : levels_)
  {
    Bits* own = nodeShown_.data() + level.first;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, level.count, bucketsATask),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
        {
          unsigned found = 0;
          const std::size_t first = fanout * i, last = std::min<std::size_t>(count, first + fanout);
          for (std::size_t child = first; child < last; ++child)
            found |= static_cast<unsigned>(below[child] != 0) << (child - first);
          own[i] = static_cast<Bits>(found);
        }
      });
    below = own;
    count = level.count;
  }
}

} // namespace mote
