#pragma once

#include "Silhouettes.h"

#include <vector>

namespace mote
{

/// Three rows of ray distances, +infinity for background, of the columns [begin, end). Pointers
/// count from column 0, so that `row[x]` is pixel x. At the image's border `up` and `down` are
/// `row`.
struct DistanceRows
{
  const float *down = nullptr, *row = nullptr, *up = nullptr;
};

/// The same of groups.
struct GroupRows
{
  const std::uint64_t *down = nullptr, *row = nullptr, *up = nullptr;
};

/// Where a step becomes an edge: 3 steps, or that share of the distance.
struct StepLimit
{
  float least = 0.0f;
  float share = 0.0f;
  bool hulls = true;
};

/// The pixels of a row that are edges.
struct EdgePixels
{
  /// What writes whole vectors may write beyond the end.
  static constexpr int spare = 16;
  /// Code of the direction in which the nearer pixels lie: (x + 3) + 7 (y + 3), x and y in [-3, 3].
  static constexpr int directions = 49;

  explicit EdgePixels(int width)
    : x(width + spare)
    , step(width + spare)
    , direction(width + spare)
  {
  }

  int count = 0;
  std::vector<std::int32_t> x;
  std::vector<float> step; ///< world units; infinity for those of full strength
  std::vector<std::int32_t> direction;
};

/// Ray distances of row `y` of the image, columns [begin, end), into out[begin, end).
void rayDistances(const DepthImage& image, int y, int begin, int end, float* out);

/// Sets `found` to the edges by depth among the columns [begin, end) of an image `width` wide.
void findSteps(const DistanceRows& rows, const StepLimit& limit, int width, int begin, int end,
  EdgePixels& found);

/// Sets `found` to the edges by group.
void findGroupChanges(const DistanceRows& rows, const GroupRows& groups, int width, int begin,
  int end, EdgePixels& found);

} // namespace mote
