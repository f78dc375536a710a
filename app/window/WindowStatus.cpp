// What the window says of its picture: at its lower edge, and in the panel.

#include "Window.h"

#include "base/Text.h"

#include <cmath>

namespace mote::app
{

std::string Window::statusText() const
{
  const std::string dot = Overlay::dot;
  std::string text = this->isEmpty() ? "" : stage_.contents();
  if (!this->isEmpty() && !stage_.shown().cuts.ranges.empty())
    text += dot + "cut";
  if (!input_.times().empty())
    text +=
      dot + stepText(step_, input_.numberOfSteps()) + "t = " + asNumber(input_.times()[step_], 10);
  if (costs_.frame > 0.0)
    text += dot + "frame " + asDuration(costs_.frame);
  if (views_.numberOfSamples() == 0)
    return text;
  if (!previewed_)
    text += dot + "structure " + asBytes(static_cast<double>(stage_.structureBytes()));
  return text + dot + this->qualityText();
}

std::string Window::qualityText() const
{
  const double distance = views_.imageSampleDistance();
  std::string text = distance > 1.0 ? "1/" + asNumber(distance, 2) + " resolution"
                                    : counted(views_.numberOfSamples(), "sample") + " per pixel";
  if (const double share = views_.finerShare(); share > 0.0)
    text += ", " + asNumber(std::floor(100.0 * share)) + " % sharpened";
  if (const double share = views_.bakedShare(); share < 1.0)
    text += ", ambient occlusion " + asNumber(std::floor(100.0 * share)) + " % baked";
  return text + stage_.errorText(distance, views_.noise());
}

} // namespace mote::app
