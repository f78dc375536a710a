// The traversal itself, included once per SIMD instruction set by CoherentGridCast.cpp.

#if defined(MOTE_COHERENT_GRID_CAST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_COHERENT_GRID_CAST_INL_H
#undef MOTE_COHERENT_GRID_CAST_INL_H
#else
#define MOTE_COHERENT_GRID_CAST_INL_H
#endif

#include "CoherentGridFrustum-inl.h"

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
  alignas(64) float nearest[16]; ///< tau before which nothing of the sphere lies
  unsigned in;                   ///< lanes that may be hit
  unsigned ahead;                ///< those that lie in front of the eye as a whole
};

/// Casts a bundle along the axis K. `Policy` says at compile time what is asked:
/// any: whether anything is hit at all; culls: whether spheres are tested against the frustum
/// first; counts: whether work is counted.
template <int K, typename Policy>
class GridCaster
{
public:
  static constexpr int U = K == 0 ? 1 : 0;
  static constexpr int V = K == 2 ? 1 : 2;
  /// Slices visited at once: rows of cells run along x, and so does this axis if it is the major
  /// one.
  static constexpr int thickness = K == 0 ? 3 : 1;

  GridCaster(const CoherentGridView& view, Pencil& pencil, const RayBundle& bundle,
    std::int32_t object, std::vector<std::uint64_t>& hits, CastCounts* counts)
    : view_(view)
    , p_(pencil)
    , bundle_(bundle)
    , object_(object)
    , hits_(hits)
    , counts_(counts)
  {
  }

  void run(const CoherentGridView::Layer& layer)
  {
    layer_ = layer;
    const float h = layer.cellSize, depth = h * thickness;
    const int slabs = (layer.resolution[K] + thickness - 1) / thickness;
    const double lower = double(layer.lower[K]) - p_.q[K];
    const double front0 = p_.sign > 0.0 ? lower : -(lower + double(depth) * slabs);
    front0_ = static_cast<float>(front0);
    lattice_ = Lattice(layer, p_, U, V);
    if (!narrow(-layer.reach))
      return;
    const auto [enter, leave] = walls_.insideOf(layer, p_, U, V);
    const float first = std::floor((enter - front0_) / depth - 1e-3f);
    const float last = std::ceil((leave - front0_) / depth + 1e-3f);
    const int begin = static_cast<int>(std::clamp(first, 0.0f, static_cast<float>(slabs)));
    const int end = static_cast<int>(std::clamp(last, 0.0f, static_cast<float>(slabs)));
    for (int step = begin; step < end; ++step)
    {
      const float front = front0_ + depth * static_cast<float>(step);
      if (changed_ != 0 && !narrow(front - layer.reach))
        break;
      // Measured along K: comparing with the rays' own distance would visit far more slices.
      if (!(farthestKappa_ > front - layer.reach))
        break;
      const int slab = p_.sign > 0.0 ? step : slabs - 1 - step;
      const int left = stepsLeftInMacrocell(slab, slabs);
      if ((step == begin || left == stepsInMacrocell - 1) &&
          isMacrocellEmpty(slab, front, front + depth * static_cast<float>(left + 1)))
      {
        step += left;
        continue;
      }
      visitSlab(slab, front, front + depth);
      flush();
    }
  }

private:
  static constexpr int stepsInMacrocell = CoherentGrid::macrocellSize / thickness;
  static_assert(CoherentGrid::macrocellSize % thickness == 0);
  static constexpr int bufferSize = 128;

  int stepsLeftInMacrocell(int slab, int slabs) const
  {
    constexpr int m = stepsInMacrocell;
    return p_.sign > 0.0 ? std::min(m - 1 - slab % m, slabs - 1 - slab) : slab % m;
  }

  /// Narrows the frustum to the blocks that can still hit something at kappa > `front`; false where
  /// there is none.
  bool narrow(float front)
  {
    changed_ = 0;
    Spread spread;
    farthest_ = farthestKappa_ = -infinity;
    for (int b = 0; b < p_.blocks; ++b)
    {
      if (!(p_.farthestKappa[b] > front))
        continue;
      spread.add(p_.lowX[b], p_.lowY[b]);
      spread.add(p_.highX[b], p_.highY[b]);
      farthest_ = std::max(farthest_, p_.farthest[b]);
      farthestKappa_ = std::max(farthestKappa_, p_.farthestKappa[b]);
    }
    if (spread.empty())
      return false;
    if (spread != spread_)
    {
      spread_ = spread;
      walls_.set(spread, p_, U, V);
    }
    return true;
  }

  bool isMacrocellEmpty(int slab, float k0, float k1) const
  {
    constexpr int m = CoherentGrid::macrocellSize;
    const CellRanges cells = lattice_.ranges(walls_, k0, k1);
    if (cells.empty())
      return true;
    const Vec3i n = layer_.macroResolution;
    Vec3i c;
    c[K] = slab / stepsInMacrocell;
    for (c[V] = cells.v0 / m; c[V] <= cells.v1 / m; ++c[V])
      for (c[U] = cells.u0 / m; c[U] <= cells.u1 / m; ++c[U])
        if (layer_.macrocellShown[(static_cast<std::size_t>(c.z) * n.y + c.y) * n.x + c.x])
          return false;
    return true;
  }

  void visitSlab(int slab, float k0, float k1)
  {
    const CellRanges cells = lattice_.ranges(walls_, k0, k1);
    if (cells.empty())
      return;
    if constexpr (Policy::counts)
      ++counts_->slices;
    for (int j = cells.v0; j <= cells.v1; ++j)
    {
      if constexpr (K == 2)
        visitCells(j, slab, cells.u0, cells.u1);
      else if constexpr (K == 1)
        visitCells(slab, j, cells.u0, cells.u1);
      else
      {
        const int x0 = slab * thickness;
        const int x1 = std::min(x0 + thickness, layer_.resolution.x) - 1;
        for (int i = cells.u0; i <= cells.u1; ++i)
          visitCells(i, j, x0, x1);
      }
    }
  }

  /// Cells x0 to x1 of the row (y, z): their particles lie one after another.
  HWY_INLINE void visitCells(int y, int z, int x0, int x1)
  {
    const std::size_t row = static_cast<std::size_t>(z) * layer_.resolution.y + y;
    const std::uint32_t* start =
      layer_.cellStart + row * (static_cast<std::size_t>(layer_.resolution.x) + 1);
    const std::uint64_t base = layer_.rowStart[row];
    std::uint64_t slot = base + start[x0];
    const std::uint64_t end = base + start[x1 + 1];
    if constexpr (Policy::counts)
    {
      counts_->cells += static_cast<std::uint64_t>(x1 - x0 + 1);
      counts_->particles += end - slot;
    }
    // Four records at a time; what is copied too much is overwritten by the next row.
    for (; slot < end; slot += 4)
    {
      const float* from = &view_.records[slot].x;
      float* to = buffer_ + 4 * buffered_;
      for (int k = 0; k < 16; k += static_cast<int>(hn::Lanes(DF())))
        hn::StoreU(hn::LoadU(DF(), from + k), DF(), to + k);
      for (int k = 0; k < 4; ++k)
        slots_[buffered_ + k] = slot + k;
      buffered_ += static_cast<int>(std::min<std::uint64_t>(4, end - slot));
      if (buffered_ > bufferSize - 4)
        flush();
    }
  }

  /// Projects the gathered spheres, many at once, and tests those that the frustum overlaps against
  /// the blocks of rays that they overlap.
  void flush()
  {
    const int lanes = static_cast<int>(hn::Lanes(DF()));
    Projected s;
    for (int i = 0; i < buffered_; i += lanes)
    {
      project(i, s);
      for (unsigned bits = s.in; bits != 0; bits &= bits - 1)
      {
        const int j = __builtin_ctz(bits);
        if (!view_.selects || view_.isShown(slots_[i + j]))
          testSphere(s, j, i + j);
      }
      refresh();
    }
    buffered_ = 0;
  }

  HWY_INLINE void project(int i, Projected& s)
  {
    const DF d;
    VF x, y, z, r;
    hn::LoadInterleaved4(d, buffer_ + 4 * i, x, y, z, r);
    const auto set = [&](float v) { return hn::Set(d, v); };
    const auto from = [&](VF c, Split q) { return hn::Sub(hn::Sub(c, set(q.high)), set(q.low)); };
    x = from(x, p_.qx);
    y = from(y, p_.qy);
    z = from(z, p_.qz);
    const auto dot = [&](const Vec3f& g)
    { return hn::MulAdd(x, set(g.x), hn::MulAdd(y, set(g.y), hn::Mul(z, set(g.z)))); };
    const VF tau = dot(p_.gTau), m = dot(p_.gM), n = dot(p_.gN);
    const VF width = hn::MulAdd(tau, set(p_.scaleSlope), set(p_.scale));
    const VF perWidth = hn::Div(set(1.0f), width);
    const VF cx = hn::Mul(m, perWidth), cy = hn::Mul(n, perWidth);
    const VF rWidth = hn::Mul(r, perWidth);
    const VF reachX = hn::Mul(rWidth, set(p_.reachX)), reachY = hn::Mul(rWidth, set(p_.reachY));
    const VF along = hn::Mul(r, set(p_.gLength));
    const VF nearest = hn::Sub(tau, along);
    const auto used = hn::FirstN(d, static_cast<std::size_t>(buffered_ - i));
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
  }

  template <typename Mask>
  static HWY_INLINE unsigned bitsOf(Mask mask)
  {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(DF(), mask, bytes);
    return bytes[0] | (static_cast<unsigned>(bytes[1]) << 8);
  }

  /// Blocks of rays that the sphere in lane j may hide.
  HWY_INLINE unsigned blocksOf(const Projected& s, int j) const
  {
    const DF d;
    const bool ahead = (s.ahead >> j & 1) != 0;
    const VF lowX = hn::Set(d, s.x[j] - s.reachX[j]), highX = hn::Set(d, s.x[j] + s.reachX[j]);
    const VF lowY = hn::Set(d, s.y[j] - s.reachY[j]), highY = hn::Set(d, s.y[j] + s.reachY[j]);
    const VF nearest = hn::Set(d, s.nearest[j]);
    unsigned bits = 0;
    for (int k = 0; k < p_.blocks; k += static_cast<int>(hn::Lanes(d)))
    {
      auto in = hn::Gt(hn::Load(d, p_.farthest + k), nearest);
      if (ahead && Policy::culls)
        in = hn::And(in, hn::And(hn::And(hn::Le(hn::Load(d, p_.lowX + k), highX),
                                   hn::Ge(hn::Load(d, p_.highX + k), lowX)),
                           hn::And(hn::Le(hn::Load(d, p_.lowY + k), highY),
                             hn::Ge(hn::Load(d, p_.highY + k), lowY))));
      bits |= bitsOf(in) << k;
    }
    return bits;
  }

  HWY_INLINE void testSphere(const Projected& s, int j, int buffered)
  {
    const DF d;
    const DU du32;
    const std::uint64_t slot = slots_[buffered];
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
        auto nearer = ahead ? meetAhead(s, j, i, near) : meetAround(buffered, i, near);
        if (hn::AllFalse(d, nearer))
          continue;
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
    return nearerOf(meets, foot, hn::Mul(left, inverse), i, near);
  }

  /// The same for a sphere that reaches behind the eye: by the perpendicular remainder.
  HWY_INLINE Mask meetAround(int buffered, int i, VF& near) const
  {
    const DF d;
    const CoherentGrid::Record& record = *reinterpret_cast<const CoherentGrid::Record*>(
      static_cast<const void*>(buffer_ + 4 * buffered));
    const Vec3d eye = p_.q - p_.t0 * p_.d;
    const Vec3f f(Vec3d(record.x, record.y, record.z) - eye);
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
    VF left = hn::Set(d, record.r * record.r);
    for (int axis = 0; axis < 3; ++axis)
    {
      const VF across = hn::NegMulAdd(foot, along[axis], hn::Set(d, f[axis]));
      left = hn::NegMulAdd(across, across, left);
    }
    const VF fromQ = hn::Sub(foot, hn::Set(d, static_cast<float>(p_.t0)));
    return nearerOf(hn::Ge(left, hn::Zero(d)), fromQ, hn::Mul(left, inverse), i, near);
  }

  HWY_INLINE Mask nearerOf(Mask meets, VF foot, VF half2, int i, VF& near) const
  {
    const DF d;
    const VF half = hn::Sqrt(hn::Max(half2, hn::Zero(d)));
    const VF first = hn::Set(d, p_.first);
    const VF in = hn::Sub(foot, half), out = hn::Add(foot, half);
    near = hn::IfThenElse(hn::Gt(in, first), in, out);
    return hn::And(meets, hn::And(hn::Gt(near, first), hn::Lt(near, hn::Load(d, p_.best + i))));
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

  /// Bounds of the blocks that were hit.
  HWY_INLINE void refresh()
  {
    for (unsigned blocks = stale_; blocks != 0; blocks &= blocks - 1)
      refreshBlock(p_, __builtin_ctz(blocks));
    changed_ |= stale_;
    stale_ = 0;
  }

  const CoherentGridView& view_;
  Pencil& p_;
  const RayBundle& bundle_;
  const std::int32_t object_;
  std::vector<std::uint64_t>& hits_;
  CastCounts* counts_;
  CoherentGridView::Layer layer_;
  Walls walls_;
  Lattice lattice_;
  Spread spread_;
  float front0_ = 0.0f;
  float farthest_ = -infinity, farthestKappa_ = -infinity;
  unsigned changed_ = 0; ///< blocks that were hit since the frustum was last narrowed
  unsigned stale_ = 0;   ///< blocks whose bounds are older than their last hit
  int buffered_ = 0;
  alignas(64) float buffer_[4 * (bufferSize + 16)];
  std::uint64_t slots_[bufferSize + 16];
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
