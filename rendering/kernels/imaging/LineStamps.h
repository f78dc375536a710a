#pragma once

#include "Silhouettes.h"

#include <vector>

namespace mote
{

/// What one edge pixel covers of the pixels around it, for each direction and strength.
///
/// A line is made of short pieces, one for each edge pixel: a piece is as far from the pixel's
/// centre as the border is on average, runs across the direction in which the nearer pixels lie,
/// and is long enough to meet its neighbours. A pixel at a distance r from it is covered by
/// thickness / 2 + 1/2 - r, in [0, 1]; lines thinner than a pixel are fainter instead.
class LineStamps
{
public:
  struct Pixel
  {
    int x, y; ///< from the edge pixel
    float coverage;
  };

  explicit LineStamps(const SilhouetteOptions& options);

  /// Pixels beyond this are never covered, along an axis.
  int reach() const { return reach_; }
  /// For a step in world units and a code of EdgePixels.
  const std::vector<Pixel>& stamp(float step, int direction, float& opacity) const;

private:
  static constexpr int levels = 16;

  void make(double thickness, bool centered, int direction, std::vector<Pixel>& stamp);

  std::vector<std::vector<Pixel>> stamps_; ///< direction by direction for each level
  float inverseStep_, inverseLog_;         ///< strength = log(step * inverseStep) * inverseLog
  float leastOpacity_;
  bool graded_;
  int reach_ = 0;
};

} // namespace mote
