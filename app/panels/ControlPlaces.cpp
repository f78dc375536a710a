#include "ControlPlaces.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cstdio>
#include <cstdlib>

namespace mote::app
{

namespace
{

const char* const file = std::getenv("MOTE_CONTROLS");
std::string lines; ///< of this frame

} // namespace

void noteControl(const std::string& name)
{
  if (!file)
    return;
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  char places[96];
  std::snprintf(places, sizeof places, " %.0f %.0f %.0f %.0f\n", from.x, from.y, to.x, to.y);
  lines += name + places;
  if (ImGui::IsItemActive())
    lines += "active " + name + places;
  if (ImGui::IsItemFocused() && !GImGui->NavDisableHighlight)
    lines += "focused " + name + places;
}

void noteTip(const std::string& text)
{
  if (file)
    lines += "tip " + text.substr(0, text.find('\n')) + " 0 0 0 0\n";
}

void writeControls(int inputs, bool isWaiting)
{
  if (!file)
    return;
  const std::string beside = std::string(file) + ".new";
  if (std::FILE* out = std::fopen(beside.c_str(), "w"))
  {
    std::fputs(lines.c_str(), out);
    std::fprintf(out, "inputs %d %d\nkeys at %u\n", inputs, isWaiting ? 1 : 0, GImGui->NavId);
    std::fclose(out);
    std::rename(beside.c_str(), file); // whoever reads sees all of a frame
  }
  lines.clear();
}

} // namespace mote::app
