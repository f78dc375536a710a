#pragma once

#include "settings/Settings.h"

#include <vtkNew.h>

class vtkMoteSilhouettes;

namespace mote::app
{

/// The silhouettes of the picture, as the settings say.
class Silhouettes
{
public:
  /// The settings are those of the scene.
  explicit Silhouettes(const SilhouetteSettings& settings);
  ~Silhouettes();

  /// Follows the settings.
  void update();
  bool isOn() const;

  /// For whatever traces the picture.
  vtkMoteSilhouettes* options() const { return options_; }

private:
  const SilhouetteSettings& settings_;
  vtkNew<vtkMoteSilhouettes> options_;
};

/// The settings after the next press of a key: on, as they were asked for, or off.
SilhouetteSettings toggled(const SilhouetteSettings& now, const SilhouetteSettings& asked);

/// Whether these settings draw lines.
bool areOn(const SilhouetteSettings& settings);

} // namespace mote::app
