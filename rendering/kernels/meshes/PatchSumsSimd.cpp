// Sums over the triangles of clusters, compiled once for every SIMD instruction set.

#include "detail/PatchSums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "meshes/PatchSumsSimd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "detail/MeshSimd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

/// Corners of a cluster's triangles, in float; those of triangles that do not exist are its first
/// point.
struct CornerRows
{
  Row at[3][3]; ///< by corner and axis

  HWY_INLINE explicit CornerRows(const TriangleCluster& cluster)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Row points;
      for (int set = 0; set < laneSets; ++set)
        points.store(hn::LoadU(DF(), cluster.point[axis] + set * lanes), set);
      for (int set = 0; set < laneSets; ++set)
      {
        const CornerIndices corners(cluster, set);
        at[0][axis].store(points.at(corners.a), set);
        at[1][axis].store(points.at(corners.b), set);
        at[2][axis].store(points.at(corners.c), set);
      }
    }
  }
};

/// Sums about the cluster's first point, in double: over triangles with corners a, b, c of twice
/// the area w, the integral of p is w (a + b + c) / 3, and that of p p' is
/// w (a a' + b b' + c c' + (a + b + c)(a + b + c)') / 12.
struct ClusterSums
{
  VD weight, first[3], second[6], normal[3];

  HWY_INLINE ClusterSums()
  {
    weight = hn::Zero(DD());
    for (VD& v : first)
      v = weight;
    for (VD& v : second)
      v = weight;
    for (VD& v : normal)
      v = weight;
  }

  HWY_INLINE void add(const CornerRows& corners, const VD* origin, int from)
  {
    const DD d;
    VD p[3][3], sum[3], u[3], v[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int k = 0; k < 3; ++k)
        p[k][axis] =
          hn::Sub(hn::PromoteTo(d, hn::Load(DH(), corners.at[k][axis].v + from)), origin[axis]);
      u[axis] = hn::Sub(p[1][axis], p[0][axis]);
      v[axis] = hn::Sub(p[2][axis], p[0][axis]);
      sum[axis] = hn::Add(hn::Add(p[0][axis], p[1][axis]), p[2][axis]);
    }
    VD n[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int b = (axis + 1) % 3, c = (axis + 2) % 3;
      n[axis] = hn::MulSub(u[b], v[c], hn::Mul(u[c], v[b]));
      normal[axis] = hn::Add(normal[axis], n[axis]);
    }
    const VD w = hn::Sqrt(hn::MulAdd(n[0], n[0], hn::MulAdd(n[1], n[1], hn::Mul(n[2], n[2]))));
    weight = hn::Add(weight, w);
    constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (int axis = 0; axis < 3; ++axis)
      first[axis] = hn::MulAdd(w, sum[axis], first[axis]);
    for (int k = 0; k < 6; ++k)
    {
      const int i = pairs[k][0], j = pairs[k][1];
      VD product = hn::Mul(sum[i], sum[j]);
      for (const auto& corner : p)
        product = hn::MulAdd(corner[i], corner[j], product);
      second[k] = hn::MulAdd(w, product, second[k]);
    }
  }
};

HWY_INLINE double total(VD v)
{
  return hn::GetLane(hn::SumOfLanes(DD(), v));
}

void sumEach(const TriangleCluster* clusters, int count, PatchSums* sums)
{
  for (int k = 0; k < count; ++k)
  {
    const TriangleCluster& cluster = clusters[k];
    const CornerRows corners(cluster);
    VD origin[3];
    for (int axis = 0; axis < 3; ++axis)
      origin[axis] = hn::Set(DD(), cluster.point[axis][0]);
    ClusterSums all;
    for (int from = 0; from < TriangleCluster::capacity;
         from += static_cast<int>(hn::MaxLanes(DD())))
      all.add(corners, origin, from);
    PatchSums& to = sums[k];
    to = {};
    to.weight = total(all.weight);
    const double per = to.weight > 0.0 ? 1.0 / to.weight : 0.0;
    Vec3d mean;
    for (int axis = 0; axis < 3; ++axis)
    {
      mean[axis] = total(all.first[axis]) * per / 3.0;
      to.middle[axis] = cluster.point[axis][0] + mean[axis];
      to.normal[axis] = total(all.normal[axis]);
    }
    const double products[6] = {mean.x * mean.x, mean.y * mean.y, mean.z * mean.z, mean.x * mean.y,
      mean.x * mean.z, mean.y * mean.z};
    for (int i = 0; i < 6; ++i)
      to.moments[i] = total(all.second[i]) / 12.0 - to.weight * products[i];
  }
}

PatchExtent extentOf(const TriangleCluster* clusters, int count, const float normal[3],
  float offset, const float middle[3])
{
  const DF d;
  VF far = hn::Zero(d), square = hn::Zero(d);
  for (int k = 0; k < count; ++k)
    for (int set = 0; set < laneSets; ++set)
    {
      VF height = all(-offset), distance = hn::Zero(d);
      for (int axis = 0; axis < 3; ++axis)
      {
        const VF p = hn::LoadU(d, clusters[k].point[axis] + set * lanes);
        const VF from = hn::Sub(p, all(middle[axis]));
        height = hn::MulAdd(p, all(normal[axis]), height);
        distance = hn::MulAdd(from, from, distance);
      }
      far = hn::Max(far, hn::Abs(height));
      square = hn::Max(square, distance);
    }
  // Coordinates lie within [-1, 1]: this is more than rounding takes.
  constexpr float rounding = 0x1p-20f, share = 1.0f + 0x1p-20f;
  return {hn::GetLane(hn::MaxOfLanes(d, far)) * share + rounding,
    hn::GetLane(hn::Sqrt(hn::MaxOfLanes(d, square))) * share + rounding};
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(sumEach);
HWY_EXPORT(extentOf);

void sumClusters(const TriangleCluster* clusters, int count, PatchSums* sums)
{
  HWY_DYNAMIC_DISPATCH(sumEach)(clusters, count, sums);
}

PatchExtent extentOfClusters(const TriangleCluster* clusters, int count, const float normal[3],
  float offset, const float middle[3])
{
  return HWY_DYNAMIC_DISPATCH(extentOf)(clusters, count, normal, offset, middle);
}

} // namespace mote

#endif
