// What colours: the array, its component, the colour map, the range.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/ColorMaps.h"
#include "stage/Coloring.h"
#include "stage/Plot.h"

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
  this->drawComponents();
  this->drawMaps();
  if (coloring.table() && !coloring.isTyped())
    this->drawColourRange();
  if (coloring.choice())
    drawn_.insert("plain-color");
  else
    this->drawRow("plain-color", "colour");
  this->drawRow("nan-color", "no number");
  this->drawRow("calculate");
  // One colour has no values.
  if (coloring.isTyped() || !coloring.choice())
    drawn_.insert({"range", "percentiles", "reverse", "log"});
  if (!coloring.isTyped())
    drawn_.insert("types");
  // The list of types has them.
  if (!coloring.isTyped() || this->hasList(coloring.choice()))
    drawn_.insert({"type-names", "type-colors"});
}

/// A list of the components of the array that colours, where it has several.
void Panel::drawComponents()
{
  const Coloring& coloring = stage_.coloring();
  const auto holder = std::find_if(stage_.parts().begin(), stage_.parts().end(),
    [&](const auto& part) { return arrayOf(part->data(), coloring.choice()); });
  const int count = coloring.componentCount(stage_.parts());
  if (holder == stage_.parts().end() || count < 2 || !coloring.table())
    return;
  vtkDataSet* data = (*holder)->data();
  putLabel("component");
  const bool isOpen = ImGui::BeginCombo("##component", coloring.title().c_str());
  noteControl("component");
  explainKey("The component that colours, or the magnitude\nC goes on to the next\n"
             "--color-by NAME:COMPONENT");
  if (!isOpen)
    return;
  ArrayChoice choice = coloring.choice();
  for (choice.component = ArrayChoice::magnitude; choice.component < count; ++choice.component)
    if (lineOf(describe(data, choice).c_str(), choice == coloring.choice()))
      next_.color.array = asText(data, choice);
  ImGui::EndCombo();
}

namespace
{

/// A colour map with its picture, as a line of a list. Empty names are the default's.
struct OfferedMap
{
  std::string name, title;
  bool isReversed;
  vtkSmartPointer<vtkLookupTable> table;
};

const std::vector<OfferedMap>& offeredMaps()
{
  static const std::vector<OfferedMap> maps = []
  {
    constexpr double range[2] = {0.0, 1.0};
    std::vector<OfferedMap> all;
    for (const std::string& name : colorMapNames())
      for (const bool isReversed : {false, true})
      {
        const bool isOfTypes = name == "types";
        if (isOfTypes && isReversed)
          continue; // is in no order
        const std::vector<int> types = {1, 2, 3, 4, 5, 6, 7, 8};
        auto table = isOfTypes ? makeTypeMap(types, typeColors(types.size()))
                               : makeColorMap(name, range, false);
        if (isReversed)
          reverse(table);
        all.push_back({name, isReversed ? name + " reversed" : name, isReversed, table});
      }
    return all;
  }();
  return maps;
}

std::string titleOf(const ColorSettings& color)
{
  if (color.map.empty())
    return "default";
  return baseName(color.map) + (color.reversed && color.map != "types" ? " reversed" : "");
}

bool isMapFile(const std::string& map)
{
  const auto& names = colorMapNames();
  return !map.empty() && std::find(names.begin(), names.end(), map) == names.end();
}

} // namespace

/// The map in force as a picture, a list of all with theirs, and the name of a file.
void Panel::drawMaps()
{
  const bool hasField = asksForMap_ || isMapFile(next_.color.map);
  this->drawMapList(hasField);
  if (hasField)
    this->drawRow("color-map", "map's file");
}

/// The list, where the file's field may stand for the setting.
void Panel::drawMapList(bool hasField)
{
  const Coloring& coloring = stage_.coloring();
  const float height = 0.9f * ImGui::GetFontSize();
  if (vtkLookupTable* table = coloring.legendTable())
    colorStrip(table, ImGui::GetContentRegionAvail().x, height, coloring.isTyped());
  const Row& row = *rowNamed("color-map");
  drawn_.insert(row.name);
  putLabel("map");
  ColorSettings& color = next_.color;
  const bool isOpen =
    ImGui::BeginCombo("##color-map", titleOf(color).c_str(), ImGuiComboFlags_HeightLargest);
  if (hasField)
    noteControl("color-map list");
  else
    RowControls::explain(row);
  if (!isOpen)
    return;
  if (lineOf("default", color.map.empty()))
    color.map.clear();
  const float left = 9.0f * ImGui::GetFontSize();
  for (const OfferedMap& map : offeredMaps())
  {
    const bool isChosen =
      color.map == map.name && (map.name == "types" || color.reversed == map.isReversed);
    if (lineOf(map.title.c_str(), isChosen))
    {
      color.map = map.name;
      color.reversed = map.name == "types" ? color.reversed : map.isReversed;
    }
    ImGui::SameLine(left);
    colorStrip(map.table, 8.0f * ImGui::GetFontSize(), height, map.name == "types");
  }
  if (lineOf("from a file ...", isMapFile(color.map)))
    asksForMap_ = true;
  ImGui::EndCombo();
}

void Panel::drawColourRange()
{
  drawn_.insert({"range", "percentiles"});
  const Coloring& coloring = stage_.coloring();
  const double* present = coloring.table()->GetRange();
  Interval range = {present[0], present[1]};
  if (rangeFields("range", range, "The values at the two ends of the colour map\n--range LO HI") &&
      range.low < range.high)
    this->setRange(range.low, range.high);
  noteControl("range");
  const bool isTrimmed = next_.color.range.empty() && !next_.color.percentiles.empty();
  if (isTrimmed)
    ImGui::TextDisabled("%s to %s %% of the values", asNumber(next_.color.percentiles[0]).c_str(),
      asNumber(next_.color.percentiles[1]).c_str());
  if (isTrimmed || !next_.color.range.empty())
  {
    if (buttonOf("Range of the data"))
    {
      next_.color.range.clear();
      next_.color.percentiles.clear();
    }
    explainKey("Colours go from the least to the greatest value of the data, as by default\n"
               "without --range and --percentiles");
  }
  else
    ImGui::TextDisabled(steps_ > 1 ? "range of the steps seen" : "range of the data");
  if (steps_ > 1)
  {
    if (nextButtonOf("Range of all steps"))
      this->wish(Action::RangeOfAllSteps);
    explainKey("Reads all time steps for their least and greatest value. Escape stops\n--range");
  }
  if (nextButtonOf("Range of view"))
    this->wish(Action::RangeOfView);
  explainKey("Colours go from the least to the greatest value that is seen now: on slices, "
             "isosurfaces, meshes and particles, and where clouds are densest\n--range");
  this->drawRangeOfShown();
  this->drawEvenRange(range);
  if (!isTrimmed)
    this->drawRangeOfMost();
}

/// A button where zero lies within the range, but not in its middle.
void Panel::drawEvenRange(const Interval& range)
{
  const double most = std::max(-range.low, range.high);
  if (!(range.low < 0.0 && range.high > 0.0) || next_.color.logarithmic || -range.low == range.high)
    return;
  if (nextButtonOf("Even about 0"))
    this->setRange(-most, most);
  explainKey("Zero has the colour in the middle of the map, which coolwarm is made for\n--range");
}

void Panel::setRange(double low, double high)
{
  next_.color.range = {low, high};
  next_.color.percentiles.clear();
}

/// A button that leaves outliers out, and what that comes to where they stretch the range.
void Panel::drawRangeOfMost()
{
  const std::vector<double> most = Coloring::percentilesOfMost();
  if (nextButtonOf("Range without outliers"))
  {
    next_.color.range.clear();
    next_.color.percentiles = most;
  }
  explainKey("Colours go from the 1st to the 99th percentile of the values. Those beyond have the "
             "colours of the ends, and the legend says so\n--percentiles 1 99");
  double range[2];
  if (!next_.color.range.empty() || !stage_.coloring().rangeOfMost(stage_.parts(), range))
    return;
  const std::string text = asNumber(most[1] - most[0]) + " % of the values lie between " +
                           asNumber(range[0], 3) + " and " + asNumber(range[1], 3);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
  noteControl("outliers");
}

/// A button where limits may hide something that the range of the data has.
void Panel::drawRangeOfShown()
{
  SelectionSettings all; // without any limit
  if (stage_.settings().selection == all)
    return;
  const bool isPressed = nextButtonOf("Range of what is shown");
  explainKey("Colours go from the least to the greatest value of what no limit hides\n--range");
  double range[2];
  if (!isPressed ||
      !rangeOfShown(stage_.parts(), stage_.coloring().choice(), stage_.settings().selection, range))
    return;
  makeRoom(range);
  this->setRange(range[0], range[1]);
}

} // namespace mote::app
