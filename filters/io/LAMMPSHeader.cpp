#include "LAMMPSHeader.h"

#include "MostArrays.h"
#include "ParseNumber.h"
#include "TextRows.h"

#include <algorithm>
#include <cmath>

namespace mote
{
namespace
{

std::string_view trimmed(std::string_view text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == text.npos ? std::string_view()
                            : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string inQuotes(std::string_view text)
{
  return std::string("'").append(text.substr(0, 40)).append("'");
}

} // namespace

void setTilted(LAMMPSBox& box, const double (&rows)[3][3])
{
  const double xy = rows[0][2];
  const double xz = rows[1][2];
  const double yz = rows[2][2];
  const double xlo = rows[0][0] - std::min({0.0, xy, xz, xy + xz});
  const double xhi = rows[0][1] - std::max({0.0, xy, xz, xy + xz});
  const double ylo = rows[1][0] - std::min(0.0, yz);
  const double yhi = rows[1][1] - std::max(0.0, yz);
  const double zlo = rows[2][0];
  const double zhi = rows[2][1];
  box.origin = {xlo, ylo, zlo};
  box.cell = {{{xhi - xlo, 0, 0}, {xy, yhi - ylo, 0}, {xz, yz, zhi - zlo}}};
}

void LAMMPSHeader::refuse(const std::string& sentence) const
{
  throw FileError(FileError::Kind::Malformed, m_cursor.path(), sentence, m_cursor.line() - 1);
}

/// The line after an item's title.
std::string_view LAMMPSHeader::value(const char* what)
{
  std::string_view line;
  if (!m_cursor.nextLine(line))
  {
    throw FileError(FileError::Kind::Truncated, m_cursor.path(),
      std::string("the file ends where ") + what + " should follow: it is truncated",
      m_cursor.line());
  }
  return trimmed(line);
}

/// A line of `count` numbers.
void LAMMPSHeader::numbers(double* values, std::size_t count, const char* what)
{
  const std::string_view line = value(what);
  const std::vector<std::string> tokens = splitValues(line);
  bool good = tokens.size() == count;
  for (std::size_t i = 0; good && i < count; ++i)
    good = parseDouble(tokens[i].c_str(), values[i]) != nullptr && std::isfinite(values[i]);
  if (!good)
  {
    refuse(std::string("expected ") + what + " (" + std::to_string(count) +
           (count == 1 ? " number" : " numbers") + "), found " + inQuotes(line));
  }
}

bool LAMMPSHeader::read()
{
  std::string_view line;
  bool any = false;
  while (!m_hasAtoms)
  {
    if (!m_cursor.nextLine(line))
    {
      if (!any)
        return false;
      throw FileError(FileError::Kind::Truncated, m_cursor.path(),
        "the file ends within the header of a time step: it is truncated", m_cursor.line());
    }
    const std::string_view text = trimmed(line);
    if (text.empty())
      continue;
    any = true;
    if (!text.starts_with("ITEM: "))
      refuse("expected a line that begins with 'ITEM: ', found " + inQuotes(text));
    readItem(text.substr(6));
  }
  return true;
}

void LAMMPSHeader::readItem(std::string_view item)
{
  if (item == "UNITS")
  {
    m_frame.units = value("the name of the units");
  }
  else if (item == "TIME")
  {
    double time = 0;
    numbers(&time, 1, "the time");
    m_frame.time = time;
  }
  else if (item == "TIMESTEP")
  {
    readTimestep();
  }
  else if (item == "NUMBER OF ATOMS")
  {
    readAtomCount();
  }
  else if (item.starts_with("BOX BOUNDS"))
  {
    readBox(trimmed(item.substr(10)));
  }
  else if (item == "ATOMS" || item.starts_with("ATOMS "))
  {
    readColumns(item.substr(5));
  }
  else
  {
    refuse("'ITEM: " + std::string(item.substr(0, 40)) +
           "' belongs to no dump of atoms; local and grid dumps are not read");
  }
}

void LAMMPSHeader::readTimestep()
{
  if (m_hasTimestep)
    refuse("a second 'ITEM: TIMESTEP' before 'ITEM: ATOMS'");
  const std::string step(value("the number of the time step"));
  const char* const end = parseInteger(step.c_str(), m_frame.timestep);
  if (!end || *end != '\0')
    refuse("expected the number of the time step, found " + inQuotes(step));
  m_hasTimestep = true;
}

void LAMMPSHeader::readAtomCount()
{
  const std::string count(value("the number of atoms"));
  std::int64_t atoms = 0;
  const char* const end = parseInteger(count.c_str(), atoms);
  if (!end || *end != '\0' || atoms < 0)
    refuse("expected the number of atoms, an integer from 0 on, found " + inQuotes(count));
  m_frame.atoms = static_cast<std::uint64_t>(atoms);
  m_hasCount = true;
}

/// `item` is what follows BOX BOUNDS: "pp pp pp", "xy xz yz pp pp pp", "abc origin pp pp pp", "".
void LAMMPSHeader::readBox(std::string_view item)
{
  LAMMPSBox& box = m_frame.box;
  const bool tilted = item.starts_with("xy xz yz");
  box.general = item.starts_with("abc origin");
  const std::size_t kind = tilted ? 8 : box.general ? 10 : 0;
  box.boundary = trimmed(item.substr(kind));
  if (box.general)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double row[4] = {};
      numbers(row, 4, "a cell vector and the origin");
      box.cell[axis] = {row[0], row[1], row[2]};
      box.origin[axis] = row[3];
    }
  }
  else
  {
    double rows[3][3] = {};
    for (auto& row : rows)
    {
      numbers(
        row, tilted ? 3 : 2, tilted ? "low and high bounds and a tilt" : "low and high bounds");
    }
    setTilted(box, rows);
  }
  box.known = true;
}

void LAMMPSHeader::readColumns(std::string_view names)
{
  m_frame.columnsLine = m_cursor.line() - 1;
  m_hasAtoms = true;
  if (!m_hasTimestep || !m_hasCount)
  {
    refuse(m_hasTimestep ? "'ITEM: ATOMS' without a number of atoms before it"
                         : "'ITEM: ATOMS' without a time step before it");
  }
  std::vector<std::string> columns = splitValues(names);
  if (columns.empty())
    columns = {"id", "type", "xs", "ys", "zs"}; // dump style atom, before columns had names
  if (columns.size() > mostArrays)
    refuse(tooMany("columns"));
  // Frames of a file share their list.
  if (!m_frame.columns || *m_frame.columns != columns)
    m_frame.columns = std::make_shared<const std::vector<std::string>>(std::move(columns));
  m_frame.rows = m_cursor.place();
}

} // namespace mote
