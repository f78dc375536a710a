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
    , tester_(view, pencil, bundle, object, hits, counts)
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
    if (!tester_.narrow(-layer.reach, U, V))
      return;
    const auto [enter, leave] = insideOf(layer, tester_.walls(), p_, U, V);
    const float first = std::floor((enter - front0_) / depth - 1e-3f);
    const float last = std::ceil((leave - front0_) / depth + 1e-3f);
    const int begin = static_cast<int>(std::clamp(first, 0.0f, static_cast<float>(slabs)));
    const int end = static_cast<int>(std::clamp(last, 0.0f, static_cast<float>(slabs)));
    for (int step = begin; step < end; ++step)
    {
      const float front = front0_ + depth * static_cast<float>(step);
      if (tester_.changed() && !tester_.narrow(front - layer.reach, U, V))
        break;
      // Measured along K: comparing with the rays' own distance would visit far more slices.
      if (!(tester_.farthestKappa() > front - layer.reach))
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

  bool isMacrocellEmpty(int slab, float k0, float k1) const
  {
    constexpr int m = CoherentGrid::macrocellSize;
    const CellRanges cells = lattice_.ranges(tester_.walls(), k0, k1);
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
    const CellRanges cells = lattice_.ranges(tester_.walls(), k0, k1);
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
    if (HWY_UNLIKELY(view_.skips))
      return gatherShown(slot, end);
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

  /// Gathers those of the spheres that are not repeats of others.
  HWY_NOINLINE void gatherShown(std::uint64_t first, std::uint64_t last)
  {
    view_.forShown(first, last,
      [this](std::uint64_t slot)
      {
        std::copy_n(&view_.records[slot].x, 4, buffer_ + 4 * buffered_);
        slots_[buffered_++] = slot;
        if (buffered_ > bufferSize - 4)
          flush();
      });
  }

  /// Projects the gathered spheres, many at once, and tests those that the frustum overlaps against
  /// the blocks of rays that they overlap.
  void flush()
  {
    const DF d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    Projected s;
    for (int i = 0; i < buffered_; i += lanes)
    {
      VF x, y, z, r;
      hn::LoadInterleaved4(d, buffer_ + 4 * i, x, y, z, r);
      const auto from = [&](VF c, Split q)
      { return hn::Sub(hn::Sub(c, hn::Set(d, q.high)), hn::Set(d, q.low)); };
      tester_.project(Vec3d(0.0), from(x, p_.qx), from(y, p_.qy), from(z, p_.qz), r,
        hn::FirstN(d, static_cast<std::size_t>(buffered_ - i)), s);
      for (unsigned bits = s.in; bits != 0; bits &= bits - 1)
      {
        const int j = __builtin_ctz(bits);
        if (!view_.selects || view_.isShown(slots_[i + j]))
          tester_.test(s, j, slots_[i + j]);
      }
      tester_.refresh();
    }
    buffered_ = 0;
  }

  const CoherentGridView& view_;
  Pencil& p_;
  SphereTester<Policy, CoherentGridView> tester_;
  CastCounts* counts_;
  CoherentGridView::Layer layer_;
  Lattice lattice_;
  float front0_ = 0.0f;
  int buffered_ = 0;
  alignas(64) float buffer_[4 * (bufferSize + 16)];
  std::uint64_t slots_[bufferSize + 16];
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
