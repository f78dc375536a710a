#pragma once

#include "../../core/Vec.h"
#include "RlodTreeParts.h"

namespace mote
{

/// What a patch of triangles sums up to: enough to fit a plane, and sums of parts join to sums of
/// the whole. All in double, and moments about the patch's own middle, so that nothing is lost
/// where the patch is small beside its distance from the origin.
struct PatchSums
{
  double weight = 0.0;    ///< twice the area
  Vec3d middle{0.0};      ///< mean of all points of the triangles
  double moments[6] = {}; ///< integral of xx, yy, zz, xy, xz, yz about the middle, times two
  Vec3d normal{0.0};      ///< sum of the triangles' normals, each as long as twice its area

  /// Sums of parts, without loss. Parts of no area count where none has any: for the middle.
  static PatchSums joined(const PatchSums* parts, int count);
};

/// Unit normal of the plane through the middle of a patch that its points are nearest to: the
/// eigenvector of the smallest eigenvalue of its moments (xx, yy, zz, xy, xz, yz), on the side of
/// `towards`. Patches without width have many: then that nearest to `towards`, or any.
Vec3d leastAxis(const double moments[6], const Vec3d& towards);

/// How far points of a patch are from a plane and from a point, at most; never told too small.
struct PatchExtent
{
  float fromPlane, fromMiddle;
};

/// Sums of each of `count` clusters.
void sumClusters(const TriangleCluster* clusters, int count, PatchSums* sums);

/// Extent of the points of all of `count` clusters about the plane dot(normal, p) = offset and the
/// point `middle`. The normal is a unit vector.
PatchExtent extentOfClusters(const TriangleCluster* clusters, int count, const float normal[3],
  float offset, const float middle[3]);

} // namespace mote
