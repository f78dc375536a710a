// The R-LODs of an RlodPaperTree. Sums are carried from the leaves up.

#include "ClippedTriangle.h"
#include "RlodPaperTree.h"

#include <kernels/core/Error.h>
#include <kernels/meshes/detail/PatchSums.h>

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote::bench
{

namespace
{

constexpr int levelsApart = 3;           ///< of inner nodes that have R-LODs
constexpr int parallelLevels = 8;        ///< from the root
constexpr std::size_t exactPoints = 512; ///< what more points lie about is known of a plane alone

/// A plane that points lie about, and a sphere about them.
struct Slab
{
  Vec3d normal;
  double offset, deviation;
  Vec3d middle;
  double radius;

  /// How far its points are from another plane, at most: what is along its normal, and across.
  double from(const Vec3d& other, double otherOffset) const
  {
    const double height = glm::dot(other, middle) - otherOffset;
    const double cosine = glm::dot(other, normal), sine = glm::length(other - cosine * normal);
    const double low = offset - glm::dot(normal, middle) - deviation, high = low + 2.0 * deviation;
    return std::min(std::abs(height) + radius,
      std::max(std::abs(height + cosine * low), std::abs(height + cosine * high)) + sine * radius);
  }
};

/// What the node above needs of a node: its points are those in `points` and those in `slabs`.
struct Content
{
  PatchSums sums;
  Box box;
  std::uint32_t triangle = RlodPaperPlane::none; ///< one near the middle
  std::vector<Vec3d> points;
  std::vector<Slab> slabs;
};

struct Cell
{
  float low[3], high[3];
};

PatchSums sumsOf(const Vec3d& a, const Vec3d& b, const Vec3d& c)
{
  PatchSums sums;
  sums.normal = glm::cross(b - a, c - a);
  sums.weight = glm::length(sums.normal);
  sums.middle = (a + b + c) / 3.0;
  for (const Vec3d& corner : {a, b, c})
  {
    const Vec3d d = corner - sums.middle;
    const double products[6] = {d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.x * d.z, d.y * d.z};
    for (int i = 0; i < 6; ++i)
      sums.moments[i] += sums.weight / 12.0 * products[i];
  }
  return sums;
}

class LodBuilder
{
public:
  explicit LodBuilder(RlodPaperArrays& arrays, RawVector<std::uint32_t>& planeNodes)
    : arrays_(arrays)
    , planeNodes_(planeNodes)
  {
  }

  /// Numbers the planes.
  void number(std::uint32_t node, int depth)
  {
    arrays_.words[node] = RlodPaperPlane::none;
    if (arrays_.nodes[node].isLeaf())
      return;
    if (depth % levelsApart == 0)
    {
      arrays_.words[node] = static_cast<std::uint32_t>(planeNodes_.size());
      planeNodes_.push_back(node);
    }
    for (std::uint32_t k = 0; k < 2; ++k)
      number(arrays_.nodes[node].first() + k, depth + 1);
  }

  void make(const Cell& cell)
  {
    if (planeNodes_.size() >= RlodPaperPlane::none)
      throw Error("The tree has more R-LODs than 27 bits count.");
    arrays_.planes.resize(planeNodes_.size());
    errors_.resize(planeNodes_.size());
    contentOf(0, cell, 0);
    if (errors_.empty())
      return;
    const auto [least, most] = std::minmax_element(errors_.begin(), errors_.end());
    arrays_.levels = ErrorLevels(*least, *most);
    for (std::size_t k = 0; k < errors_.size(); ++k)
      arrays_.words[planeNodes_[k]] |= arrays_.levels.levelOf(errors_[k]) << RlodWords::indexBits;
  }

private:
  Content contentOf(std::uint32_t index, const Cell& cell, int depth)
  {
    const RlodPaperNode node = arrays_.nodes[index];
    if (node.isLeaf())
      return contentOfLeaf(node, cell);
    Cell cells[2] = {cell, cell};
    cells[0].high[node.axis()] = cells[1].low[node.axis()] = node.split();
    Content parts[2];
    const auto part = [&](std::uint32_t k)
    { parts[k] = contentOf(node.first() + k, cells[k], depth + 1); };
    if (depth < parallelLevels)
      tbb::parallel_invoke([&] { part(0); }, [&] { part(1); });
    else
      part(0), part(1);
    Content all = joined(parts);
    if (const std::uint32_t plane = arrays_.words[index]; plane != RlodPaperPlane::none)
      fit(all, plane);
    return all;
  }

  Content contentOfLeaf(const RlodPaperNode& node, const Cell& cell) const
  {
    Content all;
    std::vector<PatchSums> sums;
    for (std::uint32_t k = 0; k < node.value; ++k)
    {
      const std::uint32_t index = arrays_.references[node.first() + k];
      const auto& [a, b, c] = arrays_.triangles[index];
      ClippedTriangle triangle{Vec3d(a), Vec3d(b), Vec3d(c)};
      triangle.clip(cell.low, cell.high);
      for (int i = 0; i < triangle.count(); ++i)
      {
        all.box.add(triangle.point(i));
        all.points.push_back(triangle.point(i));
        if (i > 1)
          sums.push_back(sumsOf(triangle.point(0), triangle.point(i - 1), triangle.point(i)));
      }
      if (all.triangle == RlodPaperPlane::none)
        all.triangle = index;
    }
    all.sums = PatchSums::joined(sums.data(), static_cast<int>(sums.size()));
    return all;
  }

  static Content joined(Content (&parts)[2])
  {
    // The longer list takes the other one in.
    const int more = parts[1].points.size() > parts[0].points.size() ? 1 : 0;
    Content& other = parts[1 - more];
    Content all = std::move(parts[more]);
    if (other.triangle == RlodPaperPlane::none)
      return all;
    if (all.triangle == RlodPaperPlane::none)
      return std::move(other);
    const PatchSums sums[2] = {all.sums, other.sums};
    all.sums = PatchSums::joined(sums, 2);
    const auto away = [&](const PatchSums& s) { return glm::length(s.middle - all.sums.middle); };
    if (away(sums[1]) < away(sums[0]))
      all.triangle = other.triangle;
    all.box.add(other.box);
    all.points.insert(all.points.end(), other.points.begin(), other.points.end());
    all.slabs.insert(all.slabs.end(), other.slabs.begin(), other.slabs.end());
    return all;
  }

  /// Makes a plane of the content. Where there are many points the plane takes their place.
  void fit(Content& content, std::uint32_t index)
  {
    RlodPaperPlane& plane = arrays_.planes[index];
    const PatchSums& sums = content.sums;
    const Vec3f normal(leastAxis(sums.moments, sums.normal));
    Slab slab = {Vec3d(normal), 0.0, 0.0, content.box.center(), 0.0};
    plane.offset = static_cast<float>(glm::dot(slab.normal, sums.middle));
    slab.offset = plane.offset;
    for (const Vec3d& p : content.points)
    {
      slab.deviation = std::max(slab.deviation, std::abs(glm::dot(slab.normal, p) - slab.offset));
      slab.radius = std::max(slab.radius, glm::length(p - slab.middle));
    }
    for (const Slab& part : content.slabs)
    {
      slab.deviation = std::max(slab.deviation, part.from(slab.normal, slab.offset));
      slab.radius = std::max(slab.radius, glm::length(part.middle - slab.middle) + part.radius);
    }
    slab.radius = std::min(slab.radius, 0.5 * glm::length(content.box.size()));
    const auto above = [](double v) { return static_cast<float>(v * (1.0 + 0x1p-20) + 0x1p-22); };
    for (int axis = 0; axis < 3; ++axis)
    {
      plane.normal[axis] = normal[axis];
      plane.low[axis] = static_cast<float>(content.box.lower[axis]) - 0x1p-22f;
      plane.high[axis] = static_cast<float>(content.box.upper[axis]) + 0x1p-22f;
    }
    plane.spread = above(spreadOf(sums, slab.normal));
    plane.deviation = above(slab.deviation);
    plane.triangle = content.triangle;
    errors_[index] = above(slab.radius + slab.deviation);
    if (content.points.size() > exactPoints || !content.slabs.empty())
    {
      content.points.clear();
      content.slabs = {slab};
    }
  }

  /// Root of the mean square of the distance from the plane, which is an eigenvalue.
  static double spreadOf(const PatchSums& sums, const Vec3d& n)
  {
    const double* m = sums.moments;
    const double square = n.x * n.x * m[0] + n.y * n.y * m[1] + n.z * n.z * m[2] +
                          2.0 * (n.x * n.y * m[3] + n.x * n.z * m[4] + n.y * n.z * m[5]);
    return sums.weight > 0.0 ? std::sqrt(std::max(square / sums.weight, 0.0)) : 0.0;
  }

  RlodPaperArrays& arrays_;
  RawVector<std::uint32_t>& planeNodes_;
  std::vector<float> errors_; ///< radii of the planes
};

} // namespace

void RlodPaperTree::makeLods()
{
  arrays_.planes.clear();
  arrays_.words.resize(arrays_.nodes.size());
  planeNodes_.clear();
  if (arrays_.nodes.empty())
    return;
  LodBuilder builder(arrays_, planeNodes_);
  builder.number(0, 0);
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    cell.low[axis] = arrays_.lower[axis];
    cell.high[axis] = arrays_.upper[axis];
  }
  builder.make(cell);
}

} // namespace mote::bench
