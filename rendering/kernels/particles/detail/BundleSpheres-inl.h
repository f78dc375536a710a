// Spheres as a bundle of rays sees them, and the test of rays against them, for every structure's
// traversal. Included once per SIMD instruction set.

#if defined(MOTE_BUNDLE_SPHERES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_BUNDLE_SPHERES_INL_H
#undef MOTE_BUNDLE_SPHERES_INL_H
#else
#define MOTE_BUNDLE_SPHERES_INL_H
#endif

#include "BundleWalls-inl.h"
#include "CastCounts.h"

#include <vector>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Up to 16 spheres as a bundle sees them, one in each lane.
struct Projected
{
  alignas(64) float x[16], y[16];           ///< the ray through the centre
  alignas(64) float reachX[16], reachY[16]; ///< half the extent in x and y
  alignas(64) float a[16], b[16], c[16];    ///< squared distance: a dx^2 + b dx dy + c dy^2
  alignas(64) float tau[16], width[16], r2[16];
  alignas(64) float fromQ[3][16]; ///< the centre; where a sphere reaches behind the eye
  alignas(64) float tie[16];      ///< hits nearer to one another than this may be equal
  alignas(64) float nearest[16];  ///< tau before which nothing of the sphere lies
  unsigned in;                    ///< lanes that may be hit
  unsigned ahead;                 ///< those that lie in front of the eye as a whole
};

/// A rectangle around a ray, and tau before which there is nothing.
struct PicturePart
{
  float x, y, reachX, reachY, nearest;
};

struct NearestPolicy
{
  static constexpr bool any = false, culls = true, counts = false, lods = false;
};
struct AnyPolicy : NearestPolicy
{
  static constexpr bool any = true;
};

/// What the centres of spheres count from, relative to Q: the same for all.
struct OneBase
{
  Vec3d fromQ;

  VF along(int axis) const { return hn::Set(DF(), static_cast<float>(fromQ[axis])); }
  VF dot(const Vec3d& v) const { return hn::Set(DF(), static_cast<float>(glm::dot(v, fromQ))); }
};

/// The same with one base for each sphere.
struct BaseEach
{
  alignas(64) double fromQ[3][16];

  /// From Q to `bases`, three rows of them.
  BaseEach(const Vec3d& q, const float* const bases[3])
  {
    const DD d;
    const DH h;
    for (int k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < hn::Lanes(DF()); i += hn::Lanes(d))
        hn::Store(
          hn::Sub(hn::PromoteTo(d, hn::Load(h, bases[k] + i)), hn::Set(d, q[k])), d, fromQ[k] + i);
  }

  template <typename Value>
  HWY_INLINE VF each(const Value& value) const
  {
    const DD d;
    alignas(64) float rounded[16];
    for (std::size_t i = 0; i < hn::Lanes(DF()); i += hn::Lanes(d))
      hn::Store(hn::DemoteTo(DH(), value(i)), DH(), rounded + i);
    return hn::Load(DF(), rounded);
  }
  VF along(int axis) const
  {
    return each([&](std::size_t i) { return hn::Load(DD(), fromQ[axis] + i); });
  }
  VF dot(const Vec3d& v) const
  {
    const DD d;
    return each(
      [&](std::size_t i)
      {
        const auto part = [&](int k, VD sum)
        { return hn::MulAdd(hn::Load(d, fromQ[k] + i), hn::Set(d, v[k]), sum); };
        return part(2, part(1, part(0, hn::Zero(d))));
      });
  }
};

/// Tests spheres against the rays of a bundle. `Policy` says at compile time what is asked:
/// any: whether anything is hit at all; culls: whether spheres are tested against the frustum
/// first; counts: whether work is counted. `Structure` is asked which of equally near hits counts:
/// coincide(a, b) says whether the particles at two slots are the same sphere, takesTie(a, b)
/// whether then slot a goes before slot b, which was met earlier.
template <typename Policy, typename Structure>
class SphereTester
{
public:
  SphereTester(const Structure& structure, Pencil& pencil, const RayBundle& bundle,
    std::int32_t object, std::vector<std::uint64_t>& hits, CastCounts* counts)
    : structure_(structure)
    , p_(pencil)
    , bundle_(bundle)
    , object_(object)
    , hits_(hits)
    , counts_(counts)
  {
  }

  const Walls& walls() const { return walls_; }
  float farthestKappa() const { return farthestKappa_; }
  bool changed() const { return changed_ != 0; }

  /// Narrows the frustum to the blocks that can still hit something at kappa > `front`; false where
  /// there is none.
  bool narrow(float front, int U, int V)
  {
    const DF d;
    const VF most = hn::Set(d, infinity), least = hn::Set(d, -infinity);
    VF lowX = most, lowY = most, highX = least, highY = least, farthest = least, kappa = least;
    for (int b = 0; b < p_.blocks; b += static_cast<int>(hn::Lanes(d)))
    {
      // Blocks that are not there are dead.
      const VF own = hn::Load(d, p_.farthestKappa + b);
      const auto alive = hn::Gt(own, hn::Set(d, front));
      const auto of = [&](const float* v, VF otherwise)
      { return hn::IfThenElse(alive, hn::Load(d, v + b), otherwise); };
      lowX = hn::Min(lowX, of(p_.lowX, most));
      lowY = hn::Min(lowY, of(p_.lowY, most));
      highX = hn::Max(highX, of(p_.highX, least));
      highY = hn::Max(highY, of(p_.highY, least));
      farthest = hn::Max(farthest, of(p_.farthest, least));
      kappa = hn::Max(kappa, hn::IfThenElse(alive, own, least));
    }
    const auto leastOf = [d](VF v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
    const auto mostOf = [d](VF v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
    changed_ = 0;
    farthest_ = mostOf(farthest);
    farthestKappa_ = mostOf(kappa);
    const Spread spread{leastOf(lowX), mostOf(highX), leastOf(lowY), mostOf(highY)};
    if (spread.empty())
      return false;
    if (spread != spread_)
    {
      spread_ = spread;
      walls_.set(spread, p_, U, V);
    }
    return true;
  }

  /// Projects a vector of spheres, their centres given from a base that is `fromQ` from Q; of
  /// `used` lanes.
  template <typename Used>
  HWY_INLINE void project(const Vec3d& fromQ, VF x, VF y, VF z, VF r, Used used, Projected& s)
  {
    projectFrom(OneBase{fromQ}, x, y, z, r, used, s);
  }

  /// The same from any base. What it makes of tau, m and n is found in double: the rest is small,
  /// and so is its error.
  template <typename Base, typename Used>
  HWY_INLINE void projectFrom(const Base& base, VF x, VF y, VF z, VF r, Used used, Projected& s)
  {
    const DF d;
    const auto set = [&](float v) { return hn::Set(d, v); };
    const auto dot = [&](const Vec3f& g, const Vec3d& exact)
    {
      const VF start = base.dot(exact);
      return hn::MulAdd(x, set(g.x), hn::MulAdd(y, set(g.y), hn::MulAdd(z, set(g.z), start)));
    };
    const VF tau = dot(p_.gTau, p_.dTau), m = dot(p_.gM, p_.dM), n = dot(p_.gN, p_.dN);
    const VF width = hn::MulAdd(tau, set(p_.scaleSlope), set(p_.scale));
    const VF perWidth = hn::Div(set(1.0f), width);
    const VF cx = hn::Mul(m, perWidth), cy = hn::Mul(n, perWidth);
    const VF rWidth = hn::Mul(r, perWidth);
    const VF reachX = hn::Mul(rWidth, set(p_.reachX)), reachY = hn::Mul(rWidth, set(p_.reachY));
    const VF along = hn::Mul(r, set(p_.gLength));
    const VF nearest = hn::Sub(tau, along);
    auto in = hn::And(
      used, hn::And(hn::Lt(nearest, set(farthest_)), hn::Gt(hn::Add(tau, along), set(p_.first))));
    const auto inX = hn::And(hn::Ge(hn::Add(cx, reachX), set(spread_.lowX)),
      hn::Le(hn::Sub(cx, reachX), set(spread_.highX)));
    const auto inY = hn::And(hn::Ge(hn::Add(cy, reachY), set(spread_.lowY)),
      hn::Le(hn::Sub(cy, reachY), set(spread_.highY)));
    // What reaches behind the eye has no such place in the picture.
    const auto ahead = hn::Gt(nearest, set(p_.common ? static_cast<float>(-p_.t0) : -infinity));
    if constexpr (Policy::culls)
      in = hn::And(in, hn::Or(hn::Not(ahead), hn::And(inX, inY)));
    s.in = bitsOf(in);
    if constexpr (Policy::counts)
      counts_->inFrustum += static_cast<unsigned>(__builtin_popcount(s.in));
    if (s.in == 0)
      return;
    s.ahead = bitsOf(ahead);
    if (HWY_UNLIKELY((s.in & ~s.ahead) != 0))
    {
      hn::Store(hn::Add(x, base.along(0)), d, s.fromQ[0]);
      hn::Store(hn::Add(y, base.along(1)), d, s.fromQ[1]);
      hn::Store(hn::Add(z, base.along(2)), d, s.fromQ[2]);
    }
    const VF w2 = hn::Mul(width, width);
    const VF two = set(2.0f), zz = set(p_.zz), xz = set(p_.xz), yz = set(p_.yz);
    // (X + cy Z)^2, 2 (X + cy Z)(Y - cx Z) and (Y - cx Z)^2, with X = wx x d, Y = wy x d, Z = wx x
    // dy
    const VF xPart = hn::MulAdd(cy, zz, xz), yPart = hn::NegMulAdd(cx, zz, yz);
    const VF a = hn::MulAdd(cy, hn::Add(xPart, xz), set(p_.xx));
    const VF c = hn::NegMulAdd(cx, hn::Add(yPart, yz), set(p_.yy));
    const VF b = hn::MulAdd(cy, yPart, hn::NegMulAdd(cx, xz, set(p_.xy)));
    hn::Store(cx, d, s.x);
    hn::Store(cy, d, s.y);
    hn::Store(reachX, d, s.reachX);
    hn::Store(reachY, d, s.reachY);
    hn::Store(hn::Mul(a, w2), d, s.a);
    hn::Store(hn::Mul(hn::Mul(two, b), w2), d, s.b);
    hn::Store(hn::Mul(c, w2), d, s.c);
    hn::Store(tau, d, s.tau);
    hn::Store(width, d, s.width);
    hn::Store(hn::Mul(r, r), d, s.r2);
    hn::Store(nearest, d, s.nearest);
    hn::Store(hn::Mul(r, set(tieShare)), d, s.tie);
  }

  /// Tests the sphere in lane j, the particle at `slot`.
  HWY_INLINE void test(const Projected& s, int j, std::uint64_t slot)
  {
    const DF d;
    const DU du32;
    const auto mark = hn::Set(du32, static_cast<std::uint32_t>(hits_.size()));
    const bool ahead = (s.ahead >> j & 1) != 0;
    unsigned changed = 0;
    for (unsigned blocks = blocksOf(s, j); blocks != 0; blocks &= blocks - 1)
    {
      const int block = __builtin_ctz(blocks);
      if constexpr (Policy::counts)
        ++counts_->tests;
      for (int k = 0; k < blockRays; k += static_cast<int>(hn::Lanes(d)))
      {
        const int i = blockRays * block + k;
        VF near;
        auto nearer = ahead ? meetAhead(s, j, i, near) : meetAround(s, j, i, near);
        if (hn::AllFalse(d, nearer))
          continue;
        if constexpr (!Policy::any && Structure::hasTies)
          nearer = withTies(nearer, near, s.tie[j], i, slot);
        if constexpr (Policy::any)
          nearer = withoutOwn(nearer, i, slot);
        const VF kept = Policy::any ? hn::Set(d, -infinity) : near;
        hn::Store(hn::IfThenElse(nearer, kept, hn::Load(d, p_.best + i)), d, p_.best + i);
        const auto old = hn::Load(du32, p_.hit + i);
        hn::Store(hn::IfThenElse(hn::RebindMask(du32, nearer), mark, old), du32, p_.hit + i);
        changed |= 1u << block;
      }
    }
    stale_ |= changed;
    if constexpr (!Policy::any)
      if (changed != 0)
        hits_.push_back(slot);
    if constexpr (Policy::counts)
      counts_->hits += changed != 0;
  }

  /// Tests something that is no sphere, in parts of a picture and from a tau on, `slot` being its
  /// own: meet(i) answers where rays i and on meet it, infinity where they do not.
  template <typename Meet>
  HWY_INLINE void testOther(const PicturePart& part, std::uint64_t slot, const Meet& meet)
  {
    const DF d;
    const DU du32;
    const auto mark = hn::Set(du32, static_cast<std::uint32_t>(hits_.size()));
    unsigned changed = 0; // blocks
    for (unsigned blocks = blocksWithin(part, true); blocks != 0; blocks &= blocks - 1)
    {
      const int block = __builtin_ctz(blocks);
      for (int k = 0; k < blockRays; k += static_cast<int>(hn::Lanes(d)))
      {
        const int i = blockRays * block + k;
        const VF near = meet(i), best = hn::Load(d, p_.best + i);
        const auto nearer = hn::Lt(near, best);
        hn::Store(hn::Min(near, best), d, p_.best + i);
        const auto old = hn::Load(du32, p_.hit + i);
        hn::Store(hn::IfThenElse(hn::RebindMask(du32, nearer), mark, old), du32, p_.hit + i);
        changed |= static_cast<unsigned>(!hn::AllFalse(d, nearer)) << block;
      }
    }
    stale_ |= changed;
    if (changed != 0)
      hits_.push_back(slot);
  }

  /// Bounds of the blocks that were hit.
  HWY_INLINE void refresh()
  {
    for (unsigned blocks = stale_; blocks != 0; blocks &= blocks - 1)
      refreshBlock(p_, __builtin_ctz(blocks));
    changed_ |= stale_;
    stale_ = 0;
  }

private:
  /// Blocks of rays that the sphere in lane j may hide.
  HWY_INLINE unsigned blocksOf(const Projected& s, int j) const
  {
    const bool ahead = (s.ahead >> j & 1) != 0;
    return blocksWithin({s.x[j], s.y[j], s.reachX[j], s.reachY[j], s.nearest[j]}, ahead);
  }

  /// Blocks of rays to which a part of the picture may matter, or, not `placed`, all that are not
  /// nearer.
  HWY_INLINE unsigned blocksWithin(const PicturePart& part, bool placed) const
  {
    const DF d;
    const VF lowX = hn::Set(d, part.x - part.reachX), highX = hn::Set(d, part.x + part.reachX);
    const VF lowY = hn::Set(d, part.y - part.reachY), highY = hn::Set(d, part.y + part.reachY);
    const VF nearest = hn::Set(d, part.nearest);
    unsigned bits = 0;
    for (int k = 0; k < p_.blocks; k += static_cast<int>(hn::Lanes(d)))
    {
      auto in = hn::Gt(hn::Load(d, p_.farthest + k), nearest);
      if (placed && Policy::culls)
        in = hn::And(in, hn::And(hn::And(hn::Le(hn::Load(d, p_.lowX + k), highX),
                                   hn::Ge(hn::Load(d, p_.highX + k), lowX)),
                           hn::And(hn::Le(hn::Load(d, p_.lowY + k), highY),
                             hn::Ge(hn::Load(d, p_.highY + k), lowY))));
      bits |= bitsOf(in) << k;
    }
    return bits;
  }

  using Mask = hn::Mask<DF>;

  /// Where rays i and on meet the sphere in lane j nearer than anything so far, given in `near`.
  ///
  /// The stable form: squared distance of the centre from the ray as a form in the ray's distance
  /// from the centre's own ray, never as a difference of squared distances to the origin.
  HWY_INLINE Mask meetAhead(const Projected& s, int j, int i, VF& near) const
  {
    const DF d;
    const VF dx = hn::Sub(hn::Load(d, p_.x + i), hn::Set(d, s.x[j]));
    const VF dy = hn::Sub(hn::Load(d, p_.y + i), hn::Set(d, s.y[j]));
    const VF inverse = hn::Load(d, p_.inverse + i);
    const VF part = hn::MulAdd(dx, hn::Set(d, s.a[j]), hn::Mul(dy, hn::Set(d, s.b[j])));
    const VF distance2 = hn::MulAdd(part, dx, hn::Mul(hn::Mul(dy, dy), hn::Set(d, s.c[j])));
    const VF left = hn::NegMulAdd(distance2, inverse, hn::Set(d, s.r2[j]));
    const auto meets = hn::Ge(left, hn::Zero(d));
    if (hn::AllFalse(d, meets))
      return meets;
    const VF shift =
      hn::MulAdd(dx, hn::Load(d, p_.shiftX + i), hn::Mul(dy, hn::Load(d, p_.shiftY + i)));
    const VF foot = hn::NegMulAdd(shift, hn::Set(d, s.width[j]), hn::Set(d, s.tau[j]));
    return nearerOf(meets, foot, hn::Mul(left, inverse), s.tie[j], i, near);
  }

  /// The same for a sphere that reaches behind the eye: by the perpendicular remainder.
  HWY_INLINE Mask meetAround(const Projected& s, int j, int i, VF& near) const
  {
    const DF d;
    const Vec3f f(Vec3d(s.fromQ[0][j], s.fromQ[1][j], s.fromQ[2][j]) + p_.t0 * p_.d);
    const Vec3f direction(p_.d), dx(p_.dx), dy(p_.dy);
    const VF x = hn::Load(d, p_.x + i), y = hn::Load(d, p_.y + i);
    const VF inverse = hn::Load(d, p_.inverse + i);
    VF along[3], product = hn::Zero(d);
    for (int axis = 0; axis < 3; ++axis)
    {
      along[axis] = hn::MulAdd(
        x, hn::Set(d, dx[axis]), hn::MulAdd(y, hn::Set(d, dy[axis]), hn::Set(d, direction[axis])));
      product = hn::MulAdd(along[axis], hn::Set(d, f[axis]), product);
    }
    const VF foot = hn::Mul(product, inverse);
    VF left = hn::Set(d, s.r2[j]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const VF across = hn::NegMulAdd(foot, along[axis], hn::Set(d, f[axis]));
      left = hn::NegMulAdd(across, across, left);
    }
    const VF fromQ = hn::Sub(foot, hn::Set(d, static_cast<float>(p_.t0)));
    return nearerOf(hn::Ge(left, hn::Zero(d)), fromQ, hn::Mul(left, inverse), s.tie[j], i, near);
  }

  HWY_INLINE Mask nearerOf(Mask meets, VF foot, VF half2, float tie, int i, VF& near) const
  {
    const DF d;
    const VF half = hn::Sqrt(hn::Max(half2, hn::Zero(d)));
    const VF first = hn::Set(d, p_.first);
    const VF in = hn::Sub(foot, half), out = hn::Add(foot, half);
    near = hn::IfThenElse(hn::Gt(in, first), in, out);
    const VF best = hn::Load(d, p_.best + i);
    VF limit = best;
    if constexpr (Structure::hasTies && !Policy::any)
      limit = hn::Add(best, hn::Set(d, tie));
    const auto nearer = hn::Lt(near, limit);
    return hn::And(meets, hn::And(hn::Gt(near, first), nearer));
  }

  /// The lanes among `nearer` whose ray does not end on the particle itself.
  HWY_INLINE Mask withoutOwn(Mask nearer, int i, std::uint64_t slot) const
  {
    const DF d;
    alignas(64) float keep[16];
    for (int k = 0; k < static_cast<int>(hn::Lanes(d)); ++k)
      keep[k] =
        i + k < bundle_.count && bundle_.slot[i + k] == slot && bundle_.object[i + k] == object_
          ? 0.0f
          : 1.0f;
    return hn::And(nearer, hn::Gt(hn::Load(d, keep), hn::Zero(d)));
  }

  /// Of the lanes of `hits`, which may be a little behind the hit so far, those that count.
  /// Particles that coincide are told by their places, for their hits may differ by rounding.
  HWY_INLINE Mask withTies(Mask hits, VF near, float tie, int i, std::uint64_t slot) const
  {
    const DF d;
    const VF best = hn::Load(d, p_.best + i);
    const auto nearer = hn::Lt(near, best);
    const auto close = hn::And(hits, hn::Le(hn::Abs(hn::Sub(near, best)), hn::Set(d, tie)));
    if (HWY_LIKELY(hn::AllFalse(d, close)))
      return hn::And(hits, nearer);
    alignas(64) float keep[16];
    const unsigned bits = bitsOf(close);
    for (int k = 0; k < static_cast<int>(hn::Lanes(d)); ++k)
    {
      const std::uint32_t hit = p_.hit[i + k];
      const bool same = (bits >> k & 1) != 0 && hit != 0 && structure_.coincide(slot, hits_[hit]);
      keep[k] = !same ? 0.5f : structure_.takesTie(slot, hits_[hit]) ? 1.0f : 0.0f;
    }
    const VF kept = hn::Load(d, keep);
    const auto known = hn::Ne(kept, hn::Set(d, 0.5f));
    const auto wins = hn::Gt(kept, hn::Set(d, 0.75f));
    return hn::And(hits, hn::Or(wins, hn::AndNot(known, nearer)));
  }

  /// Of a radius: near the rim a hit's place is much less certain than the sphere's.
  static constexpr float tieShare = 0.01f;

  const Structure& structure_;
  Pencil& p_;
  const RayBundle& bundle_;
  const std::int32_t object_;
  std::vector<std::uint64_t>& hits_;
  CastCounts* counts_;
  Walls walls_;
  Spread spread_;
  float farthest_ = -infinity, farthestKappa_ = -infinity;
  unsigned changed_ = 0; ///< blocks that were hit since the frustum was last narrowed
  unsigned stale_ = 0;   ///< blocks whose bounds are older than their last hit
};

/// Writes what was found back to the rays. hits[0] belongs to rays that met nothing.
template <typename Policy>
void keepAnswers(const Pencil& p, const std::uint64_t* hits, std::int32_t object, RayBundle& bundle)
{
  const DF d;
  const DU du;
  const DD dd;
  const DH dh;
  const hn::Rebind<std::int32_t, DF> di;
  const hn::Rebind<std::uint64_t, DD> du64;
  const hn::Rebind<std::int64_t, DD> di64;
  const hn::Rebind<std::uint32_t, DD> duh;
  const VD t0 = hn::Set(dd, p.t0), perTau = hn::Set(dd, 1.0 / p.perT);
  for (int i = 0; i < blockRays * p.blocks; i += static_cast<int>(hn::Lanes(dd)))
  {
    const auto place = hn::PromoteTo(du64, hn::Load(duh, p.hit + i));
    const auto hit = hn::Ne(place, hn::Zero(du64));
    const VD best = hn::PromoteTo(dd, hn::Load(dh, p.best + i));
    const VD t = Policy::any ? hn::Set(dd, -std::numeric_limits<double>::infinity())
                             : hn::Mul(hn::Add(t0, best), perTau);
    const VD old = hn::Load(dd, bundle.t + i);
    hn::Store(hn::IfThenElse(hn::RebindMask(dd, hit), t, old), dd, bundle.t + i);
    if constexpr (Policy::any)
      continue;
    const auto slot = hn::GatherIndex(du64, hits, hn::BitCast(di64, place));
    hn::Store(hn::IfThenElse(hit, slot, hn::Load(du64, bundle.slot + i)), du64, bundle.slot + i);
  }
  if constexpr (Policy::any)
    return;
  const auto own = hn::Set(di, object);
  for (int i = 0; i < blockRays * p.blocks; i += static_cast<int>(hn::Lanes(d)))
  {
    const auto hit = hn::RebindMask(di, hn::Ne(hn::Load(du, p.hit + i), hn::Zero(du)));
    hn::Store(hn::IfThenElse(hit, own, hn::Load(di, bundle.object + i)), di, bundle.object + i);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
