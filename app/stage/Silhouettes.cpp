#include "Silhouettes.h"

#include "base/Text.h"
#include "settings/Values.h"

#include <vtkMoteSilhouettes.h>
#include <vtkNew.h>

#include <algorithm>

namespace mote::app
{

namespace
{

constexpr double leastWidth = 0.1, mostWidth = 64.0; // pixels

/// "2" or "1.5%": the number, and whether it is a percentage.
bool parseThreshold(const std::string& text, double& value, bool& isShare)
{
  isShare = text.ends_with('%');
  return parseNumber(isShare ? text.substr(0, text.size() - 1) : text, value) && value >= 0.0;
}

/// "2" or "1:3": widths of the weakest and of the strongest lines.
bool parseThickness(const std::string& text, double& least, double& most)
{
  const std::size_t colon = text.find(':');
  const bool isRange = colon != std::string::npos;
  return parseNumber(text.substr(0, colon), least) &&
         parseNumber(isRange ? text.substr(colon + 1) : text, most) && least >= leastWidth &&
         most >= least && most <= mostWidth;
}

} // namespace

bool areOn(const SilhouetteSettings& settings)
{
  if (settings.lines != "auto")
    return settings.lines != "off";
  // Whoever says how lines look wants some.
  return settings != SilhouetteSettings{};
}

SilhouetteSettings toggled(const SilhouetteSettings& now, const SilhouetteSettings& asked)
{
  SilhouetteSettings next = now;
  const bool own = asked.lines != "off" && asked.lines != "auto";
  next.lines = areOn(now) ? "off" : own ? asked.lines : "on";
  return next;
}

SilhouetteSettings scaled(SilhouetteSettings settings, double factor)
{
  double least = 0.0, most = 0.0;
  if (factor == 1.0 || !areOn(settings) || !parseThickness(settings.thickness, least, most))
    return settings;
  const auto text = [factor](double width)
  { return exactText(std::clamp(width * factor, leastWidth, mostWidth)); };
  settings.thickness = least == most ? text(most) : text(least) + ":" + text(most);
  return settings;
}

std::string checkLines(const std::string& text)
{
  double value = 0.0;
  bool isShare = false;
  if (text == "on" || text == "off" || text == "auto" || parseThreshold(text, value, isShare))
    return {};
  return "'" + text +
         "' is none of on, off, a number of at least 0 such as 4 and a percentage "
         "such as 1%";
}

std::string checkThickness(const std::string& text)
{
  double least = 0.0, most = 0.0;
  if (parseThickness(text, least, most))
    return {};
  return "'" + text + "' is neither a width of 0.1 to 64 pixels such as 2 nor a range as 1:3";
}

void choose(const SilhouetteSettings& settings, int mode, vtkMoteSilhouettes* silhouettes)
{
  const vtkNew<vtkMoteSilhouettes> usual;
  double threshold = usual->GetThreshold(), least = 1.0, most = 1.0;
  bool isShare = false;
  if (!parseThreshold(settings.lines, threshold, isShare))
    mode = usual->GetThresholdMode();
  silhouettes->SetEnabled(areOn(settings));
  silhouettes->SetThreshold(isShare ? threshold / 100.0 : threshold);
  silhouettes->SetThresholdMode(isShare ? vtkMoteSilhouettes::SCENE_SIZE : mode);
  parseThickness(settings.thickness, least, most);
  silhouettes->SetThickness(most);
  silhouettes->SetLeastThickness(least / most);
  silhouettes->SetLeastOpacity(settings.opacity);
  silhouettes->SetColor(settings.color.data());
  silhouettes->SetStepInPixels(settings.stepInPixels);
  silhouettes->SetGroupArrayName(settings.groups.c_str());
  silhouettes->SetHulls(!settings.noHulls);
  silhouettes->SetCentered(!settings.onPixels);
}

} // namespace mote::app
