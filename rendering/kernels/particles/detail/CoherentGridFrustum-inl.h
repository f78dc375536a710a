// The cells of a slice that the frustum of a bundle overlaps. Included once per instruction set.

#if defined(MOTE_COHERENT_GRID_FRUSTUM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_COHERENT_GRID_FRUSTUM_INL_H
#undef MOTE_COHERENT_GRID_FRUSTUM_INL_H
#else
#define MOTE_COHERENT_GRID_FRUSTUM_INL_H
#endif

#include "BundleSpheres-inl.h"
#include "CoherentGridView.h"

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

/// Kappa at which the widened frustum enters and leaves the layer's sides; enter > leave where it
/// passes by.
inline std::pair<float, float> insideOf(
  const CoherentGridView::Layer& layer, const Walls& walls, const Pencil& p, int U, int V)
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
    clip(static_cast<float>(high) + reach - walls.at[k], -walls.slope[k]);
    clip(walls.at[k + 1] + reach - static_cast<float>(low), walls.slope[k + 1]);
  };
  side(U, 0, walls.widenU);
  side(V, 2, walls.widenV);
  return {enter, leave};
}

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
