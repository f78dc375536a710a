// What levels of detail of a PkdTree's node are made of, included once per SIMD instruction set.

#if defined(MOTE_PKD_TREE_LOD_FILL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PKD_TREE_LOD_FILL_INL_H
#undef MOTE_PKD_TREE_LOD_FILL_INL_H
#else
#define MOTE_PKD_TREE_LOD_FILL_INL_H
#endif

#include "PkdTreeBundle-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Looks at what is below each child of a node. How much of its bounds is covered along an axis is
/// found from points within what covers it, each of which counts for as much as the others leave it
/// (R. Karp, M. Luby, N. Madras, "Monte-Carlo approximation algorithms for enumeration problems",
/// 1989): right for specks in the void, too. Points on the box that will stand for it tell how far
/// from a sphere one may be.
class LodFill
{
public:
  /// `lods` are those of all nodes; those below `node` of `level` are there.
  LodFill(const PkdTreeView& view, int level, std::size_t node, PkdTreeView::Lods* lods)
    : view_(view)
    , level_(level)
    , index_(node)
    , node_(view.node(level, node))
    , lods_(lods)
  {
  }

  void run()
  {
    PkdTreeView::Lods& out = lods_[&node_ - view_.nodes];
    for (unsigned c = 0; c < PkdTree::fanout; ++c)
    {
      double thickness[3] = {0.0, 0.0, 0.0}, error = infinity;
      if (take(c))
      {
        double most = 0.0;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double area = level_ == 0 ? coveredBySpheres(axis) : coveredByBoxes(axis);
          const double face = 4.0 * half_[(axis + 1) % 3] * half_[(axis + 2) % 3];
          const double share = face > 0.0 ? std::min(area / face, 0.998) : 0.998;
          thickness[axis] = -std::log1p(-share);
          most = std::max(most, share);
        }
        error = farthestFrom(std::sqrt(most)) / double(lodStep(node_));
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        out.thickness[axis][c] = PkdTreeView::Lods::bitsOf(static_cast<float>(thickness[axis]));
      out.error[c] = error <= PkdTreeView::noLod - 1 ? static_cast<std::uint8_t>(std::ceil(error))
                                                     : PkdTreeView::noLod;
    }
  }

private:
  static constexpr int lanes = PkdTree::fanout;
  using Row = float[lanes];

  /// Brings what is below a child, and its bounds; false where there is no such child.
  bool take(unsigned child)
  {
    const std::size_t below = index_ * PkdTree::fanout + child;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (node_.low[k][child] > node_.high[k][child])
        return false;
      const float step = stepOf(node_, k);
      // Spheres count from the treelet's corner, nodes from the origin: small numbers both.
      base_[k] = level_ == 0 ? node_.corner[k] : node_.lower[k];
      const float lower = node_.lower[k] - base_[k];
      middle_[k] = lower + 0.5f * step * float(node_.low[k][child] + node_.high[k][child]);
      half_[k] = 0.5f * step * float(node_.high[k][child] - node_.low[k][child]);
    }
    seed_ = static_cast<std::uint32_t>(below) * 0x9e3779b9u + static_cast<unsigned>(level_);
    if (level_ == 0)
      takeSpheres(below);
    else
      takeBoxes(below);
    return true;
  }

  void takeSpheres(std::size_t bucket)
  {
    const DF d;
    for (int lane = 0; lane < lanes; lane += static_cast<int>(hn::Lanes(d)))
    {
      const Spheres spheres(view_, bucket, lane);
      hn::Store(spheres.x, d, at_[0] + lane);
      hn::Store(spheres.y, d, at_[1] + lane);
      hn::Store(spheres.z, d, at_[2] + lane);
      hn::Store(spheres.r, d, reach_ + lane);
    }
    absent_ = 0xffffu & ~view_.shownIn(bucket);
    for (unsigned bits = absent_; bits != 0; bits &= bits - 1)
      at_[0][__builtin_ctz(bits)] = infinity;
  }

  void takeBoxes(std::size_t below)
  {
    const PkdTreeView::Node& node = view_.node(level_ - 1, below);
    const PkdTreeView::Lods& lods = lods_[&node - view_.nodes];
    for (std::size_t c = 0; c < lanes; ++c)
    {
      const bool exists = node.low[0][c] <= node.high[0][c];
      const bool has = exists && lods.error[c] != PkdTreeView::noLod;
      float most = 0.0f;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const float step = 0.5f * stepOf(node, k);
        thickness_[k][c] = exists ? PkdTreeView::Lods::thicknessOf(lods.thickness[k][c]) : 0.0f;
        most = std::max(most, thickness_[k][c]);
        at_[k][c] = node.lower[k] - base_[k] + step * float(node.low[k][c] + node.high[k][c]);
        size_[k][c] = exists ? step * float(node.high[k][c] - node.low[k][c]) : -1.0f;
      }
      reach_[c] = has ? lodStep(node) * float(lods.error[c]) : infinity;
      shrunk_[c] = std::sqrt(-std::expm1(-most));
    }
  }

  /// The area that is covered across an axis, of spheres.
  double coveredBySpheres(int axis)
  {
    const DF d;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    double area = 0.0;
    for (int i = 0; i < lanes; ++i)
    {
      // Points of a spiral, evenly spread over a disc: another one for each sphere.
      const int turn = (i + static_cast<int>(nextNumber() >> 28)) % lanes;
      const float x = at_[u][i] + reach_[i] * spiral().x[turn];
      const float y = at_[v][i] + reach_[i] * spiral().y[turn];
      unsigned covering = 0;
      for (int lane = 0; lane < lanes; lane += static_cast<int>(hn::Lanes(d)))
      {
        const VF dx = hn::Sub(hn::Load(d, at_[u] + lane), hn::Set(d, x));
        const VF dy = hn::Sub(hn::Load(d, at_[v] + lane), hn::Set(d, y));
        const VF r = hn::Load(d, reach_ + lane);
        covering |= bitsOf(hn::Le(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), hn::Mul(r, r))) << lane;
      }
      const double own = double(reach_[i]) * double(reach_[i]) * M_PI;
      if ((absent_ >> i & 1) == 0)
        area += own / std::max(1, __builtin_popcount(covering & ~absent_));
    }
    return area;
  }

  /// The same of boxes, which cover their part of the face by chance.
  double coveredByBoxes(int axis)
  {
    constexpr int points = 2;
    const DF d;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    double area = 0.0;
    for (int i = 0; i < points * lanes; ++i)
    {
      const int own = i % lanes;
      if (!(thickness_[axis][own] > 0.0f))
        continue;
      const std::uint32_t bits = nextNumber();
      const float x = at_[u][own] + size_[u][own] * (float(bits >> 20) / 2048.0f - 1.0f);
      const float y = at_[v][own] + size_[v][own] * (float(bits >> 8 & 0xfff) / 2048.0f - 1.0f);
      VF sum = hn::Zero(d);
      for (int lane = 0; lane < lanes; lane += static_cast<int>(hn::Lanes(d)))
      {
        const auto within = [&](int k, float at)
        {
          return hn::Le(hn::Abs(hn::Sub(hn::Load(d, at_[k] + lane), hn::Set(d, at))),
            hn::Load(d, size_[k] + lane));
        };
        sum = hn::Add(sum, hn::IfThenElseZero(hn::And(within(u, x), within(v, y)),
                             hn::Load(d, thickness_[axis] + lane)));
      }
      // Rounding may put the point beside its own box.
      const double all = std::max(hn::GetLane(hn::SumOfLanes(d, sum)), thickness_[axis][own]);
      area += 4.0 / points * double(size_[u][own]) * double(size_[v][own]) * -std::expm1(-all) *
              (double(thickness_[axis][own]) / all);
    }
    return area;
  }

  std::uint32_t nextNumber()
  {
    seed_ = seed_ * 1664525u + 1013904223u;
    return seed_;
  }

  struct Spiral
  {
    Row x, y;
    Spiral()
    {
      for (int i = 0; i < lanes; ++i)
      {
        const double radius = std::sqrt((i + 0.5) / lanes), angle = 2.39996323 * i;
        x[i] = static_cast<float>(radius * std::cos(angle));
        y[i] = static_cast<float>(radius * std::sin(angle));
      }
    }
  };
  static const Spiral& spiral()
  {
    static const Spiral points;
    return points;
  }

  /// The greatest distance at which lines along the axes pass spheres, of lines that meet the
  /// bounds shrunk by a factor: of those through the corners, and the middles of edges and faces.
  double farthestFrom(double shrunk) const
  {
    double most = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 9; ++i)
      {
        float point[3];
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        point[u] = middle_[u] + static_cast<float>(shrunk * (i % 3 - 1)) * half_[u];
        point[v] = middle_[v] + static_cast<float>(shrunk * (i / 3 - 1)) * half_[v];
        most = std::max(most, level_ == 0 ? fromSpheres(point, u, v) : fromBoxes(point, u, v));
      }
    return most;
  }

  double fromSpheres(const float* point, int u, int v) const
  {
    const DF d;
    VF least = hn::Set(d, infinity);
    for (int lane = 0; lane < lanes; lane += static_cast<int>(hn::Lanes(d)))
    {
      VF sum = hn::Zero(d);
      for (const int k : {u, v})
      {
        const VF across = hn::Sub(hn::Load(d, at_[k] + lane), hn::Set(d, point[k]));
        sum = hn::MulAdd(across, across, sum);
      }
      least = hn::Min(least, hn::Sub(hn::Sqrt(sum), hn::Load(d, reach_ + lane)));
    }
    return std::max(0.0f, hn::GetLane(hn::MinOfLanes(d, least)));
  }

  /// To the nearest box, and what may be from there.
  double fromBoxes(const float* point, int u, int v) const
  {
    const DF d;
    VF least = hn::Set(d, infinity);
    for (int lane = 0; lane < lanes; lane += static_cast<int>(hn::Lanes(d)))
    {
      VF sum = hn::Zero(d);
      for (const int k : {u, v})
      {
        const VF across = hn::Abs(hn::Sub(hn::Load(d, at_[k] + lane), hn::Set(d, point[k])));
        const VF own = hn::Mul(hn::Load(d, size_[k] + lane), hn::Load(d, shrunk_ + lane));
        const VF left = hn::Max(hn::Sub(across, own), hn::Zero(d));
        sum = hn::MulAdd(left, left, sum);
      }
      least = hn::Min(least, hn::Add(hn::Sqrt(sum), hn::Load(d, reach_ + lane)));
    }
    return hn::GetLane(hn::MinOfLanes(d, least));
  }

  const PkdTreeView& view_;
  const int level_;
  const std::size_t index_;
  const PkdTreeView::Node& node_;
  PkdTreeView::Lods* lods_;
  std::uint32_t seed_ = 0;
  unsigned absent_ = 0;                 ///< bits of spheres that a bucket lacks
  float base_[3], middle_[3], half_[3]; ///< what places count from, and the child's bounds
  alignas(64) Row at_[3];               ///< middles of what is below it
  alignas(64) Row reach_;               ///< radii of spheres; errors of boxes
  alignas(64) Row size_[3];             ///< half the sides of boxes
  alignas(64) Row thickness_[3];        ///< how much they thin light: -log of what they leave
  alignas(64) Row shrunk_;              ///< what they shrink to at least
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
