#include "LegendTable.h"

#include <vtkColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkScalarsToColors.h>
#include <vtkVariant.h>

#include <cmath>

namespace mote::imaging
{
namespace
{

Color opaque(const double* rgb)
{
  return {rgb[0], rgb[1], rgb[2], 1.0};
}

} // namespace

TickScale scaleOf(vtkScalarsToColors* table, std::string& problem)
{
  const double* range = table->GetRange();
  auto* transfer = vtkColorTransferFunction::SafeDownCast(table);
  TickScale scale;
  scale.low = range[0];
  scale.high = range[1];
  scale.isLogarithmic =
    table->UsingLogScale() || (transfer && transfer->GetScale() == VTK_CTF_LOG10);
  if (!std::isfinite(scale.low) || !std::isfinite(scale.high) || scale.low > scale.high)
    problem = "its range is not an interval of finite numbers";
  else if (scale.isLogarithmic && scale.low <= 0.0)
    problem = "its scale is logarithmic and its range not positive";
  return scale;
}

Color colorOf(vtkScalarsToColors* table, double value)
{
  const unsigned char* rgba = table->MapValue(value);
  return {rgba[0] / 255.0, rgba[1] / 255.0, rgba[2] / 255.0, 1.0};
}

std::vector<Category> categoriesOf(vtkScalarsToColors* table)
{
  std::vector<Category> categories;
  for (vtkIdType i = 0; i < table->GetNumberOfAnnotatedValues(); ++i)
  {
    const std::string text = table->GetAnnotation(i);
    const std::string value = table->GetAnnotatedValue(i).ToString();
    double rgba[4] = {0.0, 0.0, 0.0, 1.0};
    table->GetIndexedColor(i, rgba);
    categories.push_back({text.empty() ? value : text, opaque(rgba)});
  }
  return categories;
}

void addRangeColors(vtkScalarsToColors* table, LegendContent& content)
{
  const auto add = [&](auto* known)
  {
    if (known && known->GetUseBelowRangeColor())
      content.below = opaque(known->GetBelowRangeColor());
    if (known && known->GetUseAboveRangeColor())
      content.above = opaque(known->GetAboveRangeColor());
  };
  add(vtkLookupTable::SafeDownCast(table));
  add(vtkColorTransferFunction::SafeDownCast(table));
}

std::optional<Color> nanColorOf(vtkScalarsToColors* table)
{
  if (auto* lookup = vtkLookupTable::SafeDownCast(table))
    return opaque(lookup->GetNanColor());
  if (auto* transfer = vtkColorTransferFunction::SafeDownCast(table))
    return opaque(transfer->GetNanColor());
  return std::nullopt;
}

} // namespace mote::imaging
