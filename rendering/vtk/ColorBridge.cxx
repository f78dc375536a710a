#include "ColorBridge.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkScalarsToColors.h"

#include <cmath>

namespace mote
{

namespace
{

Vec4f rgba(const double* c, double alpha)
{
  return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
    static_cast<float>(alpha)};
}

void copyTable(vtkLookupTable* from, ColorMap& map)
{
  map.interpolation = ColorMap::Interpolation::Nearest;
  map.table.resize(
    static_cast<std::size_t>(std::max<vtkIdType>(1, from->GetNumberOfTableValues())));
  for (std::size_t i = 0; i < map.table.size(); ++i)
  {
    const double* c = from->GetTableValue(static_cast<vtkIdType>(i));
    map.table[i] = rgba(c, c[3]);
  }
  map.useBelow = from->GetUseBelowRangeColor();
  map.useAbove = from->GetUseAboveRangeColor();
  map.below = rgba(from->GetBelowRangeColor(), from->GetBelowRangeColor()[3]);
  map.above = rgba(from->GetAboveRangeColor(), from->GetAboveRangeColor()[3]);
  map.nan = rgba(from->GetNanColor(), from->GetNanColor()[3]);
}

void sampleFunction(vtkScalarsToColors* from, ColorMap& map)
{
  // Steps are kept as steps, one entry each: between equal parts there is nothing to blend.
  auto* discretizable = vtkDiscretizableColorTransferFunction::SafeDownCast(from);
  const bool steps = discretizable && discretizable->GetDiscretize();
  map.interpolation = steps ? ColorMap::Interpolation::Nearest : ColorMap::Interpolation::Linear;
  map.table.resize(steps ? static_cast<std::size_t>(discretizable->GetNumberOfValues()) : 4096);
  const auto n = static_cast<double>(map.table.size());
  for (std::size_t i = 0; i < map.table.size(); ++i)
  {
    const double share = steps ? (i + 0.5) / n : i / (n - 1.0);
    double value = map.lower + share * (map.upper - map.lower);
    if (map.logarithmic)
      value = std::pow(10.0, value);
    double c[3];
    from->GetColor(value, c);
    map.table[i] = rgba(c, from->GetOpacity(value));
  }
  if (auto* function = vtkColorTransferFunction::SafeDownCast(from))
  {
    map.useBelow = function->GetUseBelowRangeColor();
    map.useAbove = function->GetUseAboveRangeColor();
    map.below = rgba(function->GetBelowRangeColor(), 1.0);
    map.above = rgba(function->GetAboveRangeColor(), 1.0);
    map.nan = rgba(function->GetNanColor(), function->GetNanOpacity());
    if (!function->GetClamping() && !steps)
    {
      // Outside its range such a function is black.
      const Vec4f black(0.0f, 0.0f, 0.0f, 1.0f);
      map.below = map.useBelow ? map.below : black;
      map.above = map.useAbove ? map.above : black;
      map.useBelow = map.useAbove = true;
    }
  }
}

} // namespace

bool toColorMap(vtkScalarsToColors* colors, ColorMap& map)
{
  if (colors->GetIndexedLookup())
    return false;
  colors->Build();
  const double* range = colors->GetRange();
  map = ColorMap{};
  map.logarithmic = colors->UsingLogScale();
  if (map.logarithmic && !(range[0] > 0.0 && range[1] > 0.0))
    return false;
  map.lower = map.logarithmic ? std::log10(range[0]) : range[0];
  map.upper = map.logarithmic ? std::log10(range[1]) : range[1];
  if (auto* table = vtkLookupTable::SafeDownCast(colors))
    copyTable(table, map);
  else
    sampleFunction(colors, map);
  if (!(map.upper > map.lower))
  {
    // VTK gives the one value of such a range the first entry, and what is above it the last.
    map.table = {map.table.front(), map.table.front(), map.table.back()};
    map.interpolation = ColorMap::Interpolation::Nearest;
  }
  return true;
}

} // namespace mote
