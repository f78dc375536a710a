// The frustum of a bundle, and the cells of a slice that it overlaps. Included once per instruction
// set.

#if defined(MOTE_COHERENT_GRID_FRUSTUM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_COHERENT_GRID_FRUSTUM_INL_H
#undef MOTE_COHERENT_GRID_FRUSTUM_INL_H
#else
#define MOTE_COHERENT_GRID_FRUSTUM_INL_H
#endif

#include "CoherentGridBundle-inl.h"

#include <array>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Cells of a slice; empty where a first is greater than its last.
struct CellRanges
{
  std::int32_t u0, u1, v0, v1;
  bool empty() const { return u0 > u1 || v0 > v1; }
};

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

  /// Kappa at which the widened frustum enters and leaves the layer's sides; enter > leave where it
  /// passes by.
  std::pair<float, float> insideOf(
    const CoherentGridView::Layer& layer, const Pencil& p, int U, int V) const
  {
    float enter = -layer.reach, leave = infinity;
    // Next to the eye the walls cross.
    if (p.common && p.t0 * std::abs(p.d[p.K]) < 2.0 * layer.reach)
      return {enter, leave};
    const auto clip = [&](float value, float along)
    {
      // value + along * kappa >= 0
      if (along > 0.0f)
        enter = std::max(enter, -value / along);
      else if (along < 0.0f)
        leave = std::min(leave, -value / along);
      else if (value < 0.0f)
        leave = -infinity;
    };
    const auto side = [&](int axis, int k, float widen)
    {
      const double low = double(layer.lower[axis]) - p.q[axis];
      const double high = low + double(layer.cellSize) * layer.resolution[axis];
      const float reach = 1.001f * layer.reach * widen;
      clip(static_cast<float>(high) + reach - at[k], -slope[k]);
      clip(at[k + 1] + reach - static_cast<float>(low), slope[k + 1]);
    };
    side(U, 0, widenU);
    side(V, 2, widenV);
    return {enter, leave};
  }
};

/// A layer's cells across the major axis, relative to Q.
struct Lattice
{
  float reach;               ///< of a sphere, in units
  alignas(16) float base[4]; ///< cell of Q
  alignas(16) float least[4], most[4];
  float cells; ///< a unit

  Lattice() = default;
  Lattice(const CoherentGridView::Layer& layer, const Pencil& p, int U, int V)
    : reach(layer.reach)
    , cells(1.0f / layer.cellSize)
  {
    for (int k = 0; k < 4; ++k)
    {
      const int axis = k < 2 ? U : V;
      base[k] = static_cast<float>((p.q[axis] - double(layer.lower[axis])) / layer.cellSize);
      // A frustum beside the grid gets an empty range.
      least[k] = k % 2 == 0 ? 0.0f : -1.0f;
      most[k] = static_cast<float>(layer.resolution[axis] - (k % 2 == 0 ? 0 : 1));
    }
  }

  /// Cells whose particles' spheres may reach into the frustum between two values of kappa.
  HWY_INLINE CellRanges ranges(const Walls& walls, float k0, float k1) const
  {
    float low[4], high[4];
    for (int k = 0; k < 4; ++k)
    {
      const float first = walls.at[k] + walls.slope[k] * k0,
                  last = walls.at[k] + walls.slope[k] * k1;
      low[k] = std::min(first, last);
      high[k] = std::max(first, last);
    }
    // Before the eye the walls have changed sides: all four ends count.
    const float bounds[4] = {std::min(low[0], low[1]) - reach * walls.widenU,
      std::max(high[0], high[1]) + reach * walls.widenU,
      std::min(low[2], low[3]) - reach * walls.widenV,
      std::max(high[2], high[3]) + reach * walls.widenV};
    std::int32_t cell[4];
    for (int k = 0; k < 4; ++k)
    {
      // In this order NaN, of rays far beside the grid, becomes a cell too.
      const float at = std::floor(bounds[k] * cells + base[k]);
      const float inside = std::min(most[k], std::max(least[k], at));
      cell[k] = static_cast<std::int32_t>(inside);
    }
    return {cell[0], cell[1], cell[2], cell[3]};
  }
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
