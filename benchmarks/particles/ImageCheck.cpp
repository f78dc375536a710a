#include "ImageCheck.h"

#include <cmath>

namespace mote::bench
{

std::vector<double> referenceDepths(
  const reference::SphereTree& tree, const CameraRays& rays, int width, int height)
{
  std::vector<double> depths(static_cast<std::size_t>(width) * height);
  forBlocks(width, height, 8,
    [&](int x0, int y0)
    {
      for (int y = y0; y < std::min(height, y0 + 8); ++y)
        for (int x = x0; x < std::min(width, x0 + 8); ++x)
          depths[static_cast<std::size_t>(y) * width + x] =
            tree.cast(reference::cameraRay(rays, x + 0.5, y + 0.5)).t;
    });
  return depths;
}

ImageErrors compare(const HitImage& image, const std::vector<double>& depths)
{
  ImageErrors errors;
  errors.checked = depths.size();
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const auto width = static_cast<std::size_t>(image.width());
    const double t = image.t(static_cast<int>(i % width), static_cast<int>(i / width));
    const bool isHit = std::isfinite(t), wanted = std::isfinite(depths[i]);
    if (!isHit || !wanted)
    {
      errors.wrong += isHit != wanted;
      continue;
    }
    const double error = std::abs(t - depths[i]) / depths[i];
    errors.maxDepthError = std::max(errors.maxDepthError, error);
    if (error <= ImageErrors::tolerance)
      errors.maxRightDepthError = std::max(errors.maxRightDepthError, error);
    else
      ++errors.wrong;
  }
  return errors;
}

} // namespace mote::bench
