// What colours, and the opacities and isosurfaces of volumes.

#include "Panel.h"

#include "PanelWidgets.h"
#include "stage/Coloring.h"

#include <vtkLookupTable.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

void Panel::drawColour()
{
  const Coloring& coloring = stage_.coloring();
  const Row& row = *rowNamed("color-by");
  drawn_.insert(row.name);
  ImGui::SetNextItemWidth(-1.0f);
  const bool isOpen = ImGui::BeginCombo("##color-by",
    coloring.choice() ? coloring.title().c_str() : "one colour", ImGuiComboFlags_HeightLarge);
  RowControls::explain(row);
  if (isOpen)
  {
    for (const NamedArray& array : found_.arrays)
      if (lineOf(array.title.c_str(), array.choice == coloring.choice()))
        next_.color.array = array.text;
    if (!found_.hasVolumes && lineOf("one colour", !coloring.choice()))
      next_.color.array = "none";
    if (!found_.others.empty())
      ImGui::Separator();
    for (const NamedArray& array : found_.others)
      if (lineOf(array.title.c_str(), array.choice == coloring.choice()))
        next_.color.array = array.text;
    ImGui::EndCombo();
  }
  const auto present = std::find_if(found_.arrays.begin(), found_.arrays.end(),
    [&](const NamedArray& array) { return array.choice.name == coloring.choice().name; });
  if (present != found_.arrays.end() && coloring.componentCount(stage_.parts()) > 1)
  {
    if (buttonOf("Next component"))
      next_.color.array = coloring.nextComponent(stage_.parts());
    explainKey("C");
  }
  if (vtkLookupTable* table = coloring.table(); table && !coloring.isTyped())
  {
    colorStrip(table, ImGui::GetContentRegionAvail().x, 0.9f * ImGui::GetFontSize());
    this->drawColourRange();
  }
  this->drawRow("color-map", "map");
  if (coloring.choice())
    drawn_.insert("plain-color");
  else
    this->drawRow("plain-color", "colour");
  this->drawRow("nan-color", "no number");
  this->drawRow("calculate");
  // One colour has no values.
  if (coloring.isTyped() || !coloring.choice())
    drawn_.insert({"range", "reverse", "log"});
  if (!coloring.isTyped())
    drawn_.insert({"types", "type-names"});
}

void Panel::drawColourRange()
{
  drawn_.insert("range");
  const Coloring& coloring = stage_.coloring();
  const double* present = coloring.table()->GetRange();
  Interval range = {present[0], present[1]};
  if (rangeFields("range", range) && range.low < range.high)
    next_.color.range = {range.low, range.high};
  RowControls::explain(*rowNamed("range"));
  if (!next_.color.range.empty())
  {
    if (buttonOf("Range of the data"))
      next_.color.range.clear();
  }
  else
    ImGui::TextDisabled(steps_ > 1 ? "range of the steps seen" : "range of the data");
  if (steps_ > 1)
  {
    ImGui::SameLine();
    if (buttonOf("Range of all steps"))
      this->wish(Action::RangeOfAllSteps);
    explainKey("Reads all time steps for their least and greatest value. Escape stops");
  }
  this->drawRangeOfShown();
}

/// A button where something is hidden that the range of the data has.
void Panel::drawRangeOfShown()
{
  const ArrayChoice& choice = stage_.coloring().choice();
  const std::string name = this->coloredBy();
  const auto& ranges = next_.selection.ranges;
  const auto shown = std::find_if(ranges.begin(), ranges.end(),
    [&](const ShowRange& range) { return range.name == name && !range.intervals.empty(); });
  const bool isPart = std::any_of(stage_.parts().begin(), stage_.parts().end(),
    [](const auto& part) { return part->isHidden(); });
  if (shown == ranges.end() && !isPart)
    return;
  if (steps_ == 1) // there is room
    ImGui::SameLine();
  if (!buttonOf("Range of what is shown"))
    return;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const auto& part : stage_.parts())
    if (double own[2];
        !part->isHidden() && finiteRange(arrayOf(part->data(), choice), choice.component, own))
    {
      least = std::min(least, own[0]);
      most = std::max(most, own[1]);
    }
  if (shown != ranges.end())
  {
    least = std::max(least, shown->intervals.front().low);
    most = std::min(most, shown->intervals.back().high);
  }
  if (least < most)
    next_.color.range = {least, most};
}

void Panel::drawVolume()
{
  drawn_.insert("opacity");
  const Coloring& coloring = stage_.coloring();
  const std::vector<OpacityPoint>& inForce = coloring.opacity();
  if (!coloring.table() || inForce.empty())
    return;
  const double* range = coloring.table()->GetRange();
  std::vector<OpacityPoint> points = inForce;
  for (OpacityPoint& point : points)
    if (point.isShare)
      point = {range[0] + 0.01 * point.value * (range[1] - range[0]), false, point.opacity};
  std::stable_sort(points.begin(), points.end(),
    [](const OpacityPoint& a, const OpacityPoint& b) { return a.value < b.value; });
  const Histogram& histogram = this->histogramOf(this->coloredBy());
  if (opacityControl("opacity", histogram, coloring.table(), points))
    next_.volume.opacity = points;
  const auto preset = [&](const char* label, std::vector<OpacityPoint> wanted)
  {
    if (buttonOf(label))
      next_.volume.opacity = std::move(wanted);
    ImGui::SameLine();
  };
  preset("Usual", {});
  preset("Rising", {{0.0, true, 0.0}, {100.0, true, 0.8}});
  preset("Falling", {{0.0, true, 0.8}, {100.0, true, 0.0}});
  preset("Even", {{0.0, true, 0.2}, {100.0, true, 0.2}});
  ImGui::NewLine();
  this->drawIsosurfaces(histogram);
}

/// Of cells that are shown by their surface: the way to the volume, and nothing else.
void Panel::drawCells()
{
  for (const Row& row : settingsTable())
    if (row.group == "Volume" && row.name != "cells")
      drawn_.insert(row.name);
}

/// Values of isosurfaces as lines over the histogram.
void Panel::drawIsosurfaces(const Histogram& histogram)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("isosurfaces");
  ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
  if (buttonOf("Add isosurface") && !histogram.isEmpty())
    next_.volume.isoValues.push_back(newIsoValue(histogram, next_.volume.isoValues));
  explainKey("One more, between the others; then drag its line\n--iso");
  if (!next_.volume.isoValues.empty())
    isoControl("iso lines", histogram, stage_.coloring().table(), next_.volume.isoValues);
  this->drawRow("iso", "values");
}

} // namespace mote::app
