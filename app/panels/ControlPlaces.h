#pragma once

#include <string>

namespace mote::app
{

/// For tests of the window: where controls lie. With the environment's MOTE_CONTROLS the panel
/// writes that file in each frame, a line for each control: name, left, top, right and bottom in
/// pixels of the window; and once more with "active" before the name where the mouse or the keys
/// work it, and with "focused" where the keys have come to it. Without it these do nothing.

/// The control that was drawn last.
void noteControl(const std::string& name);

/// That this is told beside the mouse: a line "tip" with the first line of the text.
void noteTip(const std::string& text);

/// Writes the file of this frame, with a line "inputs", how many presses came so far, and 1 where
/// more frames come for what came, else 0; and a line "keys at" with ImGui's number of the control
/// that the keys have come to.
void writeControls(int inputs, bool isWaiting);

} // namespace mote::app
