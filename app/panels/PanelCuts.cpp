// What is cut open.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/Cuts.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

struct OfferedCut
{
  const char *name, *title;
};
constexpr OfferedCut offeredCuts[] = {{"x", "x"}, {"y", "y"}, {"z", "z"},
  {"r", "r, distance from the axis"}, {"h", "h, height along the axis"},
  {"angle", "angle about the axis"}};

std::string titleOf(const std::string& name)
{
  for (const OfferedCut& one : offeredCuts)
    if (name == one.name)
      return one.title;
  return "along " + name;
}

/// A direction in words of few digits.
std::string directionName(const double direction[3])
{
  std::string name;
  for (int k = 0; k < 3; ++k)
    name += (k > 0 ? "," : "") + asNumber(std::round(direction[k] * 1e4) / 1e4 + 0.0); // no -0
  return name;
}

} // namespace

void Panel::drawCuts()
{
  drawn_.insert("cut");
  double bounds[6];
  stage_.bounds(bounds);
  std::vector<ShowRange>& cuts = next_.cuts.ranges;
  bool hasAxis = false;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    ImGui::PushID(static_cast<int>(i));
    const std::optional<CutKind> kind = cutNamed(cuts[i].name);
    hasAxis = hasAxis || (kind && kind->of != CutKind::Direction);
    const bool isKept =
      !kind || this->drawCut(cuts[i], extentOf(*kind, cutAxisOf(next_.cuts.axis), bounds));
    ImGui::PopID();
    if (isKept)
      continue;
    cuts.erase(cuts.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  if (cuts.size() < 8)
    this->drawNewCut(bounds);
  if (!hasAxis)
    drawn_.insert("cut-axis");
}

/// Returns false where the cut is to go.
bool Panel::drawCut(ShowRange& cut, const Interval& extent)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(titleOf(cut.name).c_str());
  explainKey(("Only what lies in this range is there\n--cut " + cut.name + "=LO:HI").c_str());
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 7.4f * ImGui::GetFontSize());
  Interval& shown = cut.intervals.front();
  const double low = std::max(shown.low, extent.low), high = std::min(shown.high, extent.high);
  const bool isTurned = ImGui::Button("Other side");
  noteControl("other side " + cut.name);
  explainKey("Show what lies beyond the range, in place of what lies in it\n--cut NAME=LO:HI");
  ImGui::SameLine();
  const bool isLeft = ImGui::Button("x");
  noteControl("no cut " + cut.name);
  explainKey("Take this cut away\nwithout --cut NAME");
  if (isLeft)
    return false;
  if (isTurned && high < extent.high)
    shown = {high, HUGE_VAL};
  else if (isTurned && low > extent.low)
    shown = {-HUGE_VAL, low};
  else if (Interval now = {low, high}; this->dragCut(cut.name, extent, now))
    // Where the data end, an end is open.
    shown = {
      now.low <= extent.low ? -HUGE_VAL : now.low, now.high >= extent.high ? HUGE_VAL : now.high};
  return true;
}

/// The ends of a cut, to be dragged or entered; whether they are others now.
bool Panel::dragCut(const std::string& name, const Interval& extent, Interval& shown)
{
  Histogram frame;
  frame.least = extent.low;
  frame.most = extent.high;
  const bool isDragged =
    rangeControl(("cut " + name).c_str(), frame, shown, false, "--cut NAME=LO:HI");
  const bool isEntered =
    rangeFields("fields", shown, "The ends of what is shown\n--cut NAME=LO:HI");
  return isDragged || isEntered;
}

void Panel::drawNewCut(const double bounds[6])
{
  ImGui::SetNextItemWidth(-1.0f);
  const bool isOpen = ImGui::BeginCombo("##cut", "Cut by ...", ImGuiComboFlags_HeightLarge);
  RowControls::explain(*rowNamed("cut"));
  if (!isOpen)
    return;
  std::vector<ShowRange>& cuts = next_.cuts.ranges;
  const auto offer = [&](const std::string& name, const std::string& title)
  {
    const bool isThere =
      std::any_of(cuts.begin(), cuts.end(), [&](const ShowRange& cut) { return cut.name == name; });
    if (isThere || !lineOf(title.c_str()))
      return;
    const CutKind kind = *cutNamed(name);
    const Interval extent = extentOf(kind, cutAxisOf(next_.cuts.axis), bounds);
    const double middle = 0.5 * (extent.low + extent.high);
    // An angle opens a quarter.
    cuts.push_back(
      {name, {kind.of == CutKind::Angle ? Interval{90.0, 360.0} : Interval{-HUGE_VAL, middle}}});
  };
  for (const OfferedCut& one : offeredCuts)
    offer(one.name, one.title);
  double away[3];
  stage_.renderer()->GetActiveCamera()->GetDirectionOfProjection(away);
  for (double& part : away)
    part = -part;
  offer(directionName(away), "the direction of the view");
  ImGui::EndCombo();
}

} // namespace mote::app
