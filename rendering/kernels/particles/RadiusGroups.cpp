#include "detail/RadiusGroups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace mote
{

void RadiusGroup::add(const RadiusGroup& other)
{
  if (other.count == 0)
    return;
  octave = count == 0 ? other.octave : std::min(octave, other.octave);
  count += other.count;
  centers.add(other.centers);
  largestRadius = std::max(largestRadius, other.largestRadius);
}

double particleGridEdge(const Vec3d& size, double cells, double largestRadius)
{
  std::array<double, 3> extents = {size.x, size.y, size.z};
  std::sort(extents.begin(), extents.end(), std::greater<>());
  double edge = 0.0;
  for (int dims = 3; dims >= 1; --dims)
  {
    double measure = 1.0;
    for (int k = 0; k < dims; ++k)
      measure *= extents[k] > 0.0 ? std::pow(extents[k] / cells, 1.0 / dims) : 0.0;
    // measure = (product / cells^dims)^(1/dims), formed so that no product over- or underflows.
    edge = measure * std::pow(cells, (dims - 1.0) / dims);
    if (edge > 0.0 && extents[dims - 1] >= edge)
      break;
  }
  // Where all centres coincide any size will do.
  return std::max({edge, extents[0] * std::ldexp(1.0, -20), largestRadius * 1e-3});
}

namespace
{

/// Work of a bundle's path through a grid over the group, in nanoseconds or so: slices, rows of
/// cells and particles that it has to look at. The weights are the measured shares of the
/// traversal, rounded; the joints hardly depend on them.
double traversalCost(const RadiusGroup& group, double cellsPerParticle, double footprint)
{
  constexpr double slice = 10.0, row = 4.0, particle = 2.0;
  const Vec3d size = group.centers.size();
  const auto n = static_cast<double>(group.count);
  const double edge = particleGridEdge(size, cellsPerParticle * n, group.largestRadius);
  double cells = 1.0, slices = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double along = 1.0 + size[k] / edge;
    cells *= along;
    slices = std::max(slices, along);
  }
  const double across = 1.0 + (footprint + 2.0 * group.largestRadius) / edge;
  return slices * (slice + across * row + across * across * (n / cells) * particle);
}

} // namespace

std::vector<RadiusGroup> mergedGroups(
  const std::vector<RadiusGroup>& groups, double cellsPerParticle)
{
  RadiusGroup all;
  for (const RadiusGroup& group : groups)
    all.add(group);
  // A bundle is about as wide as two mean spacings: that is how its side is chosen.
  const double footprint = 2.0 * particleGridEdge(all.centers.size(), double(all.count), 0.0);

  // least[k]: cost of the first k groups; cut[k]: where the last of their joints begins.
  const std::size_t n = groups.size();
  std::vector<double> least(n + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> cut(n + 1, 0);
  least[0] = 0.0;
  for (std::size_t last = 1; last <= n; ++last)
  {
    RadiusGroup joined;
    for (std::size_t first = last; first-- > 0;)
    {
      joined.add(groups[first]);
      const double cost = least[first] + traversalCost(joined, cellsPerParticle, footprint);
      if (cost < least[last])
      {
        least[last] = cost;
        cut[last] = first;
      }
    }
  }
  std::vector<RadiusGroup> merged;
  for (std::size_t last = n; last > 0; last = cut[last])
  {
    RadiusGroup joined;
    for (std::size_t k = cut[last]; k < last; ++k)
      joined.add(groups[k]);
    merged.push_back(joined);
  }
  std::reverse(merged.begin(), merged.end());
  return merged;
}

} // namespace mote
