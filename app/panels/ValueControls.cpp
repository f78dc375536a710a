#include "ValueControls.h"

#include "ControlPlaces.h"
#include "PanelWidgets.h"
#include "ValueFrame.h"
#include "base/Text.h"

#include <vtkLookupTable.h>

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mote::app
{

namespace
{

constexpr ImU32 hiddenBar = IM_COL32(70, 76, 86, 255);

} // namespace

bool rangeControl(const char* id, const Histogram& histogram, Interval& range, bool isOutside,
  const std::string& option)
{
  if (histogram.isEmpty())
    return false;
  const ValueFrame frame = frameOf(histogram, 2.6f);
  ImGui::InvisibleButton(id, frame.size);
  noteControl(id);
  const double low = std::clamp(range.low, frame.least, frame.most);
  const double high = std::clamp(range.high, frame.least, frame.most);
  drawBars(frame, histogram,
    [&](double value)
    { return (value >= low && value <= high) != isOutside ? drawingBar : hiddenBar; });
  explainKey(("Drag a handle, or the range between the handles\n" + option).c_str());
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
  const double width = std::max(0.0, before.high - before.low);
  const double ratio = std::max(1.0, before.high / before.low);
  if (entered.low != before.low)
    entered.high = isPositive ? entered.low * ratio : entered.low + width;
  else
    entered.low = isPositive ? entered.high / ratio : entered.high - width;
  return entered;
}

namespace
{

/// What is written in a field is known while it is, and no more when the field is left. Only one
/// field is written at a time.
template <typename T>
struct Written
{
  ImGuiID field = 0;
  T value{};

  /// After the field `label`, which says whether `typed` was written in it: whether it was left
  /// with another value than `present`, which becomes that.
  bool take(const char* label, bool isWritten, const T& typed, T& present)
  {
    const ImGuiID id = ImGui::GetID(label);
    if (isWritten)
    {
      field = id;
      value = typed;
    }
    if (!ImGui::IsItemDeactivatedAfterEdit() || field != id)
      return false;
    field = 0;
    return std::exchange(present, value) != value;
  }
};

} // namespace

bool numberField(const char* label, double& value, const char* format)
{
  static Written<double> written;
  double typed = value;
  const bool isWritten = ImGui::InputDouble(label, &typed, 0.0, 0.0, format);
  return written.take(label, isWritten, typed, value);
}

bool textField(const char* label, const char* hint, std::string& text)
{
  static Written<std::string> written;
  std::string typed = text;
  const bool isWritten = ImGui::InputTextWithHint(label, hint, &typed, textFlags);
  return written.take(label, isWritten, typed, text);
}

bool rangeFields(const char* id, Interval& range, const char* help)
{
  ImGui::PushID(id);
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  Interval next = range;
  ImGui::SetNextItemWidth(width);
  bool isEntered = numberField("##low", next.low);
  noteControl(std::string(id) + " low");
  explainKey(help);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(width);
  isEntered = numberField("##high", next.high) || isEntered;
  noteControl(std::string(id) + " high");
  explainKey(help);
  ImGui::PopID();
  if (!isEntered || !std::isfinite(next.low) || !std::isfinite(next.high) || next == range)
    return false;
  range = inOrder(range, next);
  return true;
}

//------------------------------------------------------------------------------------------------
// Values of isosurfaces

namespace
{

/// The value whose line is under the mouse; -1 for none.
int nearestLine(const ValueFrame& frame, const std::vector<double>& values)
{
  int nearest = -1;
  float least = 0.6f * ImGui::GetFontSize();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const float away = std::abs(frame.xOf(values[i]) - ImGui::GetIO().MousePos.x); away < least)
      least = away, nearest = static_cast<int>(i);
  return nearest;
}

void drawLine(const ValueFrame& frame, double value, bool isBright)
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
  if (histogram.isEmpty())
    return false;
  const auto colorOf = [&](double value)
  { return table ? colorAt(table, value) : ImGui::GetColorU32(ImGuiCol_PlotHistogram); };
  const ValueFrame frame = frameOf(histogram, 2.6f);
  ImGui::InvisibleButton(
    id, frame.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  noteControl(id);
  drawBars(frame, histogram, colorOf);
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
  const ValueFrame frame = {{}, {}, histogram.least, histogram.most};
  return frame.rounded(0.5 * (values[widest - 1] + values[widest]));
}

void colorStrip(vtkLookupTable* table, float width, float height, bool isOfBlocks)
{
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto entries = static_cast<int>(table->GetNumberOfTableValues());
  const int pieces = isOfBlocks ? entries : 32;
  const auto at = [&](int i)
  {
    const double* c = table->GetTableValue(isOfBlocks ? i : i * (entries - 1) / pieces);
    return ImGui::ColorConvertFloat4ToU32(
      ImVec4(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]), 1.0f));
  };
  for (int i = 0; i < pieces; ++i)
  {
    const ImU32 left = at(i), right = isOfBlocks ? left : at(i + 1);
    list->AddRectFilledMultiColor(ImVec2(from.x + width * float(i) / float(pieces), from.y),
      ImVec2(from.x + width * (float(i) + 1.0f) / float(pieces), from.y + height), left, right,
      right, left);
  }
  ImGui::Dummy(ImVec2(width, height));
}

} // namespace mote::app
