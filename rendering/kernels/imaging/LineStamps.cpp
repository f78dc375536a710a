#include "LineStamps.h"

#include "SilhouetteRows.h"

#include <algorithm>
#include <cmath>

namespace mote
{

LineStamps::LineStamps(const SilhouetteOptions& options)
  : inverseStep_(static_cast<float>(1.0 / std::max(options.step, 1e-30)))
  , inverseLog_(static_cast<float>(1.0 / std::log(std::max(options.fullStep, 1.0 + 1e-6))))
  , leastOpacity_(static_cast<float>(std::clamp(options.leastOpacity, 0.0, 1.0)))
  , graded_(options.leastOpacity < 1.0 || options.leastThickness != options.thickness)
{
  const int count = graded_ ? levels : 1;
  stamps_.resize(static_cast<std::size_t>(count) * EdgePixels::directions);
  for (int level = 0; level < count; ++level)
  {
    const double strength = graded_ ? level / (levels - 1.0) : 1.0;
    const double thickness =
      options.leastThickness + strength * (options.thickness - options.leastThickness);
    for (int direction = 0; direction < EdgePixels::directions; ++direction)
      make(std::max(0.0, thickness) * options.reduction, options.centered, direction,
        stamps_[level * EdgePixels::directions + direction]);
  }
}

const std::vector<LineStamps::Pixel>& LineStamps::stamp(
  float step, int direction, float& opacity) const
{
  opacity = 1.0f;
  if (!graded_)
    return stamps_[direction];
  const float strength = std::clamp(std::log(step * inverseStep_) * inverseLog_, 0.0f, 1.0f);
  opacity = leastOpacity_ + strength * (1.0f - leastOpacity_);
  const int level = static_cast<int>(strength * (levels - 1) + 0.5f);
  return stamps_[level * EdgePixels::directions + direction];
}

void LineStamps::make(double thickness, bool centered, int direction, std::vector<Pixel>& stamp)
{
  double nx = direction % 7 - 3, ny = direction / 7 - 3;
  const double length = std::hypot(nx, ny);
  double away = 0.0, half = 0.0;
  if (centered && length > 0.0)
  {
    nx /= length;
    ny /= length;
    // The border runs between the pixel and that beside it to which it is turned the most, so the
    // distance from the pixel's centre is even between 0 and this.
    const double most = std::max(std::abs(nx), std::abs(ny));
    away = 0.5 * most;
    // Pieces of a diagonal are 1.41 pixels apart, and meet; those along an axis are 1 pixel apart,
    // and must not stick out at the line's end.
    half = 1.7 * (1.0 / most - 1.0);
  }
  // A line thinner than a pixel is as wide as one, and fainter.
  const double radius = 0.5 * std::max(1.0, thickness) + 0.5;
  const int reach = static_cast<int>(std::ceil(radius + away + half));
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
    {
      const double across = nx * x + ny * y - away, along = nx * y - ny * x;
      const double distance = half > 0.0 || away > 0.0
                                ? std::hypot(across, std::max(0.0, std::abs(along) - half))
                                : std::hypot(x, y);
      const double coverage = std::clamp(radius - distance, 0.0, 1.0);
      if (thickness > 0.0 && coverage > 1e-6)
      {
        stamp.push_back({x, y, static_cast<float>(coverage * std::min(1.0, thickness))});
        reach_ = std::max({reach_, std::abs(x), std::abs(y)});
      }
    }
}

} // namespace mote
