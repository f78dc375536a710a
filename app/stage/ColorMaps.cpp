#include "ColorMaps.h"

#include "ColorMapFile.h"

#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace mote::app
{

namespace
{

/// Colours as 0xrrggbb at even distances, straight lines between them.
struct ControlPoints
{
  const char* name;
  std::vector<std::uint32_t> colors;
};

// viridis, plasma, inferno and magma: S. van der Walt and N. Smith (CC0); cividis: J. Nuñez,
// C. Anderton and R. Renslow, "Optimizing colormaps with consideration for color vision
// deficiency" (2018); turbo: A. Mikhailov (2019, Apache 2); twilight: B. Bechtold (CC0);
// coolwarm: K. Moreland, "Diverging Color Maps for Scientific Visualization" (2009);
// types: M. Okabe and K. Ito, "Color Universal Design" (2008), its black made a light grey.
const std::vector<ControlPoints>& controlPoints()
{
  static const std::vector<ControlPoints> maps = {
    {"viridis", {0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e,
                  0x1f988b, 0x22a884, 0x35b779, 0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725}},
    {"plasma", {0x0d0887, 0x330597, 0x5002a2, 0x6a00a8, 0x8405a7, 0x9c179e, 0xb12a90, 0xc33d80,
                 0xd35171, 0xe16462, 0xed7953, 0xf68f44, 0xfca636, 0xfec029, 0xf9dc24, 0xf0f921}},
    {"inferno", {0x000004, 0x0c0826, 0x240c4f, 0x420a68, 0x5d126e, 0x781c6d, 0x932667, 0xae305c,
                  0xc73e4c, 0xdd513a, 0xed6925, 0xf8850f, 0xfca50a, 0xfac62d, 0xf2e661, 0xfcffa4}},
    {"magma", {0x000004, 0x0b0924, 0x20114b, 0x3b0f70, 0x57157e, 0x721f81, 0x8c2981, 0xa8327d,
                0xc43c75, 0xde4968, 0xf1605d, 0xfa7f5e, 0xfe9f6d, 0xfebf84, 0xfddea0, 0xfcfdbf}},
    {"cividis", {0x00204d, 0x00306f, 0x2a406c, 0x48526b, 0x5e626e, 0x727374, 0x878479, 0x9e9677,
                  0xb6a971, 0xd0be67, 0xead357, 0xffea46}},
    {"gray", {0x1b1b1b, 0x5e5e5e, 0xababab, 0xf7f7f7}},
    {"coolwarm", {0x3b4cc0, 0x5977e3, 0x7b9ff9, 0x9ebeff, 0xc0d4f5, 0xdddcdc, 0xf2cbb7, 0xf7ac8e,
                   0xee8468, 0xd65244, 0xb40426}},
    {"turbo",
      {0x30123b, 0x3b2f80, 0x424bb5, 0x4666dd, 0x4680f6, 0x3e9bfe, 0x2eb4f2, 0x1ecbda, 0x18dec0,
        0x27eea4, 0x46f884, 0x6dfe62, 0x92ff47, 0xb1f936, 0xcbed34, 0xe1dd37, 0xf2c93a, 0xfcb136,
        0xfe962b, 0xf9781e, 0xf05b12, 0xe14109, 0xce2d04, 0xb71d02, 0x9b0f01, 0x7a0403}},
    {"twilight",
      {0xe2d9e2, 0xd7d7dd, 0xc4ced4, 0xacc2cc, 0x95b5c7, 0x81a6c3, 0x7297c1, 0x6887be, 0x6276ba,
        0x5f64b5, 0x5e51ad, 0x5d3da1, 0x592a8f, 0x511b77, 0x45135c, 0x381145, 0x2f1436, 0x3a113a,
        0x4a1342, 0x5f174a, 0x741e4f, 0x872750, 0x983550, 0xa64550, 0xb25652, 0xbb6958, 0xc27c63,
        0xc89073, 0xcca389, 0xd1b6a3, 0xd8c7be, 0xdfd4d6, 0xe2d9e2}},
    {"types", {0x56b4e9, 0xe69f00, 0x009e73, 0xf0e442, 0x0072b2, 0xd55e00, 0xcc79a7, 0xd0d0d0}},
  };
  return maps;
}

Color colorOf(std::uint32_t rgb)
{
  return {((rgb >> 16) & 0xff) / 255.0, ((rgb >> 8) & 0xff) / 255.0, (rgb & 0xff) / 255.0};
}

Color mixed(const Color& from, const Color& to, double blend)
{
  Color color;
  for (std::size_t k = 0; k < color.size(); ++k)
    color[k] = from[k] + (to[k] - from[k]) * blend;
  return color;
}

/// For what has no value.
void setNoColor(vtkLookupTable* table)
{
  table->SetNanColor(0.55, 0.55, 0.55, 1.0);
}

void setColor(vtkLookupTable* table, vtkIdType index, const Color& color)
{
  table->SetTableValue(index, color[0], color[1], color[2], 1.0);
}

/// The map of this name, or of this file.
std::shared_ptr<const ColorMapFile> mapOf(const std::string& name)
{
  const auto& maps = controlPoints();
  const auto found = std::find_if(
    maps.begin(), maps.end(), [&](const ControlPoints& map) { return name == map.name; });
  if (found == maps.end())
    return keptColorMapFile(name);
  auto map = std::make_shared<ColorMapFile>();
  std::transform(
    found->colors.begin(), found->colors.end(), std::back_inserter(map->colors), colorOf);
  return map;
}

} // namespace

const std::vector<std::string>& colorMapNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> list;
    for (const ControlPoints& map : controlPoints())
      list.emplace_back(map.name);
    return list;
  }();
  return names;
}

vtkSmartPointer<vtkLookupTable> makeColorMap(
  const std::string& name, const double range[2], bool logarithmic)
{
  const std::shared_ptr<const ColorMapFile> map = mapOf(name);
  const std::vector<Color>& colors = map->colors;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  setNoColor(table);
  if (map->none)
    table->SetNanColor((*map->none)[0], (*map->none)[1], (*map->none)[2], 1.0);
  constexpr int size = 256;
  table->SetNumberOfTableValues(size);
  if (logarithmic)
    table->SetScaleToLog10();
  table->SetTableRange(range[0], range[1]);
  const std::size_t last = colors.size() - 1;
  for (int i = 0; i < size; ++i)
  {
    const double place = static_cast<double>(i) / (size - 1) * static_cast<double>(last);
    const std::size_t left = std::min(static_cast<std::size_t>(place), last - 1);
    const auto step = static_cast<std::size_t>(i) * colors.size() / size;
    setColor(table, i,
      map->isStepped ? colors[step]
                     : mixed(colors[left], colors[left + 1], place - static_cast<double>(left)));
  }
  return table;
}

void reverse(vtkLookupTable* table)
{
  for (vtkIdType low = 0, high = table->GetNumberOfTableValues() - 1; low < high; ++low, --high)
  {
    double first[4], last[4];
    table->GetTableValue(low, first);
    table->GetTableValue(high, last);
    table->SetTableValue(low, last);
    table->SetTableValue(high, first);
  }
}

bool areAlike(vtkLookupTable* a, vtkLookupTable* b)
{
  const vtkIdType count = a->GetNumberOfTableValues();
  return count == b->GetNumberOfTableValues() &&
         std::equal(a->GetPointer(0), a->GetPointer(0) + 4 * count, b->GetPointer(0)) &&
         std::equal(a->GetTableRange(), a->GetTableRange() + 2, b->GetTableRange()) &&
         std::equal(a->GetNanColor(), a->GetNanColor() + 4, b->GetNanColor()) &&
         a->GetUseBelowRangeColor() == b->GetUseBelowRangeColor() &&
         a->GetUseAboveRangeColor() == b->GetUseAboveRangeColor() &&
         a->GetScale() == b->GetScale() && a->GetVectorMode() == b->GetVectorMode() &&
         a->GetVectorComponent() == b->GetVectorComponent();
}

namespace
{

/// CIELAB, where distances are about as large as differences look.
Color labOf(const Color& color)
{
  Color lab;
  vtkMath::RGBToLab(color.data(), lab.data());
  return lab;
}

double squaredDifference(const Color& a, const Color& b)
{
  return vtkMath::Distance2BetweenPoints(a.data(), b.data());
}

/// Colours that could be a type's: neither so dark that shading hides them, nor so pale that they
/// are taken for white.
std::vector<Color> candidateColors()
{
  constexpr std::uint32_t step = 0x11;
  std::vector<Color> all;
  for (std::uint32_t red = 0; red < 256; red += step)
    for (std::uint32_t green = 0; green < 256; green += step)
      for (std::uint32_t blue = 0; blue < 256; blue += step)
      {
        const Color color = colorOf(red << 16 | green << 8 | blue);
        if (const double lightness = labOf(color)[0]; lightness > 45.0 && lightness < 93.0)
          all.push_back(color);
      }
  return all;
}

/// The colours of the map of types, and then always the one that differs most from all before it,
/// as well as from the usual background and what has no value. C. Glasbey et al., "Colour Displays
/// for Categorical Images" (2007).
std::vector<Color> separatedColors()
{
  std::vector<Color> colors;
  for (const std::uint32_t color : controlPoints().back().colors)
    colors.push_back(colorOf(color));
  const std::vector<Color> candidates = candidateColors();
  std::vector<Color> places;
  std::transform(candidates.begin(), candidates.end(), std::back_inserter(places), labOf);
  std::vector<double> least(candidates.size(), HUGE_VAL); // squared differences from what is taken
  const auto take = [&](const Color& color)
  {
    const Color place = labOf(color);
    for (std::size_t i = 0; i < places.size(); ++i)
      least[i] = std::min(least[i], squaredDifference(place, places[i]));
  };
  take({0.3, 0.32, 0.35});
  take({0.55, 0.55, 0.55});
  std::for_each(colors.begin(), colors.end(), take);
  while (colors.size() < mostTypeColors)
  {
    const auto next = std::max_element(least.begin(), least.end()) - least.begin();
    colors.push_back(candidates[static_cast<std::size_t>(next)]);
    take(colors.back());
  }
  return colors;
}

} // namespace

std::vector<Color> typeColors(std::size_t count)
{
  static const std::vector<Color> all = separatedColors();
  return {all.begin(), all.begin() + static_cast<long>(std::min(count, all.size()))};
}

vtkSmartPointer<vtkLookupTable> makeTypeMap(
  const std::vector<int>& types, const std::vector<Color>& colors)
{
  const auto [least, greatest] = std::minmax_element(types.begin(), types.end());
  const int count = *greatest - *least + 1;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  setNoColor(table);
  table->SetNumberOfTableValues(count);
  table->SetTableRange(*least - 0.5, *greatest + 0.5);
  for (int i = 0; i < count; ++i)
    table->SetTableValue(i, table->GetNanColor());
  for (std::size_t i = 0; i < types.size(); ++i)
    setColor(table, types[i] - *least, colors[i]);
  return table;
}

vtkSmartPointer<vtkLookupTable> makeTypeLegend(
  const std::vector<int>& types, const std::vector<Color>& colors, const TypeNames& names)
{
  std::vector<int> ascending = types;
  std::sort(ascending.begin(), ascending.end());
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  setNoColor(table);
  table->SetNumberOfTableValues(static_cast<vtkIdType>(types.size()));
  table->IndexedLookupOn();
  for (std::size_t i = 0; i < types.size(); ++i)
  {
    const auto place = std::find(types.begin(), types.end(), ascending[i]) - types.begin();
    setColor(table, static_cast<vtkIdType>(i), colors[static_cast<std::size_t>(place)]);
    const auto name = names.find(ascending[i]);
    table->SetAnnotation(
      vtkVariant(ascending[i]), name == names.end() ? std::to_string(ascending[i]) : name->second);
  }
  return table;
}

} // namespace mote::app
