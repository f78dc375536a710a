// Which particles lie near a point, and which are shown, of every structure.

#include "NearParticle.h"
#include "PkdPaperTree.h"
#include "detail/CoherentGridView.h"
#include "detail/PkdTreeView.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Calls visit(first, last) for the slots of the rows of cells whose particles may come closer to
/// `point`, in unit() from origin(), than `distance`.
template <typename Visit>
void forRowsNear(
  const CoherentGridView::Layer& layer, const Vec3d& point, double distance, const Visit& visit)
{
  const double reach = distance + double(layer.reach);
  Vec3i first, last;
  for (int k = 0; k < 3; ++k)
  {
    const double from = (point[k] - reach - double(layer.lower[k])) / double(layer.cellSize);
    const double to = (point[k] + reach - double(layer.lower[k])) / double(layer.cellSize);
    if (!(to >= 0.0 && from < layer.resolution[k]))
      return;
    first[k] = static_cast<int>(std::max(from, 0.0));
    last[k] = static_cast<int>(std::min(to, layer.resolution[k] - 1.0));
  }
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
    {
      const std::size_t row = static_cast<std::size_t>(z) * layer.resolution.y + y;
      const std::uint32_t* start =
        layer.cellStart + row * (static_cast<std::size_t>(layer.resolution.x) + 1);
      visit(layer.rowStart[row] + start[first.x], layer.rowStart[row] + start[last.x + 1]);
    }
}

} // namespace

bool CoherentGrid::isShown(std::size_t slot) const
{
  return CoherentGridView(*this, true).isShown(slot);
}

void CoherentGrid::findNear(
  const Vec3d& point, double distance, std::vector<NearParticle>& found) const
{
  if (count_ == 0)
    return;
  const CoherentGridView view(*this);
  const Vec3d at = (point - origin_) / unit_;
  const double most = distance / unit_;
  for (int k = 0; k < view.layers(); ++k)
    forRowsNear(view.layer(k), at, most,
      [&](std::uint64_t first, std::uint64_t last)
      {
        const auto look = [&](std::uint64_t slot)
        {
          const Record& p = records_[slot];
          if (NearParticle::isNear({p.x, p.y, p.z}, p.r, at, most) &&
              (!view.selects || view.isShown(slot)))
            found.push_back({center(slot), radius(slot), slot});
        };
        if (view.skips)
          view.forShown(first, last, look);
        else
          for (std::uint64_t slot = first; slot < last; ++slot)
            look(slot);
      });
}

bool PkdTree::isShown(std::size_t slot) const
{
  return shown_.empty() || (shown_[slot / bucketSize] >> (slot % bucketSize) & 1) != 0;
}

void PkdTree::findNear(const Vec3d& point, double distance, std::vector<NearParticle>& found) const
{
  if (count_ == 0)
    return;
  const PkdTreeView view(*this);
  const Vec3d at = (point - origin_) / unit_;
  const double most = distance / unit_;
  const auto visitBucket = [&](std::size_t bucket)
  {
    for (unsigned bits = view.shownIn(bucket); bits != 0; bits &= bits - 1)
    {
      const std::uint64_t slot =
        view.slotOf(bucket * bucketSize + static_cast<unsigned>(__builtin_ctz(bits)));
      const Vec3d middle = center(slot);
      const double r = radius(slot);
      if (NearParticle::isNear(middle, r, point, distance))
        found.push_back({middle, r, slot});
    }
  };
  const auto visitNode = [&](const auto& self, int level, std::size_t index) -> void
  {
    const Node& node = view.node(level, index);
    for (unsigned bits = view.shownOf(node); bits != 0; bits &= bits - 1)
    {
      const auto child = static_cast<std::size_t>(__builtin_ctz(bits));
      if (node.low[0][child] > node.high[0][child])
        continue;
      double square = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double lower = node.lower[axis], step = stepOf(node, axis);
        const double p = at[static_cast<int>(axis)];
        const double off = std::max({lower + step * node.low[axis][child] - p,
          p - (lower + step * node.high[axis][child]), 0.0});
        square += off * off;
      }
      if (square > most * most)
        continue;
      if (level == 0)
        visitBucket(index * fanout + child);
      else
        self(self, level - 1, index * fanout + child);
    }
  };
  visitNode(visitNode, view.top, 0);
}

void PkdPaperTree::findNear(
  const Vec3d& point, double distance, std::vector<NearParticle>& found) const
{
  if (count_ == 0)
    return;
  const Vec3d at = (point - origin_) / unit_;
  const auto visit = [&](const auto& self, std::size_t node, float largest) -> void
  {
    if (node >= count_)
      return;
    if (node < subtreeRadius_.size())
      largest = subtreeRadius_[node];
    const Vec3d middle = center(node);
    const double r = radius(node);
    if (isShown(node) && NearParticle::isNear(middle, r, point, distance))
      found.push_back({middle, r, node});
    if (2 * node + 1 >= count_)
      return;
    const int k = axis(node);
    const double plane = number(node, static_cast<std::size_t>(k));
    const double most = distance / unit_ + double(largest);
    if (at[k] - most <= plane)
      self(self, 2 * node + 1, largest);
    if (at[k] + most >= plane)
      self(self, 2 * node + 2, largest);
  };
  visit(visit, 0, subtreeRadius_[0]);
}

} // namespace mote
