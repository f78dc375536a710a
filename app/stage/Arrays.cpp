#include "Arrays.h"

#include "Calculated.h"
#include "base/Failure.h"
#include "base/Text.h"

#include <vtkArrayCalculator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkMoteParticleMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace mote::app
{

namespace
{

bool isAnyOf(const std::string& name, std::initializer_list<const char*> names)
{
  const std::string lower = lowerCase(name);
  return std::any_of(names.begin(), names.end(), [&](const char* n) { return lower == n; });
}

bool namesTypes(const std::string& name)
{
  return isAnyOf(name, {"type", "types", "atom_type", "atom_types", "particletype", "species",
                         "element", "atomic_number", "kind", "group", "phase", "material"});
}

/// Arrays that say which particle it is and where, not what happens to it.
bool isBookkeeping(const std::string& name)
{
  return vtkMoteParticleMapper::GetRadiusFactor(name.c_str()) > 0.0 ||
         isAnyOf(
           name, {"id", "ids", "particleids", "globalids", "globalpointids", "vtkoriginalpointids",
                   "vtkoriginalcellids", "vtkghosttype", "mol", "molecule", "proc", "map_shift",
                   "n_neighb", "model", "ishetatm", "procp1", "ix", "iy", "iz", "image", "x", "y",
                   "z", "xu", "yu", "zu", "xs", "ys", "zs", "position", "positions", "coordinates",
                   "points", "pos", "mass", "normals", "tcoords", "residue", "chain", "is_hetatm",
                   "atom_type_strings", "secondary_structures", "secondary_structures_begin",
                   "secondary_structures_end", "rgb_colors", "confidence", "groupids", "objectids",
                   "texcoord_0", "texcoord_1", "tangent", "joints_0", "weights_0"});
}

vtkDataSetAttributes* attributesOf(vtkDataSet* data, bool ofCells)
{
  return ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData())
                 : static_cast<vtkDataSetAttributes*>(data->GetPointData());
}

int rank(vtkDataSet* data, const ArrayChoice& choice)
{
  vtkDataArray* array = arrayOf(data, choice);
  double range[2] = {0.0, 0.0};
  if (isColors(array))
    return 5;
  if (!finiteRange(array, choice.component, range) || range[0] == range[1])
    return 1;
  if (namesTypes(choice.name))
    return 3;
  const bool whole = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  if (whole)
    return 4;
  const int components = array->GetNumberOfComponents();
  return components == 1 ? 10 : components <= 3 ? 8 : 6;
}

int componentOf(vtkDataArray* array, const std::string& text)
{
  if (lowerCase(text) == "magnitude" || lowerCase(text) == "mag")
    return ArrayChoice::magnitude;
  for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    if (text == componentName(array, i))
      return i;
  double number = -1.0;
  if (parseNumber(text, number) && number >= 0.0 && number < array->GetNumberOfComponents() &&
      number == std::floor(number))
    return static_cast<int>(number);
  std::vector<std::string> known = {"magnitude"};
  for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    known.push_back(componentName(array, i));
  throw Failure(
    "array " + nameOf(array) + " has no component " + text + "; there are " + joined(known, ", "));
}

template <class Visit>
void forEachValue(vtkDataArray* array, int component, const Visit& visit)
{
  const vtkIdType tuples = array->GetNumberOfTuples();
  for (vtkIdType i = 0; i < tuples; ++i)
    visit(valueOf(array, component, i));
}

ArrayChoice findAmong(
  vtkDataSet* data, const std::string& text, std::initializer_list<bool> cellsOrPoints)
{
  const auto choiceFor = [&](const std::string& name, const std::string& component)
  {
    for (const bool ofCells : cellsOrPoints)
      if (vtkDataArray* array = attributesOf(data, ofCells)->GetArray(name.c_str()))
      {
        const bool vector = array->GetNumberOfComponents() > 1;
        const int which = !component.empty() ? componentOf(array, component)
                          : vector           ? ArrayChoice::magnitude
                                             : 0;
        return ArrayChoice{name, which, ofCells};
      }
    return ArrayChoice{};
  };
  if (const ArrayChoice whole = choiceFor(text, ""))
    return whole;
  // What a file calls "vx" may be a component of "v" here.
  for (const bool ofCells : cellsOrPoints)
    for (int i = 0; i < attributesOf(data, ofCells)->GetNumberOfArrays(); ++i)
      if (vtkDataArray* array = attributesOf(data, ofCells)->GetArray(i); !nameOf(array).empty())
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
          if (array->GetComponentName(c) && text == array->GetComponentName(c))
            return {nameOf(array), c, ofCells};
  const std::size_t colon = text.rfind(':');
  return colon == std::string::npos ? ArrayChoice{}
                                    : choiceFor(text.substr(0, colon), text.substr(colon + 1));
}

} // namespace

ArrayChoice findArray(vtkDataSet* data, const std::string& text)
{
  const auto starts = [&](const char* word) { return text.starts_with(word); };
  const std::size_t prefix = starts("point:") ? 6 : starts("cell:") ? 5 : 0;
  if (prefix > 0)
    if (const ArrayChoice found = findAmong(data, text.substr(prefix), {prefix == 5}))
      return found;
  return findAmong(data, text, {false, true});
}

std::string asText(vtkDataSet* data, const ArrayChoice& choice)
{
  if (!choice)
    return "none";
  vtkDataArray* array = arrayOf(data, choice);
  const bool both = arrayOf(data, {choice.name, 0, true}) && arrayOf(data, {choice.name, 0, false});
  std::string text = (both ? choice.ofCells ? "cell:" : "point:" : "") + choice.name;
  if (array && array->GetNumberOfComponents() > 1)
    text += choice.component == ArrayChoice::magnitude ? ":magnitude"
                                                       : ":" + std::to_string(choice.component);
  return text;
}

void addCoordinate(vtkDataSet* data, const std::string& text)
{
  const int axis = text == "x" ? 0 : text == "y" ? 1 : text == "z" ? 2 : -1;
  if (axis < 0 || data->GetNumberOfPoints() == 0 || findArray(data, text))
    return;
  auto* points = vtkPointSet::SafeDownCast(data);
  vtkNew<vtkArrayCalculator> calculator;
  calculator->SetInputData(data);
  calculator->AddCoordinateScalarVariable(text.c_str(), axis);
  calculator->SetFunction(text.c_str());
  calculator->SetResultArrayName(text.c_str());
  calculator->SetResultArrayType(
    points && points->GetPoints()->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  calculator->Update();
  data->GetPointData()->AddArray(
    vtkDataSet::SafeDownCast(calculator->GetOutput())->GetPointData()->GetArray(text.c_str()));
}

namespace
{

/// Arrays of numbers, as a whole: of vectors their magnitudes. Points and cells may both hold an
/// array of one name: the points' one is smooth.
std::vector<ArrayChoice> namedArrays(vtkDataSet* data, bool areBookkeeping)
{
  // What a scanner says of its points, in a pair; by itself intensity is what there is to see.
  const bool isScanned = data->GetPointData()->HasArray("confidence");
  std::vector<ArrayChoice> choices;
  for (const bool ofCells : {false, true})
  {
    vtkDataSetAttributes* attributes = attributesOf(data, ofCells);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      const std::string name = nameOf(array);
      const bool isOfNote = !isBookkeeping(name) && !(isScanned && name == "intensity");
      if (name.empty() || name == whereArray || isOfNote == areBookkeeping ||
          (ofCells && data->GetPointData()->GetArray(name.c_str())))
        continue;
      const bool vector = array->GetNumberOfComponents() > 1;
      choices.push_back({name, vector ? ArrayChoice::magnitude : 0, ofCells});
    }
  }
  return choices;
}

} // namespace

std::vector<ArrayChoice> rankedArrays(vtkDataSet* data)
{
  std::vector<std::pair<int, ArrayChoice>> ranked;
  for (const ArrayChoice& choice : namedArrays(data, false))
    ranked.emplace_back(rank(data, choice), choice);
  std::stable_sort(
    ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<ArrayChoice> choices;
  for (const auto& entry : ranked)
    choices.push_back(entry.second);
  return choices;
}

std::vector<ArrayChoice> otherArrays(vtkDataSet* data)
{
  return namedArrays(data, true);
}

std::string nameOf(vtkAbstractArray* array)
{
  const char* name = array ? array->GetName() : nullptr;
  return name ? name : "";
}

vtkDataArray* arrayOf(vtkDataSet* data, const ArrayChoice& choice)
{
  return choice ? attributesOf(data, choice.ofCells)->GetArray(choice.name.c_str()) : nullptr;
}

std::string componentName(vtkAbstractArray* array, int component)
{
  if (const char* own = array->GetComponentName(component))
    return own;
  return array->GetNumberOfComponents() == 3 ? std::string(1, "xyz"[component])
                                             : std::to_string(component);
}

std::string describe(vtkDataSet* data, const ArrayChoice& choice)
{
  vtkDataArray* array = arrayOf(data, choice);
  if (!array || array->GetNumberOfComponents() == 1 || isColors(array))
    return choice.name;
  if (choice.component == ArrayChoice::magnitude)
    return choice.name + " magnitude";
  return choice.name + ": " + componentName(array, choice.component);
}

namespace
{

std::string unitOf(vtkAbstractArray* array)
{
  if (!array || !array->HasInformation())
    return {};
  const char* unit = array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  return unit ? unit : "";
}

} // namespace

std::string unitOf(vtkDataSet* data, const std::string& array)
{
  vtkAbstractArray* ofPoints = data->GetPointData()->GetAbstractArray(array.c_str());
  return unitOf(ofPoints ? ofPoints : data->GetCellData()->GetAbstractArray(array.c_str()));
}

std::string lengthUnitOf(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  return points && points->GetPoints() ? unitOf(points->GetPoints()->GetData()) : "";
}

std::string listArrays(vtkDataSet* data)
{
  std::vector<std::string> names;
  for (const bool ofCells : {false, true})
    for (int i = 0; i < attributesOf(data, ofCells)->GetNumberOfArrays(); ++i)
      if (const std::string name = nameOf(attributesOf(data, ofCells)->GetArray(i)); !name.empty())
        if (name != whereArray)
          names.push_back(name);
  return joined(names, ", ");
}

bool isText(vtkDataSet* data, const std::string& name)
{
  for (const bool ofCells : {false, true})
  {
    vtkDataSetAttributes* attributes = attributesOf(data, ofCells);
    if (attributes->HasArray(name.c_str()) && !attributes->GetArray(name.c_str()))
      return true;
  }
  return false;
}

double valueOf(vtkDataArray* array, int component, vtkIdType tuple)
{
  const int components = array->GetNumberOfComponents();
  if (component != ArrayChoice::magnitude || components == 1)
    return array->GetComponent(tuple, std::max(component, 0));
  double square = 0.0;
  for (int c = 0; c < components; ++c)
    square += array->GetComponent(tuple, c) * array->GetComponent(tuple, c);
  return std::sqrt(square);
}

bool finiteRange(vtkDataArray* array, int component, double range[2])
{
  if (!array || array->GetNumberOfTuples() == 0)
    return false;
  const bool single = array->GetNumberOfComponents() == 1;
  array->GetFiniteRange(range, single ? 0 : component);
  return range[0] <= range[1];
}

bool percentileRange(
  vtkDataArray* array, int component, const std::vector<double>& percentiles, double range[2])
{
  if (!finiteRange(array, component, range))
    return false;
  constexpr vtkIdType mostLookedAt = 200'000;
  const vtkIdType count = array->GetNumberOfTuples();
  const vtkIdType step = (count + mostLookedAt - 1) / mostLookedAt;
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count / step + 1));
  for (vtkIdType i = 0; i < count; i += step)
    if (const double value = valueOf(array, component, i); std::isfinite(value))
      values.push_back(value);
  if (values.empty())
    return true;
  double ends[2];
  for (std::size_t k = 0; k < 2; ++k)
  {
    const double last = static_cast<double>(values.size() - 1);
    const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(std::lround(0.01 * percentiles[k] * last));
    std::nth_element(values.begin(), at, values.end());
    ends[k] = percentiles[k] <= 0.0 || percentiles[k] >= 100.0 ? range[k] : *at;
  }
  if (ends[0] < ends[1])
    std::copy_n(ends, 2, range);
  return true;
}

std::int64_t countInRange(vtkDataArray* array, int component, const double range[2])
{
  std::int64_t count = 0;
  forEachValue(
    array, component, [&](double value) { count += value >= range[0] && value <= range[1]; });
  return count;
}

double leastPositive(vtkDataArray* array, int component)
{
  double least = HUGE_VAL;
  forEachValue(array, component,
    [&](double value)
    {
      if (value > 0.0 && value < least)
        least = value;
    });
  return std::isfinite(least) ? least : 0.0;
}

bool isTypes(vtkDataSet* data, const ArrayChoice& choice)
{
  vtkDataArray* array = arrayOf(data, choice);
  double range[2];
  return array && array->GetNumberOfComponents() == 1 && namesTypes(choice.name) &&
         finiteRange(array, 0, range) && range[0] == std::floor(range[0]) &&
         range[1] == std::floor(range[1]);
}

bool collectTypes(
  vtkDataArray* array, int component, std::size_t limit, int span, std::vector<int>& types)
{
  double range[2];
  if (!finiteRange(array, component, range) || range[0] < -1e6 || range[1] > 1e6)
    return false;
  std::vector<int> added;
  bool possible = true;
  double previous = std::nan("");
  const auto isIn = [](const std::vector<int>& list, int type)
  { return std::find(list.begin(), list.end(), type) != list.end(); };
  forEachValue(array, component,
    [&](double value)
    {
      if (!possible || value == previous || !std::isfinite(value))
        return;
      previous = value;
      const int type = static_cast<int>(value);
      possible = type == value;
      if (!possible || isIn(types, type) || isIn(added, type))
        return;
      possible = types.size() + added.size() < limit;
      added.push_back(type);
    });
  if (!possible)
    return false;
  std::sort(added.begin(), added.end());
  types.insert(types.end(), added.begin(), added.end());
  const auto [least, greatest] = std::minmax_element(types.begin(), types.end());
  return *greatest - *least < span;
}

bool isColors(vtkDataArray* array)
{
  return array && array->GetDataType() == VTK_UNSIGNED_CHAR && array->GetNumberOfComponents() >= 3;
}

} // namespace mote::app
