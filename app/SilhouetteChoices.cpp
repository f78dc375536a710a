#include "SilhouetteChoices.h"

#include "Checks.h"
#include "Colors.h"
#include "Text.h"

#include <vtkMoteSilhouettes.h>
#include <vtkNew.h>

#include <CLI/CLI.hpp>

namespace mote::app
{

namespace
{

/// "2" or "1.5%": the number, and whether it is a percentage.
bool parseThreshold(const std::string& text, double& value, bool& isShare)
{
  isShare = !text.empty() && text.back() == '%';
  return parseNumber(isShare ? text.substr(0, text.size() - 1) : text, value) && value >= 0.0;
}

/// "2" or "1:3": widths of the weakest and of the strongest lines.
bool parseThickness(const std::string& text, double& least, double& most)
{
  const std::size_t colon = text.find(':');
  const bool isRange = colon != std::string::npos;
  return parseNumber(text.substr(0, colon), least) &&
         parseNumber(isRange ? text.substr(colon + 1) : text, most) && least >= 0.1 &&
         most >= least && most <= 64.0;
}

std::string checkThickness(std::string& text)
{
  double least, most;
  return parseThickness(text, least, most)
           ? ""
           : "'" + text + "' is neither a width of 0.1 to 64 pixels such as 2 nor a range as 1:3";
}

} // namespace

SilhouetteChoices::SilhouetteChoices()
{
  const vtkNew<vtkMoteSilhouettes> usual;
  thickness = asNumber(usual->GetThickness(), 3);
  leastOpacity = usual->GetLeastOpacity();
  usual->GetColor(color.data());
  stepInPixels = usual->GetStepInPixels();
  hulls = usual->GetHulls();
  onPixels = !usual->GetCentered();
}

void addLineOptions(CLI::App& app, SilhouetteChoices& o, const std::string& prefix)
{
  const auto finish = [&o](CLI::Option* option)
  { option->group("Silhouettes")->each([&o](const std::string&) { o.styled = true; }); };
  finish(app
           .add_option(prefix + "thickness", o.thickness,
             "Width of the lines in pixels, or LEAST:MOST to have it grow with the step")
           ->check(CLI::Validator(checkThickness, "", "thickness"))
           ->capture_default_str()
           ->type_name("W"));
  finish(app
           .add_option(prefix + "opacity", o.leastOpacity,
             "Opacity of the least steps, 0 to 1, that grows with the step: grey levels")
           ->check(isNumber())
           ->check(CLI::Range(0.0, 1.0).description(""))
           ->capture_default_str()
           ->type_name("A"));
  const std::string colorName = prefix + "color";
  finish(app
           .add_option_function<std::string>(
             colorName,
             [&o, colorName](const std::string& text)
             {
               if (!parseColor(text, o.color))
                 throw CLI::ValidationError(
                   colorName, "'" + text + "' is no colour: give a name (white, navy) or #rrggbb");
             },
             "Colour of the lines: a name or #rrggbb. By default nearly black")
           ->type_name("COLOUR"));
  finish(app.add_flag(prefix + "on-pixels", o.onPixels,
    "Draw on the farther pixels alone, crisply, and not about the border itself"));
  finish(app
           .add_option(prefix + "step-pixels", o.stepInPixels,
             "No step is drawn that is less than the width of so many pixels at its distance")
           ->check(isNumber())
           ->check(CLI::NonNegativeNumber.description(""))
           ->capture_default_str()
           ->type_name("N"));
  finish(app
           .add_option(prefix + "groups", o.groups,
             "Lines also between neighbours with different values of this array, such as type; or "
             "between each 'particle' and the next, or each 'object' (file)")
           ->type_name("NAME"));
  finish(app.add_flag("!" + prefix + "no-hulls", o.hulls, "No lines against the background"));
}

void addSilhouetteOptions(CLI::App& app, SilhouetteChoices& o)
{
  const auto check = [](const std::string& text)
  {
    const bool isWord = text == "off" || text == "true";
    return isWord ? std::string() : checkThreshold(text, "off, a number of radii such as 4");
  };
  app
    .add_flag("--silhouettes", o.threshold,
      "Lines where depth jumps, around all that stands before other things: by more than 10 radii "
      "of a typical particle, so many as in --silhouettes=4, or with % a share of the scene's size")
    ->check(CLI::Validator(check, "", "threshold"))
    ->group("Silhouettes");
  addLineOptions(app, o, "--silhouette-");
}

std::string checkThreshold(const std::string& text, const std::string& unit)
{
  double value;
  bool isShare;
  return parseThreshold(text, value, isShare)
           ? ""
           : "'" + text + "' is none of " + unit + " and a percentage such as 1%";
}

void choose(const SilhouetteChoices& choices, int mode, vtkMoteSilhouettes* silhouettes)
{
  double threshold, least, most;
  bool isShare;
  // Whoever says how lines look wants some.
  silhouettes->SetEnabled(choices.threshold.empty() ? choices.styled : choices.threshold != "off");
  if (parseThreshold(choices.threshold, threshold, isShare))
  {
    silhouettes->SetThreshold(isShare ? threshold / 100.0 : threshold);
    silhouettes->SetThresholdMode(isShare ? vtkMoteSilhouettes::SCENE_SIZE : mode);
  }
  parseThickness(choices.thickness, least, most);
  silhouettes->SetThickness(most);
  silhouettes->SetLeastThickness(least / most);
  silhouettes->SetLeastOpacity(choices.leastOpacity);
  silhouettes->SetColor(choices.color.data());
  silhouettes->SetStepInPixels(choices.stepInPixels);
  silhouettes->SetGroupArrayName(choices.groups.c_str());
  silhouettes->SetHulls(choices.hulls);
  silhouettes->SetCentered(!choices.onPixels);
}

} // namespace mote::app
