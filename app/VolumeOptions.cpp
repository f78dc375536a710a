#include "VolumeOptions.h"

#include "Checks.h"
#include "Colors.h"
#include "Text.h"

#include <vtkMoteVolumeMapper.h>

#include <CLI/CLI.hpp>

#include <cmath>

namespace mote::app
{

OpacityPoint parseOpacityPoint(const std::string& text)
{
  const std::size_t sign = text.find('=');
  OpacityPoint point;
  std::string value = text.substr(0, sign);
  if (!value.empty() && value.back() == '%')
  {
    point.isShare = true;
    value.pop_back();
  }
  if (sign == std::string::npos || !parseNumber(value, point.value) ||
      !parseNumber(text.substr(sign + 1), point.opacity))
    throw "'" + text + "' is not of the form VALUE=OPACITY, such as 12.5=0.3 or 40%=0.3";
  if (point.isShare)
    point.value /= 100.0;
  if (!(point.opacity >= 0.0 && point.opacity <= 1.0))
    throw "opacities go from 0 to 1, unlike that of " + text;
  return point;
}

namespace
{

void parseOpacity(const std::vector<std::string>& entries, VolumeOptions& o)
{
  for (const std::string& entry : entries)
  {
    try
    {
      o.opacity.push_back(parseOpacityPoint(entry));
    }
    catch (const std::string& sentence)
    {
      throw CLI::ValidationError("--opacity", sentence);
    }
  }
}

/// A finite number above zero.
CLI::Validator above()
{
  return {[](std::string& text) -> std::string
    {
      double value = 0.0;
      return parseNumber(text, value) && value > 0.0 ? ""
                                                     : "must be a number above zero, not " + text;
    },
    "", "above"};
}

CLI::Validator oneOf(const std::vector<std::string>& names)
{
  return CLI::IsMember(names).description("");
}

constexpr const char* group = "Volume";

void addAppearanceOptions(CLI::App& app, VolumeOptions& o)
{
  app
    .add_option("--cells", o.cells,
      "How cells with a volume are shown: as a 'volume' or by their 'surface'. By default as a "
      "volume, where an array can say how it looks")
    ->check(oneOf({"auto", "volume", "surface"}))
    ->type_name("KIND")
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--opacity", [&o](const std::vector<std::string>& entries) { parseOpacity(entries, o); },
      "Opacity at values of the array that colours, linear between them: 20=0,50=0.4; a value with "
      "% is a share of the colours' range. By default 0%=0.5,25%=0.08,50%=0.02,75%=0.08,100%=0.5")
    ->delimiter(',')
    ->type_name("VALUE=OPACITY,...")
    ->group(group);
  app
    .add_option("--opacity-unit", o.opacityUnit,
      "Length that opacities are of, in the data's units: twice as far hides twice over. By "
      "default a tenth of the diagonal of all")
    ->check(above())
    ->type_name("LENGTH")
    ->group(group);
  app
    .add_option("--iso", o.isoValues,
      "Opaque surface where the array that colours has this value; several with commas")
    ->delimiter(',')
    ->check(isNumber())
    ->type_name("VALUE,...")
    ->group(group);
  app
    .add_flag_function(
      "--no-cloud", [&o](std::int64_t) { o.cloud = false; }, "Nothing but the surfaces of --iso")
    ->group(group);
  app.add_flag("--lit", o.lit, "Light volumes by their gradient; surfaces are lit in any case")
    ->group(group);
  app
    .add_option_function<std::string>(
      "--nan-color",
      [&o](const std::string& name)
      {
        Color color;
        if (!parseColor(name, color))
          throw CLI::ValidationError(
            "--nan-color", "'" + name + "' is no colour: give a name (white, navy) or #rrggbb");
        o.nanColor = name;
      },
      "Colour of cells with a value that is not a number. By default they are left out")
    ->type_name("COLOUR")
    ->group(group);
}

void addTracingOptions(CLI::App& app, VolumeOptions& o)
{
  app
    .add_option("--integrator", o.integrator,
      "How rays add up a volume: " + joined(vtkMoteVolumeMapper::GetIntegratorNames(), ", ") +
        ". By default trilinear")
    ->check(oneOf(vtkMoteVolumeMapper::GetIntegratorNames()))
    ->type_name("NAME")
    ->group(group);
  app
    .add_option("--sample-distance", o.sampleDistance,
      "Distance of samples along a ray. By default half a mean cell")
    ->check(above())
    ->type_name("LENGTH")
    ->group(group);
  app
    .add_option("--tolerance", o.tolerance,
      "Error of a colour, from 0 to 1, that cell-by-cell may make. By default 0.001")
    ->check(above())
    ->type_name("ERROR")
    ->group(group);
  app
    .add_option("--cloud-tolerance", o.cloudTolerance,
      "Error of a colour, from 0 to 1, where pixels of a volume are interpolated rather than "
      "traced. By default 0: all are traced")
    ->check(isNumber())
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("ERROR")
    ->group(group);
  app
    .add_option("--cell-structure", o.structure,
      "What finds the cells: " + joined(vtkMoteVolumeMapper::GetStructureNames(), ", "))
    ->check(oneOf(vtkMoteVolumeMapper::GetStructureNames()))
    ->type_name("NAME")
    ->group(group);
}

} // namespace

void addVolumeOptions(CLI::App& app, VolumeOptions& o)
{
  addAppearanceOptions(app, o);
  addTracingOptions(app, o);
}

} // namespace mote::app
