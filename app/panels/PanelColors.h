#pragma once

#include <imgui.h>

namespace mote::app
{

/// Colours that several of the panel's drawings share: what they are drawn on, histograms, and what
/// the mouse holds.
constexpr ImU32 drawingGround = IM_COL32(30, 33, 38, 255),
                drawingBar = IM_COL32(120, 160, 210, 255), heldInk = IM_COL32(255, 200, 90, 255);

} // namespace mote::app
