#pragma once

#include "ControlPlaces.h"

#include <imgui.h>

namespace mote::app
{

// Controls of the panel that stand for no row of the table; tests find them by their labels.

inline bool buttonOf(const char* label)
{
  const bool isPressed = ImGui::Button(label);
  noteControl(label);
  return isPressed;
}

/// Of a list.
inline bool lineOf(const char* label, bool isChosen = false)
{
  const bool isPressed = ImGui::Selectable(label, isChosen);
  noteControl(label);
  return isPressed;
}

/// The key that does the same, or a word of help.
inline void explainKey(const char* text)
{
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", text);
}

} // namespace mote::app
