#include "PointRows.h"

#include "PolyDataParts.h"

#include "vtkAbstractArray.h"
#include "vtkNew.h"
#include "vtkPeriodicTable.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <map>
#include <set>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace mote
{
namespace
{

/// Where the arrays of `rows` go.
ColumnSpace chooseSpace(const PointRows& rows)
{
  if (!rows.space)
    return {};
  std::uint64_t bytes = 3 * sizeof(double);
  for (const ColumnType type : rows.types)
    bytes += type == ColumnType::Skip ? 0 : bytesOf(type);
  // A structure over the points is read here and there, columns from their begin to their end.
  const std::uint64_t structure = 20;
  return {rows.space.get(), !rows.space->hasRoomFor((bytes + structure) * rows.rows)};
}

/// The words of a column are read as numbers; the name of their array is kept for whoever says what
/// is left out.
void addWords(const PointRows& rows, const ColumnGroup& group, const ColumnSpace& space,
  vtkPolyData* output, std::vector<TextColumn>& targets)
{
  if (rows.space)
  {
    vtkNew<vtkStringArray> name;
    name->SetName(group.name.c_str());
    output->GetPointData()->AddArray(name);
  }
  if (!rows.words || group.columns[0] != rows.words->column)
    return;
  TextColumn& target = targets[group.columns[0]];
  target.type = ColumnType::Word;
  target.words = &rows.words->table;
  rows.words->numbers = vtkDataArray::SafeDownCast(
    makeColumnArray(ColumnType::Word, 1, static_cast<vtkIdType>(rows.rows), target.data, space));
}

/// Adds the arrays to the output, and points the columns at them.
void addArrays(const PointRows& rows, const ColumnSpace& space, vtkPolyData* output,
  std::vector<TextColumn>& targets)
{
  for (const ColumnGroup& group : rows.arrays)
  {
    const ColumnType type = rows.types[group.columns[0]];
    if (type == ColumnType::Skip)
      continue;
    const bool areNumbered = rows.words && group.columns[0] == rows.words->column;
    if (type == ColumnType::String && (rows.space || areNumbered))
    {
      addWords(rows, group, space, output, targets);
      continue;
    }
    const int components = static_cast<int>(group.columns.size());
    void* data = nullptr;
    auto array = makeColumnArray(type, components, static_cast<vtkIdType>(rows.rows), data, space);
    array->SetName(group.name.c_str());
    for (int i = 0; i < components; ++i)
    {
      TextColumn& target = targets[group.columns[i]];
      target.type = type;
      target.data = data ? static_cast<char*>(data) + i * bytesOf(type) : nullptr;
      target.stride = components;
      if (components > 1 && group.namesComponents)
        array->SetComponentName(i, target.name.c_str());
    }
    output->GetPointData()->AddArray(array);
  }
}

/// Names of arrays as VTK takes them: up to a zero, not empty, and each once. A second array of a
/// name would take the place of the first, which is being filled.
void settleNames(std::vector<ColumnGroup>& arrays)
{
  std::map<std::string, std::size_t> uses;
  for (ColumnGroup& array : arrays)
  {
    std::string name = array.name.c_str();
    if (name.empty())
      name.push_back('_');
    array.name = name;
    while (uses.count(array.name) > 0)
      array.name = name + "_" + std::to_string(++uses[name]);
    uses.emplace(array.name, 1);
  }
}

/// Gives a column its new type, and the others of its array too. Text has no components.
void widen(PointRows& rows, const WidenColumn& request)
{
  const auto group = std::find_if(rows.arrays.begin(), rows.arrays.end(),
    [&](const ColumnGroup& one)
    { return std::count(one.columns.begin(), one.columns.end(), request.column) > 0; });
  if (group == rows.arrays.end())
    return;
  const ColumnGroup whole = *group;
  if (request.type != ColumnType::String || whole.columns.size() == 1)
  {
    for (const std::size_t member : whole.columns)
      rows.types[member] = request.type;
    return;
  }
  std::vector<ColumnGroup> singles;
  for (const std::size_t member : whole.columns)
    singles.push_back({rows.columns[member], {member}});
  rows.arrays.insert(rows.arrays.erase(group), singles.begin(), singles.end());
  settleNames(rows.arrays);
  rows.types[request.column] = request.type;
}

} // namespace

std::set<std::string> wordsOf(
  TextCursor& cursor, const PointRows& rows, std::size_t column, const Progress& progress)
{
  constexpr std::uint64_t most = 1 << 20; // rows at a time
  WordTable table;
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(std::min(most, rows.rows)));
  std::vector<TextColumn> targets(rows.columns.size());
  for (std::size_t i = 0; i < targets.size(); ++i)
    targets[i].name = rows.columns[i];
  targets[column].type = ColumnType::Word;
  targets[column].data = numbers.data();
  targets[column].words = &table;
  cursor.seek(rows.place);
  for (std::uint64_t done = 0; done < rows.rows; done += most)
    readRows(
      cursor, std::min(most, rows.rows - done), targets, {},
      [&](double fraction)
      {
        const double all = static_cast<double>(done) + fraction * static_cast<double>(most);
        return !progress || progress(std::min(1.0, all / static_cast<double>(rows.rows)));
      },
      rows.format);
  return table.words();
}

void makePointRows(PointRows rows, const RowSource& source, vtkPolyData* output)
{
  settleNames(rows.arrays);
  const std::uint64_t first = rows.piece.first(rows.rows);
  rows.rows = rows.piece.size(rows.rows);
  RowsResult result;
  do
  {
    output->Initialize();
    std::vector<TextColumn> targets(rows.columns.size());
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      targets[i].name = rows.columns[i];
      targets[i].mayBeText = rows.mayBeText;
    }
    vtkNew<vtkPoints> points;
    const ColumnSpace space = chooseSpace(rows);
    double* const positions = makePositions(points, static_cast<vtkIdType>(rows.rows), space);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (rows.coordinates[axis] == PointRows::none)
        continue;
      TextColumn& target = targets[rows.coordinates[axis]];
      target.type = ColumnType::Float64;
      target.data = positions ? positions + axis : nullptr;
      target.stride = 3;
      target.mayBeEmpty = target.mayBeText = false;
    }
    addArrays(rows, space, output, targets);
    output->SetPoints(points);
    const bool isFlat = rows.coordinates[2] == PointRows::none;
    RowsStored stored;
    if (rows.transform || (isFlat && positions))
    {
      stored = [&](std::uint64_t begin, std::uint64_t count)
      {
        for (std::uint64_t row = begin; isFlat && row < begin + count; ++row)
          positions[3 * row + 2] = 0.0;
        if (rows.transform)
          rows.transform(positions, begin, count);
      };
    }
    result = source(first, rows.rows, targets, stored);
    if (!result.complete)
      widen(rows, result.widen);
  } while (!result.complete);
  if (!rows.space)
    setVertices(output, static_cast<vtkIdType>(rows.rows));
}

void readPointRows(
  TextCursor& cursor, PointRows rows, const Progress& progress, vtkPolyData* output)
{
  TextCursor::Place place = rows.place;
  if (!rows.piece.isAll())
  {
    cursor.seek(place);
    skipRows(cursor, rows.piece.first(rows.rows), rows.format);
    place = cursor.place();
  }
  const RowFormat format = rows.format;
  makePointRows(
    std::move(rows),
    [&, format](std::uint64_t, std::uint64_t count, const std::vector<TextColumn>& targets,
      const RowsStored& stored)
    {
      cursor.seek(place);
      return readRows(cursor, count, targets, stored, progress, format);
    },
    output);
}

std::map<std::string, int> typesOf(const std::set<std::string>& words, bool areElements)
{
  vtkNew<vtkPeriodicTable> table;
  std::map<std::string, int> types;
  for (const std::string& word : words)
    types[word] = areElements ? table->GetAtomicNumber(word) : 0;
  const auto isNone = [&](const auto& type)
  {
    const bool isDummy = type.first == "X" || type.first == "Xx";
    return type.second == 0 && !(areElements && isDummy);
  };
  int last = 0;
  if (std::any_of(types.begin(), types.end(), isNone))
    for (auto& [word, type] : types)
      type = ++last;
  return types;
}

void addTypes(NumberedWords& words, const std::map<std::string, int>& types, vtkPolyData* output)
{
  std::vector<int> typeOf(static_cast<std::size_t>(words.table.end()), 0);
  for (const auto& [word, number] : words.table.numbers())
    typeOf[static_cast<std::size_t>(number)] = types.at(word);
  const vtkIdType count = words.numbers->GetNumberOfTuples();
  auto* const values = static_cast<int*>(words.numbers->GetVoidPointer(0));
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, 10000),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      for (vtkIdType i = range.begin(); i < range.end(); ++i)
        values[i] = typeOf[static_cast<std::size_t>(values[i])];
    });
  vtkNew<vtkStringArray> names; // which the words themselves are not there for
  names->SetName("type_names");
  for (const auto& [word, type] : types)
    names->InsertNextValue(std::to_string(type) + "=" + word);
  output->GetFieldData()->AddArray(names);
  words.numbers->SetName("type");
  output->GetPointData()->AddArray(words.numbers);
}

} // namespace mote
