// Boxes that stand for the particles below a PkdTree's nodes, as a bundle of rays sees them.
// Included once per SIMD instruction set.

#if defined(MOTE_PKD_TREE_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PKD_TREE_BOXES_INL_H
#undef MOTE_PKD_TREE_BOXES_INL_H
#else
#define MOTE_PKD_TREE_BOXES_INL_H
#endif

#include "BundleSpheres-inl.h"
#include "PkdTreeView.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Bounds in 8 bits as float numbers.
HWY_INLINE VF boundsAt(const std::uint8_t* bounds)
{
  const DF d;
  const hn::Rebind<std::int32_t, DF> di;
  const hn::Rebind<std::uint8_t, DF> d8;
  return hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(d8, bounds)));
}

/// Levels of detail: which of a node's children boxes may stand for, and the test of rays against
/// these. A box is the child's bounds, shrunk about their middle until it covers as much of their
/// outline as the spheres in them do, seen from where the bundle comes from.
class LodBoxes
{
public:
  /// `poe` footprints of the bundle's rays are what a box may err by.
  void prepare(const PkdTreeView& view, const Pencil& p, const RayBundle& bundle, double poe)
  {
    view_ = &view;
    p_ = &p;
    const double perTau = bundle.footprintPerT / (p.perT * view.tree.unit());
    const double forward = p.sign * p.d[p.K];
    limit_ = static_cast<float>(poe * (bundle.footprint / view.tree.unit() + perTau * p.t0));
    limitPerKappa_ = static_cast<float>(poe * perTau / forward);
    prepareRays();
  }

  /// The children from `first` on that boxes may stand for, as bits; `near` is where they begin.
  HWY_INLINE unsigned fitting(const PkdTreeView::Node& node, const float* near, int first) const
  {
    const DF d;
    const PkdTreeView::Lods& lods = view_->lods[&node - view_->nodes];
    const VF kappa = hn::Load(d, near);
    const VF limit = hn::MulAdd(kappa, hn::Set(d, limitPerKappa_), hn::Set(d, limit_));
    const VF error = boundsAt(lods.error.data() + first);
    // What begins before the rays do is looked at more closely.
    auto fits = hn::And(hn::Gt(kappa, hn::Zero(d)), hn::Lt(error, hn::Set(d, PkdTreeView::noLod)));
    const VF mostError = hn::Mul(limit, hn::Set(d, errorsPerPixel));
    fits = hn::And(fits, hn::Le(hn::Mul(error, hn::Set(d, lodStep(node))), mostError));
    const VF widest = hn::Mul(limit, hn::Set(d, sidesPerPixel));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const VF size =
        hn::Sub(boundsAt(node.high[k].data() + first), boundsAt(node.low[k].data() + first));
      fits = hn::And(fits, hn::Le(hn::Mul(size, hn::Set(d, stepOf(node, k))), widest));
    }
    return bitsOf(fits) & (view_->wholeOf(node) >> first);
  }

  /// Tests the boxes of the children whose bits are set, those from `first` on.
  template <typename Tester>
  HWY_INLINE void test(const PkdTreeView::Node& node, unsigned bits, int first, Tester& tester)
  {
    place(node, first);
    const auto slot = PkdTree::lodBit | static_cast<std::uint64_t>(&node - view_->nodes) << 4;
    for (; bits != 0; bits &= bits - 1)
    {
      const int j = __builtin_ctz(bits);
      tester.testOther({x_[j], y_[j], reachX_[j], reachY_[j], nearest_[j]},
        slot + static_cast<unsigned>(first + j), [&](int i) { return meet(i, j); });
    }
    tester.refresh();
  }

private:
  /// Errors are those at the corners of boxes; few rays meet these (docs/pkd-tree.md).
  static constexpr float errorsPerPixel = 2.0f;
  /// A box has one colour, a mean: none of its sides is longer.
  static constexpr float sidesPerPixel = 10.0f;

  /// Of each ray the inverse of its direction, and that times where it passes Q's plane.
  void prepareRays()
  {
    const DF d;
    const auto set = [&](double v) { return hn::Set(d, static_cast<float>(v)); };
    for (int i = 0; i < blockRays * p_->blocks; i += static_cast<int>(hn::Lanes(d)))
    {
      const VF x = hn::Load(d, p_->x + i), y = hn::Load(d, p_->y + i);
      for (int k = 0; k < 3; ++k)
      {
        const VF way = hn::MulAdd(x, set(p_->dx[k]), hn::MulAdd(y, set(p_->dy[k]), set(p_->d[k])));
        const VF from = hn::MulAdd(x, set(p_->ox[k]), hn::Mul(y, set(p_->oy[k])));
        // Never infinite, so that no product with it is without meaning.
        const VF inverse = hn::Div(set(1.0), hn::CopySign(hn::Max(hn::Abs(way), set(1e-18)), way));
        hn::Store(inverse, d, inverse_[k] + i);
        hn::Store(hn::Mul(from, inverse), d, from_[k] + i);
      }
    }
  }

  /// Finds the boxes from `first` on, and where they are in the picture.
  HWY_INLINE void place(const PkdTreeView::Node& node, int first)
  {
    const DF d;
    const auto set = [&](float v) { return hn::Set(d, v); };
    const PkdTreeView::Lods& lods = view_->lods[&node - view_->nodes];
    VF middle[3], half[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const VF low = boundsAt(node.low[k].data() + first),
               high = boundsAt(node.high[k].data() + first);
      const VF step = set(0.5f * stepOf(node, k));
      const VF lower = set(static_cast<float>(double(node.lower[k]) - p_->q[static_cast<int>(k)]));
      middle[k] = hn::MulAdd(hn::Add(low, high), step, lower);
      half[k] = hn::Mul(hn::Sub(high, low), step);
    }
    // What thins light along an axis does so along a mean chord in proportion: the volume, or an
    // axis' length times its face, over the outline.
    VF outline = set(1e-30f), thinned = hn::Zero(d);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto along = static_cast<float>(std::abs(p_->d[static_cast<int>(k)]));
      const VF face = hn::Mul(half[(k + 1) % 3], half[(k + 2) % 3]);
      outline = hn::MulAdd(face, set(along), outline);
      thinned = hn::MulAdd(
        hn::Mul(face, set(along * along)), thicknessAt(lods.thickness[k].data() + first), thinned);
    }
    const VF shrunk = hn::Sqrt(covered(hn::Div(thinned, outline)));
    for (std::size_t k = 0; k < 3; ++k)
    {
      half[k] = hn::Mul(half[k], shrunk);
      hn::Store(hn::Sub(middle[k], half[k]), d, low_[k]);
      hn::Store(hn::Add(middle[k], half[k]), d, high_[k]);
    }
    project(middle, half);
  }

  static HWY_INLINE VF thicknessAt(const std::uint8_t* bits)
  {
    const DF d;
    const DU du;
    const hn::Rebind<std::uint8_t, DF> d8;
    const auto first = hn::Set(du, PkdTreeView::Lods::firstThickness);
    return hn::BitCast(
      d, hn::ShiftLeft<20>(hn::Add(hn::PromoteTo(du, hn::LoadU(d8, bits)), first)));
  }

  /// What is covered of an outline where chords of the mean length thin light by exp(-x): less than
  /// 1 - exp(-x), since chords of a box are of many lengths.
  static HWY_INLINE VF covered(VF x)
  {
    const DF d;
    const VF one = hn::Set(d, 1.0f), root = hn::MulAdd(x, hn::Set(d, 0.25f), one);
    const VF square = hn::Mul(root, root);
    return hn::Sub(one, hn::Div(one, hn::Mul(square, square)));
  }

  HWY_INLINE void project(const VF* middle, const VF* half)
  {
    const DF d;
    const auto set = [&](float v) { return hn::Set(d, v); };
    const auto along = [&](const Vec3f& g)
    {
      return hn::MulAdd(
        middle[0], set(g.x), hn::MulAdd(middle[1], set(g.y), hn::Mul(middle[2], set(g.z))));
    };
    const auto extent = [&](const Vec3f& g)
    {
      return hn::MulAdd(half[0], set(std::abs(g.x)),
        hn::MulAdd(half[1], set(std::abs(g.y)), hn::Mul(half[2], set(std::abs(g.z)))));
    };
    const VF tau = along(p_->gTau), reach = extent(p_->gTau);
    const VF slope = set(p_->scaleSlope), width = hn::MulAdd(tau, slope, set(p_->scale));
    const VF perWidth = hn::Div(set(1.0f), width);
    const VF x = hn::Mul(along(p_->gM), perWidth), y = hn::Mul(along(p_->gN), perWidth);
    // Nothing is nearer to the eye than this. What is too near it is wide.
    const VF change = hn::Mul(reach, slope);
    const VF perLeast =
      hn::Div(set(1.00001f), hn::Max(hn::Sub(width, change), hn::Mul(width, set(1e-3f))));
    const auto across = [&](const Vec3f& g, VF at)
    { return hn::Mul(hn::MulAdd(hn::Abs(at), change, extent(g)), perLeast); };
    hn::Store(x, d, x_);
    hn::Store(y, d, y_);
    hn::Store(across(p_->gM, x), d, reachX_);
    hn::Store(across(p_->gN, y), d, reachY_);
    hn::Store(hn::Sub(tau, hn::Mul(reach, set(1.00001f))), d, nearest_);
  }

  /// Where rays i and on enter box j; infinity where they do not.
  HWY_INLINE VF meet(int i, int j) const
  {
    const DF d;
    VF enter = hn::Set(d, p_->first), leave = hn::Set(d, infinity);
    for (int k = 0; k < 3; ++k)
    {
      const VF inverse = hn::Load(d, inverse_[k] + i), from = hn::Load(d, from_[k] + i);
      const VF a = hn::MulSub(hn::Set(d, low_[k][j]), inverse, from);
      const VF b = hn::MulSub(hn::Set(d, high_[k][j]), inverse, from);
      enter = hn::Max(enter, hn::Min(a, b));
      leave = hn::Min(leave, hn::Max(a, b));
    }
    const auto meets = hn::And(hn::Le(enter, leave), hn::Gt(enter, hn::Set(d, p_->first)));
    return hn::IfThenElse(meets, enter, hn::Set(d, infinity));
  }

  const PkdTreeView* view_;
  const Pencil* p_;
  float limit_, limitPerKappa_; ///< most error, in unit(), where kappa is 0, and its growth
  alignas(64) float inverse_[3][RayBundle::capacity], from_[3][RayBundle::capacity];
  alignas(64) float low_[3][PkdTree::fanout], high_[3][PkdTree::fanout]; ///< from Q
  alignas(64) float x_[PkdTree::fanout], y_[PkdTree::fanout];
  alignas(64) float reachX_[PkdTree::fanout], reachY_[PkdTree::fanout], nearest_[PkdTree::fanout];
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
