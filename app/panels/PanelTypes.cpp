// Types of particles: a line for each, with what can be chosen of it.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/Coloring.h"

#include <ParticleModel.h>
#include <vtkLookupTable.h>
#include <vtkMoteParticleMapper.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

/// Radii are chosen by the types of this array alone.
constexpr const char* radiusTypes = "type";

/// Whether a value is shown: in one of the intervals, of which none stand for all.
bool isShown(const ShowRange* range, int value)
{
  return !range || std::any_of(range->intervals.begin(), range->intervals.end(),
                     [&](const Interval& one) { return one.low <= value && value <= one.high; });
}

} // namespace

const Kinds& Panel::kindsOf(const NamedArray& array)
{
  const auto known = found_.kinds.find(array.text);
  if (known != found_.kinds.end())
    return known->second;
  for (const auto& part : stage_.parts())
    found_.typeNames[array.text].merge(typeNamesOf(part->data(), array.choice));
  return found_.kinds[array.text] = mote::app::kindsOf(stage_.parts(), array.choice);
}

/// Whether there is a list of the array's types.
bool Panel::hasList(const ArrayChoice& types)
{
  return std::any_of(found_.arrays.begin(), found_.arrays.end(),
    [&](const NamedArray& array)
    { return array.choice == types && !this->kindsOf(array).empty(); });
}

/// What a type is called; empty where nobody says.
std::string Panel::nameOf(const NamedArray& array, int kind) const
{
  const TypeNames& chosen = next_.color.typeNames;
  if (const auto found = chosen.find(kind); found != chosen.end())
    return found->second;
  const auto named = found_.typeNames.find(array.text);
  if (named != found_.typeNames.end() && named->second.count(kind) > 0)
    return named->second.at(kind);
  return {};
}

/// Whether a type is shown: its number with a box.
void Panel::drawKindShown(
  const NamedArray& array, int kind, std::vector<bool>& shown, std::size_t i) const
{
  bool isOn = shown[i];
  if (ImGui::Checkbox(std::to_string(kind).c_str(), &isOn))
  {
    // With Ctrl this one alone.
    if (ImGui::GetIO().KeyCtrl)
      shown.assign(shown.size(), false), isOn = true;
    shown[i] = isOn;
  }
  noteControl(array.text + " " + std::to_string(kind));
  explainKey(
    ("Show this type. Ctrl and click shows it alone\n--show " + array.text + "=TYPE,...").c_str());
}

/// A button with the type's colour, which opens a field of colours.
void Panel::drawKindColour(const NamedArray& array, int kind)
{
  const unsigned char* c = stage_.coloring().table()->MapValue(kind);
  float rgb[3] = {c[0] / 255.0f, c[1] / 255.0f, c[2] / 255.0f};
  const bool isChanged = ImGui::ColorEdit3(
    "##colour", rgb, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoTooltip);
  noteControl(array.text + " " + std::to_string(kind) + " colour");
  explainKey("The type's colour\n--type-colors TYPE=COLOUR,...");
  if (!isChanged)
    return;
  Color& color = next_.color.typeColors[kind];
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = std::round(255.0 * rgb[k]) / 255.0;
}

void Panel::drawKindName(const NamedArray& array, int kind)
{
  std::string name = this->nameOf(array, kind);
  ImGui::SetNextItemWidth(-1.0f);
  const bool isEntered = textField("##name", "no name", name);
  noteControl(array.text + " " + std::to_string(kind) + " name");
  explainKey("The type's name, in lists and legends; empty: as the data name it\n"
             "--type-names TYPE=NAME,...");
  if (!isEntered)
    return;
  std::replace(name.begin(), name.end(), ',', ' '); // which parts names on the command line
  if (name.empty())
    next_.color.typeNames.erase(kind);
  else
    next_.color.typeNames[kind] = name;
}

/// The radius of a type. The first that is written leaves the others as large as they are.
void Panel::drawKindRadius(const NamedArray& array, int kind)
{
  ParticleSettings& particles = next_.particles;
  const std::map<int, double>& present =
    particles.typeRadius.empty() ? this->radiiOf(array) : particles.typeRadius;
  const auto found = present.find(kind);
  double radius = found == present.end() ? 0.0 : found->second;
  ImGui::SetNextItemWidth(-1.0f);
  const bool isEntered = numberField("##radius", radius);
  noteControl(array.text + " " + std::to_string(kind) + " radius");
  explainKey("The type's radius; 0 gives all types the radii back that they have by default\n"
             "--type-radius TYPE=R,...");
  if (!isEntered)
    return;
  if (!(radius > 0.0))
  {
    particles.typeRadius.clear();
    return;
  }
  if (particles.typeRadius.empty())
  {
    particles.typeRadius = this->radiiOf(array);
    if (double number = 0.0; !parseNumber(particles.radius, number))
      particles.radius = ParticleSettings().radius; // others cannot be beside those of types
  }
  particles.typeRadius[kind] = radius;
}

/// The mean radius of each type, as it is drawn but for --radius-scale.
const std::map<int, double>& Panel::radiiOf(const NamedArray& array)
{
  unsigned long time = 0;
  for (const auto& part : stage_.parts())
    if (part->particles())
      time = std::max<unsigned long>(time, part->particles()->GetModel().structureTime());
  if (found_.radiiTime == time)
    return found_.radii;
  found_.radiiTime = time;
  found_.radii = meanRadii(stage_.parts(), array.choice, this->kindsOf(array));
  for (auto& [kind, radius] : found_.radii)
    parseNumber(asNumber(radius / stage_.settings().particles.radiusScale, 4), radius);
  return found_.radii;
}

/// Room for each radius as its field writes it.
float Panel::widthOfRadii(const NamedArray& array)
{
  float width = 4.2f * ImGui::GetFontSize();
  const ParticleSettings& particles = next_.particles;
  for (const auto& [kind, radius] :
    particles.typeRadius.empty() ? this->radiiOf(array) : particles.typeRadius)
    width = std::max(width,
      ImGui::CalcTextSize(asNumber(radius).c_str()).x + 3.0f * ImGui::GetStyle().FramePadding.x);
  return width;
}

/// What is over the list: what holds for all of its types.
void Panel::drawKindsHead(const NamedArray& array, std::vector<bool>& shown)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(array.title.c_str());
  explainKey(("--show " + array.text + "=TYPE,...").c_str());
  ImGui::SameLine();
  if (buttonOf("All"))
    shown.assign(shown.size(), true);
  explainKey("Show all types");
  ImGui::SameLine();
  if (buttonOf("Invert"))
    shown.flip();
  explainKey(
    ("Show the types that are hidden, and hide the others\n--show " + array.text + "=TYPE,...")
      .c_str());
  if (next_.color.typeColors.empty())
    return;
  ImGui::SameLine();
  if (buttonOf("Usual colours"))
    next_.color.typeColors.clear();
  explainKey("Types have the elements' colours, or those of the colour map types\n"
             "without --type-colors");
}

/// Types, each with a line.
void Panel::drawKinds(const NamedArray& array, const Kinds& kinds)
{
  std::vector<ShowRange>& ranges = next_.selection.ranges;
  const auto range = std::find_if(
    ranges.begin(), ranges.end(), [&](const ShowRange& one) { return one.name == array.text; });
  const ShowRange* present = range == ranges.end() ? nullptr : &*range;
  std::vector<bool> shown;
  for (const auto& [kind, count] : kinds)
    shown.push_back(isShown(present, kind));
  const std::vector<bool> before = shown;
  ImGui::PushID(array.text.c_str());
  this->drawKindsHead(array, shown);
  const Coloring& coloring = stage_.coloring();
  const bool hasColours = coloring.isTyped() && coloring.choice() == array.choice;
  const bool hasRadii = array.text == radiusTypes;
  constexpr std::size_t most = 16; // that are seen at once
  const bool isLong = kinds.size() > most;
  const float height = isLong ? float(most + 1) * ImGui::GetFrameHeightWithSpacing() : 0.0f;
  if (ImGui::BeginTable("kinds", 3 + hasColours + hasRadii,
        ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings |
          (isLong ? ImGuiTableFlags_ScrollY : 0),
        ImVec2(0.0f, height)))
  {
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("shown");
    if (hasColours)
      ImGui::TableSetupColumn("##colour");
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    if (hasRadii)
      ImGui::TableSetupColumn(
        "radius", ImGuiTableColumnFlags_WidthFixed, this->widthOfRadii(array));
    ImGui::TableSetupColumn("count");
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < kinds.size(); ++i)
    {
      const auto [kind, count] = kinds[i];
      ImGui::PushID(kind);
      ImGui::TableNextColumn();
      this->drawKindShown(array, kind, shown, i);
      if (hasColours)
      {
        ImGui::TableNextColumn();
        this->drawKindColour(array, kind);
      }
      ImGui::TableNextColumn();
      this->drawKindName(array, kind);
      if (hasRadii)
      {
        ImGui::TableNextColumn();
        this->drawKindRadius(array, kind);
      }
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      ImGui::TextDisabled("%s", withThousands(count).c_str());
      ImGui::PopID();
    }
    ImGui::EndTable();
  }
  ImGui::PopID();
  if (shown == before)
    return;
  ShowRange wanted = {array.text, {}};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (shown[i])
      wanted.intervals.push_back({double(kinds[i].first), double(kinds[i].first)});
  const bool isAll = wanted.intervals.size() == kinds.size();
  if (wanted.intervals.empty()) // of a type that is not there
    wanted.intervals.push_back({kinds[0].first - 1.0, kinds[0].first - 1.0});
  if (range != ranges.end())
    ranges.erase(range);
  if (!isAll)
    ranges.push_back(wanted);
}

} // namespace mote::app
