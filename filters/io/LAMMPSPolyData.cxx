#include "LAMMPSPolyData.h"

#include "LAMMPSBinary.h"
#include "LAMMPSVelocities.h"
#include "PointRows.h"
#include "PolyDataParts.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

namespace mote
{
namespace
{

void requireCoordinates(
  const std::string& path, const LAMMPSFrame& frame, const LAMMPSLayout& layout)
{
  const std::string& axis = layout.missing;
  if (axis.empty())
    return;
  std::string names;
  for (const std::string& column : *frame.columns)
    names += ' ' + column;
  throw FileError(FileError::Kind::Malformed, path,
    "no column gives the " + axis + " coordinate (" + axis + ", " + axis + "u, " + axis + "s or " +
      axis + "su); the columns are" + names,
    frame.columnsLine);
}

bool isWanted(const std::string& array, const LAMMPSReadOptions& options)
{
  return !options.wanted || options.wanted(array);
}

/// Whether velocities are to be brought to the atoms of their ids.
bool needsIds(const LAMMPSFrame& frame, const LAMMPSReadOptions& options)
{
  const std::vector<std::string> names = velocityArrays(frame, options.combine);
  return std::any_of(
    names.begin(), names.end(), [&](const std::string& name) { return isWanted(name, options); });
}

std::vector<ColumnType> chooseTypes(TextCursor* cursor, const LAMMPSFrame& frame,
  const LAMMPSLayout& layout, const LAMMPSReadOptions& options)
{
  const std::vector<std::string>& columns = *frame.columns;
  std::vector<ColumnType> types(columns.size(), ColumnType::Skip);
  std::vector<std::string> first;
  if (frame.atoms > 0 && cursor)
  {
    cursor->seek(frame.rows);
    first = peekValues(*cursor);
  }
  first.resize(columns.size(), cursor ? "" : "0"); // binary dumps have numbers alone
  for (const ColumnGroup& array : layout.arrays)
  {
    if (!isWanted(array.name, options) && !(array.name == "id" && needsIds(frame, options)))
      continue;
    for (const std::size_t column : array.columns)
    {
      ColumnType type = typeOf(columns[column], first[column]);
      if (!cursor && type == ColumnType::String)
        type = ColumnType::Int32;
      // The components of an array have one type, and only floats are ever combined.
      const bool real = array.columns.size() > 1 || type == ColumnType::Float64;
      types[column] = !real                     ? type
                      : options.singlePrecision ? ColumnType::Float32
                                                : ColumnType::Float64;
    }
  }
  return types;
}

constexpr const char* wordColumns[] = {"element", "typelabel"};

bool hasTypes(const LAMMPSFrame& frame)
{
  const std::vector<std::string>& columns = *frame.columns;
  return std::find(columns.begin(), columns.end(), "type") != columns.end();
}

/// The column whose words stand for the types of atoms: element, typelabel or any other; or none.
std::optional<std::size_t> wordColumn(const PointRows& rows)
{
  const auto find = [&](const char* name) -> std::optional<std::size_t>
  {
    for (const ColumnGroup& array : rows.arrays)
    {
      const std::size_t column = array.columns[0];
      if (array.columns.size() == 1 && rows.types[column] == ColumnType::String &&
          (!name || array.name == name))
        return column;
    }
    return {};
  };
  for (const char* name : wordColumns)
    if (const auto column = find(name))
      return column;
  return find(nullptr);
}

/// The words that stand for the types of atoms, as wordColumn() chooses them.
vtkStringArray* typeWords(vtkPointData* arrays)
{
  for (const char* name : wordColumns)
    if (auto* words = vtkStringArray::SafeDownCast(arrays->GetAbstractArray(name)))
      return words;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    auto* words = vtkStringArray::SafeDownCast(arrays->GetAbstractArray(i));
    if (words && words->GetNumberOfComponents() == 1)
      return words;
  }
  return nullptr;
}

/// Adds "type" to a frame that has only words for it: their place in alphabetical order, from 1,
/// among `all` words where these are given.
void addTypes(const LAMMPSFrame& frame, vtkPointData* arrays, const std::set<std::string>& all)
{
  vtkStringArray* words = typeWords(arrays);
  if (!words || hasTypes(frame))
    return;
  using Range = tbb::blocked_range<vtkIdType>;
  using Words = std::set<std::string>;
  const Range atoms(0, words->GetNumberOfValues(), 10000);
  const vtkStdString* const texts = atoms.empty() ? nullptr : words->GetPointer(0);
  const Words distinct = !all.empty()
                           ? all
                           : tbb::parallel_reduce(
                               atoms, Words(),
                               [&](const Range& range, Words found)
                               {
                                 found.insert(texts + range.begin(), texts + range.end());
                                 return found;
                               },
                               [](Words a, const Words& b)
                               {
                                 a.insert(b.begin(), b.end());
                                 return a;
                               });
  const std::vector<std::string> sorted(distinct.begin(), distinct.end());
  vtkNew<vtkIntArray> types;
  types->SetName("type");
  types->SetNumberOfTuples(words->GetNumberOfValues());
  tbb::parallel_for(atoms,
    [&](const Range& range)
    {
      for (vtkIdType i = range.begin(); i < range.end(); ++i)
      {
        const auto at = std::lower_bound(sorted.begin(), sorted.end(), texts[i]);
        types->SetValue(i, static_cast<int>(at - sorted.begin()) + 1);
      }
    });
  arrays->AddArray(types);
}

void addHeader(const LAMMPSFrame& frame, vtkFieldData* fields)
{
  vtkNew<vtkIdTypeArray> timestep;
  timestep->SetName("timestep");
  timestep->InsertNextValue(frame.timestep);
  fields->AddArray(timestep);
  if (frame.box.known)
  {
    addNumbers(fields, "box", frame.box.cell[0].data(), 9);
    addNumbers(fields, "box_origin", frame.box.origin.data(), 3);
    addText(fields, "boundary", frame.box.boundary);
  }
  addText(fields, "units", frame.units);
}

} // namespace

void readLAMMPSFrame(const std::string& path, const LAMMPSFrame& frame,
  const LAMMPSReadOptions& options, const Progress& progress, vtkPolyData* output)
{
  if (frame.damage)
    throw *frame.damage;
  const LAMMPSLayout layout = layoutOf(*frame.columns, options.combine);
  requireCoordinates(path, frame, layout);
  const LAMMPSPlacement placement(frame, layout, path);
  std::optional<TextCursor> cursor;
  if (!frame.chunks)
    cursor.emplace(
      path, frame.hasComments ? TextCursor::OpenEnd::Accept : TextCursor::OpenEnd::Reject);
  PointRows rows;
  rows.rows = frame.atoms;
  rows.piece = options.piece;
  rows.place = frame.rows;
  rows.format.comment = frame.hasComments ? '#' : '\0';
  rows.columns = *frame.columns;
  rows.types = chooseTypes(cursor ? &*cursor : nullptr, frame, layout, options);
  rows.arrays = layout.arrays;
  for (std::size_t axis = 0; axis < 3; ++axis)
    rows.coordinates[axis] = layout.coordinates[axis].column;
  if (placement.needed())
  {
    rows.transform = [&](double* positions, std::uint64_t first, std::uint64_t count)
    { placement.apply(positions, first, count); };
  }
  NumberedWords words;
  const auto column = wordColumn(rows);
  rows.space = options.space;
  if (rows.space && column && !hasTypes(frame))
  {
    words.column = *column;
    rows.words = &words;
  }
  std::set<std::string> all;
  if (column && !hasTypes(frame) && !rows.piece.isAll())
    all = wordsOf(*cursor, rows, *column, progress);
  if (cursor)
    readPointRows(*cursor, std::move(rows), progress, output);
  else
    makePointRows(
      std::move(rows),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored& stored)
      {
        readBinaryRows(path, frame, first, count, targets, stored, progress);
        return RowsResult();
      },
      output);
  if (words.numbers)
    addTypes(words, typesOf(words.table.words(), false), output);
  else if (!options.space)
    addTypes(frame, output->GetPointData(), all);
  if (needsIds(frame, options))
    addLAMMPSVelocities(path, frame, options, progress, output);
  if (!isWanted("id", options))
    output->GetPointData()->RemoveArray("id");
  addHeader(frame, output->GetFieldData());
}

} // namespace mote
