#include "XYZFile.h"

#include "FileError.h"
#include "ParseNumber.h"

namespace mote
{
namespace
{

/// The number after "Timestep: " in a comment.
bool timestepOf(const std::string& comment, double& time)
{
  const std::string key = "Timestep: ";
  const std::size_t at = comment.find(key);
  return at != comment.npos && parseDouble(comment.c_str() + at + key.size(), time);
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

/// The value of Properties in a comment, without quotes; empty if there is none.
std::string propertiesOf(const std::string& comment)
{
  const std::size_t at = comment.find("Properties=");
  if (at == comment.npos)
    return {};
  std::string value = comment.substr(at + 11);
  const bool isQuoted = !value.empty() && value[0] == '"';
  value = value.substr(isQuoted, value.find_first_of(isQuoted ? "\"" : " \t", isQuoted) - isQuoted);
  return value;
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
  const std::string properties = propertiesOf(frame.comment);
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

} // namespace mote
