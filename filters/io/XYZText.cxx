#include "XYZText.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <map>
#include <set>

namespace mote
{
namespace
{

using Column = std::function<void(std::string& text, vtkIdType point)>;

template <typename Number>
void appendNumber(std::string& text, Number number)
{
  std::array<char, 40> room{};
  char* end = room.data();
  if constexpr (sizeof(Number) == 1)
    end = std::to_chars(end, end + room.size(), static_cast<int>(number)).ptr;
  else
    end = std::to_chars(end, end + room.size(), number).ptr;
  text.append(room.data(), end);
  text.push_back(' ');
}

/// What an array has of a point: quick where its values lie one after the other.
Column numbersOf(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  if (array->HasStandardMemoryLayout())
    switch (array->GetDataType())
    {
      vtkTemplateMacro(return (
        [values = static_cast<const VTK_TT*>(array->GetVoidPointer(0)), components](
          std::string& text, vtkIdType point)
        {
          for (int i = 0; i < components; ++i)
            appendNumber(text, values[point * components + i]);
        }));
    default: // of bits
      break;
    }
  return [array, components](std::string& text, vtkIdType point)
  {
    for (int i = 0; i < components; ++i)
      appendNumber(text, array->GetComponent(point, i));
  };
}

/// A word that a column can hold: without blanks, and not empty.
std::string asWord(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c <= ' ' || c == 127; }, '_');
  return text.empty() ? "X" : text;
}

Column wordsOf(vtkStringArray* array)
{
  return [array](std::string& text, vtkIdType point)
  {
    text += asWord(array->GetValue(point));
    text.push_back(' ');
  };
}

/// Of types the names that the field array "type_names" has, as in "1=Cu"; none where that is not
/// there, or lacks one.
std::map<int, std::string> namesOfTypes(vtkPointSet* data, vtkDataArray* types)
{
  std::map<int, std::string> names;
  auto* pairs = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("type_names"));
  for (vtkIdType i = 0; pairs && i < pairs->GetNumberOfValues(); ++i)
  {
    const std::string& pair = pairs->GetValue(i);
    const std::size_t sign = pair.find('=');
    if (sign != pair.npos)
      names[std::atoi(pair.c_str())] = asWord(pair.substr(sign + 1));
  }
  for (vtkIdType i = 0; !names.empty() && i < types->GetNumberOfTuples(); ++i)
    if (names.count(static_cast<int>(types->GetComponent(i, 0))) == 0)
      names.clear();
  return names;
}

Column namedTypes(vtkDataArray* types, std::map<int, std::string> names)
{
  return [types, names = std::move(names)](std::string& text, vtkIdType point)
  {
    text += names.at(static_cast<int>(types->GetComponent(point, 0)));
    text.push_back(' ');
  };
}

/// The columns of a frame, and what the comment says of them.
class Columns
{
public:
  void add(const std::string& name, char type, int components, Column column)
  {
    std::string free;
    for (const char c : asWord(name))
      free.push_back(c == ':' || c == '"' || c == '=' ? '_' : c);
    while (!names_.insert(free).second)
      free.push_back('_');
    properties +=
      (properties.empty() ? "" : ":") + free + ':' + type + ':' + std::to_string(components);
    all.push_back(std::move(column));
  }

  std::string properties;
  std::vector<Column> all;

private:
  std::set<std::string> names_;
};

bool areWhole(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

/// The array of words that says what each point is: the elements; or null.
vtkStringArray* speciesOf(vtkPointSet* data)
{
  for (const char* name : {"element", "species", "typelabel"})
  {
    auto* words = vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray(name));
    if (words && words->GetNumberOfValues() == data->GetNumberOfPoints())
      return words;
  }
  return nullptr;
}

/// "1 0 0": the values of an array of fields.
std::string valuesOf(vtkDataArray* array)
{
  std::string text;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      appendNumber(text, array->GetComponent(i, k));
  return text.substr(0, text.size() - 1);
}

/// What the comment says of the box.
std::string boxOf(vtkFieldData* fields)
{
  const auto values = [&](const char* name, vtkIdType count) -> std::string
  {
    vtkDataArray* array = fields->GetArray(name);
    return array && array->GetNumberOfValues() == count ? valuesOf(array) : "";
  };
  const std::string vectors = values("box", 9);
  if (vectors.empty())
    return {};
  std::string text = "Lattice=\"" + vectors + "\" ";
  if (const std::string origin = values("box_origin", 3); !origin.empty())
    text += "Origin=\"" + origin + "\" ";
  auto* boundary = vtkStringArray::SafeDownCast(fields->GetAbstractArray("boundary"));
  if (boundary && boundary->GetNumberOfValues() > 0)
  {
    // As LAMMPS says it, "pp pp ff": two sides of each direction, or a letter for both.
    text += "pbc=\"";
    const std::string& sides = boundary->GetValue(0);
    std::string periodic;
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i] != ' ' && (i == 0 || sides[i - 1] == ' '))
        periodic += sides[i] == 'p' ? "T " : "F ";
    text.append(periodic, 0, periodic.size() - 1) += "\" ";
  }
  return text;
}

} // namespace

XYZText::XYZText(vtkPointSet* data, std::optional<double> time)
{
  vtkPointData* arrays = data->GetPointData();
  Columns columns;
  vtkStringArray* species = speciesOf(data);
  vtkDataArray* types = arrays->GetArray("type");
  if (species)
    columns.add("species", 'S', 1, wordsOf(species));
  else if (types && areWhole(types) && types->GetNumberOfComponents() == 1)
    if (auto names = namesOfTypes(data, types); !names.empty())
      columns.add("species", 'S', 1, namedTypes(types, std::move(names)));
  if (data->GetNumberOfPoints() > 0)
    columns.add("pos", 'R', 3, numbersOf(data->GetPoints()->GetData()));
  else
    columns.add("pos", 'R', 3, {});
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const int components = array->GetNumberOfComponents();
    const bool isFit = array->GetNumberOfTuples() == data->GetNumberOfPoints() && components > 0 &&
                       components <= 1000;
    auto* numbers = vtkDataArray::SafeDownCast(array);
    auto* words = vtkStringArray::SafeDownCast(array);
    if (words && words == species)
      continue;
    if (isFit && numbers)
      columns.add(name, areWhole(numbers) ? 'I' : 'R', components, numbersOf(numbers));
    else if (isFit && words && components == 1)
      columns.add(name, 'S', 1, wordsOf(words));
    else
      leftOut_ += (leftOut_.empty() ? "" : ", ") + name;
  }
  columns_ = std::move(columns.all);
  head_ = std::to_string(data->GetNumberOfPoints()) + '\n' + boxOf(data->GetFieldData()) +
          "Properties=" + columns.properties;
  if (time)
  {
    head_ += " Time=";
    appendNumber(head_, *time);
    head_.pop_back(); // the blank
  }
  head_ += '\n';
}

void XYZText::append(std::string& text, vtkIdType begin, vtkIdType end) const
{
  for (vtkIdType point = begin; point < end; ++point)
  {
    for (const Column& column : columns_)
      column(text, point);
    text.back() = '\n'; // in place of the last blank
  }
}

} // namespace mote
