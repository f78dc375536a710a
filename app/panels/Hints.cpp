#include "Hints.h"

#include "PanelWidgets.h"

#include <imgui.h>

#include <iterator>

namespace mote::app
{

namespace
{

constexpr const char* hints[] = {"Drag in the view to turn the data, with Shift to move it; the "
                                 "wheel zooms. Key r shows all again.",
  "The list under Colour chooses what colours mean; key c goes to the next array, m to the next "
  "colour map.",
  "Under Selection, show a range of an array, and drag its ends: what lies outside is hidden at "
  "once.",
  "Rest the mouse on a particle to see its values. Key p keeps them in view.",
  "Rest the mouse on a control to see what it does, and its name on the command line. Ctrl+Z "
  "undoes "
  "everything.",
  "Key s saves a picture, Ctrl+S a session that opens again as it was, h lists all keys, Tab folds "
  "this panel away."};
constexpr int count = static_cast<int>(std::size(hints));

} // namespace

Hints::Hints()
  : state_(readUserState())
{
}

void Hints::remember() const
{
  changeUserState(
    [this](UserState& state)
    {
      state.hintsSeen = state_.hintsSeen;
      state.hints = state_.hints;
    });
}

void Hints::draw()
{
  if (isLater_ || !state_.hints || state_.hintsSeen >= count)
    return;
  const bool isLast = state_.hintsSeen + 1 == count;
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.75f, 0.88f, 1.0f, 1.0f));
  ImGui::TextWrapped("%s", hints[state_.hintsSeen]);
  ImGui::PopStyleColor();
  if (buttonOf(isLast ? "Done" : "Next hint"))
  {
    ++state_.hintsSeen;
    this->remember();
  }
  explainKey(isLast ? "This was the last hint" : "Go on to the next hint");
  if (!isLast)
  {
    ImGui::SameLine();
    if (buttonOf("Later"))
      isLater_ = true;
    explainKey("Go on with the hints at the next start");
    ImGui::SameLine();
    if (buttonOf("No hints"))
    {
      state_.hints = false;
      this->remember();
    }
    explainKey("Show no hints any more");
  }
  ImGui::SameLine();
  ImGui::TextDisabled("%d of %d", std::min(state_.hintsSeen + 1, count), count);
  ImGui::Separator();
}

} // namespace mote::app
