#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

namespace mote
{

/// A depth image to find silhouettes in. Row 0 is the bottom row.
struct DepthImage
{
  int width = 0, height = 0;      ///< pixels; 0 is an empty image
  const float* depth = nullptr;   ///< one a pixel, world units; not finite: background
  std::ptrdiff_t depthStride = 0; ///< values from one row to the next; 0: `width`
  /// Depths from here on are background, too.
  float background = std::numeric_limits<float>::infinity();

  /// Optional, one a pixel: there is a silhouette also where this changes between two surfaces.
  const std::uint64_t* group = nullptr;
  std::ptrdiff_t groupStride = 0; ///< as depthStride

  /// Perspective: the tangents of the view angle that a pixel spans, and those of the lower left
  /// corner of the image from the view axis; pixel (i, j) looks along (x0 + (i + 1/2) dx,
  /// y0 + (j + 1/2) dy, 1). All 0 for an orthographic view.
  double dx = 0.0, dy = 0.0, x0 = 0.0, y0 = 0.0;
  /// Perspective: whether depth counts along the rays already, and not along the view axis.
  bool alongRays = false;
  /// Orthographic: width of a pixel in world units; 0 where it is not known.
  double pixelSize = 0.0;
};

/// Where silhouettes are, and how they are drawn.
struct SilhouetteOptions
{
  /// World units, at least 0: the least step of depth across a straight border that is drawn.
  double step = 1.0;
  /// ... and never less than the width of so many pixels at that distance: relief finer than pixels
  /// has no outlines. 0 or less: any step will do.
  double stepInPixels = 2.0;
  bool hulls = true; ///< whether surfaces have silhouettes against the background

  double thickness = 1.0; ///< of the strongest lines, in pixels of the output
  /// Of the weakest, as a share of `thickness`, in [0, 1]; it grows with the step's logarithm, in
  /// eight levels. Less than 1 takes several times as long to draw.
  double leastThickness = 1.0;
  double leastOpacity = 1.0; ///< of the weakest lines, in [0, 1]; likewise. 1: no grey levels
  /// Multiples of `step`, above 1, from which on lines are at their strongest. Those against the
  /// background and between groups always are.
  double fullStep = 8.0;
  /// Whether a line's middle lies on the border itself, so that it covers the two pixels beside it
  /// by halves; otherwise it covers the farther pixel, as published.
  bool centered = true;

  /// Pixels of the depth image along each side of a pixel of the output, which is their mean:
  /// lines are smooth. At least 1.
  int reduction = 1;

  bool operator==(const SilhouetteOptions&) const = default;
};

/// Pixels [x0, x1) x [y0, y1).
struct PixelBox
{
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Pixels of the output along a side of `pixels` of the depth image; the last may be cut off.
constexpr int reducedSize(int pixels, int reduction)
{
  return (pixels + reduction - 1) / reduction;
}

/// Pixels of the output around a part of it that must be there, too, for the part to have the same
/// silhouettes as in the whole.
int silhouetteMargin(const SilhouetteOptions& options);

/// Finds the silhouettes of a depth image. They run through its silhouette pixels: those that are
/// farther than the eight around them by more than pixels at a straight border of the least step,
///   sum_i (d_0 - d_i) > 3 step    (3x3 Laplacian of ray distances d, 8 at the centre, -1 around),
/// and farther than the four beside them by more than one step, which keeps slanted lines as thin
/// as others. Only the farther side counts, so no line is double. Neighbours that are background
/// count not, nor do those opposite to them; a background pixel beside a surface is a silhouette
/// pixel of full strength. Where groups differ, the farther pixel is one, and of two equally far
/// ones that with the larger group. Pits of one pixel, which all eight pixels around are nearer
/// than by more than a step, have no outline. At the image's border only steps along it count.
///
/// `coverage` has a float for each pixel of the output, reducedSize() of the image, row after row:
/// each becomes the larger of what it is and the share of the pixel that the lines cover, in [0,
/// 1]. The result does not depend on `threads`; 0: all that TBB's present arena allows. Source:
/// Bigler, "Use of Silhouette Edges and Ambient Occlusion in Particle Visualization", University of
/// Utah 2004; docs/silhouettes.md.
void findSilhouettes(
  const DepthImage& image, const SilhouetteOptions& options, float* coverage, int threads = 0);

/// The same for the pixels `box` of the output alone, in the calling thread. `coverage` is pixel
/// (box.x0, box.y0), and `stride` counts from one row to the next.
void findSilhouettes(const DepthImage& image, const SilhouetteOptions& options, const PixelBox& box,
  float* coverage, std::ptrdiff_t stride);

/// Finds the silhouettes of an image whose output has its size, part by part, in arrays that need
/// not have been cleared.
class SilhouetteFinder
{
public:
  /// Columns that are told of together in `covered`.
  static constexpr int coveredColumns = 16;

  /// The image, and what it views, must outlive this; `reduction` must be 1.
  SilhouetteFinder(const DepthImage& image, const SilhouetteOptions& options);
  ~SilhouetteFinder();
  SilhouetteFinder(const SilhouetteFinder&) = delete;
  SilhouetteFinder& operator=(const SilhouetteFinder&) = delete;

  /// Sets `coverage`, as in findSilhouettes(), to the coverage of the pixels `box`, in the calling
  /// thread. `covered` has a byte for each coveredColumns pixels of a row of the box, row after
  /// row, which becomes 1 where lines may cover some of them and 0 elsewhere. Where it is 0,
  /// `coverage` stays as it is and stands for 0. Thread-safe.
  void find(
    const PixelBox& box, float* coverage, std::ptrdiff_t stride, std::uint8_t* covered) const;

private:
  struct Work;
  std::unique_ptr<Work> work_;
};

} // namespace mote
