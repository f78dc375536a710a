#include "SilhouetteChoices.h"

#include "Checks.h"
#include "Colors.h"
#include "Text.h"

#include <vtkMoteSilhouettes.h>

#include <CLI/CLI.hpp>

namespace mote::app
{

namespace
{

/// Why the text behind --silhouettes= is none; empty where it is.
std::string checkThreshold(const std::string& text)
{
  double radii = 0.0;
  if (text == "off" || text == "true" || (parseNumber(text, radii) && radii >= 0.0))
    return {};
  return "'" + text +
         "' is neither off nor a number of radii of at least 0, such as in --silhouettes=4";
}

CLI::Validator checked()
{
  return {[](std::string& text) { return checkThreshold(text); }, "", "threshold"};
}

} // namespace

void addSilhouetteOptions(CLI::App& app, SilhouetteChoices& o)
{
  const std::string group = "Silhouettes";
  app
    .add_flag("--silhouettes", o.threshold,
      "Lines where depth jumps, around all that stands before other things: by more than 10 radii "
      "of a typical particle, or so many as in --silhouettes=4")
    ->check(checked())
    ->group(group);
  app
    .add_option(
      "--silhouette-thickness", o.thickness, "Width of the lines in pixels. By default 1.5")
    ->check(isNumber())
    ->check(CLI::Range(0.1, 64.0).description(""))
    ->type_name("PIXELS")
    ->group(group);
  app
    .add_option_function<std::string>(
      "--silhouette-color",
      [&o](const std::string& name)
      {
        Color color;
        if (!parseColor(name, color))
          throw CLI::ValidationError("--silhouette-color",
            "'" + name + "' is no colour: give a name (white, navy) or #rrggbb");
        o.color = color;
      },
      "Colour of the lines: a name or #rrggbb. By default nearly black")
    ->type_name("COLOUR")
    ->group(group);
  app
    .add_option("--silhouette-groups", o.groups,
      "Lines also between neighbours with different values of this array, such as type; or between "
      "each 'particle' and the next, or each 'object' (file)")
    ->type_name("NAME")
    ->group(group);
}

Silhouettes::Silhouettes(const SilhouetteChoices& options)
{
  double radii = 0.0;
  // Whoever says how lines look wants some.
  const bool styled = options.thickness > 0.0 || options.color || !options.groups.empty();
  settings_->SetEnabled(options.threshold.empty() ? styled : options.threshold != "off");
  if (parseNumber(options.threshold, radii))
    settings_->SetThreshold(radii);
  if (options.thickness > 0.0)
    settings_->SetThickness(options.thickness);
  if (options.color)
    settings_->SetColor(options.color->data());
  settings_->SetGroupArrayName(options.groups.c_str());
}

Silhouettes::~Silhouettes() = default;

void Silhouettes::toggle()
{
  settings_->SetEnabled(!this->isOn());
}

bool Silhouettes::isOn() const
{
  return settings_->GetEnabled();
}

} // namespace mote::app
