// The panel's section of recordings: what is done in the window, written down and done again.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"

#include <imgui.h>

namespace mote::app
{

namespace
{

/// How fast recordings are played.
void drawSpeed(double& speed)
{
  const auto named = [](double value)
  { return value > 0.0 ? "x " + asNumber(value) : std::string("as fast as it goes"); };
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("speed");
  ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
  ImGui::SetNextItemWidth(-1.0f);
  const bool isOpen = ImGui::BeginCombo("##speed", named(speed).c_str());
  RowControls::explain(*commandRow("mote", "play-speed"));
  if (!isOpen)
    return;
  for (const double choice : {0.5, 1.0, 2.0, 5.0, 20.0, 0.0})
    if (lineOf(named(choice).c_str(), choice == speed))
      speed = choice;
  ImGui::EndCombo();
}

} // namespace

void Panel::drawRecording(const PanelFacts& facts)
{
  const bool isOpen = ImGui::CollapsingHeader(
    facts.isRecording ? "Recording (on)###recording" : "Recording###recording");
  noteControl("group Recording");
  if (!isOpen)
    return;
  ImGui::PushID("Recording");
  const auto draw = [this](const char* name, const char* label)
  { rows_.draw(*commandRow("mote", name), next_, label); };
  if (!facts.isRecording)
    draw("record", "write to");
  if (buttonOf(facts.isRecording ? "Stop recording" : "Record"))
    this->wish(Action::Record);
  explainKey("Write down what is done in the window from now on, until this is pressed again. "
             "Nothing is picked at its beginning");
  if (facts.isRecording)
  {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(next_.output.record.c_str());
  }
  if (facts.played.empty())
  {
    draw("play", "play");
    drawSpeed(next_.output.playSpeed);
  }
  if (buttonOf(facts.played.empty() ? "Play recording" : "Stop playing"))
    this->wish(Action::PlayRecording);
  explainKey("Do again what was recorded, with the data that it names\nEscape stops it");
  if (!facts.played.empty())
  {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(facts.played.c_str());
    noteControl("played");
  }
  ImGui::Spacing();
  ImGui::PopID();
}

} // namespace mote::app
