#include "ValueControls.h"

#include "ControlPlaces.h"
#include "PanelColors.h"
#include "base/Text.h"

#include <vtkLookupTable.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mote::app
{

namespace
{

constexpr ImU32 outside = IM_COL32(70, 76, 86, 255), handle = IM_COL32(235, 235, 235, 255);

/// A rectangle of the panel, and values from its left to its right.
struct Frame
{
  ImVec2 from, size;
  double least, most;

  float xOf(double value) const
  {
    const double width = most - least;
    const double share = width > 0.0 ? (value - least) / width : 0.5;
    return from.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * size.x;
  }
  /// In round numbers, a thousand or more in all; the ends as they are.
  double valueAt(float x) const
  {
    const double share = (x - from.x) / size.x;
    return share <= 0.0 ? least : share >= 1.0 ? most : rounded(least + share * (most - least));
  }
  double rounded(double value) const
  {
    const double width = most - least;
    if (!(width > 0.0))
      return value;
    const double digits = std::floor(std::log10(width / 1000.0));
    const double step = std::pow(10.0, std::abs(digits));
    const double round =
      digits < 0.0 ? std::round(value * step) / step : std::round(value / step) * step;
    return std::clamp(round, least, most);
  }
  float yOf(double share) const
  {
    return from.y + static_cast<float>(1.0 - std::clamp(share, 0.0, 1.0)) * size.y;
  }
  double shareAt(float y) const { return std::clamp(1.0f - (y - from.y) / size.y, 0.0f, 1.0f); }
};

Frame frameOf(const Histogram& histogram, float lines)
{
  const ImVec2 size(ImGui::GetContentRegionAvail().x, lines * ImGui::GetFontSize());
  return {ImGui::GetCursorScreenPos(), size, histogram.least, histogram.most};
}

ImU32 colorAt(vtkLookupTable* table, double value)
{
  const unsigned char* c = table->MapValue(value);
  return IM_COL32(c[0], c[1], c[2], 255);
}

/// Bars as high as the square root of the counts: few are seen beside many.
template <typename ColorOf>
void drawBars(const Frame& frame, const Histogram& histogram, const ColorOf& colorOf)
{
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 end(frame.from.x + frame.size.x, frame.from.y + frame.size.y);
  list->AddRectFilled(frame.from, end, drawingGround);
  const double bins = static_cast<double>(histogram.counts.size());
  for (std::size_t i = 0; i < histogram.counts.size(); ++i)
  {
    if (!(histogram.counts[i] > 0.0))
      continue;
    const double low = histogram.least + (histogram.most - histogram.least) * double(i) / bins;
    const double high =
      histogram.least + (histogram.most - histogram.least) * (double(i) + 1.0) / bins;
    list->AddRectFilled(
      ImVec2(frame.xOf(low), frame.yOf(std::sqrt(histogram.counts[i] / histogram.highest))),
      ImVec2(std::max(frame.xOf(low) + 1.0f, frame.xOf(high)), end.y), colorOf(0.5 * (low + high)));
  }
}

/// What of a control the mouse holds, between frames.
int& heldPart(ImGuiID id)
{
  return *ImGui::GetStateStorage()->GetIntRef(id, -1);
}

} // namespace

bool rangeControl(const char* id, const Histogram& histogram, Interval& range)
{
  if (histogram.isEmpty())
    return false;
  const Frame frame = frameOf(histogram, 2.6f);
  ImGui::InvisibleButton(id, frame.size);
  noteControl(id);
  const double low = std::clamp(range.low, frame.least, frame.most);
  const double high = std::clamp(range.high, frame.least, frame.most);
  drawBars(frame, histogram,
    [&](double value) { return value >= low && value <= high ? drawingBar : outside; });
  int& part = heldPart(ImGui::GetID(id));
  const float x = ImGui::GetIO().MousePos.x;
  const float left = frame.xOf(low), right = frame.xOf(high);
  bool isChanged = false;
  if (ImGui::IsItemActivated())
  {
    const float near = 0.6f * ImGui::GetFontSize();
    const bool isLeft = std::abs(x - left) <= std::abs(x - right);
    part =
      std::abs(x - (isLeft ? left : right)) < near || x < left || x > right ? (isLeft ? 0 : 1) : 2;
  }
  else if (!ImGui::IsItemActive())
    part = -1;
  if (ImGui::IsItemActive())
  {
    Interval next = {low, high};
    const double at = frame.valueAt(x);
    if (part == 0)
      next.low = std::min(at, high);
    else if (part == 1)
      next.high = std::max(at, low);
    else if (const float moved = ImGui::GetIO().MouseDelta.x; moved != 0.0f)
    {
      const double width = frame.most - frame.least;
      double by = moved / frame.size.x * width;
      by = std::clamp(by, frame.least - low, frame.most - high);
      // The width stays: what is dragged back comes to where it was.
      next = {low + by, high + by};
    }
    isChanged = next.low != range.low || next.high != range.high;
    if (isChanged)
      range = next;
  }
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float end = frame.from.y + frame.size.y;
  list->AddRectFilled(
    ImVec2(left - 2.0f, frame.from.y), ImVec2(left + 2.0f, end), part == 0 ? heldInk : handle);
  list->AddRectFilled(
    ImVec2(right - 2.0f, frame.from.y), ImVec2(right + 2.0f, end), part == 1 ? heldInk : handle);
  return isChanged;
}

Interval inOrder(const Interval& before, Interval entered)
{
  if (entered.low <= entered.high)
    return entered;
  const bool isPositive = before.low > 0.0 && std::min(entered.low, entered.high) > 0.0;
  const double width = before.high - before.low, ratio = before.high / before.low;
  if (entered.low != before.low)
    entered.high = isPositive ? entered.low * ratio : entered.low + width;
  else
    entered.low = isPositive ? entered.high / ratio : entered.high - width;
  return entered;
}

namespace
{

/// A field for a number: true once it is left with another one, by Enter, Tab or a click elsewhere.
bool numberField(const char* label, double& value)
{
  // What is written is known while it is, and no more when the field is left. Only one field is
  // written at a time.
  static ImGuiID writtenIn = 0;
  static double written = 0.0;
  double typed = value;
  if (ImGui::InputDouble(label, &typed, 0.0, 0.0, "%.6g"))
  {
    writtenIn = ImGui::GetID(label);
    written = typed;
  }
  if (!ImGui::IsItemDeactivatedAfterEdit() || writtenIn != ImGui::GetID(label))
    return false;
  writtenIn = 0;
  const bool isOther = written != value;
  value = written;
  return isOther;
}

} // namespace

bool rangeFields(const char* id, Interval& range)
{
  ImGui::PushID(id);
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  Interval next = range;
  ImGui::SetNextItemWidth(width);
  bool isEntered = numberField("##low", next.low);
  noteControl(std::string(id) + " low");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(width);
  isEntered = numberField("##high", next.high) || isEntered;
  noteControl(std::string(id) + " high");
  ImGui::PopID();
  if (!isEntered || !std::isfinite(next.low) || !std::isfinite(next.high) || next == range)
    return false;
  range = inOrder(range, next);
  return true;
}

//------------------------------------------------------------------------------------------------
// The curve of opacities

namespace
{

/// The point under the mouse; -1 for none.
int nearestPoint(const Frame& frame, const std::vector<OpacityPoint>& points)
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

OpacityPoint pointAtMouse(const Frame& frame)
{
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {frame.valueAt(mouse.x), false, std::round(1000.0 * frame.shareAt(mouse.y)) / 1000.0};
}

/// A double click adds a point, which is held from then on; the right button takes one away.
bool addOrTakeAway(const Frame& frame, std::vector<OpacityPoint>& points, int nearest, int& part)
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
bool dragPoint(const Frame& frame, std::vector<OpacityPoint>& points, std::size_t i)
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

void drawCurve(const Frame& frame, const std::vector<OpacityPoint>& points, int bright)
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

bool opacityControl(const char* id, const Histogram& histogram, vtkLookupTable* table,
  std::vector<OpacityPoint>& points)
{
  if (histogram.isEmpty() || !table || points.empty())
    return false;
  const Frame frame = frameOf(histogram, 7.0f);
  ImGui::InvisibleButton(
    id, frame.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  noteControl(id);
  drawBars(frame, histogram, [&](double value) { return colorAt(table, value); });
  const int nearest = nearestPoint(frame, points);
  int& part = heldPart(ImGui::GetID(id));
  bool isChanged = addOrTakeAway(frame, points, nearest, part);
  if (!isChanged && ImGui::IsItemActivated())
    part = ImGui::IsMouseDown(0) ? nearest : -1;
  else if (!isChanged && !ImGui::IsItemActive())
    part = -1;
  if (!isChanged && ImGui::IsItemActive() && part >= 0 && part < static_cast<int>(points.size()))
    isChanged = dragPoint(frame, points, static_cast<std::size_t>(part));
  drawCurve(frame, points, part >= 0 ? part : ImGui::IsItemHovered() ? nearest : -1);
  if (ImGui::IsItemHovered() && nearest >= 0 && nearest < static_cast<int>(points.size()))
  {
    const OpacityPoint& point = points[static_cast<std::size_t>(nearest)];
    ImGui::SetTooltip(
      "%s: opacity %s", asNumber(point.value).c_str(), asNumber(point.opacity, 3).c_str());
  }
  else if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    ImGui::SetTooltip("Drag points; double click adds one, right click takes one away\n--opacity");
  return isChanged;
}

//------------------------------------------------------------------------------------------------
// Values of isosurfaces

namespace
{

/// The value whose line is under the mouse; -1 for none.
int nearestLine(const Frame& frame, const std::vector<double>& values)
{
  int nearest = -1;
  float least = 0.6f * ImGui::GetFontSize();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const float away = std::abs(frame.xOf(values[i]) - ImGui::GetIO().MousePos.x); away < least)
      least = away, nearest = static_cast<int>(i);
  return nearest;
}

void drawLine(const Frame& frame, double value, bool isBright)
{
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float x = frame.xOf(value), half = 0.3f * ImGui::GetFontSize();
  const ImU32 color = isBright ? heldInk : handle;
  list->AddLine(
    ImVec2(x, frame.from.y), ImVec2(x, frame.from.y + frame.size.y), color, isBright ? 3.0f : 2.0f);
  list->AddTriangleFilled(ImVec2(x - half, frame.from.y), ImVec2(x + half, frame.from.y),
    ImVec2(x, frame.from.y + 1.5f * half), color);
}

} // namespace

bool isoControl(
  const char* id, const Histogram& histogram, vtkLookupTable* table, std::vector<double>& values)
{
  if (histogram.isEmpty() || !table)
    return false;
  const Frame frame = frameOf(histogram, 2.6f);
  ImGui::InvisibleButton(
    id, frame.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  noteControl(id);
  drawBars(frame, histogram, [&](double value) { return colorAt(table, value); });
  const int nearest = nearestLine(frame, values);
  const double at = frame.valueAt(ImGui::GetIO().MousePos.x);
  int& part = heldPart(ImGui::GetID(id));
  bool isChanged = false;
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && nearest < 0)
  {
    part = static_cast<int>(values.size());
    values.push_back(at);
    isChanged = true;
  }
  else if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(1) && nearest >= 0)
  {
    values.erase(values.begin() + nearest);
    part = -1;
    isChanged = true;
  }
  else if (ImGui::IsItemActivated())
    part = ImGui::IsMouseDown(0) ? nearest : -1;
  else if (!ImGui::IsItemActive())
    part = -1;
  const float moved = ImGui::GetIO().MouseDelta.x;
  if (!isChanged && part >= 0 && part < static_cast<int>(values.size()) && moved != 0.0f)
  {
    double& value = values[static_cast<std::size_t>(part)];
    isChanged = value != at;
    value = at;
  }
  const int bright = part >= 0 ? part : ImGui::IsItemHovered() ? nearest : -1;
  for (std::size_t i = 0; i < values.size(); ++i)
    drawLine(frame, values[i], bright == static_cast<int>(i));
  if (bright >= 0 && bright < static_cast<int>(values.size()))
    ImGui::SetTooltip("%s", asNumber(values[static_cast<std::size_t>(bright)]).c_str());
  else if (ImGui::IsItemHovered())
    ImGui::SetTooltip("Drag lines; double click adds one, right click takes one away\n--iso");
  return isChanged;
}

double newIsoValue(const Histogram& histogram, std::vector<double> values)
{
  std::erase_if(
    values, [&](double value) { return value < histogram.least || value > histogram.most; });
  values.insert(values.end(), {histogram.least, histogram.most});
  std::sort(values.begin(), values.end());
  std::size_t widest = 1;
  for (std::size_t i = 2; i < values.size(); ++i)
    if (values[i] - values[i - 1] > values[widest] - values[widest - 1])
      widest = i;
  const Frame frame = {{}, {}, histogram.least, histogram.most};
  return frame.rounded(0.5 * (values[widest - 1] + values[widest]));
}

void colorStrip(vtkLookupTable* table, float width, float height)
{
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  constexpr int pieces = 32;
  const double* range = table->GetRange();
  const auto at = [&](int i)
  {
    const double share = double(i) / pieces;
    return colorAt(table, table->UsingLogScale() ? range[0] * std::pow(range[1] / range[0], share)
                                                 : range[0] + share * (range[1] - range[0]));
  };
  for (int i = 0; i < pieces; ++i)
  {
    const float left = from.x + width * float(i) / pieces;
    const float right = from.x + width * (float(i) + 1.0f) / pieces;
    list->AddRectFilledMultiColor(
      ImVec2(left, from.y), ImVec2(right, from.y + height), at(i), at(i + 1), at(i + 1), at(i));
  }
  ImGui::Dummy(ImVec2(width, height));
}

} // namespace mote::app
