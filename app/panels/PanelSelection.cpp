// What is shown: ranges, types, expressions.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/Coloring.h"

#include <vtkLookupTable.h>

#include <imgui.h>

#include <algorithm>

namespace mote::app
{

namespace
{

/// Whether a value is shown: in one of the intervals, of which none stand for all.
bool isShown(const ShowRange* range, int value)
{
  return !range || std::any_of(range->intervals.begin(), range->intervals.end(),
                     [&](const Interval& one) { return one.low <= value && value <= one.high; });
}

bool drawsRadiiAsTheyAre(const ParticleSettings& particles)
{
  return particles.radius == "auto" && particles.typeRadius.empty() && particles.radiusScale == 1.0;
}

} // namespace

void Panel::drawSelection()
{
  drawn_.insert({"show", "hide-ids", "only-ids"});
  if (!found_.hasParticles)
    drawn_.insert("where"); // is of particles alone
  else
  {
    // How many of all are shown a preview does not know.
    std::string text = counted(stage_.numberOfParticles(), "particle");
    if (stage_.preview().empty())
      text = withThousands(stage_.numberShown()) + " of " + text + " shown";
    ImGui::TextUnformatted(text.c_str());
    noteControl(text);
  }
  for (const NamedArray& array : found_.arrays)
    if (const Kinds& kinds = this->kindsOf(array); !kinds.empty())
      this->drawKinds(array, kinds);
  for (std::size_t i = 0; i < next_.selection.ranges.size(); ++i)
  {
    const std::string& name = next_.selection.ranges[i].name;
    const auto kinds = found_.kinds.find(name);
    if (kinds != found_.kinds.end() && !kinds->second.empty())
      continue;
    ImGui::PushID(static_cast<int>(i));
    const bool isKept = this->drawShown(next_.selection.ranges[i]);
    ImGui::PopID();
    if (!isKept)
    {
      next_.selection.ranges.erase(next_.selection.ranges.begin() + static_cast<long>(i));
      break;
    }
  }
  if (next_.selection.ranges.size() < 8)
    this->drawNewRange();
}

/// Returns false where the range is to go.
bool Panel::drawShown(ShowRange& range)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(range.name.c_str());
  RowControls::explain(*rowNamed("show"));
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 4.5f * ImGui::GetFontSize());
  if (buttonOf("show all"))
    return false;
  const Histogram& histogram = this->histogramOf(range.name);
  if (range.intervals.size() != 1)
  {
    ImGui::TextWrapped("%s", ValuesOf<ShowRange>::words(range).front().c_str());
    return true;
  }
  Interval shown = {std::max(range.intervals[0].low, histogram.least),
    std::min(range.intervals[0].high, histogram.most)};
  const bool isDragged = rangeControl("histogram", histogram, shown);
  const bool isEntered = rangeFields("fields", shown);
  if (isDragged || isEntered)
    range.intervals[0] = shown;
  return true;
}

void Panel::drawNewRange()
{
  ImGui::SetNextItemWidth(-1.0f);
  const bool isOpen =
    ImGui::BeginCombo("##show", "Show a range of ...", ImGuiComboFlags_HeightLarge);
  RowControls::explain(*rowNamed("show"));
  if (!isOpen)
    return;
  const auto offer = [&](const std::string& name, const std::string& title)
  {
    const auto& ranges = next_.selection.ranges;
    if (std::any_of(
          ranges.begin(), ranges.end(), [&](const ShowRange& range) { return range.name == name; }))
      return;
    if (!lineOf(title.c_str()))
      return;
    const Histogram& histogram = this->histogramOf(name);
    if (!histogram.isEmpty())
      next_.selection.ranges.push_back({name, {{histogram.least, histogram.most}}});
  };
  // Volumes hide values of the array that colours them, or its component, and of no other.
  if (found_.hasVolumes && stage_.coloring().choice())
    offer(this->coloredBy(), stage_.coloring().title());
  else
    for (const NamedArray& array : found_.arrays)
      if (this->kindsOf(array).empty())
        offer(array.text, array.title);
  if (found_.hasParticles)
    for (const NamedArray& array : found_.others)
      // By the radius what is drawn is chosen, which need not be the array's.
      if (array.text != "radius" || drawsRadiiAsTheyAre(next_.particles))
        offer(array.text, array.title);
  ImGui::EndCombo();
}

/// What is picked; it opens by itself when something is.
void Panel::drawPicked(const PickedFacts& facts)
{
  if (!facts.set)
    return;
  if (picked_.isNew(facts))
    ImGui::SetNextItemOpen(true);
  const bool isOpen = ImGui::CollapsingHeader("Picked##group");
  noteControl("group Picked");
  if (!isOpen)
    return;
  ImGui::PushID("Picked");
  if (const Action action = picked_.draw(stage_, facts, this->coloredBy(), next_);
      action != Action::None)
    this->wish(action);
  ImGui::PopID();
}

/// How values are distributed.
void Panel::drawPlot(const PickedFacts& facts)
{
  if (!facts.set)
    return;
  const bool isOpen = ImGui::CollapsingHeader("Plot##group");
  noteControl("group Plot");
  if (!isOpen)
    return;
  ImGui::PushID("Plot");
  if (const Action wanted = plot_.draw(stage_, *facts.set, next_); wanted != Action::None)
    this->wish(wanted);
  ImGui::PopID();
}

const Kinds& Panel::kindsOf(const NamedArray& array)
{
  const auto known = found_.kinds.find(array.text);
  if (known != found_.kinds.end())
    return known->second;
  for (const auto& part : stage_.parts())
    found_.typeNames[array.text].merge(typeNamesOf(part->data(), array.choice));
  return found_.kinds[array.text] = mote::app::kindsOf(stage_.parts(), array.choice);
}

/// A type's number, and what it is called.
std::string Panel::nameOf(const NamedArray& array, int kind) const
{
  const TypeNames& chosen = stage_.settings().color.typeNames;
  const auto named = found_.typeNames.find(array.text);
  std::string name;
  if (const auto found = chosen.find(kind); found != chosen.end())
    name = found->second;
  else if (named != found_.typeNames.end() && named->second.count(kind) > 0)
    name = named->second.at(kind);
  const std::string number = std::to_string(kind);
  return name.empty() || name == number ? number : number + "  " + name;
}

/// A type's line: its colour, whether it is shown, how many there are.
void Panel::drawKind(const NamedArray& array, const Kinds::value_type& kind,
  std::vector<bool>& shown, std::size_t i) const
{
  const Coloring& coloring = stage_.coloring();
  const std::string name = array.text + " " + std::to_string(kind.first);
  if (coloring.isTyped() && coloring.choice() == array.choice)
  {
    const unsigned char* c = coloring.table()->MapValue(kind.first);
    ImGui::ColorButton(("##" + name).c_str(),
      ImVec4(c[0] / 255.0f, c[1] / 255.0f, c[2] / 255.0f, 1.0f), ImGuiColorEditFlags_NoTooltip);
    ImGui::SameLine();
  }
  bool isOn = shown[i];
  if (ImGui::Checkbox(
        (this->nameOf(array, kind.first) + "##" + std::to_string(kind.first)).c_str(), &isOn))
  {
    // With Ctrl this one alone.
    if (ImGui::GetIO().KeyCtrl)
      shown.assign(shown.size(), false), isOn = true;
    shown[i] = isOn;
  }
  noteControl(name);
  explainKey("Ctrl and click shows this type alone");
  ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
  ImGui::TextDisabled("%s", withThousands(kind.second).c_str());
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
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(array.title.c_str());
  explainKey(("--show=" + array.text + "=TYPE,...").c_str());
  ImGui::SameLine();
  if (buttonOf("All"))
    shown.assign(kinds.size(), true);
  ImGui::SameLine();
  if (buttonOf("Invert"))
    shown.flip();
  for (std::size_t i = 0; i < kinds.size(); ++i)
    this->drawKind(array, kinds[i], shown, i);
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
