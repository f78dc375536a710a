#pragma once

#include "settings/Settings.h"

class vtkMoteSilhouettes;

namespace mote::app
{

/// Whether these settings draw lines: where they say so, or, with "auto", how lines look.
bool areOn(const SilhouetteSettings& settings);

/// The settings after the next press of a key: on, as they were asked for, or off.
SilhouetteSettings toggled(const SilhouetteSettings& now, const SilhouetteSettings& asked);

/// Lines that are so many times as thick, within what thicknesses may be.
SilhouetteSettings scaled(SilhouetteSettings settings, double factor);

/// Why the text is no SilhouetteSettings::lines, or thickness; empty where it is.
std::string checkLines(const std::string& text);
std::string checkThickness(const std::string& text);

/// Hands the settings on. `mode` is a vtkMoteSilhouettes::ThresholdModes: what the threshold's
/// number counts where it has no %.
void choose(const SilhouetteSettings& settings, int mode, vtkMoteSilhouettes* silhouettes);

} // namespace mote::app
