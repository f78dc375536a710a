#pragma once

#include "table/CommandLine.h"

#include <limits>
#include <optional>
#include <string>

namespace mote::app
{

/// What `mote silhouettes` may be told.
struct ImageSilhouetteOptions
{
  /// Narrow lines, grey where steps are small, from 1 % of what the image shows on.
  ImageSilhouetteOptions();

  std::string image;
  std::string output;
  std::string depth;   ///< channel or array; empty: choose
  GivenSettings given; ///< silhouettes and threads of it
  int reduction = 1;
  bool linesAlone = false;
  double viewAngle = 30.0;
  std::optional<double> orthographic; ///< height of the view in world units
  bool alongRays = false;
  double farDepth = std::numeric_limits<double>::infinity();
};

/// Declares the options of `mote silhouettes`.
void addImageSilhouetteOptions(CLI::App& app, ImageSilhouetteOptions& options);

/// Draws the silhouettes of a depth image over its colours, or on white. Throws Failure.
void drawImageSilhouettes(const ImageSilhouetteOptions& options);

} // namespace mote::app
