#include "ErrorBudget.h"

#include "base/Text.h"

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr double coarsest = 32.0; // pixels between rays, without a budget
/// Tolerances are of the largest error. Measured: the root mean square is less than this share.
constexpr double meanShare = 0.4;

/// Levels of detail make colours wrong by this times the square of their pixels of error. Measured
/// with a sphere of a million triangles; little of it is seen below one pixel.
constexpr double colorsOfLods = 0.006;

/// The number before the unit; none where there is another unit or no number.
std::optional<double> amountOf(const std::string& text, const std::string& unit)
{
  double number = 0.0;
  if (text.size() <= unit.size() || text.substr(text.size() - unit.size()) != unit ||
      !parseNumber(text.substr(0, text.size() - unit.size()), number) || !std::isfinite(number))
    return std::nullopt;
  return number;
}

} // namespace

std::string checkError(const std::string& text)
{
  const auto share = amountOf(text, "%"), pixels = amountOf(text, "px");
  if (!share && !pixels)
    return "'" + text + "' is neither a share of colours, such as 1%, nor pixels, such as 0.5px";
  if (share && !(*share > 0.0 && *share <= 100.0))
    return "an error of colours must be above 0 and at most 100 %";
  if (pixels && *pixels < 0.5)
    return "an error of places must be at least 0.5px, which is full resolution";
  return {};
}

bool isColorError(const PictureSettings& picture)
{
  return amountOf(picture.error, "%").has_value();
}

bool isPlaceError(const PictureSettings& picture)
{
  return amountOf(picture.error, "px").has_value();
}

double mostDistance(const PictureSettings& picture, double pixels, double lodError)
{
  constexpr double leastRays = 4096.0;
  double most = picture.fps ? coarsest : std::min(coarsest, std::sqrt(pixels / leastRays));
  if (const auto error = amountOf(picture.error, "px"))
    most = std::min(most, 2.0 * (*error - lodError)); // a ray is half of it away
  return std::max(1.0, most);
}

ErrorShares errorShares(const Settings& settings)
{
  const VolumeSettings& volume = settings.volume;
  ErrorShares shares = {
    settings.picture.noise, volume.tolerance, volume.cloudTolerance, settings.picture.lodError};
  const bool choosesLods = shares.lodError == 0.0;
  // Half of the error of places is for the distance of rays, which at full resolution takes 0.5 px.
  if (const auto pixels = amountOf(settings.picture.error, "px"); pixels && choosesLods)
    shares.lodError = std::min({0.5 * *pixels, *pixels - 0.5, 64.0});
  if (const auto percent = amountOf(settings.picture.error, "%"))
  {
    // Root mean squares of the three are 0.85, 0.16 and 0.32 of the budget, together 0.92; that of
    // levels of detail, which volumes have none of, is 0.15.
    const double budget = 0.01 * *percent;
    shares.noise = 0.85 * budget;
    if (choosesLods)
      shares.lodError = 0.5 * std::sqrt(*percent);
    const VolumeSettings usual;
    if (volume.tolerance == usual.tolerance)
      shares.tolerance = std::min(0.1, 0.4 * budget);
    if (volume.cloudTolerance == usual.cloudTolerance)
      shares.cloudTolerance = std::min(0.1, 0.8 * budget);
  }
  return shares;
}

double expectedError(const ErrorShares& shares, double noise, bool hasVolumes, double lodError)
{
  const double all = std::hypot(noise, colorsOfLods * lodError * lodError);
  return hasVolumes
           ? std::hypot(all, meanShare * shares.tolerance, meanShare * shares.cloudTolerance)
           : all;
}

} // namespace mote::app
