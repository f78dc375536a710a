#include "XYZFile.h"

#include "FileError.h"
#include "MostArrays.h"
#include "ParseNumber.h"

#include <cmath>

namespace mote
{
namespace
{

/// The value of KEY=value in a comment, without quotes; empty if there is none.
std::string valueOf(const std::string& comment, const std::string& key)
{
  std::size_t at = comment.find(key + '=');
  while (at != comment.npos && at > 0 && comment[at - 1] != ' ' && comment[at - 1] != '\t')
    at = comment.find(key + '=', at + 1);
  if (at == comment.npos)
    return {};
  std::string value = comment.substr(at + key.size() + 1);
  const bool isQuoted = !value.empty() && value[0] == '"';
  value = value.substr(isQuoted, value.find_first_of(isQuoted ? "\"" : " \t", isQuoted) - isQuoted);
  return value;
}

/// The number after "Timestep: ", as LAMMPS has it, or of Time= in a comment.
bool timestepOf(const std::string& comment, double& time)
{
  const std::string key = "Timestep: ";
  const std::size_t at = comment.find(key);
  if (at != comment.npos)
    return parseDouble(comment.c_str() + at + key.size(), time);
  std::string value = valueOf(comment, "Time");
  if (value.empty())
    value = valueOf(comment, "time");
  return !value.empty() && parseDouble(value.c_str(), time);
}

/// Numbers with blanks between; whether there are as many, all finite, and nothing else.
template <std::size_t count>
bool parseNumbers(const std::string& text, std::array<double, count>& numbers)
{
  const std::vector<std::string> values = splitValues(text);
  if (values.size() != count)
    return false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const char* end = parseDouble(values[i].c_str(), numbers[i]);
    if (!end || *end != '\0' || !std::isfinite(numbers[i]))
      return false;
  }
  return true;
}

void setTimes(std::vector<XYZFrame>& frames)
{
  bool written = true;
  double last = 0;
  for (XYZFrame& frame : frames)
  {
    const bool first = &frame == &frames.front();
    written = written && timestepOf(frame.comment, frame.time) && (first || frame.time > last);
    last = frame.time;
  }
  for (std::size_t i = 0; !written && i < frames.size(); ++i)
    frames[i].time = static_cast<double>(i);
}

void skipRows(TextCursor& cursor, XYZFrame& frame, const Progress& progress)
{
  std::string_view line;
  for (std::uint64_t row = 0; row < frame.atoms; ++row)
  {
    if (!cursor.nextLine(line))
    {
      throw FileError(FileError::Kind::Truncated, cursor.path(),
        "the file ends after " + std::to_string(row) + " of " + std::to_string(frame.atoms) +
          " atoms: it is truncated",
        cursor.line());
    }
    if (row % 65536 == 0 && progress && !progress(cursor.fraction()))
      throw FileError(FileError::Kind::Aborted, cursor.path(), "reading was aborted");
  }
}

std::vector<std::string> splitAtColons(const std::string& text)
{
  std::vector<std::string> fields(1);
  for (const char c : text)
    if (c == ':')
      fields.emplace_back();
    else
      fields.back().push_back(c);
  return fields;
}

void addGroup(XYZLayout& layout, const std::string& name, ColumnType type, std::int64_t count)
{
  ColumnGroup group = {name, {}};
  for (std::int64_t i = 0; i < count; ++i)
  {
    group.columns.push_back(layout.columns.size());
    layout.columns.push_back(count == 1 ? name : name + "[" + std::to_string(i + 1) + "]");
    layout.types.push_back(type);
  }
  layout.arrays.push_back(std::move(group));
}

XYZLayout extendedLayout(
  const std::string& path, const XYZFrame& frame, const std::string& properties)
{
  const auto refuse = [&](const std::string& sentence)
  { return FileError(FileError::Kind::Malformed, path, sentence, frame.commentLine); };
  XYZLayout layout;
  bool placed = false;
  const std::vector<std::string> fields = splitAtColons(properties);
  if (fields.size() > 3 * mostArrays)
    throw refuse(tooMany("properties"));
  for (std::size_t i = 0; i < fields.size(); i += 3)
  {
    std::int64_t count = 0;
    const bool whole = i + 2 < fields.size() && fields[i + 1].size() == 1 &&
                       std::string("RISL").find(fields[i + 1]) != std::string::npos &&
                       parseInteger(fields[i + 2].c_str(), count) && count > 0 && count <= 1000;
    if (!whole)
    {
      throw refuse("expected Properties=name:type:count:... with types R, I, S, L, found '" +
                   properties + "'");
    }
    const char type = fields[i + 1][0];
    if ((fields[i] == "pos" || fields[i] == "positions") && type == 'R' && count == 3)
    {
      const std::size_t first = layout.columns.size();
      addGroup(layout, fields[i], ColumnType::Float64, 3);
      layout.arrays.pop_back(); // these are the points
      layout.coordinates = {first, first + 1, first + 2};
      placed = true;
      continue;
    }
    addGroup(layout,
      fields[i].empty() ? unnamedColumn(layout.columns.size() + 1, fields) : fields[i],
      type == 'R'   ? ColumnType::Float64
      : type == 'I' ? ColumnType::Int32
                    : ColumnType::String,
      count);
    if (type == 'S' && count == 1 && layout.species.empty())
      layout.species = layout.arrays.back().name;
  }
  if (!placed)
    throw refuse("the properties have no positions (pos:R:3): '" + properties + "'");
  return layout;
}

} // namespace

std::vector<XYZFrame> indexXYZ(const std::string& path, const Progress& progress)
{
  TextCursor cursor(path, TextCursor::OpenEnd::Accept);
  std::vector<XYZFrame> frames;
  std::string_view line;
  while (cursor.nextLine(line))
  {
    const std::vector<std::string> values = splitValues(line);
    if (values.empty() && !frames.empty())
      continue; // blank lines at the end
    std::int64_t atoms = -1;
    if (values.size() != 1 || !parseInteger(values[0].c_str(), atoms) || atoms < 0)
    {
      throw FileError(frames.empty() ? FileError::Kind::OtherFormat : FileError::Kind::Malformed,
        path,
        "expected the number of atoms of an XYZ frame, found '" + std::string(line.substr(0, 40)) +
          "'",
        cursor.line() - 1);
    }
    XYZFrame frame;
    frame.atoms = static_cast<std::uint64_t>(atoms);
    frame.commentLine = cursor.line();
    if (!cursor.nextLine(line))
    {
      throw FileError(FileError::Kind::Truncated, path,
        "the file ends where a comment should follow: it is truncated", cursor.line());
    }
    frame.comment = line;
    frame.rows = cursor.place();
    skipRows(cursor, frame, progress);
    frames.push_back(std::move(frame));
  }
  if (frames.empty())
    throw FileError(FileError::Kind::Truncated, path, "the file is empty");
  setTimes(frames);
  return frames;
}

XYZLayout xyzLayout(
  const std::string& path, const XYZFrame& frame, const std::vector<std::string>& firstRow)
{
  const std::string properties = valueOf(frame.comment, "Properties");
  if (!properties.empty())
    return extendedLayout(path, frame, properties);
  std::int64_t number = 0;
  const bool numbered = !firstRow.empty() && parseInteger(firstRow[0].c_str(), number);
  XYZLayout layout;
  addGroup(
    layout, numbered ? "type" : "element", numbered ? ColumnType::Int32 : ColumnType::String, 1);
  layout.species = numbered ? "" : "element";
  for (const char* axis : {"x", "y", "z"})
  {
    layout.columns.emplace_back(axis);
    layout.types.push_back(ColumnType::Float64);
  }
  for (std::size_t i = layout.columns.size(); i < firstRow.size(); ++i)
  {
    double value = 0;
    const bool isNumber = parseDouble(firstRow[i].c_str(), value) != nullptr;
    addGroup(layout, unnamedColumn(i + 1), isNumber ? ColumnType::Float64 : ColumnType::String, 1);
  }
  return layout;
}

std::optional<XYZBox> xyzBox(const std::string& comment)
{
  XYZBox box;
  if (!parseNumbers(valueOf(comment, "Lattice"), box.vectors))
    return {};
  if (!parseNumbers(valueOf(comment, "Origin"), box.origin))
    box.origin = {};
  const std::vector<std::string> periods = splitValues(valueOf(comment, "pbc"));
  for (std::size_t i = 0; i < 3; ++i)
  {
    const bool isOpen =
      periods.size() == 3 && (periods[i][0] == 'F' || periods[i][0] == 'f' || periods[i] == "0");
    box.boundary += isOpen ? "ff " : "pp ";
  }
  box.boundary.pop_back();
  return box;
}

} // namespace mote
