// The rays of a bundle in blocks of 16, and what each has hit so far. Included once per SIMD
// instruction set.

#if defined(MOTE_BUNDLE_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_BUNDLE_RAYS_INL_H
#undef MOTE_BUNDLE_RAYS_INL_H
#else
#define MOTE_BUNDLE_RAYS_INL_H
#endif

#include "BundleFrame.h"
#include "MeshSimd-inl.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// A rectangle of cells of the picture, which 16 x 16 cells make up: x0, x1, y0, y1, a byte each,
/// the lowest first. In squares of rays the cells are the rays.
using Rect = std::uint32_t;

constexpr std::uint32_t noSlot = ~0U;

/// Where rays of a square lie in their bundle: the sum of the two. See bundleOffset().
constexpr std::uint8_t rayOfColumn[16] = {
  0, 1, 2, 3, 16, 17, 18, 19, 64, 65, 66, 67, 80, 81, 82, 83};
constexpr std::uint8_t rayOfRow[16] = {
  0, 4, 8, 12, 32, 36, 40, 44, 128, 132, 136, 140, 160, 164, 168, 172};

/// Blocks that begin before or at a column (row), and those that end there or later.
struct BlockTables
{
  std::uint16_t columnBegins[16], columnEnds[16], rowBegins[16], rowEnds[16];
};

/// Those of a square of 16 x 16 rays; smaller squares are its first quarters.
constexpr BlockTables squareTables()
{
  BlockTables tables = {};
  for (int cell = 0; cell < 16; ++cell)
    for (int block = 0; block < 16; ++block)
    {
      const int column = (block & 1) | (block >> 1 & 2), row = (block >> 1 & 1) | (block >> 2 & 2);
      tables.columnBegins[cell] |= static_cast<std::uint16_t>((column <= cell / 4) << block);
      tables.columnEnds[cell] |= static_cast<std::uint16_t>((column >= cell / 4) << block);
      tables.rowBegins[cell] |= static_cast<std::uint16_t>((row <= cell / 4) << block);
      tables.rowEnds[cell] |= static_cast<std::uint16_t>((row >= cell / 4) << block);
    }
  return tables;
}
constexpr BlockTables blocksOfSquare = squareTables();

/// Policies say what a hit does to a ray: the nearest is looked for, or any; and whether triangles
/// are hit from their inner side alone.
struct NearestHit
{
  static constexpr bool any = false, isInner = false;
};
struct NearestInnerHit
{
  static constexpr bool any = false, isInner = true;
};
struct AnyHit
{
  static constexpr bool any = true, isInner = false;
};

struct BundleRays
{
  static constexpr int capacity = RayBundle::capacity;

  alignas(64) float x[capacity]; ///< as in BundleFrame; beyond the bundle's rays 0
  alignas(64) float y[capacity];
  alignas(64) float z[capacity];              ///< of the nearest hit, or the farthest that counts
  alignas(64) std::uint32_t slot[capacity];   ///< of that hit, or noSlot
  alignas(64) float far[BundleFrame::blocks]; ///< not below any z of a block
  int blocks;                                 ///< of 16 rays
  unsigned changed = 0;                       ///< blocks whose `far` may be too large
  int lastCell;                               ///< of columns and rows
  float toFirst, toLast; ///< cells from ceil(x + toFirst) to floor(x + toLast) hold rays near x

  BundleRays(const BundleFrame& frame, const RayBundle& bundle)
    : blocks((bundle.count + 15) / 16)
  {
    takeRays(frame, bundle);
    if (frame.side > 0)
    {
      lastCell = frame.side - 1;
      toFirst = 0.5f * float(lastCell) - slack;
      toLast = 0.5f * float(lastCell) + slack;
      tables_ = &blocksOfSquare;
    }
    else
    {
      lastCell = 15;
      toFirst = 7.0f - slack;
      toLast = 8.0f + slack;
      tellBlocks();
      tables_ = &own_;
    }
  }
  BundleRays(const BundleRays&) = delete;
  BundleRays& operator=(const BundleRays&) = delete;

  /// Blocks that have rays in the rectangle, or near it, or might if they had any rays.
  HWY_INLINE unsigned blocksOf(Rect rect) const
  {
    return unsigned(tables_->columnEnds[rect & 255U] & tables_->columnBegins[rect >> 8 & 255U] &
                    tables_->rowEnds[rect >> 16 & 255U] & tables_->rowBegins[rect >> 24]);
  }

  /// Whether all rays in the rectangle have hit something nearer than z0. To be certain it looks at
  /// blocks anew whose rays have hit something.
  HWY_INLINE bool hides(float z0, Rect rect)
  {
    for (unsigned left = blocksOf(rect) & farther(z0); left != 0; left &= left - 1)
    {
      const int block = std::countr_zero(left);
      if ((changed >> block & 1U) == 0)
        return false;
      renew(block);
      if (far[block] > z0)
        return false;
    }
    return true;
  }

  /// The farthest z of any ray that may still hit something.
  HWY_INLINE float farthest() const
  {
    VF most = all(-infinity);
    for (int k = 0; k < BundleFrame::blocks; k += lanes)
      most = hn::Max(most, hn::Load(DF(), far + k));
    return hn::GetLane(hn::MaxOfLanes(DF(), most));
  }

  /// Keeps hits of 16 things, `hits` tells which, on rays of their own: those at columns x and rows
  /// y of a square, where z is above `least`. Slots count from `first`.
  template <typename Policy>
  HWY_INLINE void keepEach(unsigned hits, VF atX, VF atY, VF atZ, float least, std::uint32_t first)
  {
    alignas(64) std::int32_t columns[lanes], rows[lanes];
    alignas(64) float depths[lanes];
    hn::Store(hn::NearestInt(atX), DI(), columns);
    hn::Store(hn::NearestInt(atY), DI(), rows);
    hn::Store(atZ, DF(), depths);
    do
    {
      const int k = std::countr_zero(hits);
      hits &= hits - 1;
      const int ray = rayOfColumn[columns[k]] + rayOfRow[rows[k]];
      if (depths[k] < z[ray] && depths[k] > least)
      {
        z[ray] = Policy::any ? -infinity : depths[k];
        slot[ray] = first + static_cast<std::uint32_t>(k);
        changed |= 1U << (ray / 16);
      }
    } while (hits != 0);
  }

  /// Keeps hits of one thing on the rays from `i` on, where z is above `least`.
  template <typename Policy>
  HWY_INLINE void keepBlock(MF hits, VF atZ, int i, float least, std::uint32_t hit)
  {
    const DF d;
    const DU u;
    const VF before = hn::Load(d, z + i);
    hits = hn::And(hits, hn::And(hn::Lt(atZ, before), hn::Gt(atZ, all(least))));
    if (hn::AllFalse(d, hits))
      return;
    hn::Store(hn::IfThenElse(hits, Policy::any ? all(-infinity) : atZ, before), d, z + i);
    const auto slots = hn::Load(u, slot + i);
    hn::Store(hn::IfThenElse(hn::RebindMask(u, hits), hn::Set(u, hit), slots), u, slot + i);
    changed |= 1U << (i / 16);
  }

private:
  static constexpr float slack = 0.01f; ///< what rounding may move places in the picture by

  HWY_INLINE unsigned farther(float z0) const
  {
    unsigned bits = 0;
    for (int k = 0; k < BundleFrame::blocks; k += lanes)
      bits |= bitsOf(hn::Gt(hn::Load(DF(), far + k), all(z0))) << k;
    return bits;
  }

  HWY_INLINE void renew(int block)
  {
    VF most = all(-infinity);
    for (int k = 0; k < 16; k += lanes)
      most = hn::Max(most, hn::Load(DF(), z + 16 * block + k));
    far[block] = hn::GetLane(hn::MaxOfLanes(DF(), most));
    changed &= ~(1U << block);
  }

  void takeRays(const BundleFrame& frame, const RayBundle& bundle)
  {
    const DD d;
    const DH h;
    const DF f;
    const VD speed = hn::Set(d, frame.speed), zOfQ = hn::Set(d, frame.zOfQ);
    constexpr int step = static_cast<int>(hn::MaxLanes(d));
    for (int i = 0; i < bundle.count; i += step)
      hn::Store(hn::DemoteTo(h, hn::MulSub(hn::Load(d, bundle.t + i), speed, zOfQ)), h, z + i);
    const VF shiftX = all(frame.xShift), shiftY = all(frame.yShift);
    const VF scaleX = all(frame.xScale), scaleY = all(frame.yScale);
    for (int i = 0; i < bundle.count; i += lanes)
    {
      hn::Store(hn::Mul(hn::Sub(hn::Load(f, bundle.x + i), shiftX), scaleX), f, x + i);
      hn::Store(hn::Mul(hn::Sub(hn::Load(f, bundle.y + i), shiftY), scaleY), f, y + i);
    }
    std::fill(x + bundle.count, x + 16 * blocks, 0.0f);
    std::fill(y + bundle.count, y + 16 * blocks, 0.0f);
    std::fill(z + bundle.count, z + 16 * blocks, -infinity);
    std::fill(far, far + BundleFrame::blocks, -infinity);
    for (int i = 0; i < 16 * blocks; i += lanes)
      hn::Store(hn::Set(DU(), noSlot), DU(), slot + i);
    for (int block = 0; block < blocks; ++block)
      renew(block);
  }

  void tellBlocks()
  {
    own_ = {};
    for (int block = 0; block < blocks; ++block)
    {
      tellBlock(x + 16 * block, block, own_.columnBegins, own_.columnEnds);
      tellBlock(y + 16 * block, block, own_.rowBegins, own_.rowEnds);
    }
  }

  /// Rays beyond the bundle's count for their block: that is safe.
  void tellBlock(const float* values, int block, std::uint16_t* begins, std::uint16_t* ends) const
  {
    VF least = hn::Load(DF(), values), most = least;
    for (int k = lanes; k < 16; k += lanes)
    {
      least = hn::Min(least, hn::Load(DF(), values + k));
      most = hn::Max(most, hn::Load(DF(), values + k));
    }
    const auto cellOf = [&](float v)
    { return std::clamp(static_cast<int>(v + 0.5f * float(lastCell + 1)), 0, lastCell); };
    const int first = cellOf(hn::GetLane(hn::MinOfLanes(DF(), least)));
    const int last = cellOf(hn::GetLane(hn::MaxOfLanes(DF(), most)));
    for (int cell = 0; cell < 16; ++cell)
    {
      begins[cell] |= static_cast<std::uint16_t>((first <= cell) << block);
      ends[cell] |= static_cast<std::uint16_t>((last >= cell) << block);
    }
  }

  const BlockTables* tables_;
  BlockTables own_;
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
