#pragma once

#include <string>

namespace mote::app
{

/// For tests of the window: where controls lie. With the environment's MOTE_CONTROLS the panel
/// writes that file in each frame, a line for each control: name, left, top, right and bottom in
/// pixels of the window. Without it these do nothing.

/// The control that was drawn last.
void noteControl(const std::string& name);

/// Writes the file of this frame.
void writeControls();

} // namespace mote::app
