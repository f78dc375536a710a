#include "LAMMPSVelocities.h"

#include "PolyDataParts.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <utility>

namespace mote
{
namespace
{

constexpr const char* axes[] = {"vx", "vy", "vz"};

/// Finds the rows of atoms by their ids.
class RowsOfIds
{
public:
  RowsOfIds(vtkIdTypeArray* ids, std::uint64_t first)
    : m_ids(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues())
    , m_first(first)
  {
  }

  /// The row of an atom where the file has it in the same order; below 0 where not.
  std::int64_t findInOrder(std::int64_t id, std::uint64_t row) const
  {
    row -= m_first; // which may pass 0
    return row < m_ids.size() && m_ids[row] == id ? static_cast<std::int64_t>(row) : -1;
  }

  /// Makes find() possible.
  void sort()
  {
    if (m_ids.empty() || !m_rows.empty() || !m_sorted.empty())
      return;
    const auto [least, most] = std::minmax_element(m_ids.begin(), m_ids.end());
    m_least = static_cast<std::uint64_t>(*least);
    const std::uint64_t last = this->placeOf(*most);
    if (last / 4 < m_ids.size())
    {
      m_rows.assign(static_cast<std::size_t>(last) + 1, -1);
      for (std::size_t row = 0; row < m_ids.size(); ++row)
        m_rows[this->placeOf(m_ids[row])] = static_cast<std::int64_t>(row);
      return;
    }
    for (std::size_t row = 0; row < m_ids.size(); ++row)
      m_sorted.emplace_back(m_ids[row], row);
    tbb::parallel_sort(m_sorted.begin(), m_sorted.end());
  }

  /// The row of an atom; below 0 where there is none.
  std::int64_t find(std::int64_t id) const
  {
    if (!m_rows.empty())
      return this->placeOf(id) < m_rows.size() ? m_rows[this->placeOf(id)] : -1;
    const auto found =
      std::lower_bound(m_sorted.begin(), m_sorted.end(), std::pair(id, std::int64_t(0)));
    return found != m_sorted.end() && found->first == id ? found->second : -1;
  }

private:
  /// How far an id is above the least one. Ids below it give numbers past all rows.
  std::uint64_t placeOf(std::int64_t id) const { return static_cast<std::uint64_t>(id) - m_least; }

  std::vector<std::int64_t> m_ids;
  std::uint64_t m_first; ///< row of the file that is the first of these
  std::uint64_t m_least = 0;
  std::vector<std::int64_t> m_rows; ///< by id, from the least on, where most ids are there
  std::vector<std::pair<std::int64_t, std::int64_t>> m_sorted; ///< else
};

/// An array of the output, all 0.
vtkDataArray* addArray(
  const std::string& name, int components, const LAMMPSReadOptions& options, vtkPolyData* output)
{
  const ColumnType type = options.singlePrecision ? ColumnType::Float32 : ColumnType::Float64;
  const vtkIdType count = output->GetNumberOfPoints();
  const std::uint64_t bytes = bytesOf(type) * static_cast<std::uint64_t>(count * components);
  void* data = nullptr;
  const auto array = makeColumnArray(type, components, count, data,
    {options.space.get(), options.space && !options.space->hasRoomFor(bytes)});
  array->SetName(name.c_str());
  for (int k = 0; components > 1 && k < components; ++k)
    array->SetComponentName(k, axes[k]);
  output->GetPointData()->AddArray(array);
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  numbers->Fill(0.0);
  return numbers;
}

/// Calls bring(i, row) for the values i of `count` that begin at a row of the file, with the row of
/// the atom of the same id; returns the first value that has none, or `count`.
template <typename Bring>
std::uint64_t bringToRows(RowsOfIds& rows, const std::vector<std::int64_t>& ids,
  std::uint64_t begin, std::uint64_t count, const Bring& bring)
{
  std::atomic<std::uint64_t> lost = count;
  std::atomic<bool> areInOrder = true;
  tbb::parallel_for(std::uint64_t{0}, count,
    [&](std::uint64_t i)
    {
      if (const std::int64_t row = rows.findInOrder(ids[i], begin + i); row >= 0)
        bring(i, row);
      else
        areInOrder = false;
    });
  if (areInOrder)
    return count;
  rows.sort();
  tbb::parallel_for(std::uint64_t{0}, count,
    [&](std::uint64_t i)
    {
      if (const std::int64_t row = rows.find(ids[i]); row >= 0)
        bring(i, row);
      else
        for (std::uint64_t first = lost; i < first && !lost.compare_exchange_weak(first, i);)
        {
        }
    });
  return lost;
}

} // namespace

std::vector<std::string> velocityArrays(const LAMMPSFrame& frame, bool combine)
{
  if (!frame.velocities)
    return {};
  return combine ? std::vector<std::string>{"v"}
                 : std::vector<std::string>{axes[0], axes[1], axes[2]};
}

void addLAMMPSVelocities(const std::string& path, const LAMMPSFrame& frame,
  const LAMMPSReadOptions& options, const Progress& progress, vtkPolyData* output)
{
  constexpr std::uint64_t most = 1 << 20; // rows at a time
  const std::vector<std::string> names = velocityArrays(frame, options.combine);
  const int components = names.size() == 1 ? 3 : 1;
  std::vector<vtkDataArray*> arrays;
  for (const std::string& name : names)
    if (!options.wanted || options.wanted(name))
      arrays.push_back(addArray(name, components, options, output));
    else
      arrays.push_back(nullptr);
  auto* const ids = vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("id"));
  if (!ids)
    throw FileError(FileError::Kind::Malformed, path,
      "an id of the atoms is no integer, so that velocities do not find them", frame.columnsLine);
  RowsOfIds rows(ids, options.piece.first(frame.atoms));
  const auto room = static_cast<std::size_t>(std::min(most, frame.atoms));
  std::vector<std::int64_t> idsOfRows(room);
  std::vector<double> values(3 * room);
  std::vector<TextColumn> columns(frame.velocityColumns);
  columns[0] = {"id", ColumnType::Int64, idsOfRows.data()};
  for (std::size_t k = 0; k < 3; ++k)
    columns[k + 1] = {axes[k], ColumnType::Float64, values.data() + k, 3};
  RowFormat format;
  format.comment = '#';
  TextCursor cursor(path, TextCursor::OpenEnd::Accept);
  cursor.seek(*frame.velocities);
  for (std::uint64_t done = 0; done < frame.atoms; done += most)
  {
    const std::uint64_t line = cursor.line(), count = std::min(most, frame.atoms - done);
    const RowsResult result = readRows(cursor, count, columns, {}, progress, format);
    if (!result.complete)
      throw FileError(
        FileError::Kind::Malformed, path, "an id of the velocities is no integer", line);
    const auto bring = [&](std::uint64_t i, std::int64_t row)
    {
      for (int k = 0; k < 3; ++k)
        if (vtkDataArray* array = arrays[components == 3 ? 0 : k])
          array->SetComponent(row, components == 3 ? k : 0, values[3 * i + k]);
    };
    const std::uint64_t lost = bringToRows(rows, idsOfRows, done, count, bring);
    if (lost < count && options.piece.isAll())
      throw FileError(FileError::Kind::Malformed, path,
        "there is a velocity of atom " + std::to_string(idsOfRows[lost]) + ", but no such atom",
        line + lost);
  }
}

} // namespace mote
