#pragma once

#include "Box.h"
#include "RayBundle.h"
#include "Vec.h"

namespace mote
{

/// A camera in world coordinates. Everything is double: the data may lie far from the origin.
struct Camera
{
  enum class Projection
  {
    Perspective,
    Orthographic
  };

  Projection projection = Projection::Perspective;
  Vec3d position{0.0, 0.0, 1.0};
  Vec3d forward{0.0, 0.0, -1.0}; ///< view axis, any length but 0
  Vec3d up{0.0, 1.0, 0.0};       ///< any vector not parallel to `forward`
  double viewAngle = 30.0;       ///< vertical, degrees in (0, 180); perspective only
  double parallelScale = 1.0;    ///< half the height of the view in world units; orthographic only
  double pixelAspect = 1.0;      ///< width of a pixel over its height
  double centerX = 0.0;          ///< shift of the view's centre, in half widths and half heights
  double centerY = 0.0;
  double nearDistance = 0.0; ///< along the view axis; what lies nearer is not seen
  double farDistance = std::numeric_limits<double>::infinity();

  bool operator==(const Camera&) const = default;
};

/// The rays of a camera through the pixels of an image, as linear functions of the pixel: origin
/// and direction of the ray through image position (x, y) are o0 + x ox + y oy and d0 + x dx + y
/// dy. Positions count in pixels from the lower left corner; pixel (i, j) has its centre at (i +
/// 1/2, j + 1/2). Along every ray t is the distance along the view axis.
struct CameraRays
{
  Vec3d o0, ox, oy, d0, dx, dy;
  double tMin, tMax;

  /// `width` and `height` in pixels, at least 1.
  /// Throws Error for a camera with no view direction or an angle outside (0, 180).
  CameraRays(const Camera& camera, int width, int height);

  /// The same rays seen from a coordinate system of which `toLocal` is the affine transform;
  /// t keeps its meaning.
  CameraRays transformed(const Mat4d& toLocal) const;

  Vec3d originAt(double x, double y) const { return o0 + x * ox + y * oy; }
  Vec3d directionAt(double x, double y) const { return d0 + x * dx + y * dy; }

  /// Fills the bundle with the rays of the `side` x `side` pixels (2, 4, 8 or 16) whose lower left
  /// one is (x0, y0), in the order of bundleOffset(), at `jitter` (pixels, 0 is the centre) from
  /// the pixel centres, with nothing hit. Bundles may reach over the image's edge: those rays are
  /// traced and not kept.
  void fillBundle(
    RayBundle& bundle, int side, int x0, int y0, double jitterX, double jitterY) const;

  /// The part of fillBundle() that tells where the rays run: kind, origin, direction, dx, dy, and
  /// the footprint, which is a pixel's width or height, the larger one. With
  /// rays that are transformed() it takes a bundle to another coordinate system, hits and all.
  void placeBundle(
    RayBundle& bundle, int side, int x0, int y0, double jitterX, double jitterY) const;
};

/// Side in pixels (2, 4, 8 or 16) of the bundles that suit the square of `size` pixels at (x0, y0):
/// the larger `spacing`, a length in the world that holds one particle, looks where the square's
/// middle ray passes the middle of the data within `bounds`, or, from within, a quarter of the
/// data's size in front of the eye.
int suitingBundleSide(
  const CameraRays& rays, const Box& bounds, double spacing, int x0, int y0, int size);

} // namespace mote
