#pragma once

#include "Settings.h"

#include <optional>
#include <string>

namespace mote::app
{

/// What each part of the program may err by, so that all of them together keep to --error; without
/// it what the other settings say.
struct ErrorShares
{
  std::optional<double> noise; ///< standard error of colours, from 0 to 1; none: nobody judges it
  double tolerance;            ///< of integrals through volumes
  double cloudTolerance;       ///< between pixels of volumes
  double lodError;             ///< pixels, of levels of detail
};

ErrorShares errorShares(const Settings& settings);

/// How far apart neighbouring rays may be, in pixels, in a view of so many pixels that moves: as
/// --error says, and no farther than that one still knows what there is, unless --fps asks for so
/// many frames.
/// `lodError`: pixels that levels of detail take of --error.
double mostDistance(const PictureSettings& picture, double pixels, double lodError = 0.0);

/// Why the text is no --error, such as "1%" or "0.5px"; empty where it is.
std::string checkError(const std::string& text);

/// The error of colours, from 0 to 1, that a picture with this noise most likely has: root mean
/// square of noise, tolerances and levels of detail. `hasVolumes` tells whether tolerances count;
/// `lodError` are the pixels that levels of detail err by.
double expectedError(
  const ErrorShares& shares, double noise, bool hasVolumes, double lodError = 0.0);

/// Whether --error is of colours, or of places in pixels.
bool isColorError(const PictureSettings& picture);
bool isPlaceError(const PictureSettings& picture);

} // namespace mote::app
