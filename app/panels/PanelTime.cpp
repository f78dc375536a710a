// The panel's section of time: play, step, and what is read ahead.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"

#include <imgui.h>

#include <algorithm>

namespace mote::app
{

void Panel::drawTime(const PanelFacts& facts)
{
  // One step leaves little to do.
  const bool isOpen =
    ImGui::CollapsingHeader("Time", facts.steps > 1 ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  noteControl("group Time");
  if (!isOpen)
    return;
  if (facts.steps < 2)
  {
    rows_.draw(*commandRow("mote", "follow"), next_, "follow");
    return;
  }
  const auto stepButton = [&](const char* label, int step, const char* help)
  {
    if (buttonOf(label) && step >= 0 && step < facts.steps && step != facts.step)
    {
      next_.data.time.reset();
      next_.data.step = std::to_string(step + 1);
    }
    explainKey(help);
    ImGui::SameLine();
  };
  stepButton("|<", 0, "The first time step\nHome");
  stepButton("<", facts.step - 1, "The time step before\nLeft");
  if (buttonOf(facts.isPlaying ? "Pause" : "Play"))
    this->wish(Action::Play);
  explainKey("Play the time steps one after the other, or pause\nspace");
  ImGui::SameLine();
  stepButton(">", facts.step + 1, "The next time step\nRight");
  stepButton(">|", facts.steps - 1, "The last time step\nEnd");
  rows_.draw(*commandRow("mote", "loop"), next_, "loop");
  ImGui::SameLine();
  rows_.draw(*commandRow("mote", "follow"), next_, "follow");
  this->drawCache(facts);
  this->drawStep(facts);
  rows_.draw(*commandRow("mote", "cache"), next_, "memory for steps");
  const bool anyPicked = facts.picked.set && facts.picked.set->hasParticles();
  const bool areShown = !next_.marks.trajectories.empty();
  if (anyPicked && buttonOf("Paths of the picked"))
    this->wish(Action::PathsOfPicked);
  if (anyPicked)
    RowControls::explain(*rowNamed("trajectories"));
  if (anyPicked && areShown)
    ImGui::SameLine();
  if (areShown && buttonOf("No paths"))
    next_.marks.trajectories = {};
  if (areShown)
    explainKey("Take the paths away\nwithout --trajectories");
}

void Panel::drawStep(const PanelFacts& facts)
{
  int step = facts.step + 1;
  ImGui::SetNextItemWidth(-1.0f);
  const std::string shown = "step %d of " + std::to_string(facts.steps);
  if (ImGui::SliderInt(
        "##step", &step, 1, facts.steps, shown.c_str(), ImGuiSliderFlags_AlwaysClamp) &&
      step != facts.step + 1)
  {
    next_.data.time.reset();
    next_.data.step = std::to_string(step);
  }
  RowControls::explain(*rowNamed("step"));
  ImGui::AlignTextToFramePadding();
  if (facts.shownStep != facts.step)
  {
    const std::string time = facts.hasTimes ? "t = " + asNumber(facts.time, 10) + ", " : "";
    const std::string text = "step " + std::to_string(facts.shownStep + 1) + " until that is read";
    return ImGui::TextUnformatted((time + text).c_str());
  }
  ImGui::TextUnformatted(facts.hasTimes ? "t" : "");
  if (facts.hasTimes)
  {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(0.53f * ImGui::GetWindowContentRegionMax().x - ImGui::GetCursorPosX());
    if (double time = facts.time; numberField("##time", time, "%.10g"))
      next_.data.time = time;
    RowControls::explain(*rowNamed("time"));
  }
  ImGui::SameLine(0.55f * ImGui::GetWindowContentRegionMax().x);
  ImGui::SetNextItemWidth(-1.0f);
  const Row& row = *commandRow("mote", "speed");
  auto speed = static_cast<float>(next_.output.speed);
  if (ImGui::SliderFloat("##speed", &speed, static_cast<float>(row.limits.least),
        static_cast<float>(row.limits.most), "%.3g steps/s",
        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
    next_.output.speed = std::clamp(static_cast<double>(speed), row.limits.least, row.limits.most);
  RowControls::explain(row);
}

/// A bar above the slider: where steps are in memory, as players of films have it.
void Panel::drawCache(const PanelFacts& facts)
{
  using Mark = StepCache::Mark;
  const auto& marks = facts.cache.marks;
  if (marks.empty())
    return;
  const float height = 0.35f * ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy(ImVec2(width, height));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(
    at, ImVec2(at.x + width, at.y + height), ImGui::GetColorU32(ImGuiCol_FrameBg));
  const float share = width / static_cast<float>(marks.size());
  int here = 0;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    here += marks[i] == Mark::Here;
    if (marks[i] == Mark::Away)
      continue;
    const auto from = static_cast<float>(i);
    draw->AddRectFilled(ImVec2(at.x + share * from, at.y),
      ImVec2(at.x + share * (from + 1.0f), at.y + height),
      ImGui::GetColorU32(
        marks[i] == Mark::Here ? ImGuiCol_PlotHistogram : ImGuiCol_PlotHistogramHovered,
        marks[i] == Mark::Here ? 0.8f : 0.4f));
  }
  noteControl("cache " + std::to_string(here) + "/" + std::to_string(marks.size()));
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s of %s in memory: %s of %s\n--cache SIZE", withThousands(here).c_str(),
      counted(facts.steps, "time step").c_str(),
      asBytes(static_cast<double>(facts.cache.bytes)).c_str(),
      asBytes(static_cast<double>(facts.cache.budget)).c_str());
}

} // namespace mote::app
