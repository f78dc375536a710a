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

/// A cell's own coordinates of a place on a face: of its first corner, and what u and v add.
struct FaceAxes
{
  float from[3], u[3], v[3];
};
constexpr FaceAxes axesOf(const std::uint8_t (&corners)[4])
{
  constexpr std::uint8_t at[8][3] = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  FaceAxes axes{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const float from = at[corners[0]][k];
    axes.from[k] = from;
    axes.u[k] = static_cast<float>(at[corners[1]][k]) - from;
    axes.v[k] = static_cast<float>(at[corners[3]][k]) - from;
  }
  return axes;
}
constexpr FaceAxes faceAxes[6] = {axesOf(faceCorners[0]), axesOf(faceCorners[1]),
  axesOf(faceCorners[2]), axesOf(faceCorners[3]), axesOf(faceCorners[4]), axesOf(faceCorners[5])};

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

  /// Of the lanes `which`, gives those that are as good as lines, those for which two lines are
  /// good enough, and those for which four are; for the latter finds l.quarter.
  struct Good
  {
    std::uint32_t line = 0, two = 0, four = 0;
  };
  HWY_INLINE Good find(std::uint32_t which)
  {
    Good good;
    const std::uint32_t known = this->loadFaces(which);
    std::uint32_t bent = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
      if (const std::uint32_t here = lanesFrom(first, known); here != 0)
        bent |= enter(first, here) << first;
    good.line = known & ~bent;
    this->loadCells(bent);
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
      if (const std::uint32_t here = lanesFrom(first, bent); here != 0)
        step(first, here, good);
    return good;
  }

private:
  static std::uint32_t lanesFrom(std::size_t first, std::uint32_t which)
  {
    return which >> first & ((1U << hn::Lanes(D())) - 1);
  }
  /// The corners of the faces by which rays have come. Gives the lanes of which these are known.
  HWY_INLINE std::uint32_t loadFaces(std::uint32_t which)
  {
    const D4 d;
    const WalkCells::Point* const points = task_.cells->points();
    std::uint32_t known = 0;
    forLanes(which,
      [&](std::size_t k)
      {
        const std::uint32_t face = l_.inFace[k];
        if (face >= noFace)
          return;
        known |= 1U << k;
        const std::uint32_t* ids = task_.cells->mesh().cell(l_.cell[k]).data();
        for (std::size_t i = 0; i < 4; ++i)
          hn::Store(hn::Load(d, &points[ids[faceCorners[face][i]]].x), d, inCorner_[i][k]);
      });
    return known;
  }
  HWY_INLINE void loadCells(std::uint32_t which)
  {
    const D4 d;
    const WalkCells::Point* const points = task_.cells->points();
    forLanes(which,
      [&](std::size_t k)
      {
        const std::uint32_t* ids = task_.cells->mesh().cell(l_.cell[k]).data();
        for (std::size_t i = 0; i < 8; ++i)
          hn::Store(hn::Load(d, &points[ids[i]].x), d, corner_[i][k]);
      });
  }

  /// Finds where the rays come into their cells, and from where to where they run in the cells' own
  /// coordinates. Gives those of the rays `here` that bend too much.
  HWY_INLINE std::uint32_t enter(std::size_t first, std::uint32_t here)
  {
    const D d;
    FaceCorners c;
    for (std::size_t i = 0; i < 4; ++i)
    {
      V p[3];
      hn::LoadInterleaved4(d, inCorner_[i][first], p[0], p[1], p[2], c.value[i]);
      placeAbout<axis>(l_, first, p, c.x[i], c.y[i]);
    }
    const PatchPlace place = passPatch(c.x, c.y, !task_.isBackwards);
    alignas(64) float u[lanes], v[lanes];
    hn::Store(place.u, d, u);
    hn::Store(place.v, d, v);
    forLanes(here,
      [&](std::size_t k)
      {
        const FaceAxes &in = faceAxes[l_.inFace[first + k]], &out = faceAxes[l_.outFace[first + k]];
        for (std::size_t i = 0; i < 3; ++i)
        {
          in_[i][first + k] = in.from[i] + u[k] * in.u[i] + v[k] * in.v[i];
          out_[i][first + k] =
            out.from[i] + l_.outU[first + k] * out.u[i] + l_.outV[first + k] * out.v[i];
        }
      });
    // Bends go with the mixed derivatives: with products of two of the three ways.
    V way[3];
    for (std::size_t i = 0; i < 3; ++i)
      way[i] = hn::Abs(hn::Sub(hn::Load(d, out_[i] + first), hn::Load(d, in_[i] + first)));
    const V share =
      hn::Max(hn::Max(hn::Mul(way[0], way[1]), hn::Mul(way[1], way[2])), hn::Mul(way[2], way[0]));
    const V bend = hn::Mul(hn::Load(d, l_.bend + first), share);
    const V error =
      hn::Mul(bend, hn::Mul(hn::Load(d, l_.rate + first), hn::Load(d, l_.transmittance + first)));
    return maskOf(hn::Not(hn::Lt(error, set(task_.allowedShare)))) & here; // NaN bends
  }

  HWY_INLINE void step(std::size_t first, std::uint32_t known, Good& good)
  {
    const D d;
    V x[8], y[8], z[8], v[8];
    for (std::size_t i = 0; i < 8; ++i)
    {
      V p[3];
      hn::LoadInterleaved4(d, corner_[i][first], p[0], p[1], p[2], v[i]);
      placeAbout<axis>(l_, first, p, x[i], y[i]);
      z[i] = p[axis];
    }
    const V half = set(0.5f);
    V mid[3];
    for (std::size_t i = 0; i < 3; ++i)
      mid[i] = hn::Mul(half, hn::Add(hn::Load(d, in_[i] + first), hn::Load(d, out_[i] + first)));
    const V r = mid[0], s = mid[1], t = mid[2];
    const Trilinear px(x, r, s, t), py(y, r, s, t), pz(z, r, s, t), value(v, r, s, t);
    const V in = hn::Load(d, l_.z + first), out = hn::Load(d, l_.outZ + first);
    const V sign = set(task_.isBackwards ? -1.0f : 1.0f);
    const V wanted = hn::Mul(sign, hn::Mul(half, hn::Add(in, out)));
    const V ex = hn::Neg(px.at), ey = hn::Neg(py.at), ez = hn::Sub(wanted, pz.at);
    const V per =
      hn::Div(set(1.0f), determinant(px.r, px.s, px.t, py.r, py.s, py.t, pz.r, pz.s, pz.t));
    const V dr = hn::Mul(per, determinant(ex, px.s, px.t, ey, py.s, py.t, ez, pz.s, pz.t));
    const V ds = hn::Mul(per, determinant(px.r, ex, px.t, py.r, ey, py.t, pz.r, ez, pz.t));
    const V dt = hn::Mul(per, determinant(px.r, px.s, ex, py.r, py.s, ey, pz.r, pz.s, ez));
    const V middle =
      hn::MulAdd(dr, value.r, hn::MulAdd(ds, value.s, hn::MulAdd(dt, value.t, value.at)));
    // The slope along the ray, for all of the way.
    const V sr = hn::MulSub(px.s, py.t, hn::Mul(px.t, py.s));
    const V ss = hn::MulSub(px.t, py.r, hn::Mul(px.r, py.t));
    const V st = hn::MulSub(px.r, py.s, hn::Mul(px.s, py.r));
    const V slope = hn::Mul(hn::Mul(hn::Mul(sign, per), hn::Sub(out, in)),
      hn::MulAdd(sr, value.r, hn::MulAdd(ss, value.s, hn::Mul(st, value.t))));
    const V far = hn::Max(hn::Max(hn::Abs(dr), hn::Abs(ds)), hn::Abs(dt));
    const V from = hn::Load(d, l_.partIn + first), to = hn::Load(d, l_.partOut + first);
    // The cubic with these values and this slope, against the line.
    const V change = hn::Sub(to, from), bent = hn::NegMulAdd(half, hn::Add(from, to), middle);
    const V twist = hn::Sub(slope, change);
    const V left = hn::MulAdd(set(0.25f), change, hn::MulAdd(set(0.75f), bent, from));
    const V right = hn::MulAdd(set(0.75f), change, hn::MulAdd(set(0.75f), bent, from));
    const M isKnown = lanesOf(known);
    const auto keep = [&](V value, float* to)
    { hn::Store(hn::IfThenElse(isKnown, value, hn::Load(d, to)), d, to); };
    keep(hn::NegMulAdd(set(0.1875f), twist, left), l_.quarter[0] + first);
    keep(middle, l_.quarter[1] + first);
    keep(hn::MulAdd(set(0.1875f), twist, right), l_.quarter[2] + first);
    // What two lines leave of it; four leave at most a quarter of that.
    const V off = hn::MulAdd(set(0.25f), hn::Abs(bent), hn::Mul(set(0.19f), hn::Abs(twist)));
    const V perOff = hn::Mul(hn::Load(d, l_.rate + first), hn::Load(d, l_.transmittance + first));
    const V error = hn::Mul(off, perOff);
    const V ofLine = hn::Mul(hn::MulAdd(set(0.1f), hn::Abs(twist), hn::Abs(bent)), perOff);
    const M isNear = hn::And(isKnown, hn::Lt(far, set(0.3f)));
    good.line |= maskOf(hn::And(isNear, hn::Lt(ofLine, set(task_.allowedOff)))) << first;
    good.two |= maskOf(hn::And(isNear, hn::Lt(error, set(task_.allowedOff)))) << first;
    good.four |= maskOf(hn::And(isNear, hn::Lt(error, set(4.0f * task_.allowedOff)))) << first;
  }

  const WalkTask& task_;
  Lanes& l_;
  alignas(64) float corner_[8][lanes][4]{}, inCorner_[4][lanes][4]{};
  alignas(64) Floats in_[3]{}, out_[3]{};
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
