#pragma once

#include "ControlPlaces.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

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

/// A button beside what was drawn last, where there is room for it; else below.
inline bool nextButtonOf(const char* label)
{
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right)
    ImGui::SameLine();
  return buttonOf(label);
}

/// Of a list.
inline bool lineOf(const char* label, bool isChosen = false)
{
  const bool isPressed = ImGui::Selectable(label, isChosen);
  noteControl(label);
  return isPressed;
}

/// The label stands left of its control.
inline void putLabel(const std::string& label)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label.c_str());
  ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
  ImGui::SetNextItemWidth(-1.0f);
}

inline void explainKey(const char* text);

/// A list of names, with `none`, where there may be none, for the empty one; whether another one
/// was chosen. Tests find it as `of` and `label`; `help` is its tooltip.
inline bool chooseName(const std::string& of, const std::string& label,
  const std::vector<std::string>& names, const char* none, const char* help, std::string& chosen)
{
  const std::string before = chosen;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label.c_str());
  ImGui::SameLine(2.2f * ImGui::GetFontSize());
  ImGui::SetNextItemWidth(-1.0f);
  const bool isOpen = ImGui::BeginCombo(("##" + of + label).c_str(),
    chosen.empty() && none ? none : chosen.c_str(), ImGuiComboFlags_HeightLarge);
  noteControl(of + " " + label);
  explainKey(help);
  if (!isOpen)
    return false;
  if (none && lineOf(none, chosen.empty()))
    chosen.clear();
  for (const std::string& name : names)
    if (lineOf(name.c_str(), name == chosen))
      chosen = name;
  ImGui::EndCombo();
  return chosen != before;
}

/// Where the panel ends; 0 where it has all of the window.
inline float rightOfPanel = 0.0f;

/// Where the control lies that was pressed last, while the mouse stays on it; else nowhere.
inline const ImVec2 nowhere(-1.0f, -1.0f);
inline ImVec2 pressedAt = nowhere;

/// The key that does the same, or a word of help: beside the panel, where it hides no control, and
/// not while something is dragged or written: over the view each letter would take a whole frame.
/// Who has pressed a button looks for what it did, which the view may tell there.
inline void explainKey(const char* text)
{
  const ImVec2 at = ImGui::GetItemRectMin();
  if (ImGui::IsItemActive())
    pressedAt = at;
  const bool isPressed = at.x == pressedAt.x && at.y == pressedAt.y;
  if (isPressed && !ImGui::IsItemHovered())
    pressedAt = nowhere;
  if (!ImGui::IsItemHovered() || isPressed || ImGui::IsMouseDown(0))
    return;
  const float wrap = 25.0f * ImGui::GetFontSize();
  if (ImGui::GetItemRectMin().x < rightOfPanel)
  {
    const ImVec2 margin = ImGui::GetStyle().WindowPadding;
    const float height = ImGui::CalcTextSize(text, nullptr, false, wrap).y + 2.0f * margin.y;
    const float lowest = ImGui::GetIO().DisplaySize.y - height;
    const float y = std::max(0.0f, std::min(ImGui::GetItemRectMin().y, lowest));
    ImGui::SetNextWindowPos(ImVec2(rightOfPanel + margin.x, y));
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(wrap);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  noteTip(text);
}

} // namespace mote::app
