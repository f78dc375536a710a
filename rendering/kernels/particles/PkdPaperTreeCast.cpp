// Casting rays through a PkdPaperTree, one by one.

#include "PkdPaperTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

/// One ray in the tree's coordinates: P + tau d, with |d| = 1 and P where the ray enters the
/// bounds. With ANY set it ends at whatever it meets first.
template <bool ANY>
class PkdPaperRay
{
public:
  PkdPaperRay(const PkdPaperTree& tree, const Vec3d& origin, const Vec3d& direction, double tMin,
    double t, std::uint64_t except)
    : tree_(tree)
    , tMin_(tMin)
    , t_(t)
    , except_(except)
  {
    const Box& bounds = tree.statistics_.bounds;
    const Vec3d size = bounds.size() / tree.unit_;
    const double largest = std::max({size.x, size.y, size.z});
    margin_ = 1e-12 * largest;
    const Vec3d from = (origin - tree.origin_) / tree.unit_;
    const double speed = glm::length(direction);
    perT_ = speed / tree.unit_;
    double enter = tMin * perT_, leave = t * perT_;
    if (!(speed > 0.0))
      leave = -std::numeric_limits<double>::infinity();
    d_ = direction / speed;
    for (int k = 0; k < 3; ++k)
    {
      // Never infinite, so that no product with it is without meaning.
      inverse_[k] = 1.0 / std::copysign(std::max(std::abs(d_[k]), 1e-18), d_[k]);
      const double least = (bounds.lower[k] - tree.origin_[k]) / tree.unit_ - 1e-6 * largest;
      const double most = (bounds.upper[k] - tree.origin_[k]) / tree.unit_ + 1e-6 * largest;
      const double a = (least - from[k]) * inverse_[k], b = (most - from[k]) * inverse_[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    p_ = from + enter * d_;
    tau0_ = enter;
    leave_ = leave - enter + margin_;
    best_ = leave_;
  }

  /// Slot of the particle that is hit, or noHit; t() is where.
  std::uint64_t cast()
  {
    if (!(leave_ >= 0.0))
      return RayPacket::noHit;
    visit(0, 0.0, leave_, tree_.subtreeRadius_[0]);
    while (depth_ > 0 && !(ANY && slot_ != RayPacket::noHit))
    {
      const Later& next = stack_[--depth_];
      if (next.enter > best_)
        continue;
      if (next.enter <= next.leaveOwn)
        test(next.node);
      visit(next.far, next.enter, next.leave, next.radius);
    }
    return slot_;
  }

  double t() const { return t_; }

private:
  /// What is left of a node when its near child is done: its own sphere and its far child.
  struct Later
  {
    std::size_t node, far;
    double enter;    ///< tau where sphere and far child begin
    double leaveOwn; ///< and where the sphere ends
    double leave;    ///< and the far child
    float radius;    ///< the largest there
  };

  /// Goes down from the node to what is nearest, between two tau. Spheres there are as large as
  /// `radius` at most.
  void visit(std::size_t node, double enter, double leave, float radius)
  {
    while (node < tree_.count_ && enter <= std::min(leave, best_))
    {
      const std::size_t lower = 2 * node + 1;
      if (lower >= tree_.count_)
      {
        test(node);
        return;
      }
      if (node < tree_.subtreeRadius_.size())
        radius = tree_.subtreeRadius_[node];
      const int axis = tree_.axis(node);
      const double inverse = inverse_[axis];
      const double at = (double(tree_.number(node, std::size_t(axis))) - p_[axis]) * inverse;
      const double reach = (double(radius) + margin_) * std::abs(inverse);
      const bool upwards = inverse > 0.0;
      const double nearLeave = std::min(leave, at + reach), farEnter = std::max(enter, at - reach);
      if (farEnter <= leave)
        stack_[depth_++] = {node, upwards ? lower + 1 : lower, farEnter, nearLeave, leave, radius};
      node = upwards ? lower : lower + 1;
      leave = nearLeave;
    }
  }

  void test(std::size_t slot)
  {
    const Vec3d f = Vec3d(tree_.number(slot, 0), tree_.number(slot, 1), tree_.number(slot, 2)) - p_;
    const double r = tree_.storedRadius(slot), foot = glm::dot(f, d_);
    const Vec3d across = f - foot * d_;
    const double left = r * r - glm::dot(across, across);
    if (!(left >= 0.0) || slot == except_ || !tree_.isShown(slot))
      return;
    const double half = std::sqrt(left);
    // Compared as it is answered: casting again finds nothing nearer.
    double tau = foot - half, t = (tau0_ + tau) / perT_;
    if (!(t > tMin_))
    {
      tau = foot + half;
      t = (tau0_ + tau) / perT_;
    }
    const bool first =
      t == t_ && slot_ != RayPacket::noHit && tree_.inputIndex(slot) < tree_.inputIndex(slot_);
    if (!(t > tMin_) || !(t < t_ || first))
      return;
    t_ = t;
    slot_ = slot;
    // Not less: of coincident particles another one may count.
    best_ = std::min(best_, tau + margin_);
  }

  const PkdPaperTree& tree_;
  Vec3d p_, d_, inverse_;
  double tMin_, t_;     ///< of the ray as it was given; t of the nearest hit so far
  double perT_ = 1.0;   ///< units of tau in one of t
  double tau0_ = 0.0;   ///< tau of P counted from the ray's own origin
  double leave_ = 0.0;  ///< tau where the ray leaves the bounds, or ends
  double best_ = 0.0;   ///< tau beyond which nothing counts
  double margin_ = 0.0; ///< by which planes may be rounded
  std::uint64_t except_;
  std::uint64_t slot_ = RayPacket::noHit;
  int depth_ = 0;
  Later stack_[64]; ///< one a level
};

/// Casts the rays; place(i, origin, direction, tMin) says where ray i is.
template <bool ANY, typename Rays, typename Place>
void PkdPaperTree::castRays(Rays& rays, std::int32_t object, const Place& place) const
{
  for (int i = 0; i < rays.count && count_ > 0; ++i)
  {
    Vec3d origin, direction;
    double tMin = 0.0;
    place(i, origin, direction, tMin);
    const bool own = ANY && rays.object[i] == object;
    PkdPaperRay<ANY> ray(
      *this, origin, direction, tMin, rays.t[i], own ? rays.slot[i] : RayPacket::noHit);
    const std::uint64_t slot = ray.cast();
    if (slot == RayPacket::noHit)
      continue;
    if constexpr (ANY)
      rays.t[i] = -std::numeric_limits<double>::infinity();
    else
    {
      rays.t[i] = ray.t();
      rays.slot[i] = slot;
      rays.object[i] = object;
    }
  }
}

namespace
{

auto placeIn(const RayPacket& rays)
{
  return [&rays](int i, Vec3d& origin, Vec3d& direction, double& tMin)
  {
    origin = {rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]};
    direction = {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]};
    tMin = rays.tMin[i];
  };
}

auto placeIn(const RayBundle& rays)
{
  return [&rays](int i, Vec3d& origin, Vec3d& direction, double& tMin)
  {
    origin = rays.originOf(i);
    direction = rays.directionOf(i);
    tMin = rays.tMin;
  };
}

} // namespace

void PkdPaperTree::cast(RayPacket& packet, std::int32_t object) const
{
  castRays<false>(packet, object, placeIn(packet));
}

void PkdPaperTree::cast(RayBundle& bundle, std::int32_t object) const
{
  castRays<false>(bundle, object, placeIn(bundle));
}

void PkdPaperTree::occlude(RayPacket& packet, std::int32_t object) const
{
  castRays<true>(packet, object, placeIn(packet));
}

void PkdPaperTree::occlude(RayBundle& bundle, std::int32_t object) const
{
  castRays<true>(bundle, object, placeIn(bundle));
}

} // namespace mote
