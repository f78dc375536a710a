#include "PickedPanel.h"

#include "PanelWidgets.h"
#include "base/Text.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mote::app
{

bool PickedPanel::isNew(const PickedFacts& facts)
{
  const bool wasEmpty = wasEmpty_;
  wasEmpty_ = !facts.set || (facts.set->empty() && facts.set->numberAway() == 0);
  return wasEmpty && !wasEmpty_;
}

Action PickedPanel::draw(
  const Stage& stage, const PickedFacts& facts, const std::string& coloredBy, Settings& next)
{
  Action action = Action::None;
  const auto button = [&](const char* label, Action meant, const char* help)
  {
    if (buttonOf(label))
      action = meant;
    explainKey(help);
  };
  const PickedSet& set = *facts.set;
  const auto away = static_cast<std::int64_t>(set.numberAway());
  if (set.empty() && away == 0)
    ImGui::TextWrapped("Click on a particle or a cell to pick it; Shift and a click adds. "
                       "Ctrl and drag picks what is in a rectangle.");
  else if (!set.empty())
  {
    ImGui::Text("%s picked", withThousands(static_cast<std::int64_t>(set.items().size())).c_str());
    button("Copy", Action::CopyPicked, "Copy the list, to be pasted into a spreadsheet\nCtrl+C");
    ImGui::SameLine();
    button("Save CSV", Action::SavePicked,
      "Save the list as comma-separated values beside where mote runs\nCtrl+E");
    ImGui::SameLine();
    button("Save JSON", Action::SavePickedJson,
      "Save the list as JSON; of cells with the places of all their points");
    button("Hide picked", Action::HidePicked, "Delete\n--hide-ids");
    ImGui::SameLine();
    button("Only picked", Action::OnlyPicked, "Show only what is picked\ni\n--only-ids");
    ImGui::SameLine();
    button("Save data", Action::SavePickedData,
      "Save the picked particles, or cells, with all arrays as .vtp or .vtu, for other programs");
  }
  if (away > 0)
  {
    const std::string told = withThousands(away) + " picked, not in this time step";
    ImGui::TextWrapped("%s", told.c_str());
    noteControl(told);
  }
  ImGui::Checkbox("rectangles take what is behind, too", facts.picksThrough);
  noteControl("picks through");
  explainKey("Ctrl and drag with the right button does so in any case");
  drawHidden(next);
  if (const auto measured = measure(stage.parts(), set))
    drawMeasured(*measured);
  if (!set.empty())
    this->drawTable(stage, set);
  if (facts.steps > 1 && !set.empty())
    button("Plot over time", Action::PlotOverTime,
      "Reads all time steps for the values of the picked particles, or at the picked places in "
      "cells, and plots them");
  if (facts.overTime)
    if (const Action wanted =
          overTime_.draw(*facts.overTime, facts.times, facts.step, coloredBy, next);
        wanted != Action::None)
      action = wanted;
  return action;
}

void PickedPanel::drawHidden(Settings& next)
{
  SelectionSettings& selection = next.selection;
  if (selection.hidden.empty() && selection.only.empty())
    return;
  const auto tell = [](const IdRanges& ids, const char* what)
  {
    if (!ids.empty())
      ImGui::TextWrapped("%s %s", withThousands(ids.count()).c_str(), what);
  };
  tell(selection.hidden, selection.hidden.count() == 1 ? "id is hidden" : "ids are hidden");
  tell(selection.only, selection.only.count() == 1 ? "id alone is shown" : "ids alone are shown");
  if (buttonOf("Show hidden"))
    selection.hidden = selection.only = {};
  explainKey("Show what is hidden by its id\nu");
  if (!selection.hidden.empty() && !selection.only.empty())
    return; // no list of ids says the opposite
  ImGui::SameLine();
  if (buttonOf("Invert ids"))
    std::swap(selection.hidden, selection.only);
  explainKey("Show the ids that are hidden, and hide those that are shown\n--hide-ids, --only-ids");
}

/// What is between two or three picked.
void PickedPanel::drawMeasured(const Measured& measured)
{
  const auto line = [](const std::string& text)
  {
    ImGui::TextWrapped("%s", text.c_str());
    noteControl(text);
  };
  for (const Distance& distance : measured.distances)
  {
    line("distance " + asText(distance));
    ImGui::TextDisabled("  x %s, y %s, z %s", asNumber(distance.step[0]).c_str(),
      asNumber(distance.step[1]).c_str(), asNumber(distance.step[2]).c_str());
    explainKey("Along x, y and z");
    if (distance.isAcross)
      ImGui::TextDisabled("  %s without the box's images", asNumber(distance.direct).c_str());
  }
  if (measured.angle)
    line("angle " + asNumber(*measured.angle, 5) + "\u00b0");
}

namespace
{

/// What each column needs to show its title and its first cells whole, in pixels.
std::vector<float> widthsOf(const PickedTable& table)
{
  constexpr std::size_t enough = 200;
  const auto widthOf = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  std::vector<float> widths;
  for (std::size_t column = 0; column < table.columns().size(); ++column)
  {
    widths.push_back(widthOf(table.columns()[column]));
    for (std::size_t row = 0; row < std::min(enough, table.rows()); ++row)
      widths.back() = std::max(widths.back(), widthOf(table.cell(row, column, 6)));
  }
  return widths;
}

} // namespace

void PickedPanel::drawTable(const Stage& stage, const PickedSet& set)
{
  std::vector<std::pair<vtkDataSet*, unsigned long>> key;
  for (const auto& part : stage.parts())
    key.emplace_back(part->data(), part->data()->GetMTime());
  if (key != key_ || version_ != set.version() || fontSize_ != ImGui::GetFontSize())
  {
    table_ = PickedTable(stage.parts(), set);
    key_ = key;
    version_ = set.version();
    fontSize_ = ImGui::GetFontSize();
    widths_ = widthsOf(table_);
  }
  constexpr std::size_t most = 60; // ImGui draws up to 64
  const std::size_t columns = std::min(most, table_.columns().size());
  const auto rows = static_cast<int>(table_.rows());
  const float height =
    ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(std::clamp(rows + 2, 4, 12));
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_Resizable;
  // A table keeps the widths of its columns: where others are needed it is another table.
  std::string id = "picked";
  for (const float width : widths_)
    id += "," + std::to_string(std::lround(width));
  if (!ImGui::BeginTable(id.c_str(), static_cast<int>(columns), flags, ImVec2(0.0f, height)))
    return;
  ImGui::TableSetupScrollFreeze(1, 1);
  for (std::size_t column = 0; column < columns; ++column)
    ImGui::TableSetupColumn(
      table_.columns()[column].c_str(), ImGuiTableColumnFlags_WidthFixed, widths_[column]);
  ImGui::TableHeadersRow();
  ImGuiListClipper clipper;
  clipper.Begin(rows);
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
    {
      ImGui::TableNextRow();
      for (std::size_t column = 0; column < columns; ++column)
        if (ImGui::TableSetColumnIndex(static_cast<int>(column)))
          ImGui::TextUnformatted(table_.cell(static_cast<std::size_t>(row), column, 6).c_str());
    }
  ImGui::EndTable();
  noteControl("picked list");
  if (columns < table_.columns().size())
    ImGui::TextDisabled("%s more columns are in copies and files",
      withThousands(static_cast<std::int64_t>(table_.columns().size() - columns)).c_str());
}

} // namespace mote::app
