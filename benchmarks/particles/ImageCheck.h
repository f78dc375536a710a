#pragma once

#include "HitImage.h"

#include <kernels/core/Camera.h>
#include <support/SphereTree.h>

namespace mote::bench
{

/// Depths of an image's pixels from the reference: t along the view axis, infinity for none.
std::vector<double> referenceDepths(
  const reference::SphereTree& tree, const CameraRays& rays, int width, int height);

/// How far a method's image is from the reference. A pixel is wrong where one hits and the other
/// does not, or where the depths differ by more than 1e-4 of the right one.
struct ImageErrors
{
  static constexpr double tolerance = 1e-4;
  std::size_t checked = 0;
  std::size_t wrong = 0;
  double maxDepthError = 0.0;      ///< relative, over all pixels in which both hit
  double maxRightDepthError = 0.0; ///< relative, over those of them that are not wrong
};

ImageErrors compare(const HitImage& image, const std::vector<double>& depths);

} // namespace mote::bench
