// The curve of opacities over a histogram: by the mouse, by the keys, and as numbers.

#include "ControlPlaces.h"
#include "PanelWidgets.h"
#include "ValueControls.h"
#include "ValueFrame.h"
#include "base/Text.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

/// The point under the mouse; -1 for none.
int nearestPoint(const ValueFrame& frame, const std::vector<OpacityPoint>& points)
{
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  int nearest = -1;
  float least = 0.6f * ImGui::GetFontSize();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const float away =
      std::hypot(frame.xOf(points[i].value) - mouse.x, frame.yOf(points[i].opacity) - mouse.y);
    if (away < least)
      least = away, nearest = static_cast<int>(i);
  }
  return nearest;
}

OpacityPoint pointAtMouse(const ValueFrame& frame)
{
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {frame.valueAt(mouse.x), false, std::round(1000.0 * frame.shareAt(mouse.y)) / 1000.0};
}

/// A double click adds a point, which is held from then on; the right button takes one away.
bool addOrTakeAway(
  const ValueFrame& frame, std::vector<OpacityPoint>& points, int nearest, int& part)
{
  if (!ImGui::IsItemHovered())
    return false;
  if (ImGui::IsMouseDoubleClicked(0) && nearest < 0)
  {
    const OpacityPoint added = pointAtMouse(frame);
    const auto at = std::find_if(points.begin(), points.end(),
      [&](const OpacityPoint& point) { return point.value > added.value; });
    part = static_cast<int>(points.insert(at, added) - points.begin());
    return true;
  }
  if (ImGui::IsMouseClicked(1) && nearest >= 0 && points.size() > 1)
  {
    points.erase(points.begin() + nearest);
    part = -1;
    return true;
  }
  return false;
}

/// A point that is dragged stays between its neighbours.
bool dragPoint(const ValueFrame& frame, std::vector<OpacityPoint>& points, std::size_t i)
{
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x == 0.0f && moved.y == 0.0f)
    return false;
  OpacityPoint next = pointAtMouse(frame);
  next.value = std::clamp(next.value, i > 0 ? points[i - 1].value : frame.least,
    i + 1 < points.size() ? points[i + 1].value : frame.most);
  if (next == points[i])
    return false;
  points[i] = next;
  return true;
}

void drawCurve(const ValueFrame& frame, const std::vector<OpacityPoint>& points, int bright)
{
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto placeOf = [&](const OpacityPoint& point)
  { return ImVec2(frame.xOf(point.value), frame.yOf(point.opacity)); };
  ImVec2 before(frame.from.x, placeOf(points.front()).y);
  for (const OpacityPoint& point : points)
  {
    list->AddLine(before, placeOf(point), handle, 1.5f);
    before = placeOf(point);
  }
  list->AddLine(before, ImVec2(frame.from.x + frame.size.x, before.y), handle, 1.5f);
  for (std::size_t i = 0; i < points.size(); ++i)
    list->AddCircleFilled(placeOf(points[i]), 0.28f * ImGui::GetFontSize(),
      bright == static_cast<int>(i) ? heldInk : handle);
}

} // namespace

namespace
{

/// A new point in the middle of the widest gap, as opaque as the curve is there; its number.
std::size_t addPoint(const Histogram& histogram, std::vector<OpacityPoint>& points)
{
  const ValueFrame frame = {{}, {}, histogram.least, histogram.most};
  std::vector<OpacityPoint> ends = points;
  ends.insert(ends.begin(), {histogram.least, false, points.front().opacity});
  ends.push_back({histogram.most, false, points.back().opacity});
  std::size_t widest = 1;
  for (std::size_t i = 2; i < ends.size(); ++i)
    if (ends[i].value - ends[i - 1].value > ends[widest].value - ends[widest - 1].value)
      widest = i;
  const OpacityPoint &before = ends[widest - 1], &after = ends[widest];
  const OpacityPoint added = {frame.rounded(0.5 * (before.value + after.value)), false,
    std::round(500.0 * (before.opacity + after.opacity)) / 1000.0};
  points.insert(points.begin() + static_cast<long>(widest) - 1, added);
  return widest - 1;
}

bool isKeyPressed(ImGuiKey key)
{
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

/// What the keys do to the point that they hold, of which `part` is the number. Whether points are
/// others now.
bool moveByKeys(
  const ValueFrame& frame, const Histogram& histogram, std::vector<OpacityPoint>& points, int& part)
{
  const auto last = static_cast<int>(points.size()) - 1;
  if (isKeyPressed(ImGuiKey_PageUp))
    part = std::max(0, part - 1);
  if (isKeyPressed(ImGuiKey_PageDown))
    part = std::min(last, part + 1);
  if (isKeyPressed(ImGuiKey_Insert))
  {
    part = static_cast<int>(addPoint(histogram, points));
    return true;
  }
  const auto i = static_cast<std::size_t>(part);
  if (isKeyPressed(ImGuiKey_Delete) && points.size() > 1)
  {
    points.erase(points.begin() + part);
    part = std::min(part, last - 1);
    return true;
  }
  const double right = isKeyPressed(ImGuiKey_RightArrow) - isKeyPressed(ImGuiKey_LeftArrow);
  const double up = isKeyPressed(ImGuiKey_UpArrow) - isKeyPressed(ImGuiKey_DownArrow);
  if (right == 0.0 && up == 0.0)
    return false;
  OpacityPoint next = points[i];
  if (right != 0.0)
    next.value = std::clamp(frame.rounded(next.value + 0.01 * right * (frame.most - frame.least)),
      i > 0 ? points[i - 1].value : frame.least, part < last ? points[i + 1].value : frame.most);
  next.opacity = std::clamp(std::round(1000.0 * next.opacity + 20.0 * up) / 1000.0, 0.0, 1.0);
  const bool isOther = next != points[i];
  points[i] = next;
  return isOther;
}

/// Whether the keys hold a point of the control that was drawn last. Space takes hold; space,
/// Return and Escape let go, as does whatever takes the focus away.
bool holdByKeys(ImGuiID id)
{
  ImGuiContext& context = *ImGui::GetCurrentContext();
  bool& isHeld = *ImGui::GetStateStorage()->GetBoolRef(id + 1);
  const bool wasHeld = isHeld;
  if (!ImGui::IsItemFocused() || context.NavDisableHighlight)
    isHeld = false;
  else if (!wasHeld)
    isHeld = context.NavActivateId == id;
  else if (isKeyPressed(ImGuiKey_Space) || isKeyPressed(ImGuiKey_Enter) ||
           isKeyPressed(ImGuiKey_Escape))
    isHeld = false;
  if (!isHeld)
  {
    if (wasHeld && context.ActiveId == id)
      ImGui::ClearActiveID();
    return false;
  }
  // While it is active the keys below go nowhere else.
  ImGui::SetActiveID(id, context.CurrentWindow);
  context.ActiveIdSource = ImGuiInputSource_Nav;
  context.ActiveIdUsingNavDirMask = 0xf;
  context.ActiveIdUsingKeyInputMask = ImU64(1) << ImGuiKey_PageUp | ImU64(1) << ImGuiKey_PageDown;
  return wasHeld;
}

} // namespace

bool opacityControl(const char* id, const Histogram& histogram, vtkLookupTable* table,
  std::vector<OpacityPoint>& points)
{
  if (histogram.isEmpty() || !table || points.empty())
    return false;
  const ValueFrame frame = frameOf(histogram, 7.0f);
  ImGui::InvisibleButton(
    id, frame.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const ImGuiID self = ImGui::GetID(id);
  int& part = heldPart(self);
  int& selected = heldPart(self + 2); // that the keys take hold of
  selected = std::clamp(selected, 0, static_cast<int>(points.size()) - 1);
  const bool isByKeys = holdByKeys(self);
  noteControl(id);
  drawBars(frame, histogram, [&](double value) { return colorAt(table, value); });
  const int nearest = nearestPoint(frame, points);
  bool isChanged = false;
  if (isByKeys)
  {
    isChanged = moveByKeys(frame, histogram, points, selected);
    part = -1;
  }
  else if (isChanged = addOrTakeAway(frame, points, nearest, part); isChanged)
    ;
  else if (ImGui::IsItemActivated())
    part = ImGui::IsMouseDown(0) ? nearest : -1;
  else if (!ImGui::IsItemActive())
    part = -1;
  else if (part >= 0 && part < static_cast<int>(points.size()))
    isChanged = dragPoint(frame, points, static_cast<std::size_t>(part));
  if (part >= 0)
    selected = part;
  drawCurve(frame, points,
    part >= 0                ? part
    : isByKeys               ? selected
    : ImGui::IsItemHovered() ? nearest
                             : -1);
  const int told = isByKeys ? selected : ImGui::IsItemHovered() ? nearest : -1;
  if (told >= 0 && told < static_cast<int>(points.size()))
  {
    const OpacityPoint& point = points[static_cast<std::size_t>(told)];
    ImGui::SetTooltip(
      "%s: opacity %s", asNumber(point.value).c_str(), asNumber(point.opacity, 3).c_str());
  }
  else if (!ImGui::IsItemActive())
    explainKey(
      "Drag points; double click adds one, right click takes one away. With the keys space "
      "takes hold of a point, arrows move it, Page Up and Page Down go to others, Insert "
      "adds one, Delete takes one away, and space lets go\n--opacity VALUE=OPACITY,...");
  return isChanged;
}

bool opacityFields(std::vector<OpacityPoint>& points, const Histogram& histogram)
{
  const bool isOpen = ImGui::TreeNodeEx("points", ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
    counted(static_cast<long>(points.size()), "point").c_str());
  noteControl("opacity points");
  explainKey("The points of the curve as numbers\n--opacity VALUE=OPACITY,...");
  if (!isOpen || points.empty())
    return false;
  bool isChanged = false;
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight()) -
                      ImGui::GetStyle().ItemSpacing.x;
  const auto field = [&](
                       const char* label, double& value, const std::string& name, const char* help)
  {
    ImGui::SetNextItemWidth(width);
    const bool isEntered = numberField(label, value);
    noteControl(name);
    explainKey(help);
    ImGui::SameLine();
    return isEntered;
  };
  for (std::size_t i = 0; i < points.size() && !isChanged; ++i)
  {
    const std::string name = "opacity " + std::to_string(i + 1);
    ImGui::PushID(static_cast<int>(i));
    isChanged = field("##value", points[i].value, name + " value", "The value\n--opacity VALUE=");
    isChanged = field("##opacity", points[i].opacity, name + " opacity",
                  "How opaque that value is, from 0 to 1\n--opacity VALUE=OPACITY") ||
                isChanged;
    points[i].opacity = std::clamp(points[i].opacity, 0.0, 1.0);
    if (ImGui::Button("x", ImVec2(ImGui::GetFrameHeight(), 0.0f)) && points.size() > 1)
    {
      points.erase(points.begin() + static_cast<long>(i));
      isChanged = true;
    }
    noteControl("forget " + name);
    explainKey("Take this point away");
    ImGui::PopID();
  }
  if (buttonOf("Add point"))
  {
    addPoint(histogram, points);
    isChanged = true;
  }
  explainKey("One more point, in the widest gap between the others");
  std::stable_sort(points.begin(), points.end(),
    [](const OpacityPoint& a, const OpacityPoint& b) { return a.value < b.value; });
  return isChanged;
}

} // namespace mote::app
