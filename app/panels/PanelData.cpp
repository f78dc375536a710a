// The data sets of the scene: which are shown, how much there is of them, their arrays.

#include "Panel.h"

#include "PanelWidgets.h"
#include "base/Text.h"
#include "stage/HiddenParts.h"

#include <vtkDataArray.h>

#include <imgui.h>

#include <algorithm>

namespace mote::app
{

namespace
{

std::string countOf(const Part& part)
{
  const bool isParticles = part.kind() == Part::Kind::Particles;
  const vtkIdType all =
    isParticles ? part.data()->GetNumberOfPoints() : part.data()->GetNumberOfCells();
  const vtkIdType shown = isParticles ? part.numberShown() : part.numberOfCellsShown();
  return part.isHidden() || part.isPreview() || shown == all
           ? counted(all, isParticles ? "particle" : "cell")
           : withThousands(shown) + " of " + withThousands(all);
}

/// What a data set's box does, and the option that does it.
std::string optionFor(const NamedData& one, int number)
{
  return "Shows or hides " + one.name +
         (one.block.empty()
             ? "\n--hide-data " + std::to_string(number)
             : (one.isBoundary ? "\n--show-part '" : "\n--hide-part '") + partName(one) + "'");
}

} // namespace

/// A line for each data set, with a box that shows or hides it.
void Panel::drawData()
{
  drawn_.insert("calculate"); // which Colour has
  if (!found_.hasParticles)
    drawn_.insert("positions");
  if (!found_.hasLines && next_.data.lines == DataSettings().lines)
    drawn_.insert("lines");
  if (stage_.parts().size() > 1)
    this->drawRow("side-by-side", "side by side");
  const std::vector<bool> isHidden = hiddenParts(stage_.data(), next_.selection);
  for (std::size_t i = 0; i < isHidden.size() && i < stage_.parts().size(); ++i)
  {
    const Part& part = *stage_.parts()[i];
    const int number = static_cast<int>(i) + 1;
    const std::string name = "data " + std::to_string(number);
    bool isOn = !isHidden[i];
    ImGui::PushID(number);
    if (ImGui::Checkbox("##shown", &isOn))
      next_.selection = withPart(next_.selection, stage_.data(), i, isOn);
    noteControl(name);
    explainKey(optionFor(stage_.data()[i], number).c_str());
    ImGui::SameLine();
    const bool isOpen =
      ImGui::TreeNodeEx("arrays", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", part.name().c_str());
    noteControl(name + " arrays");
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("%s\nIts arrays; a click on one colours by it", part.name().c_str());
    ImGui::Indent(ImGui::GetFrameHeight());
    std::string facts = countOf(part);
    if (part.kind() == Part::Kind::Volume && !arrayOf(part.data(), stage_.coloring().choice()))
      facts += ", not shown: " + std::string(stage_.coloring().choice() ? "no " + this->coloredBy()
                                                                        : "no array chosen");
    ImGui::TextDisabled("%s", facts.c_str());
    ImGui::Unindent(ImGui::GetFrameHeight());
    if (isOpen)
    {
      this->drawArrays(part, name);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
}

/// The arrays of a data set with their ranges.
void Panel::drawArrays(const Part& part, const std::string& name)
{
  std::vector<NamedArray> arrays = found_.arrays;
  arrays.insert(arrays.end(), found_.others.begin(), found_.others.end());
  for (const NamedArray& array : arrays)
  {
    vtkDataArray* values = arrayOf(part.data(), array.choice);
    if (!values)
      continue;
    const auto key = std::make_pair(part.data(), array.text);
    auto known = found_.ranges.find(key);
    if (known == found_.ranges.end())
    {
      double range[2];
      const bool isThere = finiteRange(values, array.choice.component, range);
      known = found_.ranges
                .emplace(key, isThere ? asNumber(range[0]) + " to " + asNumber(range[1])
                                      : std::string("no number"))
                .first;
    }
    if (ImGui::Selectable(array.title.c_str(), array.choice == stage_.coloring().choice()))
      next_.color.array = array.text;
    noteControl(name + " " + array.text);
    explainKey(("Colour by this array\n--color-by " + array.text).c_str());
    // Beside the name where there is room for both, else below it.
    const float right = ImGui::GetWindowContentRegionMax().x;
    const float gap = ImGui::GetFontSize();
    const float end = ImGui::GetCursorPosX() + ImGui::CalcTextSize(array.title.c_str()).x + gap;
    const float width = ImGui::CalcTextSize(known->second.c_str()).x;
    if (end + width <= right)
      ImGui::SameLine(std::max(end, std::min(0.48f * right, right - width)));
    else
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + gap);
    ImGui::TextDisabled("%s", known->second.c_str());
    noteControl(name + " range of " + array.text);
  }
}

} // namespace mote::app
