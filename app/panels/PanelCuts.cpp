// What is cut open, and where volumes are sliced.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/Cuts.h"
#include "stage/Slices.h"

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

/// A list of the names that cuts and slices go by, without those that are `taken`; the one chosen,
/// or nothing.
std::string Panel::chooseCut(
  const char* label, const char* row, const std::vector<ShowRange>& taken)
{
  std::string chosen;
  ImGui::SetNextItemWidth(-1.0f);
  const bool isOpen =
    ImGui::BeginCombo((std::string("##") + row).c_str(), label, ImGuiComboFlags_HeightLarge);
  RowControls::explain(*rowNamed(row));
  if (!isOpen)
    return chosen;
  const auto offer = [&](const std::string& name, const std::string& title)
  {
    const bool isThere = std::any_of(
      taken.begin(), taken.end(), [&](const ShowRange& cut) { return cut.name == name; });
    if (!isThere && lineOf(title.c_str()))
      chosen = name;
  };
  for (const OfferedCut& one : offeredCuts)
    offer(one.name, one.title);
  double away[3];
  stage_.renderer()->GetActiveCamera()->GetDirectionOfProjection(away);
  for (double& part : away)
    part = -part;
  offer(directionName(away), "the direction of the view");
  ImGui::EndCombo();
  return chosen;
}

void Panel::drawNewCut(const double bounds[6])
{
  std::vector<ShowRange>& cuts = next_.cuts.ranges;
  const std::string name = this->chooseCut("Cut by ...", "cut", cuts);
  if (name.empty())
    return;
  const CutKind kind = *cutNamed(name);
  const Interval extent = extentOf(kind, cutAxisOf(next_.cuts.axis), bounds);
  const double middle = 0.5 * (extent.low + extent.high);
  double away[3];
  stage_.renderer()->GetActiveCamera()->GetDirectionOfProjection(away);
  const auto& along =
    kind.of == CutKind::Height ? cutAxisOf(next_.cuts.axis).direction : kind.direction;
  const double slope = along[0] * away[0] + along[1] * away[1] + along[2] * away[2];
  if (kind.of == CutKind::Angle) // opens a quarter
    cuts.push_back({name, {{90.0, 360.0}}});
  else if (kind.of == CutKind::Radius || slope <= 0.0)
    cuts.push_back({name, {{-HUGE_VAL, middle}}});
  else // the face of the cut is towards the eye
    cuts.push_back({name, {{middle, HUGE_VAL}}});
}

void Panel::drawSlices()
{
  drawn_.insert("slice");
  double bounds[6];
  stage_.bounds(bounds);
  const std::vector<ShowRange> inForce =
    stage_.shown().volume.slices.value_or(std::vector<ShowRange>());
  std::vector<ShowRange> slices = next_.volume.slices.value_or(inForce);
  this->changeSlices(slices, bounds);
  if (slices != next_.volume.slices.value_or(inForce))
    next_.volume.slices = slices;
}

void Panel::changeSlices(std::vector<ShowRange>& slices, const double bounds[6])
{
  const CutAxis axis = cutAxisOf(next_.cuts.axis);
  const auto extent = [&](const std::string& name)
  { return extentOf(*cutNamed(name), axis, bounds); };
  for (std::size_t i = 0; i < slices.size(); ++i)
    for (std::size_t k = 0; k < slices[i].intervals.size(); ++k)
    {
      ImGui::PushID(static_cast<int>(100 * i + k));
      const bool isKept =
        !cutNamed(slices[i].name) ||
        drawSlice(slices[i].name, k, extent(slices[i].name), slices[i].intervals[k]);
      ImGui::PopID();
      if (!isKept)
        slices[i].intervals.erase(slices[i].intervals.begin() + static_cast<std::ptrdiff_t>(k--));
    }
  std::erase_if(slices, [](const ShowRange& slice) { return slice.intervals.empty(); });
  std::size_t count = 0;
  for (const ShowRange& slice : slices)
    count += slice.intervals.size();
  if (count >= mostSlices)
    return;
  const std::string name = this->chooseCut("Slice by ...", "slice", {});
  if (name.empty())
    return;
  const Interval all = extent(name);
  if (slices.empty())
    next_.volume.cloud = "off"; // which would hide it
  auto same = std::find_if(
    slices.begin(), slices.end(), [&](const ShowRange& slice) { return slice.name == name; });
  if (same == slices.end())
    same = slices.insert(slices.end(), {name, {}});
  // The first one in the middle, others in the widest gap.
  std::vector<double> places = {all.low, all.high};
  for (const Interval& place : same->intervals)
    places.push_back(place.low);
  std::sort(places.begin(), places.end());
  std::size_t widest = 1;
  for (std::size_t k = 2; k < places.size(); ++k)
    if (places[k] - places[k - 1] > places[widest] - places[widest - 1])
      widest = k;
  const double place = 0.5 * (places[widest - 1] + places[widest]);
  same->intervals.push_back({place, place});
  std::sort(same->intervals.begin(), same->intervals.end(),
    [](const Interval& a, const Interval& b) { return a.low < b.low; });
}

/// A slider for one slice; returns false where it is to go.
bool Panel::drawSlice(
  const std::string& name, std::size_t number, const Interval& extent, Interval& place)
{
  const float button = 1.8f * ImGui::GetFontSize();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX() - button);
  // Radii begin above 0.
  const double low = name == "r" ? 1e-6 * extent.high : extent.low, high = extent.high;
  const std::string format =
    (name.find(',') == std::string::npos ? name : "along view") + " = %.5g";
  double value = place.low;
  if (ImGui::SliderScalar("##place", ImGuiDataType_Double, &value, &low, &high, format.c_str()) &&
      std::isfinite(value) && (name != "r" || value > 0.0))
    place = {value, value};
  noteControl("slice " + name + " " + std::to_string(number));
  explainKey(
    ("Where the slice lies; Ctrl and a click to type\n--slice " + name + "=PLACE").c_str());
  ImGui::SameLine();
  const bool isLeft = ImGui::Button("x");
  noteControl("no slice " + name + " " + std::to_string(number));
  explainKey("Take this slice away\nwithout --slice NAME");
  return !isLeft;
}

} // namespace mote::app
