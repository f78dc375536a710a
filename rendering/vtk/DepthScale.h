#pragma once

#include "vtkCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

/// Depth-buffer values, 0 at the near clipping plane to 1 at the far one, and distances along the
/// view axis in world units.
class DepthScale
{
public:
  explicit DepthScale(vtkCamera* camera)
    : orthographic_(camera->GetParallelProjection())
    , near_(camera->GetClippingRange()[0])
    , far_(camera->GetClippingRange()[1])
  {
  }

  float valueOf(float distance) const
  {
    if (!std::isfinite(distance))
      return 1.0f;
    const double share = orthographic_ ? (distance - near_) / (far_ - near_)
                                       : far_ * (distance - near_) / (distance * (far_ - near_));
    return static_cast<float>(std::clamp(share, 0.0, 1.0));
  }

  /// Infinity for the value 1, which stands for nothing.
  float distanceOf(float value) const
  {
    if (value >= 1.0f)
      return std::numeric_limits<float>::infinity();
    const double v = value;
    return static_cast<float>(
      orthographic_ ? near_ + v * (far_ - near_) : far_ * near_ / (far_ - v * (far_ - near_)));
  }

private:
  bool orthographic_;
  double near_, far_;
};

} // namespace mote
