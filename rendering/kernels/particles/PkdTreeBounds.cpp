// Bounds of what lies below the nodes of a PkdTree.

#include "PkdTree.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

PkdTree::Bounds::Bounds()
{
  lower.fill(std::numeric_limits<double>::infinity());
  upper.fill(-std::numeric_limits<double>::infinity());
}

void PkdTree::Bounds::add(const Bounds& b)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    lower[k] = std::min(lower[k], b.lower[k]);
    upper[k] = std::max(upper[k], b.upper[k]);
  }
}

std::size_t PkdTree::planLevels(std::size_t count, std::vector<Level>& levels)
{
  if (count > mostParticles)
    throw Error("A P-k-d tree holds at most 2^36 particles.");
  levels.clear();
  count = (count + bucketSize - 1) / bucketSize;
  std::size_t nodes = 0;
  do
  {
    count = (count + fanout - 1) / fanout;
    levels.push_back({0, count});
    nodes += count;
  } while (count > 1);
  std::size_t first = 0;
  for (std::size_t k = levels.size(); k-- > 0; first += levels[k].count)
    levels[k].first = first;
  return nodes;
}

double PkdTree::roundingMargin() const
{
  const Vec3d size = statistics_.bounds.size();
  return 2e-7 * std::max({size.x, size.y, size.z}) / unit_;
}

void PkdTree::setBounds(Node& node, const Bounds& all, const std::array<Bounds, fanout>& children,
  double marginOfSet, double step)
{
  node.unused = {};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double largest = std::max(std::abs(all.lower[k]), std::abs(all.upper[k]));
    const double margin = marginOfSet + 1e-6 * (all.upper[k] - all.lower[k]);
    const double lower = all.lower[k] - margin - 1e-7 * largest;
    node.lower[k] = static_cast<float>(step > 0.0 ? std::floor(lower / step) * step : lower);
    const double extent = std::max(all.upper[k] + margin - node.lower[k], 508.0 * step);
    const int exponent =
      std::clamp(static_cast<int>(std::ceil(std::log2(extent / 254.0))), -120, 120);
    node.exponent[k] = static_cast<std::uint8_t>(exponent + 127);
    const double perSize = std::ldexp(1.0, -exponent);
    for (std::size_t c = 0; c < fanout; ++c)
    {
      const Bounds& child = children[c];
      const bool empty = !(child.lower[k] <= child.upper[k]);
      const double low = std::floor((child.lower[k] - margin - node.lower[k]) * perSize);
      const double high = std::ceil((child.upper[k] + margin - node.lower[k]) * perSize);
      node.low[k][c] = empty ? 255 : static_cast<std::uint8_t>(std::clamp(low, 0.0, 255.0));
      node.high[k][c] = empty ? 0 : static_cast<std::uint8_t>(std::clamp(high, 0.0, 255.0));
    }
  }
}

PkdTree::Bounds PkdTree::boundNodes(
  const std::vector<Level>& levels, Node* nodes, std::vector<Bounds> below, double marginOfSet)
{
  for (std::size_t k = 1; k < levels.size(); ++k)
  {
    std::vector<Bounds> own(levels[k].count);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, own.size(), 64),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
        {
          std::array<Bounds, fanout> children;
          const std::size_t first = i * fanout;
          const std::size_t last = std::min<std::size_t>(below.size(), first + fanout);
          std::copy(below.begin() + static_cast<std::ptrdiff_t>(first),
            below.begin() + static_cast<std::ptrdiff_t>(last), children.begin());
          for (const Bounds& child : children)
            own[i].add(child);
          Node& node = nodes[levels[k].first + i];
          node.corner = {};
          setBounds(node, own[i], children, marginOfSet);
        }
      });
    below = std::move(own);
  }
  return below.front();
}

} // namespace mote
