// What is shown: ranges, expressions.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/Coloring.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mote::app
{

namespace
{

/// All numbers but those of an interval.
std::vector<Interval> around(const Interval& interval)
{
  return {{-HUGE_VAL, std::nextafter(interval.low, -HUGE_VAL)},
    {std::nextafter(interval.high, HUGE_VAL), HUGE_VAL}};
}

/// The interval around which a range lies, if it does.
std::optional<Interval> outsideOf(const ShowRange& range)
{
  const std::vector<Interval>& parts = range.intervals;
  if (parts.size() != 2 || parts[0].low != -HUGE_VAL || parts[1].high != HUGE_VAL)
    return {};
  return Interval{std::nextafter(parts[0].high, HUGE_VAL), std::nextafter(parts[1].low, -HUGE_VAL)};
}

/// An expression that holds where this one does not.
std::string inverted(const std::string& expression)
{
  if (!expression.starts_with("!(") || !expression.ends_with(')'))
    return "!(" + expression + ")";
  // Whether that bracket ends with the whole.
  int open = 0;
  for (std::size_t i = 1; i + 1 < expression.size(); ++i)
    if (open += expression[i] == '(' ? 1 : expression[i] == ')' ? -1 : 0; open == 0)
      return "!(" + expression + ")";
  return expression.substr(2, expression.size() - 3);
}

/// Turns a range round. Those of x, y, z and the radius, which have one interval each, become a
/// part of the expression: false then, and the range is to go.
bool invert(ShowRange& range, SelectionSettings& selection)
{
  const std::vector<std::string> places = {"x", "y", "z", "radius"};
  if (std::find(places.begin(), places.end(), range.name) == places.end())
  {
    const std::vector<Interval> before = range.intervals;
    range.intervals.clear();
    double low = -HUGE_VAL;
    for (const Interval& one : before)
    {
      if (one.low > low)
        range.intervals.push_back({low, std::nextafter(one.low, -HUGE_VAL)});
      low = std::nextafter(one.high, HUGE_VAL);
    }
    if (before.back().high < HUGE_VAL)
      range.intervals.push_back({low, HUGE_VAL});
    return true;
  }
  const Interval& shown = range.intervals.front();
  std::string inside;
  if (std::isfinite(shown.low))
    inside = range.name + " >= " + exactText(shown.low);
  if (std::isfinite(shown.high))
    inside += (inside.empty() ? "" : " && ") + range.name + " <= " + exactText(shown.high);
  const std::string& where = selection.where;
  selection.where = (where.empty() ? "" : "(" + where + ") && ") + inverted(inside);
  return false;
}

bool drawsRadiiAsTheyAre(const ParticleSettings& particles)
{
  return particles.radius == "auto" && particles.typeRadius.empty() && particles.radiusScale == 1.0;
}

/// Texts and titles of the components of a vector whose magnitude is meant; of others none.
std::vector<std::pair<std::string, std::string>> componentsOf(
  const std::vector<std::unique_ptr<Part>>& parts, ArrayChoice choice)
{
  std::vector<std::pair<std::string, std::string>> found;
  if (choice.component != ArrayChoice::magnitude)
    return found;
  for (const auto& part : parts)
    if (vtkDataArray* array = found.empty() ? arrayOf(part->data(), choice) : nullptr)
      for (int component = 0; component < array->GetNumberOfComponents(); ++component)
      {
        const ArrayChoice one{choice.name, component, choice.ofCells};
        found.emplace_back(asText(part->data(), one), describe(part->data(), one));
      }
  return found;
}

} // namespace

void Panel::drawSelection()
{
  drawn_.insert({"show", "hide-ids", "only-ids"});
  this->tellShown();
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
  this->drawWhere();
  if (buttonOf("Save what is shown"))
    this->wish(Action::SaveShown);
  explainKey("Save the particles, or cells, that are shown with all arrays as .vtp or .vtu, for "
             "other programs; what is cut away is left out\nmote convert");
}

/// An expression, and a button that turns it round.
void Panel::drawWhere()
{
  this->drawRow("where");
  std::string& where = next_.selection.where;
  if (where.empty())
    return;
  if (buttonOf("Invert expression"))
    where = inverted(where);
  explainKey("Show what the expression does not hold for\n--where \"!(...)\"");
}

/// What a range is of, for people.
std::string Panel::titleOfRange(const ShowRange& range) const
{
  for (const NamedArray& array : found_.arrays)
  {
    if (array.text == range.name)
      return array.title;
    for (const auto& [text, title] : componentsOf(stage_.parts(), array.choice))
      if (text == range.name)
        return title;
  }
  return range.name;
}

/// What is over a range: its name, and what can be done with it. Returns false where it is to go.
bool Panel::drawShownHead(ShowRange& range)
{
  const bool isOutside = outsideOf(range).has_value();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted((this->titleOfRange(range) + (isOutside ? ", outside of" : "")).c_str());
  RowControls::explain(*rowNamed("show"));
  const bool isInvertible = range.name != "radius" || drawsRadiiAsTheyAre(next_.particles);
  ImGui::SameLine(
    ImGui::GetContentRegionMax().x - (isInvertible ? 8.4f : 4.5f) * ImGui::GetFontSize());
  if (isInvertible)
  {
    const bool isPressed = ImGui::Button("Invert");
    noteControl("invert " + range.name);
    if (isPressed)
      return invert(range, next_.selection);
    explainKey("Show what is hidden by this range, and hide what it shows\n"
               "--show NAME=:LO,HI:, or --where of x, y, z and radius");
    ImGui::SameLine();
  }
  const bool isLeft = buttonOf("show all");
  explainKey("Take this range away\nwithout --show NAME");
  return !isLeft;
}

/// How much of all is shown.
void Panel::tellShown() const
{
  const auto tell = [](const std::string& text)
  {
    ImGui::TextUnformatted(text.c_str());
    noteControl(text);
  };
  const auto shownOf = [](vtkIdType shown, vtkIdType all, const char* what)
  { return withThousands(shown) + " of " + counted(all, what) + " shown"; };
  // How many of all are shown a preview does not know.
  const vtkIdType particles = stage_.numberOfParticles();
  if (found_.hasParticles)
    tell(stage_.preview().empty() ? shownOf(stage_.numberShown(), particles, "particle")
                                  : counted(particles, "particle"));
  vtkIdType cells = 0, shown = 0;
  for (const auto& part : stage_.parts())
    if (!part->particles())
    {
      cells += part->data()->GetNumberOfCells();
      shown += part->numberOfCellsShown();
    }
  if (cells > 0)
    tell(shownOf(shown, cells, "cell"));
}

/// Returns false where the range is to go.
bool Panel::drawShown(ShowRange& range)
{
  if (!this->drawShownHead(range))
    return false;
  const Histogram& histogram = this->histogramOf(range.name);
  const std::optional<Interval> outside = outsideOf(range);
  if (range.intervals.size() != 1 && !outside)
  {
    ImGui::TextWrapped("%s", ValuesOf<ShowRange>::words(range).front().c_str());
    return true;
  }
  Interval shown = outside.value_or(range.intervals[0]);
  // Of a range beside all values, which other data have, both ends are at one end of them.
  const auto within = [&](double value)
  { return std::min(std::max(value, histogram.least), histogram.most); };
  shown = {within(shown.low), within(shown.high)};
  const bool isDragged = rangeControl("histogram", histogram, shown, outside.has_value());
  const bool isEntered = rangeFields("fields", shown, "The ends of the range\n--show NAME=LO:HI");
  if (!isDragged && !isEntered)
    return true;
  if (outside)
    range.intervals = around(shown);
  else
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
  // Volumes hide values of the array that colours them, or its component, within cells.
  const bool hidesWithin = found_.hasVolumes && stage_.coloring().choice();
  if (hidesWithin)
    offer(this->coloredBy(), stage_.coloring().title());
  for (const NamedArray& array : found_.arrays)
    if (this->kindsOf(array).empty() && !(hidesWithin && array.text == this->coloredBy()))
    {
      offer(array.text, array.title);
      for (const auto& [text, title] : componentsOf(stage_.parts(), array.choice))
        if (!(hidesWithin && text == this->coloredBy()))
          offer(text, title);
    }
  for (const NamedArray& array : found_.others)
    // By the radius what is drawn is chosen, which need not be the array's.
    if (array.text != "radius" || drawsRadiiAsTheyAre(next_.particles))
      offer(array.text, array.title);
  if (!found_.hasParticles) // whose places are among the others
    for (const char* axis : {"x", "y", "z"})
      offer(axis, axis);
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

} // namespace mote::app
