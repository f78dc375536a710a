#include "PlotPanel.h"

#include "PanelColors.h"
#include "PanelWidgets.h"
#include "ValueControls.h"
#include "base/Text.h"
#include "stage/ColorMaps.h"
#include "table/Row.h"

#include <ParticleModel.h>
#include <vtkLookupTable.h>
#include <vtkMoteParticleMapper.h>
#include <vtkTimerLog.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

constexpr int bins = 120, columns = 96, rows = 72;
constexpr double shortTime = 0.02; // s

/// The range of a name that is shown; null for all.
ShowRange* rangeOf(Settings& settings, const std::string& name)
{
  auto& ranges = settings.selection.ranges;
  const auto found = std::find_if(
    ranges.begin(), ranges.end(), [&](const ShowRange& range) { return range.name == name; });
  return found == ranges.end() ? nullptr : &*found;
}

void show(Settings& settings, const std::string& name, const Interval& interval)
{
  if (ShowRange* range = rangeOf(settings, name))
    range->intervals = {interval};
  else if (settings.selection.ranges.size() < 8) // as many as there may be
    settings.selection.ranges.push_back({name, {interval}});
}

/// A number between two, as short as a thousandth of the whole tells apart.
double valueAt(const Plot& plot, std::size_t axis, double share)
{
  const double least = plot.least[axis], most = plot.most[axis];
  if (share <= 0.0 || share >= 1.0 || !(most > least))
    return share <= 0.0 ? least : most;
  const double digits = -std::floor(std::log10((most - least) / 1000.0));
  const double scale = std::pow(10.0, std::abs(digits)), value = least + share * (most - least);
  // Dividing by a whole number gives what has few digits as it is written.
  return std::clamp(
    digits > 0.0 ? std::round(value * scale) / scale : std::round(value / scale) * scale, least,
    most);
}

double shareOf(const Plot& plot, std::size_t axis, double value)
{
  const double width = plot.most[axis] - plot.least[axis];
  return width > 0.0 ? std::clamp((value - plot.least[axis]) / width, 0.0, 1.0) : 0.5;
}

} // namespace

PlotPanel::PlotPanel() = default;
PlotPanel::~PlotPanel() = default;

/// What the settings ask for, as far as the data have it.
void PlotPanel::choose(const Stage& stage, const PlotSettings& wanted)
{
  std::vector<std::pair<vtkDataSet*, unsigned long>> data;
  for (const auto& part : stage.parts())
    data.emplace_back(part->data(), part->data()->GetMTime());
  if (data != data_)
  {
    data_ = data;
    plotted_ = {};
    names_ = plottable(stage.parts());
  }
  const auto has = [&](const std::string& name)
  { return std::find(names_.begin(), names_.end(), name) != names_.end(); };
  auto& [x, y] = choice_.names;
  // What is plotted stays, whatever colours by now.
  if (!wanted.x.empty() || !has(x))
    x = has(wanted.x) ? wanted.x : "";
  for (const auto& part : stage.parts())
    if (x.empty() && arrayOf(part->data(), stage.coloring().choice()))
      x = asText(part->data(), stage.coloring().choice());
  if (x.empty() && !names_.empty())
    x = names_.front();
  y = has(wanted.y) ? wanted.y : "";
  choice_.of = wanted.of == "picked"    ? Plotted::Picked
               : wanted.of == "visible" ? Plotted::Visible
                                        : Plotted::All;
}

void PlotPanel::update(const Stage& stage, const PickedSet& picked)
{
  this->choose(stage, stage.settings().plot);
  this->follow(stage, picked);
}

Action PlotPanel::draw(const Stage& stage, const PickedSet& picked, Settings& next)
{
  isLogarithmic_ = next.plot.logarithmic;
  this->choose(stage, next.plot);
  this->drawChoices(next.plot);
  this->choose(stage, next.plot);
  this->follow(stage, picked);
  if (plot_.isEmpty())
  {
    ImGui::TextWrapped("There are no values that both are of points or of cells.");
    return Action::None;
  }
  this->drawPlot(next);
  this->drawFields(next);
  Action action = Action::None;
  if (buttonOf("Save plot"))
    action = Action::SavePlot;
  explainKey("Save the plot as a picture with axes, .png, beside where mote runs");
  ImGui::SameLine();
  if (buttonOf("Save SVG"))
    action = Action::SavePlotSvg;
  explainKey("Save the plot as lines and texts, .svg, which papers and slides enlarge");
  ImGui::SameLine();
  if (buttonOf("Save counts"))
    action = Action::SaveCounts;
  explainKey("Save what is plotted as comma-separated values: ranges, and how many lie in them");
  return action;
}

void PlotPanel::drawChoices(PlotSettings& next) const
{
  const Row& row = *commandRow("mote", "plot-of");
  for (const std::string& word : row.words)
  {
    if (word != row.words.front())
      ImGui::SameLine();
    if (ImGui::RadioButton(word.c_str(), next.of == word))
      next.of = word;
    noteControl("plot " + word);
    explainKey((row.help + "\n" + row.option() + " " + word).c_str());
  }
  ImGui::SameLine();
  ImGui::Checkbox("log", &next.logarithmic);
  noteControl("plot log");
  explainKey("Plot the logarithm of the counts\n--plot-log");
  if (std::string x = choice_.names[0];
      chooseName("plot", "x", names_, nullptr, "What is plotted to the right\n--plot-x NAME", x))
    next.x = x;
  if (std::string y = choice_.names[1]; chooseName("plot", "y", names_, "how many there are",
        "What is plotted upwards: how many there are, or another value\n--plot-y NAME", y))
    next.y = y;
}

/// Counts anew where something is another; while a control is held only where that is fast.
void PlotPanel::follow(const Stage& stage, const PickedSet& picked)
{
  unsigned long time = choice_.of == Plotted::Picked ? picked.version() : 0;
  if (choice_.of == Plotted::Visible)
    for (const auto& part : stage.parts())
      if (part->particles())
        time = std::max<unsigned long>(time, part->particles()->GetModel().time());
  if (choice_.of == Plotted::Visible)
    for (const auto& part : stage.parts())
      time = 31 * (31 * time + part->isHidden()) + part->cells().time();
  if (choice_ == plotted_ && time == chosenTime_)
    return;
  if (choice_ == plotted_ && seconds_ > shortTime && ImGui::IsAnyItemActive())
    return;
  const double start = vtkTimerLog::GetUniversalTime();
  plot_ = plotOf(stage.parts(), picked, choice_, choice_.names[1].empty() ? bins : columns, rows);
  seconds_ = vtkTimerLog::GetUniversalTime() - start;
  plotted_ = choice_;
  chosenTime_ = time;
}

void PlotPanel::drawCounts(const float* from, const float* size) const
{
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(
    ImVec2(from[0], from[1]), ImVec2(from[0] + size[0], from[1] + size[1]), drawingGround);
  const double highest = isLogarithmic_ ? std::log1p(plot_.highest) : plot_.highest;
  const auto share = [&](std::uint32_t count)
  { return (isLogarithmic_ ? std::log1p(count) : count) / highest; };
  const float width = size[0] / static_cast<float>(plot_.width);
  const float height = size[1] / static_cast<float>(plot_.height);
  for (int row = 0; row < plot_.height; ++row)
    for (int column = 0; column < plot_.width; ++column)
    {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(plot_.width);
      const std::uint32_t count = plot_.counts[at + static_cast<std::size_t>(column)];
      if (count == 0)
        continue;
      const float left = from[0] + width * static_cast<float>(column);
      if (plot_.height == 1)
      {
        list->AddRectFilled(
          ImVec2(left, from[1] + size[1] * (1.0f - static_cast<float>(share(count)))),
          ImVec2(left + std::max(width, 1.0f), from[1] + size[1]), drawingBar);
        continue;
      }
      // Neighbours of one colour are one rectangle. Few are seen beside many.
      const auto level = [&](std::uint32_t n) { return std::lround(31.0 * std::sqrt(share(n))); };
      int end = column + 1;
      while (end < plot_.width && plot_.counts[at + static_cast<std::size_t>(end)] > 0 &&
             level(plot_.counts[at + static_cast<std::size_t>(end)]) == level(count))
        ++end;
      const unsigned char* color =
        colors_->MapValue(0.15 + 0.85 * static_cast<double>(level(count)) / 31.0);
      const float bottom = from[1] + size[1] - height * static_cast<float>(row);
      list->AddRectFilled(ImVec2(left, bottom - height),
        ImVec2(from[0] + width * static_cast<float>(end), bottom),
        IM_COL32(color[0], color[1], color[2], 255));
      column = end - 1;
    }
}

/// A frame around what is shown.
void PlotPanel::drawLimits(Settings& settings, const float* from, const float* size) const
{
  ImVec2 low(from[0], from[1]), high(from[0] + size[0], from[1] + size[1]);
  bool isLimited = false;
  for (std::size_t axis = 0; axis < (plot_.height > 1 ? 2u : 1u); ++axis)
    if (const ShowRange* range = rangeOf(settings, choice_.names[axis]);
        range && !range->intervals.empty())
    {
      isLimited = true;
      const auto begin = static_cast<float>(shareOf(plot_, axis, range->intervals.front().low));
      const auto end = static_cast<float>(shareOf(plot_, axis, range->intervals.back().high));
      if (axis == 0)
        low.x = from[0] + begin * size[0], high.x = from[0] + end * size[0];
      else
        low.y = from[1] + (1.0f - end) * size[1], high.y = from[1] + (1.0f - begin) * size[1];
    }
  if (isLimited)
    ImGui::GetWindowDrawList()->AddRect(low, high, heldInk);
}

/// Shows the range from where the mouse was pressed to where it is. Along an axis on which that is
/// hardly a pixel or two nothing is meant, and what was shown before is.
void PlotPanel::drag(const std::array<double, 2>& at, const float* size, Settings& next)
{
  constexpr double least = 4.0; // pixels
  std::array<bool, 2> isMeant{};
  for (std::size_t axis = 0; axis < (plot_.height > 1 ? 2u : 1u); ++axis)
    isMeant[axis] = size[axis] * std::abs(at[axis] - pressed_->at[axis]) > least;
  pressed_->isMoved = pressed_->isMoved || isMeant[0] || isMeant[1];
  if (!pressed_->isMoved)
    return;
  next.selection.ranges = pressed_->ranges;
  for (std::size_t axis = 0; axis < isMeant.size(); ++axis)
    if (isMeant[axis])
      show(next, choice_.names[axis],
        {valueAt(plot_, axis, std::min(pressed_->at[axis], at[axis])),
          valueAt(plot_, axis, std::max(pressed_->at[axis], at[axis]))});
}

void PlotPanel::drawPlot(Settings& next)
{
  if (!colors_)
  {
    const double range[2] = {0.0, 1.0};
    colors_ = makeColorMap(colorMapNames().front(), range, false);
  }
  const bool isPair = plot_.height > 1;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(
    ImGui::GetContentRegionAvail().x, (isPair ? 14.0f : 7.0f) * ImGui::GetFontSize());
  ImGui::InvisibleButton("plot", size);
  noteControl("plot");
  this->drawCounts(&from.x, &size.x);
  if (ImGui::IsItemActivated() || !ImGui::IsItemActive())
    heldTop_ = from.y;
  // The ranges that a drag makes come up above the plot, and would push it away under the mouse.
  if (heldTop_ != from.y)
    ImGui::SetScrollY(ImGui::GetScrollY() + from.y - heldTop_);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const std::array<double, 2> at = {std::clamp((mouse.x - from.x) / size.x, 0.0f, 1.0f),
    std::clamp(1.0f - (mouse.y - heldTop_) / size.y, 0.0f, 1.0f)};
  if (ImGui::IsItemActivated())
    pressed_ = {at, next.selection.ranges};
  if (pressed_ && ImGui::IsItemActive())
    this->drag(at, &size.x, next);
  else
    pressed_.reset();
  this->drawLimits(next, &from.x, &size.x);
  if (!ImGui::IsItemHovered() || ImGui::IsItemActive())
    return;
  const auto bin = [&](std::size_t axis, int count)
  { return std::min(static_cast<int>(at[axis] * count), count - 1); };
  const auto number = static_cast<std::size_t>(bin(1, plot_.height) * plot_.width) +
                      static_cast<std::size_t>(bin(0, plot_.width));
  ImGui::SetTooltip("%s = %s%s%s%s\n%s of %s\nDrag to show a range", choice_.names[0].c_str(),
    asNumber(valueAt(plot_, 0, at[0])).c_str(), isPair ? ", " : "",
    isPair ? (choice_.names[1] + " = ").c_str() : "",
    isPair ? asNumber(valueAt(plot_, 1, at[1])).c_str() : "",
    withThousands(plot_.counts[number]).c_str(), withThousands(plot_.total).c_str());
}

/// The ranges that are shown, as numbers.
void PlotPanel::drawFields(Settings& next) const
{
  bool isLimited = false;
  for (std::size_t axis = 0; axis < (plot_.height > 1 ? 2u : 1u); ++axis)
  {
    const ShowRange* range = rangeOf(next, choice_.names[axis]);
    isLimited = isLimited || range;
    Interval interval = {plot_.least[axis], plot_.most[axis]};
    if (range && !range->intervals.empty())
      interval = {std::max(interval.low, range->intervals.front().low),
        std::min(interval.high, range->intervals.back().high)};
    if (rangeFields(axis == 0 ? "x range" : "y range", interval,
          "The range that is shown of what is plotted\n--show NAME=LO:HI"))
      show(next, choice_.names[axis], interval);
    noteControl(axis == 0 ? "plot x range" : "plot y range");
  }
  if (isLimited && buttonOf("Show all of these"))
    std::erase_if(next.selection.ranges, [&](const ShowRange& range)
      { return range.name == choice_.names[0] || range.name == choice_.names[1]; });
  if (isLimited)
    explainKey("Take the ranges of what is plotted away\nwithout --show");
  if (!isLimited)
    ImGui::TextDisabled("%s %s", withThousands(plot_.total).c_str(), plot_.what.c_str());
}

} // namespace mote::app
