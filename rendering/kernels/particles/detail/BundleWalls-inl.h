// The frustum around a bundle of rays. Included once per SIMD instruction set.

#if defined(MOTE_BUNDLE_WALLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_BUNDLE_WALLS_INL_H
#undef MOTE_BUNDLE_WALLS_INL_H
#else
#define MOTE_BUNDLE_WALLS_INL_H
#endif

#include "BundlePencil-inl.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// The walls of a bundle's frustum: the least and greatest u, and v, of its rays as linear
/// functions of kappa, relative to Q.
struct Walls
{
  alignas(16) float at[4];    ///< least u, greatest u, least v, greatest v at kappa = 0
  alignas(16) float slope[4]; ///< of them
  float widenU, widenV;       ///< a sphere's radius counts this many times along u and v

  /// The rays at the corners of the spread are the outermost: u is a quotient of linear functions
  /// of x and y at each kappa.
  void set(const Spread& spread, const Pencil& p, int U, int V)
  {
    const float xs[4] = {spread.lowX, spread.highX, spread.lowX, spread.highX};
    const float ys[4] = {spread.lowY, spread.lowY, spread.highY, spread.highY};
    using Corners = std::array<float, 4>;
    const auto linear = [&](double c, double cx, double cy)
    {
      const auto f = static_cast<float>(c), fx = static_cast<float>(cx),
                 fy = static_cast<float>(cy);
      Corners out;
      for (int i = 0; i < 4; ++i)
        out[i] = xs[i] * fx + (ys[i] * fy + f);
      return out;
    };
    const double s = p.sign, dk = p.d[p.K];
    const Corners perSlope = linear(s * dk, s * p.dx[p.K], s * p.dy[p.K]);
    const auto bounds = [&](const Corners& numerator, float& low, float& high)
    {
      low = infinity;
      high = -infinity;
      for (int i = 0; i < 4; ++i)
      {
        const float v = numerator[i] / perSlope[i];
        low = std::min(low, v);
        high = std::max(high, v);
      }
    };
    const auto wall = [&](int axis, int k)
    {
      // Differences of products of the lines' steps: what the plane across K makes of them.
      const double cx = p.ox[axis] * dk - p.d[axis] * p.ox[p.K];
      const double cy = p.oy[axis] * dk - p.d[axis] * p.oy[p.K];
      bounds(linear(0.0, s * cx, s * cy), at[k], at[k + 1]);
      bounds(linear(p.d[axis], p.dx[axis], p.dy[axis]), slope[k], slope[k + 1]);
      const float steepest = std::max(std::abs(slope[k]), std::abs(slope[k + 1]));
      return std::sqrt(1.0f + steepest * steepest);
    };
    widenU = wall(U, 0);
    widenV = wall(V, 2);
  }
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
