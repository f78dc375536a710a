#pragma once

namespace mote::app
{

/// Gives the controls of the present context of ImGui their colours, and their size and that of
/// their letters: 1 for a display of 96 dots an inch.
void setPanelLook(double scale);

} // namespace mote::app
