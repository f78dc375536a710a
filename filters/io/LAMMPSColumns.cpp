#include "LAMMPSColumns.h"

#include "ParseNumber.h"

#include <algorithm>
#include <string_view>

namespace mote
{
namespace
{

using Names = std::vector<std::string>;

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// "c_stress[3]" is base "c_stress" and index 3; index 0 where there are no brackets.
struct Indexed
{
  std::string base;
  std::size_t index = 0;
};

Indexed splitIndex(const std::string& name)
{
  const std::size_t open = name.find('[');
  std::int64_t index = 0;
  if (open == 0 || open == name.npos || name.back() != ']')
    return {name, 0};
  const std::string inside = name.substr(open + 1, name.size() - open - 2);
  const char* const end = parseInteger(inside.c_str(), index);
  if (!end || *end != '\0' || index < 1)
    return {name, 0};
  return {name.substr(0, open), static_cast<std::size_t>(index)};
}

/// How many of the names that follow one another from `first` on make one vector, and its name.
std::size_t groupLength(const Names& names, std::size_t first, std::string& group)
{
  const Indexed indexed = splitIndex(names[first]);
  if (indexed.index == 1)
  {
    std::size_t length = 1;
    while (first + length < names.size())
    {
      const Indexed next = splitIndex(names[first + length]);
      if (next.base != indexed.base || next.index != length + 1)
        break;
      ++length;
    }
    group = indexed.base;
    return length;
  }
  for (const char* vector : {"v", "f", "mu", "omega", "angmom", "tq"})
  {
    const std::string base = vector;
    if (first + 2 < names.size() && names[first] == base + 'x' && names[first + 1] == base + 'y' &&
        names[first + 2] == base + 'z')
    {
      group = base;
      return 3;
    }
  }
  return 1;
}

/// Whether LAMMPS defines a column of this name, and defines it as a number.
bool isNumberOfLAMMPS(const std::string& name)
{
  for (const char* prefix : {"c_", "f_", "v_", "i_", "d_", "i2_", "d2_"})
    if (name.starts_with(prefix))
      return true;
  return isOneOf(
    name, {"id", "mol", "proc", "procp1", "mass", "x", "y", "z", "xs", "ys", "zs", "xu", "yu", "zu",
            "xsu", "ysu", "zsu", "ix", "iy", "iz", "vx", "vy", "vz", "fx", "fy", "fz", "q", "mux",
            "muy", "muz", "mu", "radius", "diameter", "omegax", "omegay", "omegaz", "angmomx",
            "angmomy", "angmomz", "tqx", "tqy", "tqz"});
}

} // namespace

LAMMPSLayout layoutOf(const Names& columns, bool combine)
{
  LAMMPSLayout layout;
  std::vector<bool> used(columns.size(), false);
  // A name stands for the same values each time: LIGGGHTS' own examples have "id type type x y z".
  for (std::size_t i = 1; i < columns.size(); ++i)
    used[i] = std::find(columns.begin(), columns.begin() + i, columns[i]) != columns.begin() + i;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::string letter(1, static_cast<char>('x' + axis));
    auto found = columns.end();
    for (const char* suffix : {"", "u", "s", "su"})
    {
      found = std::find(columns.begin(), columns.end(), letter + suffix);
      if (found != columns.end())
      {
        const auto column = static_cast<std::size_t>(found - columns.begin());
        layout.coordinates[axis] = {column, suffix[0] == 's'};
        used[column] = true;
        break;
      }
    }
    if (found == columns.end() && layout.missing.empty())
      layout.missing = letter;
  }
  for (std::size_t first = 0; first < columns.size();)
  {
    std::string name = columns[first];
    const std::size_t length = combine && !used[first] ? groupLength(columns, first, name) : 1;
    if (!used[first])
    {
      ColumnGroup array = {length > 1 ? name : columns[first], {}};
      for (std::size_t i = 0; i < length; ++i)
        array.columns.push_back(first + i);
      layout.arrays.push_back(std::move(array));
    }
    first += length;
  }
  return layout;
}

ColumnType typeOf(const std::string& column, const std::string& firstValue)
{
  if (isOneOf(column, {"element", "typelabel"}))
    return ColumnType::String;
  double number = 0;
  if (!isNumberOfLAMMPS(column) && !firstValue.empty() && !parseDouble(firstValue.c_str(), number))
    return ColumnType::String;
  if (isOneOf(column, {"id", "mol"}))
    return ColumnType::Int64;
  if (isOneOf(column, {"type", "proc", "procp1", "ix", "iy", "iz"}))
    return ColumnType::Int32;
  return ColumnType::Float64;
}

LAMMPSPlacement::LAMMPSPlacement(
  const LAMMPSFrame& frame, const LAMMPSLayout& layout, const std::string& path)
  : m_box(frame.box)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    m_scaled[axis] = layout.coordinates[axis].scaled;
  const std::size_t count = m_scaled[0] + m_scaled[1] + m_scaled[2];
  if (count > 0 && !m_box.known)
  {
    throw FileError(FileError::Kind::Malformed, path,
      "scaled coordinates need 'ITEM: BOX BOUNDS' before them", frame.columnsLine);
  }
  if (count > 0 && count < 3 && m_box.general)
  {
    throw FileError(FileError::Kind::Malformed, path,
      "in a general triclinic box either all coordinates are scaled or none", frame.columnsLine);
  }
}

void LAMMPSPlacement::apply(double* positions, std::uint64_t first, std::uint64_t count) const
{
  const auto& [a, b, c] = m_box.cell;
  const auto& origin = m_box.origin;
  for (double* p = positions + 3 * first; p != positions + 3 * (first + count); p += 3)
  {
    if (m_box.general)
    {
      applyGeneral(p);
      continue;
    }
    // The cell is lower triangular: z needs no other coordinate, y needs z, x needs both. A
    // coordinate that is a length already still has a fraction for the others to use.
    const double zs = m_scaled[2] ? p[2] : (c[2] != 0 ? (p[2] - origin[2]) / c[2] : 0);
    const double yz = c[1] != 0 ? zs * c[1] : 0;
    const double ys = m_scaled[1] ? p[1] : (b[1] != 0 ? (p[1] - origin[1] - yz) / b[1] : 0);
    const double xy = b[0] != 0 ? ys * b[0] : 0;
    const double xz = c[0] != 0 ? zs * c[0] : 0;
    p[0] = m_scaled[0] ? origin[0] + p[0] * a[0] + xy + xz : p[0];
    p[1] = m_scaled[1] ? origin[1] + p[1] * b[1] + yz : p[1];
    p[2] = m_scaled[2] ? origin[2] + p[2] * c[2] : p[2];
  }
}

void LAMMPSPlacement::applyGeneral(double* position) const
{
  const double s[3] = {position[0], position[1], position[2]};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    position[axis] = m_box.origin[axis] + s[0] * m_box.cell[0][axis] + s[1] * m_box.cell[1][axis] +
                     s[2] * m_box.cell[2][axis];
  }
}

} // namespace mote
