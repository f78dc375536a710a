#include "PointRows.h"

#include "PolyDataParts.h"

#include "vtkAbstractArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace mote
{
namespace
{

/// Adds the arrays to the output, and points the columns at them.
void addArrays(const PointRows& rows, vtkPolyData* output, std::vector<TextColumn>& targets)
{
  for (const ColumnGroup& group : rows.arrays)
  {
    const ColumnType type = rows.types[group.columns[0]];
    if (type == ColumnType::Skip)
    {
      continue;
    }
    const int components = static_cast<int>(group.columns.size());
    void* data = nullptr;
    auto array = makeColumnArray(type, components, static_cast<vtkIdType>(rows.rows), data);
    array->SetName(group.name.c_str());
    for (int i = 0; i < components; ++i)
    {
      TextColumn& target = targets[group.columns[i]];
      target.type = type;
      target.data = data ? static_cast<char*>(data) + i * bytesOf(type) : nullptr;
      target.stride = components;
      if (components > 1)
      {
        array->SetComponentName(i, target.name.c_str());
      }
    }
    output->GetPointData()->AddArray(array);
  }
}

/// Gives a column its new type, and the others of its array too.
void widen(PointRows& rows, const WidenColumn& request)
{
  for (const ColumnGroup& group : rows.arrays)
  {
    if (std::count(group.columns.begin(), group.columns.end(), request.column) > 0)
    {
      for (const std::size_t member : group.columns)
      {
        rows.types[member] = request.type;
      }
    }
  }
}

} // namespace

void readPointRows(
  TextCursor& cursor, PointRows rows, const Progress& progress, vtkPolyData* output)
{
  RowsResult result;
  do
  {
    output->Initialize();
    std::vector<TextColumn> targets(rows.columns.size());
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      targets[i].name = rows.columns[i];
    }
    vtkNew<vtkPoints> points;
    double* const positions = makePositions(points, static_cast<vtkIdType>(rows.rows));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      TextColumn& target = targets[rows.coordinates[axis]];
      target.type = ColumnType::Float64;
      target.data = positions ? positions + axis : nullptr;
      target.stride = 3;
    }
    addArrays(rows, output, targets);
    output->SetPoints(points);
    RowsStored stored;
    if (rows.transform)
    {
      stored = [&](std::uint64_t first, std::uint64_t count)
      { rows.transform(positions, first, count); };
    }
    cursor.seek(rows.place);
    result = readRows(cursor, rows.rows, targets, stored, progress);
    if (!result.complete)
    {
      widen(rows, result.widen);
    }
  } while (!result.complete);
  setVertices(output, static_cast<vtkIdType>(rows.rows));
}

} // namespace mote
