// The rays of a bundle as every structure's traversal needs them. Included once per SIMD
// instruction set.

#if defined(MOTE_BUNDLE_PENCIL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_BUNDLE_PENCIL_INL_H
#undef MOTE_BUNDLE_PENCIL_INL_H
#else
#define MOTE_BUNDLE_PENCIL_INL_H
#endif

#include "../../core/RayBundle.h"

#include <glm/geometric.hpp>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DU = hn::Rebind<std::uint32_t, DF>;
using DD = hn::CappedTag<double, 8>;
using DH = hn::Rebind<float, DD>;
using VF = hn::Vec<DF>;
using VD = hn::Vec<DD>;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int blockRays = 16;                               ///< rays that are tested together
constexpr int blockCount = RayBundle::capacity / blockRays; ///< most blocks of a bundle

/// Least sine of the angle between a bundle's middle ray and the plane of its dx and dy, give or
/// take that between those: at 0.15 rounding is up to 6 times that of a narrow view.
constexpr double leastLean = 0.15;

/// What a structure's coordinates count from, and in.
struct Frame
{
  Vec3d origin;
  double unit;
};

/// A mask as bits, the first lane lowest.
template <typename Mask>
HWY_INLINE unsigned bitsOf(Mask mask)
{
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(DF(), mask, bytes);
  return bytes[0] | (static_cast<unsigned>(bytes[1]) << 8);
}

/// A double as the sum of two floats, to subtract it from floats with less error.
struct Split
{
  float high, low;
  Split() = default;
  explicit Split(double v)
    : high(static_cast<float>(v))
    , low(static_cast<float>(v - static_cast<double>(high)))
  {
  }
};

/// The rays of a bundle in the structure's coordinates.
///
/// Q is the point where the middle ray enters the structure, and tau counts from there in its
/// unit. Ray i passes Q + x ox + y oy + tau (d + x dx + y dy), with |d| = 1: formed in double and
/// only then rounded, so that all float numbers are small and their errors relative to the
/// structure, not to the camera's distance.
///
/// A sphere's centre is Q + tau d + m wx + n wy; w is what a step of 1 in x or y makes at Q, or, if
/// Q is nearly the eye, one unit behind it. The ray through the centre is that of x = m / w, y = n
/// / w, where w = scale + scaleSlope * tau is the bundle's width there in its width at Q.
struct Pencil
{
  // Per ray.
  alignas(64) float x[RayBundle::capacity], y[RayBundle::capacity];
  alignas(64) float inverse[RayBundle::capacity]; ///< 1 / |direction|^2
  /// Shift of the foot of the perpendicular from a centre, for one unit of w in x and in y.
  alignas(64) float shiftX[RayBundle::capacity], shiftY[RayBundle::capacity];
  alignas(64) float best[RayBundle::capacity];        ///< tau of the nearest hit; -inf: dead
  alignas(64) std::uint32_t hit[RayBundle::capacity]; ///< place in the list of hits, 0 for none
  // Per block of 16 rays.
  alignas(64) float lowX[blockCount], highX[blockCount], lowY[blockCount], highY[blockCount];
  alignas(64) float farthest[blockCount];                   ///< greatest `best`
  alignas(64) float farthestKappa[blockCount];              ///< the same along the major axis
  alignas(64) float alongK[blockCount], shiftK[blockCount]; ///< kappa = tau * alongK + shiftK

  int blocks;
  bool common; ///< common origin
  float first; ///< hits at tau <= first do not count
  Vec3d q;     ///< Q
  Vec3d d, dx, dy, ox, oy, wx, wy;
  double t0;   ///< tau of Q counted from the origin of the middle ray
  double perT; ///< units of tau in one of the bundle's t
  int K, U, V; ///< major axis and the others; kappa counts from Q along K in the way of travel
  double sign; ///< of travel along K

  // Of the spheres' projection.
  Split qx, qy, qz;
  Vec3d dTau, dM, dN; ///< tau, m and n of a unit along each axis
  Vec3f gTau, gM, gN; ///< the same, rounded
  float gLength;      ///< |gTau|
  float scale, scaleSlope;
  float reachX, reachY; ///< half the extent in x and y of a sphere of radius 1 where the width is 1
  float xx, xy, yy, xz, yz, zz; ///< products of wx x d, wy x d and wx x dy
};

/// Major axis and sign of a direction.
inline void majorAxis(const Vec3d& direction, Pencil& p)
{
  p.K = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(direction[axis]) > std::abs(direction[p.K]))
      p.K = axis;
  p.U = p.K == 0 ? 1 : 0; // x wherever possible: rows of cells run along x
  p.V = p.K == 2 ? 1 : 2;
  p.sign = direction[p.K] < 0.0 ? -1.0 : 1.0;
}

/// Extent of the rays of a bundle in x and y.
struct Spread
{
  float lowX = infinity, highX = -infinity, lowY = infinity, highY = -infinity;

  bool empty() const { return lowX > highX; }
  bool operator==(const Spread&) const = default;
  void add(float x, float y)
  {
    lowX = std::min(lowX, x);
    highX = std::max(highX, x);
    lowY = std::min(lowY, y);
    highY = std::max(highY, y);
  }
};

inline Spread spreadOf(const RayBundle& bundle)
{
  Spread s;
  if (bundle.side > 0)
  {
    s.add(bundle.x[0], bundle.y[0]);
    s.add(bundle.x[bundle.count - 1], bundle.y[bundle.count - 1]);
    return s;
  }
  for (int i = 0; i < bundle.count; ++i)
    s.add(bundle.x[i], bundle.y[i]);
  return s;
}

/// Expresses the bundle's lines in the structure's coordinates, from the plane across K at which
/// its first ray can meet a sphere. `least` and `most` bound all spheres. False where the bundle
/// ends before, or where its rays do not all travel forward along K and nowhere near across it:
/// `coherent` tells which.
inline bool placePencil(const Frame& frame, const RayBundle& bundle, const Spread& spread,
  const Vec3d& least, const Vec3d& most, Pencil& p, bool& coherent)
{
  const double perUnit = 1.0 / frame.unit;
  p.common = bundle.kind == RayBundle::Kind::CommonOrigin;
  const double speed = glm::length(bundle.direction);
  coherent = speed > 0.0;
  if (!coherent)
    return false;
  p.perT = speed * perUnit;
  p.d = bundle.direction / speed;
  p.dx = p.common ? bundle.dx / speed : Vec3d(0.0);
  p.dy = p.common ? bundle.dy / speed : Vec3d(0.0);
  majorAxis(p.d + 0.5 * (double(spread.lowX) + double(spread.highX)) * p.dx +
              0.5 * (double(spread.lowY) + double(spread.highY)) * p.dy,
    p);
  const Vec3d eye = (bundle.origin - frame.origin) * perUnit;
  const double begin = bundle.tMin * p.perT;
  double start = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 4; ++corner)
  {
    const double x = corner & 1 ? spread.highX : spread.lowX;
    const double y = corner & 2 ? spread.highY : spread.lowY;
    const Vec3d direction = p.d + x * p.dx + y * p.dy;
    const double forward = p.sign * direction[p.K];
    const double across = std::max(std::abs(direction[p.U]), std::abs(direction[p.V]));
    coherent = coherent && forward > 0.0 && across <= 2.0 * forward;
    // Behind the eye the rays' order is reversed: such are cast one by one.
    coherent = coherent && (begin >= 0.0 || !p.common);
    const Vec3d shift = p.common ? Vec3d(0.0) : perUnit * (x * bundle.dx + y * bundle.dy);
    start = std::min(start, p.sign * (eye[p.K] + shift[p.K]) + begin * forward);
  }
  if (!coherent)
    return false;
  const double nearFace = p.sign > 0.0 ? least[p.K] : -most[p.K];
  const double farFace = p.sign > 0.0 ? most[p.K] : -least[p.K];
  start = std::max(nearFace, start);
  if (!(start <= farFace))
    return false;
  p.t0 = (p.sign * start - eye[p.K]) / p.d[p.K];
  p.q = eye + p.t0 * p.d;
  p.ox = p.common ? p.t0 * p.dx : perUnit * bundle.dx;
  p.oy = p.common ? p.t0 * p.dy : perUnit * bundle.dy;
  const double width = std::max(p.t0, 1.0);
  p.wx = p.common ? width * p.dx : p.ox;
  p.wy = p.common ? width * p.dy : p.oy;
  // Far from the axis of a very wide view the rays lean so much that d, wx and wy nearly lie in one
  // plane, and coordinates in them would lose digits.
  const double volume = std::abs(glm::dot(p.d, glm::cross(p.wx, p.wy)));
  coherent = volume > leastLean * glm::length(p.wx) * glm::length(p.wy);
  if (!coherent)
    return false;
  p.scale = p.common ? static_cast<float>(p.t0 / width) : 1.0f;
  p.scaleSlope = p.common ? static_cast<float>(1.0 / width) : 0.0f;
  p.first = static_cast<float>(begin - p.t0);
  return true;
}

/// Prepares the projection of spheres.
inline void prepareProjection(const Spread& spread, Pencil& p)
{
  p.qx = Split(p.q.x);
  p.qy = Split(p.q.y);
  p.qz = Split(p.q.z);
  const Vec3d crossed = glm::cross(p.wx, p.wy);
  const double volume = glm::dot(p.d, crossed);
  p.dTau = crossed / volume;
  p.dM = glm::cross(p.wy, p.d) / volume;
  p.dN = glm::cross(p.d, p.wx) / volume;
  p.gTau = Vec3f(p.dTau);
  p.gM = Vec3f(p.dM);
  p.gN = Vec3f(p.dN);
  p.gLength = static_cast<float>(glm::length(p.dTau));
  const Vec3d x = glm::cross(p.wx, p.d), y = glm::cross(p.wy, p.d), z = glm::cross(p.wx, p.dy);
  p.xx = static_cast<float>(glm::dot(x, x));
  p.xy = static_cast<float>(glm::dot(x, y));
  p.yy = static_cast<float>(glm::dot(y, y));
  p.xz = static_cast<float>(glm::dot(x, z));
  p.yz = static_cast<float>(glm::dot(y, z));
  p.zz = static_cast<float>(glm::dot(z, z));
  // A plane of rays of one x is met by a sphere whose centre is at most r from it. Bounding its
  // normal over the bundle makes that a bound on x, with a little more for rounding.
  const auto reach = [&](const Vec3d& normal, const Vec3d& slope, double low, double high)
  {
    const double most =
      std::max(glm::length(normal + low * slope), glm::length(normal + high * slope));
    return static_cast<float>(most / std::abs(volume) * 1.00001);
  };
  p.reachX = reach(-y, z, spread.lowX, spread.highX);
  p.reachY = reach(x, z, spread.lowY, spread.highY);
}

/// What a ray needs for the test against spheres, and the blocks' bounds.
inline void prepareRays(const RayBundle& bundle, Pencil& p)
{
  const DF d;
  const DD dd;
  const DH dh;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto set = [&](double v) { return hn::Set(d, static_cast<float>(v)); };
  // |direction|^2 and the shifts' numerators are polynomials in x and y.
  const VF one = set(glm::dot(p.d, p.d)), dxd = set(glm::dot(p.dx, p.d)),
           dyd = set(glm::dot(p.dy, p.d));
  const VF dxdx = set(glm::dot(p.dx, p.dx)), dydy = set(glm::dot(p.dy, p.dy));
  const VF dxdy = set(glm::dot(p.dx, p.dy));
  const VF wxd = set(glm::dot(p.wx, p.d)), wyd = set(glm::dot(p.wy, p.d));
  const VF wxdx = set(glm::dot(p.wx, p.dx)), wxdy = set(glm::dot(p.wx, p.dy));
  const VF wydx = set(glm::dot(p.wy, p.dx)), wydy = set(glm::dot(p.wy, p.dy));
  p.blocks = (bundle.count + blockRays - 1) / blockRays;
  for (int i = 0; i < blockRays * p.blocks; i += lanes)
  {
    const auto used = hn::FirstN(d, static_cast<std::size_t>(std::max(0, bundle.count - i)));
    const VF x = hn::IfThenElseZero(used, hn::Load(d, bundle.x + i));
    const VF y = hn::IfThenElseZero(used, hn::Load(d, bundle.y + i));
    const VF ex = hn::MulAdd(x, dxdx, hn::MulAdd(y, dxdy, dxd));
    const VF ey = hn::MulAdd(x, dxdy, hn::MulAdd(y, dydy, dyd));
    const VF length2 = hn::MulAdd(x, hn::Add(ex, dxd), hn::MulAdd(y, hn::Add(ey, dyd), one));
    const VF inverse = hn::Div(hn::Set(d, 1.0f), length2);
    hn::Store(x, d, p.x + i);
    hn::Store(y, d, p.y + i);
    hn::Store(inverse, d, p.inverse + i);
    hn::Store(hn::Mul(inverse, hn::MulAdd(x, wxdx, hn::MulAdd(y, wxdy, wxd))), d, p.shiftX + i);
    hn::Store(hn::Mul(inverse, hn::MulAdd(x, wydx, hn::MulAdd(y, wydy, wyd))), d, p.shiftY + i);
    hn::Store(hn::Zero(DU()), DU(), p.hit + i);
  }
  const VD perT = hn::Set(dd, p.perT), t0 = hn::Set(dd, p.t0);
  for (int i = 0; i < blockRays * p.blocks; i += static_cast<int>(hn::Lanes(dd)))
  {
    const auto used = hn::FirstN(dd, static_cast<std::size_t>(std::max(0, bundle.count - i)));
    const VD last = hn::MulSub(hn::Load(dd, bundle.t + i), perT, t0);
    const VD dead = hn::Set(dd, -std::numeric_limits<double>::infinity());
    hn::Store(hn::DemoteTo(dh, hn::IfThenElse(used, last, dead)), dh, p.best + i);
  }
}

/// Greatest `best` of a block.
HWY_INLINE float farthestOf(const Pencil& p, int block)
{
  const DF d;
  VF most = hn::Load(d, p.best + blockRays * block);
  for (int k = static_cast<int>(hn::Lanes(d)); k < blockRays; k += static_cast<int>(hn::Lanes(d)))
    most = hn::Max(most, hn::Load(d, p.best + blockRays * block + k));
  return hn::GetLane(hn::MaxOfLanes(d, most));
}

HWY_INLINE void refreshBlock(Pencil& p, int block)
{
  const float most = farthestOf(p, block);
  p.farthest[block] = most;
  // Not to be less than that of any ray, before Q too.
  p.farthestKappa[block] = most > 0.0f         ? most * p.alongK[block] + p.shiftK[block]
                           : most == -infinity ? -infinity
                                               : p.shiftK[block];
}

inline void prepareBlocks(const RayBundle& bundle, Pencil& p)
{
  const auto along = [&](const Vec3d& v) { return static_cast<float>(p.sign * v[p.K]); };
  const float dk = along(p.d), dxk = along(p.dx), dyk = along(p.dy);
  const float oxk = along(p.ox), oyk = along(p.oy);
  for (int b = 0; b < blockCount; ++b)
  {
    if (b >= p.blocks)
    {
      p.lowX[b] = p.lowY[b] = infinity;
      p.highX[b] = p.highY[b] = p.farthest[b] = p.farthestKappa[b] = -infinity;
      continue;
    }
    Spread s;
    const int first = blockRays * b, last = std::min(bundle.count, first + blockRays);
    if (bundle.side > 0)
    {
      s.add(p.x[first], p.y[first]);
      s.add(p.x[last - 1], p.y[last - 1]);
    }
    else
      for (int i = first; i < last; ++i)
        s.add(p.x[i], p.y[i]);
    p.lowX[b] = s.lowX;
    p.highX[b] = s.highX;
    p.lowY[b] = s.lowY;
    p.highY[b] = s.highY;
    const auto most = [&](float cx, float cy)
    { return std::max(s.lowX * cx, s.highX * cx) + std::max(s.lowY * cy, s.highY * cy); };
    p.alongK[b] = dk + most(dxk, dyk);
    p.shiftK[b] = most(oxk, oyk);
    refreshBlock(p, b);
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
