#include "LAMMPSPolyData.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <numeric>

namespace mote
{
namespace
{

static_assert(sizeof(vtkStdString) == sizeof(std::string), "rows are stored as std::string");
static_assert(sizeof(vtkIdType) == sizeof(std::int64_t), "Int64 columns become vtkIdTypeArray");

template <class Array>
vtkSmartPointer<vtkAbstractArray> makeArray(int components, vtkIdType tuples, void*& data)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data = tuples > 0 ? array->GetPointer(0) : nullptr;
  return array;
}

vtkSmartPointer<vtkAbstractArray> makeArray(ColumnType type, int components, vtkIdType tuples,
                                            void*& data)
{
  switch (type)
  {
    case ColumnType::Int32:
      return makeArray<vtkIntArray>(components, tuples, data);
    case ColumnType::Int64:
      return makeArray<vtkIdTypeArray>(components, tuples, data);
    case ColumnType::Float32:
      return makeArray<vtkFloatArray>(components, tuples, data);
    case ColumnType::String:
    {
      auto array = vtkSmartPointer<vtkStringArray>::New();
      array->SetNumberOfComponents(components);
      array->SetNumberOfTuples(tuples);
      data = tuples > 0 ? static_cast<std::string*>(array->GetPointer(0)) : nullptr;
      return array;
    }
    default:
      return makeArray<vtkDoubleArray>(components, tuples, data);
  }
}

std::size_t bytesOf(ColumnType type)
{
  return type == ColumnType::String ? sizeof(std::string)
    : type == ColumnType::Int32 || type == ColumnType::Float32 ? 4
                                                               : 8;
}

/// One frame on its way into one vtkPolyData.
class FrameReader
{
public:
  FrameReader(const std::string& path, const LAMMPSFrame& frame, const LAMMPSReadOptions& options)
    : m_frame(frame), m_options(options), m_columns(*frame.columns),
      m_layout(layoutOf(m_columns, options.combine)), m_cursor(path)
  {
  }

  void read(const Progress& progress, vtkPolyData* output);

private:
  void chooseTypes();
  std::vector<TextColumn> allocate();

  const LAMMPSFrame& m_frame;
  const LAMMPSReadOptions& m_options;
  const std::vector<std::string>& m_columns;
  LAMMPSLayout m_layout;
  TextCursor m_cursor;
  std::vector<ColumnType> m_types;
  vtkNew<vtkPoints> m_points;
  std::vector<vtkSmartPointer<vtkAbstractArray>> m_arrays;
};

void FrameReader::chooseTypes()
{
  m_types.assign(m_columns.size(), ColumnType::Skip);
  m_cursor.seek(m_frame.rows);
  std::vector<std::string> first;
  if (m_frame.atoms > 0)
  {
    first = peekValues(m_cursor);
  }
  first.resize(m_columns.size());
  for (const LAMMPSArray& array : m_layout.arrays)
  {
    if (m_options.wanted && !m_options.wanted(array.name))
    {
      continue;
    }
    for (const std::size_t column : array.columns)
    {
      const ColumnType type = typeOf(m_columns[column], first[column]);
      // The components of an array have one type, and only floats are ever combined.
      const bool number = array.columns.size() > 1 || type == ColumnType::Float64;
      m_types[column] = !number ? type
        : m_options.singlePrecision ? ColumnType::Float32
                                    : ColumnType::Float64;
    }
  }
}

/// Makes points and arrays, and points the columns at them.
std::vector<TextColumn> FrameReader::allocate()
{
  const auto atoms = static_cast<vtkIdType>(m_frame.atoms);
  std::vector<TextColumn> targets(m_columns.size());
  for (std::size_t i = 0; i < m_columns.size(); ++i)
  {
    targets[i].name = m_columns[i];
  }
  m_points->SetDataTypeToDouble();
  m_points->SetNumberOfPoints(atoms);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    TextColumn& target = targets[m_layout.coordinates[axis].column];
    target.type = ColumnType::Float64;
    target.data = atoms > 0 ? static_cast<double*>(m_points->GetVoidPointer(0)) + axis : nullptr;
    target.stride = 3;
  }
  m_arrays.clear();
  for (const LAMMPSArray& array : m_layout.arrays)
  {
    const ColumnType type = m_types[array.columns[0]];
    if (type == ColumnType::Skip)
    {
      continue;
    }
    const int components = static_cast<int>(array.columns.size());
    void* data = nullptr;
    m_arrays.push_back(makeArray(type, components, atoms, data));
    m_arrays.back()->SetName(array.name.c_str());
    for (int i = 0; i < components; ++i)
    {
      TextColumn& target = targets[array.columns[i]];
      target.type = type;
      target.data = data ? static_cast<char*>(data) + i * bytesOf(type) : nullptr;
      target.stride = components;
      if (components > 1)
      {
        m_arrays.back()->SetComponentName(i, target.name.c_str());
      }
    }
  }
  return targets;
}

/// One vertex cell an atom, so that cell-wise filters (vtkThreshold) can take atoms apart. In
/// 32-bit storage these cost the 8 bytes an atom that one 64-bit poly-vertex would.
template <class Array>
void setVertices(vtkPolyData* output, vtkIdType atoms)
{
  vtkNew<Array> offsets;
  vtkNew<Array> connectivity;
  offsets->SetNumberOfValues(atoms + 1);
  connectivity->SetNumberOfValues(atoms);
  std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + atoms + 1, 0);
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + atoms, 0);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetVerts(cells);
}

void FrameReader::read(const Progress& progress, vtkPolyData* output)
{
  if (m_frame.damage)
  {
    throw *m_frame.damage;
  }
  if (!m_layout.missing.empty())
  {
    std::string names;
    for (const std::string& column : m_columns)
    {
      names += ' ' + column;
    }
    const std::string& axis = m_layout.missing;
    throw FileError(FileError::Kind::Malformed, m_cursor.path(),
                    "no column gives the " + axis + " coordinate (" + axis + ", " + axis + "u, " +
                      axis + "s or " + axis + "su); the columns are" + names,
                    m_frame.columnsLine);
  }
  const LAMMPSPlacement placement(m_frame, m_layout, m_cursor.path());
  chooseTypes();
  RowsResult result;
  do
  {
    const std::vector<TextColumn> targets = allocate();
    auto* const positions =
      m_frame.atoms > 0 ? static_cast<double*>(m_points->GetVoidPointer(0)) : nullptr;
    RowsStored stored;
    if (placement.needed())
    {
      stored = [&](std::uint64_t first, std::uint64_t count)
      { placement.apply(positions, first, count); };
    }
    m_cursor.seek(m_frame.rows);
    result = readRows(m_cursor, m_frame.atoms, targets, stored, progress);
    if (!result.complete)
    {
      m_types[result.widen.column] = result.widen.type;
    }
  } while (!result.complete);

  output->SetPoints(m_points);
  for (vtkAbstractArray* array : m_arrays)
  {
    output->GetPointData()->AddArray(array);
  }
  const auto atoms = static_cast<vtkIdType>(m_frame.atoms);
  if (atoms < VTK_INT_MAX)
  {
    setVertices<vtkTypeInt32Array>(output, atoms);
  }
  else
  {
    setVertices<vtkTypeInt64Array>(output, atoms);
  }
}

void addNumbers(vtkFieldData* fields, const char* name, const double* values, int count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(count);
  array->InsertNextTuple(values);
  fields->AddArray(array);
}

void addText(vtkFieldData* fields, const char* name, const std::string& text)
{
  if (!text.empty())
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    fields->AddArray(array);
  }
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
                     const LAMMPSReadOptions& options, const Progress& progress,
                     vtkPolyData* output)
{
  FrameReader(path, frame, options).read(progress, output);
  addHeader(frame, output->GetFieldData());
}

} // namespace mote
