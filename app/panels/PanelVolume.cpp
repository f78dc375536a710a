// The opacities and isosurfaces of volumes.

#include "Panel.h"

#include "PanelWidgets.h"
#include "stage/Coloring.h"

#include <vtkLookupTable.h>

#include <imgui.h>

#include <algorithm>

namespace mote::app
{

void Panel::drawVolume()
{
  drawn_.insert("opacity");
  const Coloring& coloring = stage_.coloring();
  const std::vector<OpacityPoint>& inForce = coloring.opacity();
  if (!coloring.table() || inForce.empty())
    return;
  const double* range = coloring.table()->GetRange();
  std::vector<OpacityPoint> points = inForce;
  for (OpacityPoint& point : points)
    if (point.isShare)
      point = {range[0] + 0.01 * point.value * (range[1] - range[0]), false, point.opacity};
  std::stable_sort(points.begin(), points.end(),
    [](const OpacityPoint& a, const OpacityPoint& b) { return a.value < b.value; });
  const Histogram& histogram = this->histogramOf(this->coloredBy());
  if (opacityControl("opacity", histogram, coloring.table(), points))
    next_.volume.opacity = points;
  const auto preset = [&](const char* label, std::vector<OpacityPoint> wanted, const char* help)
  {
    if (buttonOf(label))
      next_.volume.opacity = std::move(wanted);
    explainKey(help);
    ImGui::SameLine();
  };
  preset("Usual", {}, "The opacities that Mote chooses by the values\nwithout --opacity");
  preset("Rising", {{0.0, true, 0.0}, {100.0, true, 0.8}},
    "The greater the value, the more opaque\n--opacity 0%=0,100%=0.8");
  preset("Falling", {{0.0, true, 0.8}, {100.0, true, 0.0}},
    "The less the value, the more opaque\n--opacity 0%=0.8,100%=0");
  preset("Even", {{0.0, true, 0.2}, {100.0, true, 0.2}},
    "All values are as opaque\n--opacity 0%=0.2,100%=0.2");
  ImGui::NewLine();
  if (opacityFields(points, histogram))
    next_.volume.opacity = points;
  const std::string& followed = next_.volume.isoArray;
  this->drawIsosurfaces(followed.empty() ? histogram : this->histogramOf(followed));
}

/// Of cells that are shown by their surface: the way to the volume, and nothing else.
void Panel::drawCells()
{
  for (const Row& row : settingsTable())
    if (row.group == "Volume" && row.name != "cells")
      drawn_.insert(row.name);
}

/// Values of isosurfaces as lines over the histogram.
void Panel::drawIsosurfaces(const Histogram& histogram)
{
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("isosurfaces");
  ImGui::SameLine(0.42f * ImGui::GetWindowContentRegionMax().x);
  if (buttonOf("Add isosurface") && !histogram.isEmpty())
    next_.volume.isoValues.push_back(newIsoValue(histogram, next_.volume.isoValues));
  explainKey("One more, between the others; then drag its line\n--iso");
  if (!next_.volume.isoValues.empty())
    isoControl("iso lines", histogram,
      next_.volume.isoArray.empty() ? stage_.coloring().table() : nullptr, next_.volume.isoValues);
  this->drawRow("iso", "values");
  this->drawRow("iso-array", "of");
}

} // namespace mote::app
