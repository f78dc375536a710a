#pragma once

#include "../../core/RayBundle.h"
#include "RlodTreeView.h"

#include <cstdint>

namespace mote
{

/// An error that grows along rays, in the tree's unit: atQ + z * perZ.
struct Tolerance
{
  float atQ = 0.0f, perZ = 0.0f;
};

/// R-LODs are taken whose error radius is less than so many pixels for each pixel of error: hits
/// then lie within the pixels of error of their triangles for 99.9 % of the rays
/// (docs/triangles.md).
constexpr double radiiPerPixel = 2.0;

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
  /// The ray at (x, y) is Q + at[0] + x at[1] + y at[2] + z (way[0] + x way[1] + y way[2]).
  float at[3][3], way[3][3];
  double zOfQ; ///< z counts from there: t = (zOfQ + z) / speed
  double speed;
  float first;      ///< hits with z <= first do not count
  float handedness; ///< 1, or -1 where u, v and the rays' direction are left-handed

  /// x = xScale * (ray's x - xShift), likewise y; xScale is 0 where all x are equal.
  float xShift, yShift, xScale, yScale;
  int side; ///< of a square of rays, 4, 8 or 16; or 0

  /// False where the bundle's vectors lie nearly in one plane, so that single rays are better.
  /// `at` and `way` are placed `withLines` alone.
  bool place(const RlodTreeView& view, const RayBundle& bundle, bool withLines);

  /// Greatest error radius of R-LODs for `poe` pixels of error.
  Tolerance tolerance(const RlodTreeView& view, const RayBundle& bundle, double poe) const;

private:
  /// The middle ray, and what neighbours add to its direction or, without a fan, its origin.
  struct Lines
  {
    Vec3d origin, direction, spread[2];
  };

  void placeLines(const Lines& rays, const Vec3f& entry, bool fan);
  void measure(const RayBundle& bundle);
};

} // namespace mote
