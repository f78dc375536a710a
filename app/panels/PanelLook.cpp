#include "PanelLook.h"

#include <imgui.h>

#include <cmath>
#include <filesystem>

namespace mote::app
{

namespace
{

void addFont(double scale)
{
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.FontGlobalScale = 1.0f;
  const float size = std::floor(static_cast<float>(14.5 * scale));
  static const ImWchar glyphs[] = {
    0x20, 0x24f, 0x370, 0x3ff, 0x2010, 0x2027, 0x2190, 0x2193, 0x2212, 0x2212, 0x25a0, 0x25cf, 0};
  for (const char* file : {MOTE_PANEL_FONT, "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"})
    if (*file && std::filesystem::exists(file) &&
        io.Fonts->AddFontFromFileTTF(file, size, nullptr, glyphs))
      return;
  io.Fonts->AddFontDefault();
  io.FontGlobalScale = static_cast<float>(scale);
}

} // namespace

void setPanelLook(double scale)
{
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  ImGui::StyleColorsDark();
  style.WindowRounding = style.FrameRounding = style.GrabRounding = 3.0f;
  style.WindowBorderSize = 0.0f;
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.13f, 0.14f, 0.16f, 1.0f);
  style.Colors[ImGuiCol_PopupBg] = ImVec4(0.11f, 0.12f, 0.14f, 1.0f);
  style.ScaleAllSizes(static_cast<float>(scale));
  addFont(scale);
}

} // namespace mote::app
