#include "PanelKeys.h"

#include <imgui.h>

#include <cstring>
#include <iterator>

namespace mote::app
{

namespace
{

/// Keys that ImGui asks for by meaning, and X11's names for them.
struct KeyName
{
  const char* symbol;
  int key;
};
constexpr KeyName keyNames[] = {{"Tab", ImGuiKey_Tab}, {"Left", ImGuiKey_LeftArrow},
  {"Right", ImGuiKey_RightArrow}, {"Up", ImGuiKey_UpArrow}, {"Down", ImGuiKey_DownArrow},
  {"Prior", ImGuiKey_PageUp}, {"Next", ImGuiKey_PageDown}, {"Home", ImGuiKey_Home},
  {"End", ImGuiKey_End}, {"Insert", ImGuiKey_Insert}, {"Delete", ImGuiKey_Delete},
  {"BackSpace", ImGuiKey_Backspace}, {"space", ImGuiKey_Space}, {"Return", ImGuiKey_Enter},
  {"Escape", ImGuiKey_Escape}, {"KP_Enter", ImGuiKey_KeyPadEnter}, {"a", ImGuiKey_A},
  {"c", ImGuiKey_C}, {"v", ImGuiKey_V}, {"x", ImGuiKey_X}, {"y", ImGuiKey_Y}, {"z", ImGuiKey_Z}};

} // namespace

void mapKeys(ImGuiIO& io)
{
  for (std::size_t i = 0; i < std::size(keyNames); ++i)
    io.KeyMap[keyNames[i].key] = static_cast<int>(i);
}

int placeOfKey(const char* symbol)
{
  for (std::size_t i = 0; i < std::size(keyNames); ++i)
    if (std::strcmp(keyNames[i].symbol, symbol) == 0)
      return static_cast<int>(i);
  return -1;
}

bool isForMoving(const char* symbol)
{
  for (const char* moving : {"Left", "Right", "Up", "Down", "Prior", "Next", "Home", "End", "space",
         "Return", "Escape", "Insert", "Delete"})
    if (std::strcmp(moving, symbol) == 0)
      return true;
  return false;
}

} // namespace mote::app
