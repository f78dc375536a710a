#pragma once

#include "../Silhouettes.h"
#include "SilhouetteRows.h"

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

/// From which sum over the eight neighbours on a pixel is a silhouette pixel.
struct StepLimit
{
  float least = 0.0f; ///< three steps
  float share = 0.0f; ///< of the distance, where that is more
  bool hulls = true;
};

/// How levels of thickness and opacities follow from steps.
struct SilhouetteGrades
{
  bool graded = false;                 ///< otherwise all lines are alike
  float perStep = 0.0f, perLog = 0.0f; ///< strength = log2(step perStep) perLog, in [0, 1]
  float leastOpacity = 1.0f;
};

/// Ray distances of row `y` of the image, columns [begin, end), into out[begin, end).
void rayDistances(const DepthImage& image, int y, int begin, int end, float* out);

/// Adds the silhouette pixels by depth among the columns [begin, end) of an image `width` wide.
void findSteps(const DistanceRows& rows, const StepLimit& limit, const SilhouetteGrades& grades,
  int width, int begin, int end, const SilhouetteRow& found);

/// Adds the silhouette pixels by group.
void findGroupChanges(const DistanceRows& rows, const GroupRows& groups, int width, int begin,
  int end, const SilhouetteRow& found);

} // namespace mote
