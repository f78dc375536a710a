#include "TypeNames.h"

#include "ColorMaps.h"
#include "base/Text.h"

#include <vtkColor.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPeriodicTable.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <cstdlib>

namespace mote::app
{

namespace
{

vtkPeriodicTable* periodicTable()
{
  static const vtkNew<vtkPeriodicTable> table;
  return table;
}

/// The number of the element with this symbol; 0 for none.
int elementNamed(const std::string& symbol)
{
  const int number = periodicTable()->GetAtomicNumber(symbol);
  // VTK's table knows names and numbers, too.
  return number > 0 && lowerCase(symbol) == lowerCase(periodicTable()->GetSymbol(number)) ? number
                                                                                          : 0;
}

/// Words that stand beside the types.
vtkStringArray* wordsBeside(vtkDataSet* data)
{
  for (const char* name : {"element", "typelabel", "species"})
    if (auto* words = vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray(name)))
      if (words->GetNumberOfValues() == data->GetNumberOfPoints())
        return words;
  return nullptr;
}

/// What a reader notes of words that it does not keep: "1=Cu".
TypeNames notedNames(vtkDataSet* data)
{
  TypeNames names;
  auto* noted = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("type_names"));
  for (vtkIdType i = 0; noted && i < noted->GetNumberOfValues(); ++i)
  {
    const std::string text = noted->GetValue(i);
    const std::size_t sign = text.find('=');
    if (sign != std::string::npos)
      names[std::atoi(text.c_str())] = text.substr(sign + 1);
  }
  return names;
}

/// Whether types are numbers of the periodic table: those of files of the Protein Data Bank.
bool areNumbersOfElements(vtkDataSet* data, const ArrayChoice& types)
{
  return lowerCase(types.name) == "atomic_number" ||
         (lowerCase(types.name) == "atom_type" && data->GetPointData()->HasArray("residue"));
}

} // namespace

TypeNames typeNamesOf(vtkDataSet* data, const ArrayChoice& types)
{
  vtkDataArray* array = arrayOf(data, types);
  if (!array || types.ofCells || !isTypes(data, types))
    return {};
  vtkStringArray* words = wordsBeside(data);
  const bool areElements = areNumbersOfElements(data, types);
  if (!words && !areElements)
    return lowerCase(types.name) == "type" ? notedNames(data) : TypeNames();
  constexpr std::size_t most = 1000;
  TypeNames names;
  double before = std::nan(""); // neighbours are often of one type
  for (vtkIdType i = 0; i < array->GetNumberOfTuples() && names.size() < most; ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (value == before || !std::isfinite(value))
      continue;
    before = value;
    const int type = static_cast<int>(value);
    const auto [entry, isNew] = names.try_emplace(type);
    if (!isNew)
      continue;
    if (!areElements)
      entry->second = words->GetValue(i);
    else if (type > 0 && type <= periodicTable()->GetNumberOfElements())
      entry->second = periodicTable()->GetSymbol(type);
  }
  std::erase_if(names, [](const auto& name) { return name.second.empty(); });
  return names;
}

std::vector<Color> elementColors(const std::vector<int>& types, const TypeNames& names)
{
  const std::vector<Color> others = typeColors(mostTypeColors);
  std::vector<Color> colors;
  std::size_t unknown = 0;
  for (const int type : types)
  {
    const auto name = names.find(type);
    const int element = name == names.end() ? 0 : elementNamed(name->second);
    if (element == 0)
    {
      colors.push_back(others[unknown++ % others.size()]);
      continue;
    }
    const auto rgb = periodicTable()->GetDefaultRGBTuple(static_cast<unsigned short>(element));
    colors.push_back({rgb[0], rgb[1], rgb[2]});
  }
  return unknown < types.size() ? colors : std::vector<Color>();
}

} // namespace mote::app
