// The rays of a bundle against the triangles of one cluster. Included once per SIMD instruction
// set.

#if defined(MOTE_CLUSTER_CAST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_CLUSTER_CAST_INL_H
#undef MOTE_CLUSTER_CAST_INL_H
#else
#define MOTE_CLUSTER_CAST_INL_H
#endif

#include "BundleRays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Tests clusters. Triangles that cover up to half a block of the picture are tested many at
/// a time, each with a ray of its own; larger ones one at a time with the rays of a block.
template <typename Policy>
class ClusterCaster
{
public:
  ClusterCaster(const BundleFrame& frame, BundleRays& rays)
    : frame_(frame)
    , rays_(rays)
    , half_(0.5f * float(rays.lastCell))
    , smallest_(frame.side > 0 ? 8.5f : 0.0f)
  {
  }

  /// `slot` is that of the cluster's first triangle.
  void cast(const TriangleCluster& cluster, std::uint32_t slot)
  {
    Points points;
    const bool behind = project(cluster, points);
    for (int set = 0; set < laneSets; ++set)
    {
      const CornerIndices corners(cluster, set);
      Cells cells;
      MF found = cellsOf(points, corners, cells);
      if (HWY_UNLIKELY(behind))
        found = reachBehind(points, corners, cells, found);
      const MF used =
        hn::FirstN(DF(), static_cast<std::size_t>(std::max(0, int(cluster.count) - set * lanes)));
      found = hn::And(found, used);
      if (hn::AllFalse(DF(), found))
        continue;
      const VF one = all(1.0f);
      const VF count = hn::Mul(
        hn::Add(hn::Sub(cells.x1, cells.x0), one), hn::Add(hn::Sub(cells.y1, cells.y0), one));
      const MF large = hn::And(found, hn::Gt(count, all(smallest_)));
      const MF small = hn::AndNot(large, found);
      const std::uint32_t first = slot + static_cast<std::uint32_t>(set * lanes);
      if (!hn::AllFalse(DF(), small))
        castSmall(points, corners, cells, small, first);
      if (!hn::AllFalse(DF(), large))
        castLarge(points, cluster, cells, bitsOf(large), set, first);
    }
  }

private:
  /// A cluster's points as BundleFrame sees them, and their places in the picture.
  struct Points
  {
    Row u, v, s, z, x, y;
  };
  /// The cells of the picture that triangles cover.
  struct Cells
  {
    VF x0, x1, y0, y1;
  };

  /// Whether any point lies behind the rays' origin, or beside it.
  bool project(const TriangleCluster& cluster, Points& points) const
  {
    bool behind = false;
    for (int set = 0; set < laneSets; ++set)
    {
      const DF d;
      const auto along = [&](int axis)
      { return hn::Sub(hn::LoadU(d, cluster.point[axis] + set * lanes), all(frame_.q[axis])); };
      const VF x = along(0), y = along(1), z = along(2);
      const auto function = [&](int k)
      {
        return hn::MulAdd(x, all(frame_.perAxis[0][k]),
          hn::MulAdd(y, all(frame_.perAxis[1][k]),
            hn::MulAdd(z, all(frame_.perAxis[2][k]), all(frame_.atQ[k]))));
      };
      const VF u = function(0), v = function(1), depth = function(2);
      const VF s = hn::MulAdd(depth, all(frame_.weightPerZ), all(frame_.weightAtQ));
      const VF perS = hn::Div(all(1.0f), s);
      behind |= !hn::AllTrue(d, hn::Gt(s, all(leastWeight)));
      points.u.store(u, set);
      points.v.store(v, set);
      points.s.store(s, set);
      points.z.store(depth, set);
      points.x.store(hn::Mul(u, perS), set);
      points.y.store(hn::Mul(v, perS), set);
    }
    return behind;
  }

  /// Triangles that cover cells.
  HWY_INLINE MF cellsOf(const Points& points, const CornerIndices& at, Cells& cells) const
  {
    const auto span = [&](const Row& row, VF& first, VF& last)
    {
      const VF a = row.at(at.a), b = row.at(at.b), c = row.at(at.c);
      first = hn::Min(hn::Min(a, b), c);
      last = hn::Max(hn::Max(a, b), c);
      const VF end = all(float(rays_.lastCell));
      first = hn::Max(hn::Ceil(hn::Add(first, all(rays_.toFirst))), hn::Zero(DF()));
      last = hn::Min(hn::Floor(hn::Add(last, all(rays_.toLast))), end);
    };
    span(points.x, cells.x0, cells.x1);
    span(points.y, cells.y0, cells.y1);
    return hn::And(hn::Le(cells.x0, cells.x1), hn::Le(cells.y0, cells.y1));
  }

  /// Triangles that reach behind the origin of the rays may be anywhere in the picture, unless all
  /// of them is there.
  HWY_NOINLINE MF reachBehind(
    const Points& points, const CornerIndices& at, Cells& cells, MF found) const
  {
    const VF a = points.s.at(at.a), b = points.s.at(at.b), c = points.s.at(at.c);
    const VF least = all(leastWeight), zero = hn::Zero(DF()), end = all(float(rays_.lastCell));
    const MF reaches = hn::Not(hn::Gt(hn::Min(hn::Min(a, b), c), least));
    const MF before = hn::Gt(hn::Max(hn::Max(a, b), c), zero);
    cells.x0 = hn::IfThenElse(reaches, zero, cells.x0);
    cells.y0 = hn::IfThenElse(reaches, zero, cells.y0);
    cells.x1 = hn::IfThenElse(reaches, end, cells.x1);
    cells.y1 = hn::IfThenElse(reaches, end, cells.y1);
    return hn::Or(hn::And(reaches, before), hn::AndNot(reaches, found));
  }

  HWY_INLINE MF hitsOf(const Edges& edges, VF sum) const
  {
    if constexpr (Policy::isInner)
      return edges.hitsInner(sum, frame_.handedness);
    else
      return edges.hits(sum);
  }

  /// A corner as the ray at (x, y) sees it. All corners, everywhere, are seen by this formula.
  static HWY_INLINE Corner cornerAt(VF x, VF y, VF u, VF v, VF s)
  {
    return {hn::NegMulAdd(x, s, u), hn::NegMulAdd(y, s, v)};
  }

  HWY_INLINE void castSmall(
    const Points& points, const CornerIndices& at, const Cells& cells, MF some, std::uint32_t first)
  {
    const DF d;
    const VF ua = points.u.at(at.a), ub = points.u.at(at.b), uc = points.u.at(at.c);
    const VF va = points.v.at(at.a), vb = points.v.at(at.b), vc = points.v.at(at.c);
    const VF sa = points.s.at(at.a), sb = points.s.at(at.b), sc = points.s.at(at.c);
    VF x = cells.x0, y = cells.y0;
    const VF one = all(1.0f), half = all(half_);
    do
    {
      const VF atX = hn::Sub(x, half), atY = hn::Sub(y, half);
      const Edges edges(cornerAt(atX, atY, ua, va, sa), cornerAt(atX, atY, ub, vb, sb),
        cornerAt(atX, atY, uc, vc, sc));
      const VF sum = edges.sum();
      const MF hits = hn::And(some, hitsOf(edges, sum));
      if (!hn::AllFalse(d, hits))
      {
        const VF z = edges.at(sum, points.z.at(at.a), points.z.at(at.b), points.z.at(at.c));
        rays_.template keepEach<Policy>(bitsOf(hits), x, y, z, frame_.first, first);
      }
      x = hn::Add(x, one);
      const MF ends = hn::Gt(x, cells.x1);
      x = hn::IfThenElse(ends, cells.x0, x);
      y = hn::IfThenElse(ends, hn::Add(y, one), y);
      some = hn::And(some, hn::Le(y, cells.y1));
    } while (!hn::AllFalse(d, some));
  }

  void castLarge(const Points& points, const TriangleCluster& cluster, const Cells& cells,
    unsigned some, int set, std::uint32_t first)
  {
    alignas(64) std::int32_t rects[lanes];
    const DI d;
    const auto byte = [&](VF cell) { return hn::NearestInt(cell); };
    const VI rect = hn::Or(hn::Or(byte(cells.x0), hn::ShiftLeft<8>(byte(cells.x1))),
      hn::Or(hn::ShiftLeft<16>(byte(cells.y0)), hn::ShiftLeft<24>(byte(cells.y1))));
    hn::Store(rect, d, rects);
    const unsigned existing = lowest(static_cast<unsigned>(rays_.blocks));
    for (; some != 0; some &= some - 1)
    {
      const int k = std::countr_zero(some);
      const Triangle triangle(points, cluster, set * lanes + k);
      unsigned blocks = rays_.blocksOf(static_cast<Rect>(rects[k])) & existing;
      for (; blocks != 0; blocks &= blocks - 1)
        castBlock(triangle, std::countr_zero(blocks), first + static_cast<std::uint32_t>(k));
    }
  }

  /// The corners of one triangle.
  struct Triangle
  {
    float u[3], v[3], s[3], z[3];

    HWY_INLINE Triangle(const Points& points, const TriangleCluster& cluster, int number)
    {
      for (int k = 0; k < 3; ++k)
      {
        const unsigned p = cluster.corner(number, k);
        u[k] = points.u.v[p];
        v[k] = points.v.v[p];
        s[k] = points.s.v[p];
        z[k] = points.z.v[p];
      }
    }
  };

  HWY_INLINE void castBlock(const Triangle& t, int block, std::uint32_t slot)
  {
    const DF d;
    for (int i = 16 * block; i < 16 * block + 16; i += lanes)
    {
      const VF x = hn::Load(d, rays_.x + i), y = hn::Load(d, rays_.y + i);
      const auto corner = [&](int k)
      { return cornerAt(x, y, all(t.u[k]), all(t.v[k]), all(t.s[k])); };
      const Edges edges(corner(0), corner(1), corner(2));
      const VF sum = edges.sum();
      const MF hits = hitsOf(edges, sum);
      if (hn::AllFalse(d, hits))
        continue;
      const VF z = edges.at(sum, all(t.z[0]), all(t.z[1]), all(t.z[2]));
      rays_.template keepBlock<Policy>(hits, z, i, frame_.first, slot);
    }
  }

  /// Points with a smaller s are looked at as if they were behind the rays.
  static constexpr float leastWeight = 1e-18f;

  const BundleFrame& frame_;
  BundleRays& rays_;
  float half_;
  float smallest_; ///< cells that a triangle covers at most to be tested beside others
};

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
