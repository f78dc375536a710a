// Single rays as a PkdTree sees them, and what one ray meets of 16 children or 16 particles.
// Included once per SIMD instruction set.

#if defined(MOTE_PKD_TREE_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_PKD_TREE_RAYS_INL_H
#undef MOTE_PKD_TREE_RAYS_INL_H
#else
#define MOTE_PKD_TREE_RAYS_INL_H
#endif

#include "../../core/RayPacket.h"
#include "PkdTreeBundle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

using D4 = hn::CappedTag<float, 4>;

/// The rays of a packet in the tree's coordinates, made many at a time: P + tau d, with |d| = 1 and
/// P where the ray enters the bounds.
struct TreeRays
{
  template <typename T>
  using Row = T[RayPacket::capacity];

  alignas(64) float p[RayPacket::capacity][4];       ///< P; the fourth number is 0
  alignas(64) float inverse[RayPacket::capacity][4]; ///< of d, finite; likewise
  alignas(64) Row<float> high[3]; ///< P, to what corners of treelets are multiples of
  alignas(64) Row<float> low[3];  ///< and the rest of it
  alignas(64) Row<float> d[3];
  alignas(64) Row<float> first; ///< hits at tau <= first do not count
  alignas(64) Row<float> best;  ///< tau of the nearest hit so far
  alignas(64) Row<double> t0;   ///< tau of P counted from the ray's own origin
  alignas(64) Row<double> perT; ///< units of tau in one of the ray's t

  bool isAnywhere(int i) const { return best[i] > first[i]; }

  TreeRays(const PkdTreeView& view, const RayPacket& packet)
  {
    alignas(64) Row<float> at3[3];
    alignas(64) Row<float> inverse3[3];
    const DD d;
    const DH h;
    const auto set = [&](double v) { return hn::Set(d, v); };
    const VD perUnit = set(1.0 / view.tree.unit()), one = set(1.0);
    const VD coarse = set(view.coarse), perCoarse = set(1.0 / double(view.coarse));
    for (int i = 0; i < packet.count; i += static_cast<int>(hn::Lanes(d)))
    {
      VD origin[3], way[3], inverses[3], length2 = hn::Zero(d);
      for (int k = 0; k < 3; ++k)
      {
        origin[k] =
          hn::Mul(hn::Sub(hn::Load(d, packet.origin[k] + i), set(view.tree.origin()[k])), perUnit);
        way[k] = hn::Load(d, packet.direction[k] + i);
        length2 = hn::MulAdd(way[k], way[k], length2);
      }
      const VD speed = hn::Sqrt(length2), perSpeed = hn::Div(one, speed);
      const VD toTau = hn::Mul(speed, perUnit);
      VD enter = hn::Mul(hn::Load(d, packet.tMin + i), toTau);
      VD leave = hn::Mul(hn::Load(d, packet.t + i), toTau);
      const VD begin = enter, end = leave;
      for (int k = 0; k < 3; ++k)
      {
        way[k] = hn::Mul(way[k], perSpeed);
        // Never infinite, so that no product with it is without meaning.
        inverses[k] = hn::Div(one, hn::CopySign(hn::Max(hn::Abs(way[k]), set(1e-18)), way[k]));
        const VD a = hn::Mul(hn::Sub(set(view.least[k]), origin[k]), inverses[k]);
        const VD b = hn::Mul(hn::Sub(set(view.most[k]), origin[k]), inverses[k]);
        enter = hn::Max(enter, hn::Min(a, b));
        leave = hn::Min(leave, hn::Max(a, b));
      }
      for (int k = 0; k < 3; ++k)
      {
        const VD at = hn::MulAdd(enter, way[k], origin[k]);
        const VD rough = hn::Mul(hn::Round(hn::Mul(at, perCoarse)), coarse);
        hn::Store(hn::DemoteTo(h, at), h, at3[k] + i);
        hn::Store(hn::DemoteTo(h, rough), h, high[k] + i);
        hn::Store(hn::DemoteTo(h, hn::Sub(at, rough)), h, low[k] + i);
        hn::Store(hn::DemoteTo(h, way[k]), h, this->d[k] + i);
        hn::Store(hn::DemoteTo(h, inverses[k]), h, inverse3[k] + i);
      }
      // A ray that passes by, or has no direction, ends before it begins.
      const auto meets = hn::And(hn::Lt(enter, leave), hn::Gt(length2, hn::Zero(d)));
      const VD last =
        hn::IfThenElse(meets, hn::Sub(end, enter), set(-std::numeric_limits<double>::infinity()));
      hn::Store(hn::DemoteTo(h, hn::Sub(begin, enter)), h, first + i);
      hn::Store(hn::DemoteTo(h, last), h, best + i);
      hn::Store(enter, d, t0 + i);
      hn::Store(toTau, d, perT + i);
    }
    interleave(at3, p, packet.count);
    interleave(inverse3, inverse, packet.count);
  }

private:
  /// Three rows as tuples of four numbers, the last being 0.
  static void interleave(const Row<float>* rows, float (*tuples)[4], int count)
  {
    for (int i = 0; i < count; ++i)
    {
      for (int k = 0; k < 3; ++k)
        tuples[i][k] = rows[k][i];
      tuples[i][3] = 0.0f;
    }
  }
};

/// The children that ray i meets before its end, as bits; `near`, of 16, becomes where it enters
/// them.
HWY_INLINE unsigned childrenMet(
  const PkdTreeView::Node& node, const TreeRays& rays, int i, float* near)
{
  const DF d;
  const D4 d4;
  const hn::Rebind<std::uint32_t, D4> u4;
  const hn::Rebind<std::uint8_t, D4> bytes;
  alignas(16) float perBound[4], base[4];
  for (int k = 0; k < 4; k += static_cast<int>(hn::Lanes(d4)))
  {
    const auto inverse = hn::Load(d4, rays.inverse[i] + k);
    const auto step = hn::BitCast(
      d4, hn::ShiftLeft<23>(hn::PromoteTo(u4, hn::LoadU(bytes, node.exponent.data() + k))));
    hn::Store(hn::Mul(step, inverse), d4, perBound + k);
    const auto from = hn::Sub(hn::LoadU(d4, node.lower.data() + k), hn::Load(d4, rays.p[i] + k));
    hn::Store(hn::Mul(from, inverse), d4, base + k);
  }
  unsigned bits = 0;
  for (int c = 0; c < PkdTree::fanout; c += static_cast<int>(hn::Lanes(d)))
  {
    VF enter = hn::Set(d, rays.first[i]), leave = hn::Set(d, rays.best[i]);
    for (int k = 0; k < 3; ++k)
    {
      const bool forward = rays.inverse[i][k] > 0.0f;
      const std::uint8_t* first = (forward ? node.low : node.high)[k].data() + c;
      const std::uint8_t* last = (forward ? node.high : node.low)[k].data() + c;
      const VF scale = hn::Set(d, perBound[k]), shift = hn::Set(d, base[k]);
      enter = hn::Max(enter, hn::MulAdd(boundsAt(first), scale, shift));
      leave = hn::Min(leave, hn::MulAdd(boundsAt(last), scale, shift));
    }
    hn::StoreU(enter, d, near + c);
    // Children that do not exist have turned bounds on every axis.
    bits |= bitsOf(hn::Le(enter, leave)) << c;
  }
  return bits;
}

/// Spheres of a bucket, from `lane` on, beside a ray: where on it the feet of the perpendiculars
/// from their centres are, and what the perpendiculars leave of r^2. `corner` is the treelet's from
/// the ray's `high`.
HWY_INLINE void spheresBeside(const PkdTreeView& view, std::size_t bucket, int lane,
  const float* corner, const TreeRays& rays, int i, VF& foot, VF& left)
{
  const DF d;
  const Spheres spheres(view, bucket, lane);
  const VF local[3] = {spheres.x, spheres.y, spheres.z};
  VF f[3];
  foot = hn::Zero(d);
  const PkdTreeView::Row* corners = view.cornersOf(bucket);
  for (int k = 0; k < 3; ++k)
  {
    const VF from =
      corners == nullptr
        ? hn::Set(d, corner[k])
        : hn::Sub(hn::Load(d, reinterpret_cast<const float*>(corners[k].words.data()) + lane),
            hn::Set(d, rays.high[k][i]));
    // Both steps round the same for coincident particles, wherever their corners are.
    f[k] = hn::Sub(hn::Add(local[k], from), hn::Set(d, rays.low[k][i]));
    foot = hn::MulAdd(f[k], hn::Set(d, rays.d[k][i]), foot);
  }
  left = hn::Mul(spheres.r, spheres.r);
  for (int k = 0; k < 3; ++k)
  {
    const VF across = hn::NegMulAdd(foot, hn::Set(d, rays.d[k][i]), f[k]);
    left = hn::NegMulAdd(across, across, left);
  }
}

/// The corner of a treelet from the ray's `high`: exact.
HWY_INLINE void cornerFrom(
  const PkdTreeView::Node& treelet, const TreeRays& rays, int i, float* corner)
{
  for (int k = 0; k < 3; ++k)
    corner[k] = treelet.corner[static_cast<std::size_t>(k)] - rays.high[k][i];
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
