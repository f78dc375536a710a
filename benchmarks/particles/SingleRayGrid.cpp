// Single rays through a grid, compiled once for every SIMD instruction set.

#include "SingleRayGrid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "particles/SingleRayGrid.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mote::bench
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using VF = hn::Vec<DF>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t noPlace = std::numeric_limits<std::uint32_t>::max();

/// One ray at a time on its way through the grid. Lengths are in the grid's unit and count from the
/// point where the ray enters the box of all spheres, so that float tells them apart.
class SingleRay
{
public:
  explicit SingleRay(const CellGrid& grid)
    : grid_(grid)
    , perUnit_(1.0 / grid.unit)
    , reach_(static_cast<int>(std::ceil(grid.largestRadius / grid.cellSize + 1e-4f)))
  {
    const double margin = 1e-5 * glm::length(Vec3d(grid.boxUpper - grid.boxLower));
    low_ = Vec3d(grid.boxLower) - margin;
    high_ = Vec3d(grid.boxUpper) + margin;
  }

  /// Casts a ray in the input's coordinates. Answers t, or infinity; place() is what is hit.
  double cast(const Vec3d& origin, const Vec3d& direction, double tMin, double tMax)
  {
    place_ = noPlace;
    const Vec3d o = perUnit_ * (origin - grid_.origin);
    const double length = perUnit_ * glm::length(direction);
    const Vec3d d = (perUnit_ / length) * direction;
    double in = tMin * length, out = tMax * length;
    if (!clip(o, d, in, out))
      return infinity;
    start(o + in * d, d);
    first_ = static_cast<float>(tMin * length - in);
    best_ = static_cast<float>(out - in);
    walk(out - in);
    return place_ == noPlace ? infinity : (in + best_) / length;
  }

  std::uint32_t place() const { return place_; }

private:
  struct Range
  {
    int first, last;
  };

  /// The part of the ray in the box of all spheres; false where there is none.
  bool clip(const Vec3d& o, const Vec3d& d, double& in, double& out) const
  {
    for (int k = 0; k < 3; ++k)
    {
      if (d[k] == 0.0)
      {
        if (!(o[k] >= low_[k] && o[k] <= high_[k]))
          return false;
        continue;
      }
      const double a = (low_[k] - o[k]) / d[k], b = (high_[k] - o[k]) / d[k];
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    }
    return in <= out;
  }

  /// Puts the ray into the cell of its first point. Cells go on outside of the grid, empty.
  void start(const Vec3d& entry, const Vec3d& d)
  {
    const double h = grid_.cellSize;
    for (int k = 0; k < 3; ++k)
    {
      entryHigh_[k] = static_cast<float>(entry[k]);
      entryLow_[k] = static_cast<float>(entry[k] - entryHigh_[k]);
      direction_[k] = static_cast<float>(d[k]);
      const double place = (entry[k] - grid_.lower[k]) / h;
      cell_[k] = static_cast<int>(std::floor(place));
      step_[k] = d[k] < 0.0 ? -1 : 1;
      const double face = (step_[k] > 0 ? cell_[k] + 1 : cell_[k]) - place;
      next_[k] = d[k] != 0.0 ? face * h / d[k] : infinity;
      delta_[k] = d[k] != 0.0 ? h / std::abs(d[k]) : infinity;
    }
    // The rounded direction has not quite unit length.
    inverseLength2_ = 1.0f / glm::dot(direction_, direction_);
  }

  void walk(double end)
  {
    gather(around(0), around(1), around(2));
    test();
    for (;;)
    {
      const int axis =
        next_[0] < next_[1] ? (next_[0] < next_[2] ? 0 : 2) : (next_[1] < next_[2] ? 1 : 2);
      // Whatever is hit before the face lies in a cell that has been in reach.
      if (next_[axis] >= best_ || next_[axis] > end)
        return;
      cell_[axis] += step_[axis];
      next_[axis] += delta_[axis];
      const int ahead = cell_[axis] + step_[axis] * reach_;
      if (ahead < 0 || ahead >= grid_.resolution[axis])
        continue;
      const Range fresh{ahead, ahead};
      gather(axis == 0 ? fresh : around(0), axis == 1 ? fresh : around(1),
        axis == 2 ? fresh : around(2));
      test();
    }
  }

  /// The cells in reach along an axis; empty where all lie outside.
  Range around(int axis) const
  {
    return {std::max(0, cell_[axis] - reach_),
      std::min(grid_.resolution[axis] - 1, cell_[axis] + reach_)};
  }

  /// Copies the particles of these cells to where test() finds them.
  HWY_INLINE void gather(Range x, Range y, Range z)
  {
    if (x.first > x.last)
      return;
    const auto width = static_cast<std::size_t>(grid_.resolution.x) + 1;
    for (int k = z.first; k <= z.last; ++k)
      for (int j = y.first; j <= y.last; ++j)
      {
        const std::size_t row = static_cast<std::size_t>(k) * grid_.resolution.y + j;
        const std::uint32_t* start = grid_.cellStart.data() + row * width;
        std::uint64_t place = grid_.rowStart[row] + start[x.first];
        const std::uint64_t end = grid_.rowStart[row] + start[x.last + 1];
        // Four records at a time; what is copied too much is overwritten by the next row.
        for (; place < end; place += 4)
        {
          const float* from = &grid_.records[place].x;
          float* to = buffer_ + 4 * buffered_;
          for (int i = 0; i < 16; i += static_cast<int>(hn::Lanes(DF())))
            hn::StoreU(hn::LoadU(DF(), from + i), DF(), to + i);
          for (int i = 0; i < 4; ++i)
            places_[buffered_ + i] = static_cast<std::uint32_t>(place) + i;
          buffered_ += static_cast<int>(std::min<std::uint64_t>(4, end - place));
          if (buffered_ > bufferSize - 4)
            test();
        }
      }
  }

  /// Tests the gathered spheres, many at once. The stable form: distance from the centre to the ray
  /// by the perpendicular remainder.
  HWY_INLINE void test()
  {
    const DF d;
    const VF dx = hn::Set(d, direction_.x), dy = hn::Set(d, direction_.y);
    const VF dz = hn::Set(d, direction_.z), inverse = hn::Set(d, inverseLength2_);
    const VF first = hn::Set(d, first_);
    const auto relative = [&](VF c, int k)
    { return hn::Sub(hn::Sub(c, hn::Set(d, entryHigh_[k])), hn::Set(d, entryLow_[k])); };
    for (int i = 0; i < buffered_; i += static_cast<int>(hn::Lanes(d)))
    {
      VF x, y, z, r;
      hn::LoadInterleaved4(d, buffer_ + 4 * i, x, y, z, r);
      x = relative(x, 0);
      y = relative(y, 1);
      z = relative(z, 2);
      const VF at = hn::Mul(hn::MulAdd(x, dx, hn::MulAdd(y, dy, hn::Mul(z, dz))), inverse);
      const VF px = hn::NegMulAdd(at, dx, x), py = hn::NegMulAdd(at, dy, y);
      const VF pz = hn::NegMulAdd(at, dz, z);
      const VF left =
        hn::NegMulAdd(px, px, hn::NegMulAdd(py, py, hn::NegMulAdd(pz, pz, hn::Mul(r, r))));
      const auto used = hn::FirstN(d, static_cast<std::size_t>(buffered_ - i));
      const auto meets = hn::And(used, hn::Ge(left, hn::Zero(d)));
      if (hn::AllFalse(d, meets))
        continue;
      const VF half = hn::Sqrt(hn::Mul(hn::Max(left, hn::Zero(d)), inverse));
      const VF in = hn::Sub(at, half), out = hn::Add(at, half);
      const VF near = hn::IfThenElse(hn::Gt(in, first), in, out);
      const auto nearer =
        hn::And(meets, hn::And(hn::Gt(near, first), hn::Lt(near, hn::Set(d, best_))));
      if (!hn::AllFalse(d, nearer))
        keepNearest(hn::IfThenElse(nearer, near, hn::Set(d, best_)), i);
    }
    buffered_ = 0;
  }

  HWY_INLINE void keepNearest(VF near, int i)
  {
    const DF d;
    best_ = hn::GetLane(hn::MinOfLanes(d, near));
    const auto lane = hn::FindKnownFirstTrue(d, hn::Eq(near, hn::Set(d, best_)));
    place_ = places_[i + static_cast<int>(lane)];
  }

  static constexpr int bufferSize = 64;

  const CellGrid& grid_;
  double perUnit_;
  int reach_; ///< how many cells a sphere may reach out of its own
  Vec3d low_, high_;
  Vec3d next_{0.0}, delta_{0.0}; ///< lengths to the next face along each axis, and between faces
  Vec3i cell_{0}, step_{0};
  Vec3f entryHigh_{0.0f}, entryLow_{0.0f}, direction_{0.0f};
  float inverseLength2_ = 1.0f;
  float first_ = 0.0f, best_ = 0.0f;
  std::uint32_t place_ = noPlace;
  int buffered_ = 0;
  alignas(64) float buffer_[4 * (bufferSize + 16)];
  std::uint32_t places_[bufferSize + 16];
};

void castBlock(const CellGrid& grid, const CameraRays& rays, int x0, int y0, HitImage& image)
{
  SingleRay ray(grid);
  constexpr int side = 8;
  for (int i = 0; i < side * side; ++i) // neighbours after one another: they find the same cells
  {
    int x = 0, y = 0;
    bundleOffset(side, i, x, y);
    const double px = x0 + x + 0.5, py = y0 + y + 0.5;
    const double t =
      ray.cast(rays.originAt(px, py), rays.directionAt(px, py), rays.tMin, rays.tMax);
    image.put(x0 + x, y0 + y, static_cast<float>(t), ray.place());
  }
}

} // namespace HWY_NAMESPACE
} // namespace mote::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote::bench
{

HWY_EXPORT(castBlock);

void castSingleRays(const CellGrid& grid, const CameraRays& rays, int x0, int y0, HitImage& image)
{
  HWY_DYNAMIC_DISPATCH(castBlock)(grid, rays, x0, y0, image);
}

} // namespace mote::bench

#endif
