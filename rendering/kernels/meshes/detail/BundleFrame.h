#pragma once

#include "../../core/RayBundle.h"
#include "RlodTreeView.h"

#include <cstdint>

namespace mote
{

/// A bundle's rays in the tree's coordinates, as a picture: the ray at (x, y) meets the point p
/// where u(p) = x s(p) and v(p) = y s(p), at the depth z(p). u, v, z are linear in p, and s in z:
/// it is 1 for rays of one direction, and for rays of one origin how far p lies along the view
/// axis.
///
/// All are formed in double and count from Q, where the middle ray enters the triangles, so that
/// float numbers are small and their errors relative to the tree, not to the camera's distance.
/// x and y are in steps of a square of rays, or so that all rays lie within [-7.5, 7.5].
struct BundleFrame
{
  static constexpr int blocks = RayBundle::capacity / 16;

  float q[3];
  alignas(
    16) float perAxis[3]
                     [4];   ///< what a step along an axis adds to u, v, z; the fourth numbers are 0
  alignas(16) float atQ[4]; ///< u and v at Q; 0; 0
  float weightAtQ, weightPerZ; ///< s at Q, and what a step of z adds
  double zOfQ;                 ///< z counts from there: t = (zOfQ + z) / speed
  double speed;
  float first; ///< hits with z <= first do not count

  /// x = xScale * (ray's x - xShift), likewise y; xScale is 0 where all x are equal.
  float xShift, yShift, xScale, yScale;
  int side; ///< of a square of rays, 4, 8 or 16; or 0

  /// False where the bundle's vectors lie nearly in one plane, so that single rays are better.
  bool place(const RlodTreeView& view, const RayBundle& bundle);

private:
  void measure(const RayBundle& bundle);
};

} // namespace mote
