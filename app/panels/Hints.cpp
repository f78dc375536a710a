#include "Hints.h"

#include "PanelWidgets.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace mote::app
{

namespace
{

struct Hint
{
  const char* text;
  bool ofVolumes = false; ///< for who sees volumes alone
};

constexpr Hint hints[] = {
  {"Drag in the view to turn the data, with Shift to move it; the wheel zooms. Key r shows all "
   "again."},
  {"The list under Colour chooses what colours mean; key c goes to the next array, m to the next "
   "colour map."},
  {"Key w shows a volume as a cloud, and again as walls and slices.", true},
  {"Open Slices or Cuts: what cuts the data has an outline and a mark in its middle then, by which "
   "you drag it. Key n shows them always.",
    true},
  {"Under Selection, show a range of an array, and drag its ends: what lies outside is hidden at "
   "once."},
  {"Rest the mouse on a particle to see its values. Key p keeps them in view."},
  {"Rest the mouse on a control to see what it does, and its name on the command line. Ctrl+Z "
   "undoes everything."},
  {"Key s saves a picture, Ctrl+S a session that opens again as it was, h lists all keys, Tab "
   "folds this panel away."}};
constexpr int count = static_cast<int>(std::size(hints));

/// Of the first so many, those that are for who sees such data.
int countOf(int end, bool hasVolumes)
{
  return static_cast<int>(std::count_if(
    hints, hints + end, [&](const Hint& hint) { return hasVolumes || !hint.ofVolumes; }));
}

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

void Hints::draw(bool hasVolumes)
{
  while (state_.hintsSeen < count && hints[state_.hintsSeen].ofVolumes && !hasVolumes)
    ++state_.hintsSeen;
  if (isLater_ || !state_.hints || state_.hintsSeen >= count)
    return;
  const bool isLast = state_.hintsSeen + 1 == count;
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.75f, 0.88f, 1.0f, 1.0f));
  ImGui::TextWrapped("%s", hints[state_.hintsSeen].text);
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
  ImGui::TextDisabled("%d of %d", countOf(std::min(state_.hintsSeen + 1, count), hasVolumes),
    countOf(count, hasVolumes));
  ImGui::Separator();
}

} // namespace mote::app
