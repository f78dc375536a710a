// The scalar half-way through a cell. To be included by CellWalkSimd.cpp, once for every
// instruction set.

#if defined(MOTE_WALK_BENDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_BENDS_INL
#undef MOTE_WALK_BENDS_INL
#else
#define MOTE_WALK_BENDS_INL
#endif

#include "WalkLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

/// A cell's own coordinates of a place on each face: of its first corner, and what u and v add.
struct FaceAxes
{
  alignas(64) float from[3][16], u[3][16], v[3][16];
};
constexpr FaceAxes makeFaceAxes()
{
  constexpr std::uint8_t at[8][3] = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  FaceAxes axes{};
  for (std::size_t f = 0; f < 6; ++f)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint8_t(&corners)[4] = faceCorners[f];
      const float from = at[corners[0]][k];
      axes.from[k][f] = from;
      axes.u[k][f] = static_cast<float>(at[corners[1]][k]) - from;
      axes.v[k][f] = static_cast<float>(at[corners[3]][k]) - from;
    }
  return axes;
}
constexpr FaceAxes faceAxes = makeFaceAxes();

HWY_INLINE V pickOf16(const float (&table)[16], VI index)
{
#if HWY_TARGET <= HWY_AVX3
  return wide::pick(hn::Load(D(), table), index);
#else
  return hn::GatherIndex(D(), table, index);
#endif
}
/// A coordinate of a place on faces.
HWY_INLINE V placeOn(VI face, std::size_t k, V u, V v)
{
  const V near = hn::MulAdd(u, pickOf16(faceAxes.u[k], face), pickOf16(faceAxes.from[k], face));
  return hn::MulAdd(v, pickOf16(faceAxes.v[k], face), near);
}

/// A trilinear number at (r, s, t), and its derivatives.
struct Trilinear
{
  V at, r, s, t;

  HWY_INLINE Trilinear(const V (&c)[8], V pr, V ps, V pt)
  {
    const V d0 = hn::Sub(c[1], c[0]), d1 = hn::Sub(c[2], c[3]);
    const V d2 = hn::Sub(c[5], c[4]), d3 = hn::Sub(c[6], c[7]);
    const V a0 = hn::MulAdd(pr, d0, c[0]), a1 = hn::MulAdd(pr, d1, c[3]);
    const V a2 = hn::MulAdd(pr, d2, c[4]), a3 = hn::MulAdd(pr, d3, c[7]);
    const V low = hn::Sub(a1, a0), high = hn::Sub(a3, a2);
    const V b0 = hn::MulAdd(ps, low, a0), b1 = hn::MulAdd(ps, high, a2);
    t = hn::Sub(b1, b0);
    at = hn::MulAdd(pt, t, b0);
    s = hn::MulAdd(pt, hn::Sub(high, low), low);
    const V e0 = hn::MulAdd(ps, hn::Sub(d1, d0), d0), e1 = hn::MulAdd(ps, hn::Sub(d3, d2), d2);
    r = hn::MulAdd(pt, hn::Sub(e1, e0), e0);
  }
};

HWY_INLINE V determinant(V ax, V ay, V az, V bx, V by, V bz, V cx, V cy, V cz)
{
  const V x = hn::MulSub(by, cz, hn::Mul(bz, cy)), y = hn::MulSub(bz, cx, hn::Mul(bx, cz));
  const V z = hn::MulSub(bx, cy, hn::Mul(by, cx));
  return hn::MulAdd(ax, x, hn::MulAdd(ay, y, hn::Mul(az, z)));
}

/// One step of Newton's method in cells of which the corners are about the rays: from (r, s, t) to
/// where a ray is at the depth `wanted`.
struct CellStep
{
  V dr, ds, dt; ///< the step
  V value;      ///< of the scalar behind it
  V slope;      ///< of the scalar, for one of depth along the ray

  HWY_INLINE CellStep(
    const V (&x)[8], const V (&y)[8], const V (&z)[8], const V (&v)[8], V r, V s, V t, V wanted)
  {
    const Trilinear px(x, r, s, t), py(y, r, s, t), pz(z, r, s, t), pv(v, r, s, t);
    const V ex = hn::Neg(px.at), ey = hn::Neg(py.at), ez = hn::Sub(wanted, pz.at);
    const V per =
      hn::Div(set(1.0f), determinant(px.r, px.s, px.t, py.r, py.s, py.t, pz.r, pz.s, pz.t));
    dr = hn::Mul(per, determinant(ex, px.s, px.t, ey, py.s, py.t, ez, pz.s, pz.t));
    ds = hn::Mul(per, determinant(px.r, ex, px.t, py.r, ey, py.t, pz.r, ez, pz.t));
    dt = hn::Mul(per, determinant(px.r, px.s, ex, py.r, py.s, ey, pz.r, pz.s, ez));
    value = hn::MulAdd(dr, pv.r, hn::MulAdd(ds, pv.s, hn::MulAdd(dt, pv.t, pv.at)));
    const V sr = hn::MulSub(px.s, py.t, hn::Mul(px.t, py.s));
    const V ss = hn::MulSub(px.t, py.r, hn::Mul(px.r, py.t));
    const V st = hn::MulSub(px.r, py.s, hn::Mul(px.s, py.r));
    slope = hn::Mul(per, hn::MulAdd(sr, pv.r, hn::MulAdd(ss, pv.s, hn::Mul(st, pv.t))));
  }
  HWY_INLINE V size() const { return hn::Max(hn::Max(hn::Abs(dr), hn::Abs(ds)), hn::Abs(dt)); }
};

/// Finds the scalar in the middle of rays' ways through their cells: by one step of Newton's method
/// from half-way between the places on the two faces, in the cell's own coordinates, which would be
/// it in a cell without warps.
template <int axis>
class WalkBends
{
public:
  WalkBends(const WalkTask& task, Lanes& lanesOfTask)
    : task_(task)
    , l_(lanesOfTask)
  {
  }

  static constexpr std::size_t fineLines = 16;

  /// Of the lanes `which`, gives those that are as good as lines, and those for which two, four, or
  /// fineLines lines are good enough; for the latter three finds l.quarter, for fineAt() the
  /// way in the cell's own coordinates.
  struct Good
  {
    std::uint32_t line = 0, two = 0, four = 0, fine = 0;
  };
  HWY_INLINE Good find(std::uint32_t which)
  {
    Good good;
    Some some, bent; // lanes that bend are few: they are put side by side
    forLanes(which,
      [&](std::size_t k)
      {
        if (l_.inFace[k] >= noFace)
          return;
        some.add(k);
        good.line |= 1U << k;
        if (some.count == some.most)
          enter(some, bent, good);
      });
    if (some.count > 0)
      enter(some, bent, good);
    if (bent.count > 0)
      step(bent, good);
    return good;
  }

  /// Finds the scalar of lane k at fineLines even places behind the entry, the last one the exit.
  /// False where that fails.
  HWY_INLINE bool fineAt(std::size_t k, float (&values)[fineLines]) const
  {
    const D d;
    V x[8], y[8], z[8], v[8];
    for (std::size_t i = 0; i < 8; ++i)
    {
      const float* p = cornerOf(k, i);
      x[i] = set(p[(axis + 1) % 3] - l_.x[k] - l_.dx[k] * p[axis]);
      y[i] = set(p[(axis + 2) % 3] - l_.y[k] - l_.dy[k] * p[axis]);
      z[i] = set(p[axis]);
      v[i] = set(p[3]);
    }
    const float sign = task_.isBackwards ? -1.0f : 1.0f, in = sign * l_.z[k];
    const V depth = set(sign * (l_.outZ[k] - l_.z[k])), one = set(1.0f);
    std::uint32_t isNear = ~0U;
    for (std::size_t first = 0; first < fineLines; first += hn::Lanes(d))
    {
      const V u = hn::Mul(hn::Iota(d, static_cast<float>(first + 1)), set(1.0f / fineLines));
      const V hump = hn::Mul(hn::Mul(set(4.0f), u), hn::Sub(one, u));
      V own[3]; // a parabola through the ends and the middle
      for (std::size_t i = 0; i < 3; ++i)
        own[i] = hn::MulAdd(hump, set(l_.step[i][k]),
          hn::MulAdd(hn::Sub(hn::Add(u, u), one), set(l_.way[i][k]), set(l_.mid[i][k])));
      const CellStep step(x, y, z, v, own[0], own[1], own[2], hn::MulAdd(u, depth, set(in)));
      isNear &= maskOf(hn::Lt(step.size(), set(0.1f)));
      hn::Store(step.value, d, values + first);
    }
    values[fineLines - 1] = l_.partOut[k];
    return (~isNear & ((1U << hn::Lanes(d)) - 1)) == 0;
  }

private:
  /// Lanes, no more than a vector has.
  struct Some
  {
    static constexpr std::size_t most = hn::MaxLanes(D());
    std::size_t count = 0;
    alignas(64) std::int32_t lane[most]{};
    /// Half-way in the cell's own coordinates, what goes from there to the exit; and the step that
    /// Newton's method takes half-way.
    alignas(64) float mid[3][most]{}, way[3][most]{}, step[3][most]{};

    void add(std::size_t k) { lane[count++] = static_cast<std::int32_t>(k); }
    /// Lets numbers behind the last stand for some lane.
    void fill() { std::fill(lane + count, lane + most, lane[0]); }
    std::size_t operator[](std::size_t i) const { return static_cast<std::size_t>(lane[i]); }
    HWY_INLINE V of(const Floats& numbers) const
    {
      const D d;
      const VI at = hn::Load(DI(), lane);
#if HWY_TARGET <= HWY_AVX3
      return wide::pick(hn::Load(d, numbers), hn::Load(d, numbers + lanes / 2), at);
#else
      return hn::GatherIndex(d, numbers, at);
#endif
    }
    HWY_INLINE VI of(const std::uint32_t (&numbers)[lanes]) const
    {
      return hn::BitCast(DI(), of(reinterpret_cast<const Floats&>(numbers)));
    }
  };

  /// Points about the rays of lanes: the first two of three coordinates in the order of WalkRays.
  static HWY_INLINE void place(const Lanes& l, const Some& some, const V (&p)[4], V& x, V& y)
  {
    x = hn::Sub(hn::Sub(p[(axis + 1) % 3], some.of(l.x)), hn::Mul(some.of(l.dx), p[axis]));
    y = hn::Sub(hn::Sub(p[(axis + 2) % 3], some.of(l.y)), hn::Mul(some.of(l.dy), p[axis]));
  }
  HWY_INLINE const float* cornerOf(std::size_t k, std::size_t i) const
  {
    return &task_.cells->points()[task_.cells->mesh().cell(l_.cell[k])[i]].x;
  }

  /// Finds where the rays come into their cells, and from where to where they run in the cells' own
  /// coordinates. Puts those that bend too much into `bent`, and takes them from the lines.
  HWY_INLINE void enter(Some& some, Some& bent, Good& good)
  {
    const D d;
    some.fill();
    FaceCorners c;
    for (std::size_t i = 0; i < 4; ++i)
    {
      V p[4];
      loadFours(
        [&](std::size_t j) { return cornerOf(some[j], faceCorners[l_.inFace[some[j]]][i]); }, p);
      place(l_, some, p, c.x[i], c.y[i]);
    }
    const PatchPlace place = passPatch(c.x, c.y, !task_.isBackwards);
    const VI in = some.of(l_.inFace), out = some.of(l_.outFace);
    V way[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const V from = placeOn(in, i, place.u, place.v);
      const V to = placeOn(out, i, some.of(l_.outU), some.of(l_.outV));
      const V half = hn::Mul(set(0.5f), hn::Sub(to, from));
      way[i] = hn::Abs(hn::Sub(to, from));
      hn::Store(hn::Add(from, half), d, some.mid[i]);
      hn::Store(half, d, some.way[i]);
    }
    // Bends go with the mixed derivatives: with products of two of the three ways.
    const V share =
      hn::Max(hn::Max(hn::Mul(way[0], way[1]), hn::Mul(way[1], way[2])), hn::Mul(way[2], way[0]));
    const V error = hn::Mul(
      hn::Mul(some.of(l_.bend), share), hn::Mul(some.of(l_.rate), some.of(l_.transmittance)));
    const std::uint32_t bends = maskOf(hn::Not(hn::Lt(error, set(task_.allowedShare)))); // NaN too
    forLanes(bends & ((1U << some.count) - 1),
      [&](std::size_t j)
      {
        for (std::size_t i = 0; i < 3; ++i)
        {
          bent.mid[i][bent.count] = some.mid[i][j];
          bent.way[i][bent.count] = some.way[i][j];
        }
        bent.add(some[j]);
        good.line &= ~(1U << some[j]);
        if (bent.count == bent.most)
          step(bent, good);
      });
    some.count = 0;
  }

  HWY_INLINE void step(Some& some, Good& good)
  {
    const D d;
    some.fill();
    V x[8], y[8], z[8], v[8];
    for (std::size_t i = 0; i < 8; ++i)
    {
      V p[4];
      loadFours([&](std::size_t j) { return cornerOf(some[j], i); }, p);
      place(l_, some, p, x[i], y[i]);
      z[i] = p[axis];
      v[i] = p[3];
    }
    const V half = set(0.5f);
    const V r = hn::Load(d, some.mid[0]), s = hn::Load(d, some.mid[1]);
    const V t = hn::Load(d, some.mid[2]);
    const V in = some.of(l_.z), out = some.of(l_.outZ);
    const V sign = set(task_.isBackwards ? -1.0f : 1.0f);
    const CellStep step(x, y, z, v, r, s, t, hn::Mul(sign, hn::Mul(half, hn::Add(in, out))));
    const V middle = step.value;
    // For all of the way.
    const V slope = hn::Mul(hn::Mul(sign, step.slope), hn::Sub(out, in));
    hn::Store(step.dr, d, some.step[0]);
    hn::Store(step.ds, d, some.step[1]);
    hn::Store(step.dt, d, some.step[2]);
    const V from = some.of(l_.partIn), to = some.of(l_.partOut);
    // The cubic with these values and this slope, against the line.
    const V change = hn::Sub(to, from), bent = hn::NegMulAdd(half, hn::Add(from, to), middle);
    const V twist = hn::Sub(slope, change);
    const V left = hn::MulAdd(set(0.25f), change, hn::MulAdd(set(0.75f), bent, from));
    const V right = hn::MulAdd(set(0.75f), change, hn::MulAdd(set(0.75f), bent, from));
    const V quarter[3] = {
      hn::NegMulAdd(set(0.1875f), twist, left), middle, hn::MulAdd(set(0.1875f), twist, right)};
    // What two lines leave of it; twice as many leave at most a quarter of that.
    const V off = hn::MulAdd(set(0.25f), hn::Abs(bent), hn::Mul(set(0.19f), hn::Abs(twist)));
    const V perOff = hn::Mul(some.of(l_.rate), some.of(l_.transmittance));
    const V error = hn::Mul(off, perOff);
    const V ofLine = hn::Mul(hn::MulAdd(set(0.1f), hn::Abs(twist), hn::Abs(bent)), perOff);
    const M isNear = hn::Lt(step.size(), set(0.3f));
    const auto below = [&](V e, float most)
    { return maskOf(hn::And(isNear, hn::Lt(e, set(most)))); };
    take(some, quarter,
      {below(ofLine, task_.allowedOff), below(error, task_.allowedOff),
        below(error, 4.0f * task_.allowedOff),
        below(error, static_cast<float>(fineLines * fineLines / 4) * task_.allowedOff)},
      good);
  }
  /// Takes values at the quarters, and what is good enough, a bit each of `some`, to the lanes.
  HWY_INLINE void take(Some& some, const V (&quarter)[3], const Good& ofSome, Good& good)
  {
    alignas(64) float values[3][Some::most];
    for (std::size_t i = 0; i < 3; ++i)
      hn::Store(quarter[i], D(), values[i]);
    for (std::size_t j = 0; j < some.count; ++j)
    {
      const std::size_t k = some[j];
      for (std::size_t i = 0; i < 3; ++i)
      {
        l_.quarter[i][k] = values[i][j];
        l_.mid[i][k] = some.mid[i][j];
        l_.way[i][k] = some.way[i][j];
        l_.step[i][k] = some.step[i][j];
      }
      good.line |= (ofSome.line >> j & 1U) << k;
      good.two |= (ofSome.two >> j & 1U) << k;
      good.four |= (ofSome.four >> j & 1U) << k;
      good.fine |= (ofSome.fine >> j & 1U) << k;
    }
    some.count = 0;
  }

  const WalkTask& task_;
  Lanes& l_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
