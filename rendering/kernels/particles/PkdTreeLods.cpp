// Levels of detail of a PkdTree, made once for every SIMD instruction set.

#include "PkdTree.h"

#include "../core/ScratchSpace.h"
#include "detail/PkdTreeMeans.h"
#include "detail/PkdTreeView.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/PkdTreeLods.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/PkdTreeLodFill-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

void fillTreeLods(
  const PkdTreeView& view, int level, std::size_t first, std::size_t last, PkdTreeView::Lods* lods)
{
  for (std::size_t i = first; i < last; ++i)
    LodFill(view, level, i, lods).run();
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <cmath>
#include <limits>

namespace mote
{

HWY_EXPORT(fillTreeLods);

void PkdTree::makeLods(const std::shared_ptr<ScratchSpace>& space)
{
  if (hasLods() || count_ == 0)
    return;
  const PkdTreeView all(*this, true);
  StoredArray<Lods> made;
  made.resize(nodes_.size(), space ? space->allocate(nodes_.size() * sizeof(Lods)) : nullptr);
  for (std::size_t k = 0; k < levels_.size(); ++k)
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, levels_[k].count, 64),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        HWY_DYNAMIC_DISPATCH(fillTreeLods)
        (all, static_cast<int>(k), range.begin(), range.end(), made.own());
      });
  lods_ = std::move(made);
  if (!shown_.empty() && !sparse_)
    findNodesWhole();
}

void PkdTree::dropLods()
{
  lods_ = {};
  RawVector<Bits>().swap(nodeWhole_);
}

PkdTree::Lod PkdTree::lod(std::uint64_t slot) const
{
  const std::uint64_t place = lodPlace(slot);
  const std::size_t child = place % fanout;
  const Node& node = nodes_[place / fanout];
  const Lods& lods = lods_[place / fanout];
  Lod lod;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double step = 0.5 * unit_ * double(stepOf(node, k));
    const int axis = static_cast<int>(k);
    lod.center[axis] = origin_[axis] + unit_ * double(node.lower[k]) +
                       step * (node.low[k][child] + node.high[k][child]);
    lod.half[axis] = step * (node.high[k][child] - node.low[k][child]);
    lod.coverage[axis] = -std::expm1(-double(Lods::thicknessOf(lods.thickness[k][child])));
  }
  lod.error = lods.error[child] == noLod ? std::numeric_limits<double>::infinity()
                                         : unit_ * double(lodStep(node)) * lods.error[child];
  return lod;
}

std::vector<std::uint64_t> PkdTree::lodSlots() const
{
  std::vector<std::uint64_t> slots;
  for (std::size_t node = 0; node < lods_.size(); ++node)
    for (std::size_t child = 0; child < fanout; ++child)
      if (lods_[node].error[child] != noLod)
        slots.push_back(lodBit | (node * fanout + child));
  return slots;
}

SlotRun PkdTree::slotsBelow(std::uint64_t lodSlot) const
{
  const std::uint64_t place = lodPlace(lodSlot);
  std::size_t level = 0; // nodes of the lower levels come later
  while (place / fanout < levels_[level].first)
    ++level;
  const std::size_t each = std::size_t{bucketSize} << (4 * level);
  const std::size_t child = (place / fanout - levels_[level].first) * fanout + place % fanout;
  return {std::min(count_, child * each), std::min(count_, (child + 1) * each)};
}

std::vector<float> PkdTree::lodMeans(int components, const ParticleValues& valuesOf) const
{
  const auto each = static_cast<std::size_t>(components);
  std::vector<float> means(nodes_.size() * fanout * each, std::numeric_limits<float>::quiet_NaN());
  PkdTreeMeans made(*this, components, means.data(), each, 1);
  made.add(0, buckets(),
    [&](std::size_t bucket)
    {
      WeightedSum sum;
      std::array<double, mostMeans> values{};
      for (std::size_t slot = bucket * bucketSize;
           slot < std::min(count_, (bucket + 1) * bucketSize); ++slot)
      {
        valuesOf(inputIndex(slot), values.data());
        sum.add(values.data(), std::pow(double(storedRadius(slot)), 2), components);
      }
      return sum;
    });
  made.finish();
  return means;
}

PkdTreeMeans::PkdTreeMeans(
  const PkdTree& tree, int numbers, float* means, std::size_t perPlace, std::size_t perNumber)
  : tree_(tree)
  , numbers_(numbers)
  , means_(means)
  , perPlace_(perPlace)
  , perNumber_(perNumber)
  , sums_(tree.levels_.empty() ? 0 : tree.levels_.front().count)
{
}

void PkdTreeMeans::put(std::size_t level, std::size_t child, const WeightedSum& sum)
{
  const std::size_t place = tree_.levels_[level].first * PkdTree::fanout + child;
  for (int c = 0; c < numbers_; ++c)
    means_[place * perPlace_ + static_cast<std::size_t>(c) * perNumber_] = sum.mean(c);
}

void PkdTreeMeans::finish()
{
  std::vector<WeightedSum> above;
  for (std::size_t level = 1; level < tree_.levels_.size(); ++level, sums_.swap(above))
  {
    above.assign(tree_.levels_[level].count, {});
    for (std::size_t child = 0; child < sums_.size(); ++child)
    {
      this->put(level, child, sums_[child]);
      above[child / PkdTree::fanout].add(sums_[child]);
    }
  }
}

} // namespace mote

#endif
