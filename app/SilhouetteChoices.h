#pragma once

#include <array>
#include <string>

class vtkMoteSilhouettes;

namespace CLI
{
class App;
} // namespace CLI

namespace mote::app
{

/// What the user may say about silhouettes, of a scene as of a depth image.
struct SilhouetteChoices
{
  /// What a new vtkMoteSilhouettes has, but for the threshold.
  SilhouetteChoices();

  /// A number, or with % a share of the scene's size; "off", or "true" for the usual one; empty:
  /// "true" where anything else is said
  std::string threshold;
  bool styled = false;   ///< whether anything else is said
  std::string thickness; ///< pixels, or LEAST:MOST
  double leastOpacity;
  std::array<double, 3> color;
  double stepInPixels;
  std::string groups; ///< array with lines between its values, too; empty: none
  bool hulls;
  bool onPixels;
};

/// Declares all but the threshold, under names that begin with `prefix`, such as "--".
void addLineOptions(CLI::App& app, SilhouetteChoices& choices, const std::string& prefix);

/// The same with --silhouettes, whose numbers are radii of a typical particle.
void addSilhouetteOptions(CLI::App& app, SilhouetteChoices& choices);

/// Why the text is no threshold in this unit; empty where it is one.
std::string checkThreshold(const std::string& text, const std::string& unit);

/// Hands the choices on, which must have been checked. `mode` is a
/// vtkMoteSilhouettes::ThresholdModes: what the threshold's number counts where it has no %.
void choose(const SilhouetteChoices& choices, int mode, vtkMoteSilhouettes* silhouettes);

} // namespace mote::app
