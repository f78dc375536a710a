#include "ArrayColors.h"

#include "Names.h"
#include "TransferBridge.h"

#include "kernels/scene/Scene.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSet.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
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

/// The kernels' form of a VTK lookup table or transfer function. vtkLookupTable is taken entry by
/// entry; functions are sampled finely enough (4096 entries) for 8-bit colours, so that only steps
/// within them are blurred, to a 4096th of the range. False where a table over one range cannot say
/// it: indexed lookup, logarithms over a range that is not positive.
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

/// Why there is no array to colour by, where one was asked for by name; else empty.
std::string whyNoArray(vtkMapper* mapper, vtkDataSet* data, bool cellsToo)
{
  const char* name = mapper->GetArrayName();
  const bool named = mapper->GetScalarVisibility() &&
                     mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME && name && *name &&
                     mapper->GetScalarMode() >= VTK_SCALAR_MODE_USE_POINT_FIELD_DATA;
  if (!named || !data || data->GetNumberOfPoints() == 0)
    return {};
  const std::string quoted = '"' + std::string(name) + '"';
  const bool cells = cellsToo && mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  const std::string kind = cells ? "cell" : "point";
  vtkFieldData* arrays = cells ? static_cast<vtkFieldData*>(data->GetCellData())
                               : static_cast<vtkFieldData*>(data->GetPointData());
  if (arrays->HasArray(name))
    return "The " + kind + " array " + quoted + " cannot colour " +
           (cellsToo ? "triangles" : "particles") + ": it is text, or was asked for as something " +
           "else than " + kind + " data.";
  return "There is no " + kind + " array " + quoted +
         " to colour by; there are: " + arrayNames(arrays) + ".";
}

} // namespace

vtkDataArray* ArrayColors::arrayOf(vtkMapper* mapper, vtkDataSet* data, bool* ofCells)
{
  if (ofCells)
    *ofCells = false;
  if (!data || !mapper->GetScalarVisibility())
    return nullptr;
  int cellFlag = 0;
  auto* array =
    vtkDataArray::SafeDownCast(vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag));
  if (!array)
    return nullptr;
  if (cellFlag != 1 && array->GetNumberOfTuples() == data->GetNumberOfPoints())
    return array;
  if (!ofCells || cellFlag == 0 || array->GetNumberOfTuples() != data->GetNumberOfCells())
    return nullptr;
  *ofCells = true;
  return array;
}

int ArrayColors::componentOf(vtkMapper* mapper, vtkDataArray* array)
{
  vtkScalarsToColors* colors = mapper->GetLookupTable(); // creates the default one
  if (array->GetNumberOfComponents() == 1)
    return 0;
  if (colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
    return ArrayView::magnitude;
  const int chosen = mapper->GetArrayComponent();
  return std::clamp(
    chosen > 0 ? chosen : colors->GetVectorComponent(), 0, array->GetNumberOfComponents() - 1);
}

double ArrayColors::valueOf(vtkMapper* mapper, vtkDataArray* array, vtkIdType id)
{
  if (!array || id < 0 || id >= array->GetNumberOfTuples())
    return vtkMath::Nan();
  const int component = componentOf(mapper, array);
  if (component >= 0)
    return array->GetComponent(id, component);
  return vtkMath::Norm(array->GetTuple(id), array->GetNumberOfComponents());
}

std::string ArrayColors::describe(
  vtkMapper* mapper, vtkDataSet* data, SurfaceColoring& coloring, bool* ofCells)
{
  vtkDataArray* array = arrayOf(mapper, data, ofCells);
  if (!array)
    return whyNoArray(mapper, data, ofCells != nullptr);
  vtkScalarsToColors* colors = mapper->GetLookupTable();
  if (!mapper->GetUseLookupTableScalarRange())
    colors->SetRange(mapper->GetScalarRange());
  const int mode = mapper->GetColorMode();
  const bool bytes = vtkUnsignedCharArray::SafeDownCast(array) != nullptr;
  const bool direct =
    mode == VTK_COLOR_MODE_DIRECT_SCALARS || (mode == VTK_COLOR_MODE_DEFAULT && bytes);
  const bool vectorColors =
    array->GetNumberOfComponents() > 1 && colors->GetVectorMode() == vtkScalarsToColors::RGBCOLORS;
  InputKey key;
  addArray(key, array);
  if (key != valuesKey_)
  {
    values_ = DataArrayView(array);
    valuesKey_ = key;
  }
  if (direct && bytes)
  {
    coloring.direct = values_.view;
    return {};
  }
  const int component = vectorColors ? -1 : componentOf(mapper, array);
  if (!direct && !vectorColors && toColorMap(colors, coloring.map))
  {
    coloring.values = values_.view;
    coloring.component = component;
    return {};
  }
  // What only VTK itself can map: annotated values, floating point colours, vectors as colours.
  key.insert(key.end(), {double(colors->GetMTime()), double(mode), double(component)});
  if (key != mappedKey_)
  {
    mapped_.TakeReference(colors->MapScalars(array, mode, component));
    mappedKey_ = key;
  }
  coloring.direct = DataArrayView(mapped_).view;
  return {};
}

const TransferFunction& ArrayColors::describe(vtkVolumeProperty* property)
{
  const InputKey key = {
    double(reinterpret_cast<std::uintptr_t>(property)), double(property->GetMTime())};
  if (key != transferKey_)
  {
    transfer_ = transferOf(property);
    transferKey_ = key;
  }
  return transfer_;
}

} // namespace mote
