#pragma once

#include <vtkNew.h>

#include <array>
#include <optional>
#include <string>

class vtkMoteSilhouettes;

namespace CLI
{
class App;
} // namespace CLI

namespace mote::app
{

/// What the user may say about silhouettes.
struct SilhouetteChoices
{
  /// "off", "true" for the usual one, or a number of radii; empty: "true" where anything else is
  /// set
  std::string threshold;
  double thickness = 0.0; ///< pixels; 0: choose
  std::optional<std::array<double, 3>> color;
  std::string groups; ///< array with lines between its values, too; empty: none
};

/// Declares them to the command line.
void addSilhouetteOptions(CLI::App& app, SilhouetteChoices& options);

/// The silhouettes of a scene.
class Silhouettes
{
public:
  /// `options` must have been checked.
  explicit Silhouettes(const SilhouetteChoices& options);
  ~Silhouettes();

  /// On or off.
  void toggle();
  bool isOn() const;

  /// For whatever traces the scene.
  vtkMoteSilhouettes* settings() { return settings_; }

private:
  vtkNew<vtkMoteSilhouettes> settings_;
};

} // namespace mote::app
