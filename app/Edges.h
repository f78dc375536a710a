#pragma once

#include "settings/Settings.h"

#include <limits>
#include <optional>
#include <string>

namespace mote::app
{

/// What `mote edges` may be told.
struct EdgesOptions
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

/// Declares the options of `mote edges`.
void addEdgesOptions(CLI::App& app, EdgesOptions& options);

/// Draws the silhouette edges of a depth image over its colours, or on white. Throws Failure.
void drawEdges(const EdgesOptions& options);

} // namespace mote::app
