// Treelets of a PkdTree whose particles are all the same sphere, of which rays need but one.

#include "PkdTree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <map>

namespace mote
{

bool PkdTree::isOneSphere(std::size_t treelet) const
{
  const std::size_t first = treelet * treeletSize, last = std::min(count_, first + treeletSize);
  const Vec3d middle = center(first);
  const double r = radius(first);
  if (!(middle == middle && r == r)) // a file may hold anything
    return false;
  for (std::size_t slot = first + 1; slot < last; ++slot)
    if (center(slot) != middle || radius(slot) != r)
      return false;
  return true;
}

/// Looks for treelets of one sphere, by the nodes above treelets: one whose bounds there are those
/// of its neighbour may be one. Particles at one place lie next to one another in the order of the
/// tree, but for those at the ends of their group. Reads hardly more than those nodes.
void PkdTree::findRepeats()
{
  repeats_.clear();
  if (levels_.size() > 1)
  {
    const std::size_t treelets = levels_[0].count;
    RawVector<std::uint8_t> found(treelets);
    std::fill(found.begin(), found.end(), std::uint8_t{0});
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, levels_[1].count, 256),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
        {
          const Node& node = nodes_[levels_[1].first + i];
          const auto areAlike = [&](std::size_t a, std::size_t b)
          {
            for (std::size_t k = 0; k < 3; ++k)
              if (node.low[k][a] != node.low[k][b] || node.high[k][a] != node.high[k][b])
                return false;
            return true;
          };
          const std::size_t first = i * fanout;
          const std::size_t children = std::min<std::size_t>(fanout, treelets - first);
          for (std::size_t c = 0; c < children; ++c)
            if ((c > 0 && areAlike(c, c - 1)) || (c + 1 < children && areAlike(c, c + 1)))
              found[first + c] = isOneSphere(first + c);
        }
      });
    groupRepeats(found);
  }
  findShown();
}

/// Puts treelets of the same sphere into a group, where it is large.
void PkdTree::groupRepeats(const RawVector<std::uint8_t>& isOne)
{
  std::map<std::array<double, 4>, std::vector<SlotRun>> runs;
  for (std::size_t treelet = 0; treelet < isOne.size(); ++treelet)
    if (isOne[treelet] != 0)
    {
      const std::size_t first = treelet * treeletSize;
      const Vec3d middle = center(first);
      runs[{middle.x, middle.y, middle.z, radius(first)}].push_back(
        {first, std::min(count_, first + treeletSize)});
    }
  for (const auto& [sphere, group] : runs)
    if (group.size() * treeletSize >= RepeatedSpheres::smallest)
    {
      repeats_.addGroup();
      for (const SlotRun& run : group)
        repeats_.addRun(run.first, run.last);
    }
}

} // namespace mote
