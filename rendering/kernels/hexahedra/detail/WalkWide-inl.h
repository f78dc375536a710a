// A cell about one ray, where a SIMD vector holds 16 numbers. To be included by CellWalkSimd.cpp,
// once for every instruction set.

#if defined(MOTE_WALK_WIDE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_WALK_WIDE_INL
#undef MOTE_WALK_WIDE_INL
#else
#define MOTE_WALK_WIDE_INL
#endif

#include "WalkLanes-inl.h"

#if HWY_TARGET <= HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

/// Where numbers are in two vectors: from 16 on in the second one.
using Places = std::array<std::int32_t, 16>;

/// The places in eight points of four coordinates of: the coordinate `a` of all points, then `b`.
constexpr Places placesOf(int a, int b)
{
  Places places{};
  for (int i = 0; i < 8; ++i)
  {
    places[std::size_t(i)] = 4 * i + a;
    places[std::size_t(8 + i)] = 4 * i + b;
  }
  return places;
}

/// Of what WideCorners has, the first or second corners of all edges: `from` 0 the first of two
/// coordinates, 8 the other one.
constexpr Places edgePlaces(std::size_t end, int from)
{
  Places places{};
  for (std::size_t e = 0; e < 12; ++e)
    places[e] = from + edgeCorners[e][end];
  return places;
}
/// The four corners of the faces: x, y, z, and values.
struct FacePlaces
{
  alignas(64) Places of[6];
};
constexpr FacePlaces makeFacePlaces()
{
  FacePlaces places{};
  for (std::size_t f = 0; f < 6; ++f)
    for (std::size_t i = 0; i < 16; ++i)
      places.of[f][i] = static_cast<std::int32_t>(8 * (i / 4) + faceCorners[f][i % 4]);
  return places;
}
constexpr FacePlaces facePlaces = makeFacePlaces();

HWY_INLINE V pick(V first, V second, const Places& places)
{
  return wide::pick(first, second, hn::LoadU(DI(), places.data()));
}
HWY_INLINE V pick(V from, const Places& places)
{
  return wide::pick(from, hn::LoadU(DI(), places.data()));
}

/// The corners of a cell: the first and second coordinates, eight each; depths, twice; depths and
/// values.
template <int axis>
struct WideCell
{
  V uv, zz, zValue;

  HWY_INLINE WideCell(const WalkCells::Point* points, const std::uint32_t* ids)
  {
    alignas(64) static constexpr Places uvPlaces = placesOf((axis + 1) % 3, (axis + 2) % 3),
                                        zzPlaces = placesOf(axis, axis),
                                        zValuePlaces = placesOf(axis, 3);
    const D d;
    const V near = loadRows(d, [&](std::size_t i) { return &points[ids[i]].x; });
    const V far = loadRows(d, [&](std::size_t i) { return &points[ids[4 + i]].x; });
    uv = pick(near, far, uvPlaces);
    zz = pick(near, far, zzPlaces);
    zValue = pick(near, far, zValuePlaces);
  }
  /// The first and second coordinates about a ray.
  HWY_INLINE V about(const Lanes& l, std::size_t k) const
  {
    const D d;
    return hn::Sub(hn::Sub(uv, hn::Load(d, l.rayXY[k])), hn::Mul(hn::Load(d, l.raySlope[k]), zz));
  }
};

/// Which edges turn counter-clockwise about the ray, and which clockwise, a bit each; the upper
/// four bits of 16 say nothing.
HWY_INLINE void turnWide(V xy, std::uint16_t& left, std::uint16_t& right)
{
  alignas(64) static constexpr Places ax = edgePlaces(0, 0), ay = edgePlaces(0, 8),
                                      bx = edgePlaces(1, 0), by = edgePlaces(1, 8);
  const V p = hn::Mul(pick(xy, ax), pick(xy, by)), q = hn::Mul(pick(xy, bx), pick(xy, ay));
  left = wide::bitsOf(hn::Gt(p, q));
  right = wide::bitsOf(hn::Lt(p, q));
}
/// Which corners are above the ray.
HWY_INLINE unsigned cornersAbove(V xy)
{
  return unsigned(wide::bitsOf(hn::Gt(xy, hn::Zero(D())))) >> 8;
}

/// Of each set of edges that turn counter-clockwise, where all others turn clockwise: the face of
/// which all edges do, plus 16 times that of which none does; or `unsure` where that is not one.
struct TurnFaces
{
  static constexpr std::uint8_t unsure = 0xff;
  std::uint8_t of[4096 + 3]; ///< four are read at a time
};
constexpr TurnFaces makeTurnFaces()
{
  std::array<unsigned, 6> own{}, against{};
  for (std::size_t e = 0; e < 12; ++e)
  {
    own[edgeFaces[e][0]] |= 1U << e;
    against[edgeFaces[e][1]] |= 1U << e;
  }
  TurnFaces faces{};
  for (unsigned set = 0; set < 4096; ++set)
  {
    unsigned out = 0, in = 0, outs = 0, ins = 0;
    for (unsigned f = 0; f < 6; ++f)
    {
      if ((set & own[f]) == own[f] && (set & against[f]) == 0)
      {
        out = f;
        ++outs;
      }
      if ((set & own[f]) == 0 && (set & against[f]) == against[f])
      {
        in = f;
        ++ins;
      }
    }
    faces.of[set] =
      outs == 1 && ins == 1 ? static_cast<std::uint8_t>(out + 16 * in) : TurnFaces::unsure;
  }
  return faces;
}
constexpr TurnFaces turnFaces = makeTurnFaces();

} // namespace
} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
#endif
