#pragma once

#include "ControlPlaces.h"

#include <imgui.h>

namespace mote::app
{

// Controls of the panel that stand for no row of the table; tests find them by their labels.

/// Of every field for text. The program may change a field's text while it has the keys; what
/// ImGui 1.86 then undoes lies beyond the new text, and it ends the program.
constexpr ImGuiInputTextFlags textFlags = ImGuiInputTextFlags_NoUndoRedo;

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
