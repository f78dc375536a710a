// Where rays enter a mesh by the faces of its boundary, compiled once for every SIMD instruction
// set.
//
// This file must be compiled without contraction to fused multiply-adds: corners about rays are to
// be the same numbers as in CellWalkSimd.cpp.

#include "detail/WalkTask.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hexahedra/WalkEntriesSimd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/WalkPatch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{
namespace
{

/// Rays that enter by faces, until there are as many as lanes.
class EntryList
{
public:
  explicit EntryList(WalkTask& task)
    : task_(task)
  {
  }

  HWY_ATTR void add(std::size_t ray, const WalkView::Face& face)
  {
    const HexMesh::Cell& ids = task_.cells->mesh().cell(face.face.cell);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const WalkCells::Point& p = task_.cells->points()[ids[faceCorners[face.face.face][i]]];
      const float at[3] = {p.x, p.y, p.z};
      x_[i][count_] = at[(task_.axis + 1) % 3];
      y_[i][count_] = at[(task_.axis + 2) % 3];
      z_[i][count_] = at[task_.axis];
      value_[i][count_] = p.value;
    }
    ray_[count_] = ray;
    rayX_[count_] = task_.rays.x[ray];
    rayY_[count_] = task_.rays.y[ray];
    rayDx_[count_] = task_.rays.dx[ray];
    rayDy_[count_] = task_.rays.dy[ray];
    cell_[count_] = face.face.cell;
    if (++count_ == hn::Lanes(D()))
      flush();
  }

  HWY_ATTR void flush()
  {
    const D d;
    FaceCorners c;
    for (std::size_t i = 0; i < 4; ++i)
    {
      c.z[i] = hn::Load(d, z_[i]);
      c.value[i] = hn::Load(d, value_[i]);
      c.x[i] = hn::Sub(
        hn::Sub(hn::Load(d, x_[i]), hn::Load(d, rayX_)), hn::Mul(hn::Load(d, rayDx_), c.z[i]));
      c.y[i] = hn::Sub(
        hn::Sub(hn::Load(d, y_[i]), hn::Load(d, rayY_)), hn::Mul(hn::Load(d, rayDy_), c.z[i]));
    }
    const PatchPlace place = passPatch(c.x, c.y, !task_.isBackwards);
    alignas(64) float z[16], value[16];
    hn::Store(place.of(c.z), d, z);
    hn::Store(place.of(c.value), d, value);
    for (std::size_t k = 0; k < count_; ++k)
      task_.entries.add(ray_[k], task_.depth(z[k]), value[k], cell_[k]);
    count_ = 0;
  }

private:
  WalkTask& task_;
  std::size_t count_ = 0;
  std::size_t ray_[16];
  std::uint32_t cell_[16];
  alignas(64) float x_[4][16]{}, y_[4][16]{}, z_[4][16]{}, value_[4][16]{};
  alignas(64) float rayX_[16]{}, rayY_[16]{}, rayDx_[16]{}, rayDy_[16]{};
};

HWY_INLINE std::uint64_t bitsOf(M mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0] | static_cast<std::uint64_t>(bits[1]) << 8;
}

/// The places of groups of rays, of which each has as many as there are lanes.
struct PlaceBounds
{
  static constexpr std::size_t most = WalkRays::capacity / 4;
  alignas(64) float left[most]{}, right[most]{}, lower[most]{}, upper[most]{};

  void set(std::size_t group, const float* x, const float* y, std::size_t count)
  {
    const auto [leftmost, rightmost] = std::minmax_element(x, x + count);
    const auto [lowest, uppermost] = std::minmax_element(y, y + count);
    left[group] = *leftmost;
    right[group] = *rightmost;
    lower[group] = *lowest;
    upper[group] = *uppermost;
  }
  /// Which groups a face may meet, a bit each, of as many as there are lanes.
  HWY_INLINE std::uint64_t meeting(const WalkView::Face& face, std::size_t first) const
  {
    const D d;
    const M across = hn::And(hn::Ge(hn::Set(d, face.right), hn::Load(d, left + first)),
      hn::Le(hn::Set(d, face.left), hn::Load(d, right + first)));
    const M up = hn::And(hn::Ge(hn::Set(d, face.upper), hn::Load(d, lower + first)),
      hn::Le(hn::Set(d, face.lower), hn::Load(d, upper + first)));
    return bitsOf(hn::And(across, up));
  }
};

/// Which rays enter by a face, a bit each; and which may, though the signs of its edges do not
/// tell: where the face is clear, only if an edge passes through the ray, as far as numbers can
/// tell.
struct FaceTest
{
  std::uint64_t entered, unsure;
};

HWY_INLINE FaceTest testFace(const V (&x)[4], const V (&y)[4], bool isBackwards, bool isUnclear)
{
  const V zero = hn::Zero(D());
  std::uint64_t left = 0xffff, right = 0xffff, even = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const V a = hn::Mul(x[i], y[(i + 1) % 4]), b = hn::Mul(y[i], x[(i + 1) % 4]);
    const std::uint64_t more = bitsOf(hn::Gt(a, b)), less = bitsOf(hn::Lt(a, b));
    left &= more;
    right &= less;
    even |= ~(more | less);
  }
  const std::uint64_t entered = isBackwards ? left : right;
  if (HWY_LIKELY(!isUnclear && even == 0))
    return {entered, 0};
  const auto around = [&](const V(&c)[4])
  {
    const V most = hn::Max(hn::Max(c[0], c[1]), hn::Max(c[2], c[3]));
    const V least = hn::Min(hn::Min(c[0], c[1]), hn::Min(c[2], c[3]));
    return bitsOf(hn::And(hn::Gt(most, zero), hn::Le(least, zero)));
  };
  const std::uint64_t unsure = around(x) & around(y) & ~(left | right);
  return {entered, isUnclear ? unsure : unsure & even};
}

} // namespace

HWY_ATTR void testFaces(WalkTask& task, const std::vector<std::uint32_t>& faces)
{
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const WalkRays& rays = task.rays;
  const auto count = static_cast<std::size_t>(rays.count);
  PlaceBounds bounds;
  const std::size_t groups = (count + lanes - 1) / lanes;
  for (std::size_t g = 0; g < groups; ++g)
    bounds.set(
      g, &rays.placeX[g * lanes], &rays.placeY[g * lanes], std::min(lanes, count - g * lanes));
  EntryList list(task);
  for (const std::uint32_t which : faces)
  {
    const WalkView::Face& face = task.view->face(which);
    const HexMesh::Cell& ids = task.cells->mesh().cell(face.face.cell);
    float corners[4][3];
    for (std::size_t i = 0; i < 4; ++i)
    {
      const WalkCells::Point& p = task.cells->points()[ids[faceCorners[face.face.face][i]]];
      const float at[3] = {p.x, p.y, p.z};
      for (int k = 0; k < 3; ++k)
        corners[i][k] = at[(task.axis + 1 + k) % 3];
    }
    std::uint64_t met = 0;
    for (std::size_t g = 0; g < groups; g += lanes)
      met |= bounds.meeting(face, g) << g;
    for (met &= ~std::uint64_t(0) >> (64 - groups); met != 0; met &= met - 1)
    {
      const std::size_t first = static_cast<std::size_t>(std::countr_zero(met)) * lanes;
      V x[4], y[4];
      for (std::size_t i = 0; i < 4; ++i)
      {
        const V z = set(corners[i][2]);
        x[i] = hn::Sub(hn::Sub(set(corners[i][0]), hn::Load(d, &rays.x[first])),
          hn::Mul(hn::Load(d, &rays.dx[first]), z));
        y[i] = hn::Sub(hn::Sub(set(corners[i][1]), hn::Load(d, &rays.y[first])),
          hn::Mul(hn::Load(d, &rays.dy[first]), z));
      }
      const std::uint64_t all = (std::uint64_t(1) << std::min(lanes, count - first)) - 1;
      const FaceTest test = testFace(x, y, task.isBackwards, face.isUnclear);
      for (std::uint64_t hits = test.entered & all; hits != 0; hits &= hits - 1)
        list.add(first + static_cast<std::size_t>(std::countr_zero(hits)), face);
      for (std::uint64_t unsure = test.unsure & all; unsure != 0; unsure &= unsure - 1)
        addSeldomEntries(task, first + static_cast<std::size_t>(std::countr_zero(unsure)), face);
    }
  }
  list.flush();
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(testFaces);

void testEntries(WalkTask& task, const std::vector<std::uint32_t>& faces)
{
  HWY_DYNAMIC_DISPATCH(testFaces)(task, faces);
}

} // namespace mote

#endif
