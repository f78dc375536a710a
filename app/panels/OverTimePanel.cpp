#include "OverTimePanel.h"

#include "PanelColors.h"
#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/ParticlePaths.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mote::app
{

namespace
{

constexpr std::size_t mostDrawn = 64, mostTold = 8;

ImU32 inkOf(std::size_t curve)
{
  const auto color = pathColor(curve);
  return IM_COL32(color[0], color[1], color[2], 255);
}

} // namespace

Action OverTimePanel::draw(const ValuesOverTime& values, const std::vector<double>& times, int step,
  const std::string& usual, Settings& next)
{
  Action action = Action::None;
  if (values.stepsRead() == 0) // which has the names
  {
    ImGui::TextDisabled("0 of %s read", counted(values.steps(), "step").c_str());
    return action;
  }
  this->choose(values.names(), usual, next.plot);
  const std::string& name = name_;
  times_ = times;
  if (times_.empty())
  {
    times_.resize(static_cast<std::size_t>(values.steps()));
    std::iota(times_.begin(), times_.end(), 1.0);
  }
  this->follow(values, name);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 7.0f * ImGui::GetFontSize());
  const bool isPressed = ImGui::InvisibleButton("over time", size);
  noteControl("over time");
  this->drawCurves(&from.x, &size.x, step);
  if (ImGui::IsItemHovered())
  {
    int nearest = 0;
    const float at = (ImGui::GetIO().MousePos.x - from.x) / std::max(1.0f, size.x);
    for (int i = 1; i < values.steps(); ++i)
      if (std::abs(this->shareOf(i) - at) < std::abs(this->shareOf(nearest) - at))
        nearest = i;
    this->explain(values.isRead(nearest), nearest);
    if (isPressed)
    {
      next.data.time.reset();
      next.data.step = std::to_string(nearest + 1);
    }
  }
  const std::string ranges = least_ <= most_ ? asNumber(least_) + " to " + asNumber(most_) +
                                                 ", t = " + asNumber(times_.front(), 10) + " to " +
                                                 asNumber(times_.back(), 10)
                                             : "no values so far";
  ImGui::TextDisabled("%s", ranges.c_str());
  noteControl(ranges);
  this->drawIds();
  if (read_ < values.steps())
  {
    ImGui::TextDisabled("%d of %s read", read_, counted(values.steps(), "step").c_str());
    return action;
  }
  if (buttonOf("Save over time"))
    action = Action::SaveOverTime;
  explainKey("Save all of these values as comma-separated values, a line for each step and id, or "
             "cell, beside where mote runs");
  return action;
}

/// What is plotted: what the settings say, or else what colours.
void OverTimePanel::choose(
  const std::vector<std::string>& names, const std::string& usual, PlotSettings& next)
{
  const auto has = [&](const std::string& name)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  // What is shown stays, whatever colours by now. The first steps may lack what the others have.
  if (has(next.overTime))
    name_ = next.overTime;
  else if (!has(name_) || (isMakeshift_ && has(usual)))
  {
    isMakeshift_ = !has(usual);
    name_ = isMakeshift_ ? names.front() : usual;
  }
  if (chooseName("over time", "of", names, nullptr,
        "Which values are plotted over time\n--plot-over-time NAME", name_))
    next.overTime = name_;
}

/// Takes what was read by now.
void OverTimePanel::follow(const ValuesOverTime& values, const std::string& name)
{
  const int read = values.stepsRead();
  if (number_ == values.number() && read_ == read && followed_ == name)
    return;
  number_ = values.number();
  read_ = read;
  followed_ = name;
  curves_ = values.curves(name);
  least_ = std::numeric_limits<double>::infinity();
  most_ = -least_;
  for (const ValuesOverTime::Curve& curve : curves_)
    for (const double value : curve.values)
      if (std::isfinite(value))
        least_ = std::min(least_, value), most_ = std::max(most_, value);
}

float OverTimePanel::shareOf(int step) const
{
  const double first = times_.front(), last = times_.back();
  const double time = times_[std::min(static_cast<std::size_t>(step), times_.size() - 1)];
  return static_cast<float>(last > first ? 0.02 + 0.96 * (time - first) / (last - first) : 0.5);
}

void OverTimePanel::drawCurves(const float* from, const float* size, int step) const
{
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(
    ImVec2(from[0], from[1]), ImVec2(from[0] + size[0], from[1] + size[1]), drawingGround);
  const float now = from[0] + size[0] * this->shareOf(step);
  list->AddLine(ImVec2(now, from[1]), ImVec2(now, from[1] + size[1]), heldInk);
  const auto placeOf = [&](const ValuesOverTime::Curve& curve, std::size_t i)
  {
    const double value = curve.values[i];
    const double share = most_ > least_ ? (value - least_) / (most_ - least_) : 0.5;
    return ImVec2(from[0] + size[0] * this->shareOf(static_cast<int>(i)),
      from[1] + size[1] * static_cast<float>(0.95 - 0.9 * share));
  };
  for (std::size_t c = 0; c < std::min(mostDrawn, curves_.size()); ++c)
    for (std::size_t i = 0; i < curves_[c].values.size(); ++i)
    {
      if (!std::isfinite(curves_[c].values[i]))
        continue;
      const ImVec2 here = placeOf(curves_[c], i);
      list->AddCircleFilled(here, 2.0f, inkOf(c), 8);
      if (i > 0 && std::isfinite(curves_[c].values[i - 1]))
        list->AddLine(placeOf(curves_[c], i - 1), here, inkOf(c), 1.5f);
    }
}

void OverTimePanel::explain(bool isRead, int step) const
{
  std::string text = "step " + std::to_string(step + 1) +
                     ", t = " + asNumber(times_[static_cast<std::size_t>(step)], 10);
  for (std::size_t c = 0; c < std::min(mostTold, curves_.size()); ++c)
    if (static_cast<std::size_t>(step) < curves_[c].values.size())
    {
      const double value = curves_[c].values[static_cast<std::size_t>(step)];
      text += "\n" + std::to_string(curves_[c].id) + ": " +
              (!std::isnan(value) ? asNumber(value)
                : isRead          ? "not there"
                                  : "not read yet");
    }
  ImGui::SetTooltip("%s\nA click goes to this step", text.c_str());
}

/// The ids in the colours of their curves.
void OverTimePanel::drawIds() const
{
  for (std::size_t c = 0; c < std::min(mostTold, curves_.size()); ++c)
  {
    const std::string id = std::to_string(curves_[c].id);
    if (c > 0)
      ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(id.c_str()).x)
      ImGui::NewLine();
    ImGui::PushStyleColor(ImGuiCol_Text, inkOf(c));
    ImGui::TextUnformatted(id.c_str());
    ImGui::PopStyleColor();
  }
  if (curves_.size() > mostTold)
  {
    ImGui::TextDisabled("of %s, %s drawn",
      withThousands(static_cast<std::int64_t>(curves_.size())).c_str(),
      withThousands(static_cast<std::int64_t>(std::min(mostDrawn, curves_.size()))).c_str());
  }
}

} // namespace mote::app
