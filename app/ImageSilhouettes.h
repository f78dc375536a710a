#pragma once

#include "ViewOptions.h"

#include <limits>
#include <optional>
#include <string>

namespace mote::app
{

/// What `mote silhouettes` may be told.
struct ImageSilhouetteOptions
{
  std::string image;
  std::string output;
  std::string depth;            ///< channel or array; empty: choose
  std::string groups;           ///< likewise; empty: none
  std::string threshold = "1%"; ///< world units, or with % a share of the scene's size
  double stepInPixels = 2.0;
  std::string thickness = "1"; ///< pixels, or LEAST:MOST
  double leastOpacity = 0.3;
  bool hulls = true;
  bool onPixels = false;
  int reduction = 1;
  Color color = {0.05, 0.05, 0.05};
  bool linesAlone = false;
  double viewAngle = 30.0;
  std::optional<double> orthographic; ///< height of the view in world units
  bool alongRays = false;
  double farDepth = std::numeric_limits<double>::infinity();
  int threads = 0;
};

/// Declares the options of `mote silhouettes`.
void addImageSilhouetteOptions(CLI::App& app, ImageSilhouetteOptions& options);

/// Draws the silhouettes of a depth image over its colours, or on white. Throws Failure.
void drawImageSilhouettes(const ImageSilhouetteOptions& options);

} // namespace mote::app
