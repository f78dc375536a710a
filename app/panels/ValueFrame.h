#pragma once

// What controls over a histogram are drawn with.

#include "PanelColors.h"
#include "stage/Histogram.h"

#include <vtkLookupTable.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

constexpr ImU32 handle = IM_COL32(235, 235, 235, 255);

/// A rectangle of the panel, and values from its left to its right.
struct ValueFrame
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

inline ValueFrame frameOf(const Histogram& histogram, float lines)
{
  const ImVec2 size(ImGui::GetContentRegionAvail().x, lines * ImGui::GetFontSize());
  return {ImGui::GetCursorScreenPos(), size, histogram.least, histogram.most};
}

inline ImU32 colorAt(vtkLookupTable* table, double value)
{
  const unsigned char* c = table->MapValue(value);
  return IM_COL32(c[0], c[1], c[2], 255);
}

/// Bars as high as the square root of the counts: few are seen beside many.
template <typename ColorOf>
void drawBars(const ValueFrame& frame, const Histogram& histogram, const ColorOf& colorOf)
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
inline int& heldPart(ImGuiID id)
{
  return *ImGui::GetStateStorage()->GetIntRef(id, -1);
}

} // namespace mote::app
