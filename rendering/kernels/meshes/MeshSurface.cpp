#include "MeshSurface.h"

#include "../core/PlaceByNormals.h"
#include "../core/SurfaceRounding.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// The same direction with a largest coordinate of 1, or 0: squares of any triangle's normal stay
/// within float.
Vec3d scaledNormal(const Vec3d& normal)
{
  const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  return largest > 0.0 && std::isfinite(largest) ? normal / largest : Vec3d(0.0);
}

} // namespace

double MeshSurface::rounding() const
{
  return surfaceRounding(this->bounds().size());
}

namespace
{

/// The cosine to the eye that is seen of triangles whose mean normal has the cosine `c`, and whose
/// normals have a mean of length `evenness`: E[x^2] / E[|x|] where x is the cosine of one of them,
/// for normals that spread evenly about the mean. Exact where they do not spread, within a few
/// percent for the normally distributed slopes of a rough surface.
double seenCosine(double c, double evenness)
{
  const double even2 = evenness * evenness, spread2 = (1.0 - even2) / (3.0 - even2);
  const double sine2 = 1.0 - c * c;
  const double squares = c * c * (1.0 - 2.0 * spread2) + sine2 * spread2;
  const double mean2 = even2 * c * c + 0.64 * sine2 * spread2; // 0.64: 2 / pi
  return mean2 > 0.0 ? std::max(std::abs(c), squares / std::sqrt(mean2)) : 0.0;
}

/// The normal that a plane has for who sees it: where triangles look different ways, most of what
/// is seen of them looks nearer to the eye than their mean does. With the mean a patch that is seen
/// from its edge is black, and the folds of a surface are dark lines.
///
/// The side that looks to the eye is the one that counts. But near outlines planes look away that
/// stand for the rim, or reach over it from behind: they are lit like the rim.
Vec3d seenNormal(const Vec3d& mean, const Vec3d& way)
{
  const double evenness = std::min(1.0, glm::length(mean));
  const Vec3d toEye = glm::normalize(-way);
  Vec3d normal = glm::normalize(mean);
  const double rim = 0.05 + std::sqrt(8.0 * (1.0 - evenness));
  if (glm::dot(normal, toEye) < -rim)
    normal = -normal;
  const double cosine = glm::dot(normal, toEye);
  const Vec3d across = normal - cosine * toEye;
  const double sine2 = glm::dot(across, across);
  if (!(sine2 > 0.0))
    return toEye;
  // Never quite across: rounding must not make it look away.
  const double seen = std::clamp(seenCosine(cosine, evenness), 1e-4, 1.0);
  return seen * toEye + std::sqrt((1.0 - seen * seen) / sine2) * across;
}

} // namespace

/// Triangles and hits of an R-LOD lie within its deviation of the plane, and in a box that is no
/// wider than twice its error radius.
double MeshSurface::clearance(std::uint64_t slot, double cosine) const
{
  const double ofRounding = this->rounding() / cosine;
  if (!RlodTree::isLod(slot))
    return ofRounding;
  const RlodTree::Lod lod = tree_->lod(slot);
  return ofRounding +
         2.0 * tree_->unit() * std::min(double(lod.deviation) / cosine, double(lod.error));
}

void MeshSurface::fetch(HitBlock& block) const
{
  alignas(64) float normals[3][HitBlock::capacity];
  float* const rows[3] = {normals[0], normals[1], normals[2]};
  tree_->normals(block.slot, block.count, rows);
  for (int k = 0; k < block.count; ++k)
  {
    const Vec3d normal = scaledNormal({normals[0][k], normals[1][k], normals[2][k]});
    for (int axis = 0; axis < 3; ++axis)
      block.own[axis][k] = normal[axis];
  }
}

void MeshSurface::place(HitBlock& block, const HitPlacing& placing) const
{
  const RayBundle& rays = placing.local;
  const bool smooth = isSmooth(), errs = pixelsOfError() > 0.0;
  for (int k = 0; (smooth || errs) && k < block.count; ++k)
  {
    if (RlodTree::isLod(block.slot[k]))
    {
      const Vec3d seen =
        seenNormal(Vec3d(tree_->normal(block.slot[k])), rays.directionOf(block.ray[k]));
      for (int axis = 0; axis < 3; ++axis)
        block.own[axis][k] = seen[axis];
      continue;
    }
    if (!smooth)
      continue;
    const int ray = block.ray[k];
    const Vec3d way = rays.directionOf(ray), point = rays.originOf(ray) + block.t[k] * way;
    Vec3d flat(block.own[0][k], block.own[1][k], block.own[2][k]);
    if (glm::dot(flat, way) > 0.0)
      flat = -flat;
    Vec3d normal = smoothNormal(block.slot[k], point, flat);
    // Never quite across: rounding must not make it look away.
    const double least = 1e-4 * glm::length(normal) * glm::length(way);
    if (const double away = glm::dot(normal, way) + least; away > 0.0)
      normal -= away / glm::dot(way, way) * way;
    for (int axis = 0; axis < 3; ++axis)
      block.own[axis][k] = normal[axis];
  }
  placeByNormals(block, placing);
}

/// Barycentric coordinates of a point in its triangle; those of the nearest inside where rounding
/// puts it outside, and of the first corner where the triangle has no area.
std::array<double, 3> MeshSurface::sharesAt(std::uint64_t slot, const Vec3d& point) const
{
  const auto corners = tree_->localCorners(slot);
  const Vec3d at = (point - tree_->origin()) / tree_->unit();
  const Vec3d a(corners[0]), b(corners[1]), c(corners[2]);
  const Vec3d across = glm::cross(b - a, c - a);
  const double area = glm::dot(across, across);
  if (!(area > 0.0))
    return {1.0, 0.0, 0.0};
  const double shareB = std::clamp(glm::dot(glm::cross(at - a, c - a), across) / area, 0.0, 1.0);
  const double shareC =
    std::clamp(glm::dot(glm::cross(b - a, at - a), across) / area, 0.0, 1.0 - shareB);
  return {1.0 - shareB - shareC, shareB, shareC};
}

/// The normal between those of the corners, on the side of the triangle's own, `flat`; that where
/// the corners have none.
Vec3d MeshSurface::smoothNormal(std::uint64_t slot, const Vec3d& point, const Vec3d& flat) const
{
  const std::array<double, 3> shares = this->sharesAt(slot, point);
  const MeshCorners::Corners points = this->pointsOf(slot);
  Vec3d sum(0.0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3d normal = {look_.normals.value(points[k], 0), look_.normals.value(points[k], 1),
      look_.normals.value(points[k], 2)};
    const double length = glm::length(scaledNormal(normal));
    if (length > 0.0)
      sum += shares[k] / length * scaledNormal(normal);
  }
  if (!(glm::dot(sum, sum) > 0.0))
    return flat;
  return glm::dot(sum, flat) < 0.0 ? -sum : sum;
}

Vec3d MeshSurface::normalAt(std::uint64_t slot, const Vec3d& point) const
{
  const Vec3d flat = scaledNormal(tree_->normal(slot));
  return isSmooth() && !RlodTree::isLod(slot) ? smoothNormal(slot, point, flat) : flat;
}

Vec3d MeshSurface::seenNormalAt(std::uint64_t slot, const Vec3d& /*point*/, const Vec3d& way) const
{
  return seenNormal(Vec3d(tree_->normal(slot)), way);
}

void MeshSurface::mixColors(
  const std::uint64_t* slots, const Vec3d* points, int count, ColorMix& mix) const
{
  for (int k = 0; k < count; ++k)
  {
    const std::array<double, 3> shares = this->sharesAt(slots[k], points[k]);
    const MeshCorners::Corners corners = this->pointsOf(slots[k]);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      mix.index[corner][k] = corners[corner];
      mix.share[corner][k] = shares[corner];
    }
  }
}

void MeshSurface::inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const
{
  tree_->inputIndices(slots, count, ids);
  if (!look_.cells.empty())
    for (int k = 0; k < count; ++k)
      ids[k] = static_cast<std::uint64_t>(look_.cells.value(ids[k]));
}

/// What a plane stands for that R-LODs have has no edges.
void MeshSurface::edges(const std::uint64_t* slots, const Vec3d* points, const Vec3d* ways,
  int count, EdgeSeen* found) const
{
  for (int k = 0; k < count; ++k)
  {
    if (RlodTree::isLod(slots[k]))
      continue;
    const unsigned own = look_.edges ? (*look_.edges)[tree_->inputIndex(slots[k])] : 7U;
    const auto corners = tree_->localCorners(slots[k]);
    const Vec3d at = (points[k] - tree_->origin()) / tree_->unit();
    for (std::size_t side = 0; side < 3; ++side)
    {
      if ((own >> side & 1) == 0)
        continue;
      const Vec3d from(corners[side]), to(corners[(side + 1) % 3]), third(corners[(side + 2) % 3]);
      const Vec3d edge = to - from;
      const double length2 = glm::dot(edge, edge);
      if (!(length2 > 0.0))
        continue;
      const auto across = [&](const Vec3d& p) // from p to the side's line
      { return from + glm::dot(p - from, edge) / length2 * edge - p; };
      const double height = glm::length(across(third));
      const Vec3d offset = across(at);
      found[k].take(
        tree_->unit() * offset, edge, ways[k], height > 0.0 ? glm::length(offset) / height : 0.0);
    }
  }
}

MeshSurface MeshSurface::unowned() const
{
  MeshSurface copy(mote::unowned(tree_), look_);
  copy.look_.corners = mote::unowned(look_.corners);
  copy.look_.edges = mote::unowned(look_.edges);
  return copy;
}

} // namespace mote
