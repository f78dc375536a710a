#include "PointTable.h"

#include "FileError.h"
#include "MostArrays.h"
#include "ParseNumber.h"
#include "TextLine.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

namespace mote
{
namespace
{

using Names = std::vector<std::string>;

/// Lines above the names of the columns that are looked at.
constexpr int mostLinesAbove = 100;

/// What separates the values of a line: the most frequent of comma, semicolon and tab that stands
/// outside of quotes, or blanks.
char separatorOf(std::string_view line)
{
  char best = ' ';
  std::ptrdiff_t most = 0;
  for (const char candidate : {',', ';', '\t'})
  {
    bool isQuoted = false;
    const auto count = std::count_if(line.begin(), line.end(),
      [&](char c)
      {
        isQuoted = isQuoted != (c == '"');
        return !isQuoted && c == candidate;
      });
    if (count > most)
    {
      best = candidate;
      most = count;
    }
  }
  return best;
}

bool isNumber(const std::string& text)
{
  double value = 0.0;
  return parseDouble((text + '\n').c_str(), value) != nullptr && text.find('\n') == text.npos;
}

bool areNumbers(const Names& values)
{
  return std::all_of(values.begin(), values.end(), isNumber);
}

std::string withDecimalPoint(std::string text)
{
  std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

/// A line without the marks of a comment; whether it had any.
bool takeComment(std::string_view& line)
{
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  const std::string_view text = line.substr(begin);
  const bool isComment = text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
  if (isComment)
    line.remove_prefix(std::min(line.find_first_not_of("#%/ \t"), line.size()));
  return isComment;
}

/// A name in small letters, without the unit behind it and what stands between its words:
/// "X [ m ]" is x, "Points:0" points0.
std::string plainName(const std::string& name)
{
  const std::size_t unit = name.find_first_of("([");
  std::string plain;
  for (const char c : name.substr(0, unit == 0 ? name.npos : unit))
    if (std::string_view(" \t-_.:").find(c) == std::string_view::npos)
      plain.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  return plain;
}

/// How well a name is that of a coordinate: 0 best; none where it is not.
std::optional<int> rankOf(const std::string& name, int axis)
{
  const std::string letter(1, static_cast<char>('x' + axis)), digit = std::to_string(axis);
  if (name.size() == 1 && std::tolower(static_cast<unsigned char>(name[0])) == letter[0])
    return 0;
  const std::string plain = plainName(name);
  if (plain == letter)
    return 1;
  for (const std::string stem :
    {"coordinate", "coordinates", "coord", "coords", "position", "positions", "pos", "points"})
    if (plain == letter + stem || plain == stem + letter || plain == stem + digit)
      return 2;
  return std::nullopt;
}

/// The columns of x, y and z; PointRows::none for what there is not.
std::array<std::size_t, 3> coordinatesOf(const Names& names)
{
  std::array<std::size_t, 3> columns = {PointRows::none, PointRows::none, PointRows::none};
  for (int axis = 0; axis < 3; ++axis)
  {
    int best = 3;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const std::optional<int> rank = rankOf(names[i], axis); rank && *rank < best)
      {
        best = *rank;
        columns[axis] = i;
      }
  }
  return columns;
}

bool hasCoordinates(const Names& names)
{
  const auto columns = coordinatesOf(names);
  return columns[0] != PointRows::none && columns[1] != PointRows::none;
}

/// The first line from the cursor on that is not blank, which stays the next one; false where there
/// is none.
bool findRow(TextCursor& cursor, std::string_view& line)
{
  RowFormat format;
  while (cursor.peekLine(line))
  {
    format.separator = separatorOf(line);
    if (!isBlankLine(line, format))
      return true;
    cursor.nextLine(line);
  }
  return false;
}

/// Names of a line, and what separates them.
struct Head
{
  Names names;
  char separator = ' ';
};

Head headOf(std::string_view line)
{
  Head head;
  head.separator = separatorOf(line);
  head.names = splitValues(line, {head.separator});
  // Tabs and blanks may be mixed.
  if (head.separator == '\t' && !hasCoordinates(head.names) && !areNumbers(head.names))
    head = {splitValues(line), ' '};
  return head;
}

/// Without what is behind a last separator.
std::size_t countOf(const Names& names)
{
  return names.size() - (names.size() > 1 && names.back().empty());
}

/// Of columns without names: what three or more numbers of a row are.
Names namesOfNumbers(std::size_t count)
{
  Names names = {"x", "y", "z"};
  while (names.size() < count)
    names.push_back(unnamedColumn(names.size() + 1));
  return names;
}

/// What a file has in place of coordinates.
[[noreturn]] void failWithoutNames(const std::string& path, const Names& first, std::uint64_t line)
{
  std::string names;
  for (const std::string& name : first)
    names.append(names.empty() ? "'" : ", '").append(name).append("'");
  throw FileError(FileError::Kind::Malformed, path,
    "no column is named 'x'; points need columns x, y and mostly z, and here are " + names, line);
}

/// Finds the line with the names, and leaves the cursor behind it: the first one with those of x
/// and y. A comment is it where the row below has as many values. Numbers in the first line are
/// those of columns without names.
Head findHead(TextCursor& cursor)
{
  std::string_view line;
  Names first;
  std::uint64_t firstLine = 1;
  for (int above = 0; above < mostLinesAbove && findRow(cursor, line); ++above)
  {
    if (cursor.line() == 1 && line.starts_with("\xEF\xBB\xBF")) // the mark of UTF-8
      line.remove_prefix(3);
    const bool isComment = takeComment(line);
    Head head = headOf(line);
    const std::uint64_t number = cursor.line();
    if (!isComment && first.empty())
    {
      first = head.names;
      firstLine = number;
      Names values = head.names;
      if (head.separator != ',')
        std::transform(values.begin(), values.end(), values.begin(), withDecimalPoint);
      if (values.size() > mostArrays)
        throw FileError(FileError::Kind::Malformed, cursor.path(), tooMany("columns"), number);
      if (values.size() >= 3 && areNumbers(values))
        return {namesOfNumbers(values.size()), head.separator};
    }
    cursor.nextLine(line);
    if (!hasCoordinates(head.names))
      continue;
    if (!isComment)
      return head;
    std::string_view row;
    const Head below = findRow(cursor, row) ? headOf(row) : Head();
    if (countOf(below.names) == countOf(head.names) && !hasCoordinates(below.names))
      return {head.names, below.separator};
  }
  if (first.empty())
    throw FileError(FileError::Kind::Truncated, cursor.path(),
      cursor.offset() == 0 ? "the file is empty" : "the table has no row");
  failWithoutNames(cursor.path(), first, firstLine);
}

/// Whether the columns from one on are the components of a vector, "U:0", "U:1" ...; how many.
std::size_t componentsAt(const PointRows& rows, std::size_t from, char mark)
{
  const auto begin = [&](std::size_t column, std::size_t component) -> std::string
  {
    const std::string& name = rows.columns[column];
    const std::string end = mark + std::to_string(component);
    return name.ends_with(end) ? name.substr(0, name.size() - end.size()) : "";
  };
  const std::string name = begin(from, 0);
  std::size_t count = name.empty() ? 0 : 1;
  while (count > 0 && from + count < rows.columns.size() && begin(from + count, count) == name)
    ++count;
  const bool areNumbers = std::all_of(rows.types.begin() + from, rows.types.begin() + from + count,
    [](ColumnType type) { return type == ColumnType::Int32 || type == ColumnType::Float64; });
  return count > 1 && areNumbers ? count : 0;
}

/// Makes arrays of the columns that are no coordinates: vectors where names say so, as those that
/// ParaView writes do.
void groupColumns(PointRows& rows)
{
  const auto& axes = rows.coordinates;
  const auto isAxis = [&](std::size_t i)
  { return std::find(axes.begin(), axes.end(), i) != axes.end(); };
  // Newer ones write U_0, which others may mean otherwise: where the points are so, too.
  const char mark = rows.columns[axes[0]].ends_with("_0") ? '_' : ':';
  for (std::size_t i = 0; i < rows.columns.size();)
  {
    const std::size_t count = isAxis(i) ? 1 : std::max<std::size_t>(1, componentsAt(rows, i, mark));
    if (!isAxis(i))
    {
      const std::string& name = rows.columns[i];
      ColumnGroup group = {count > 1 ? name.substr(0, name.size() - 2) : name, {}, false};
      ColumnType type = rows.types[i];
      for (std::size_t k = i; k < i + count; ++k)
      {
        group.columns.push_back(k);
        type = rows.types[k] == ColumnType::Float64 ? rows.types[k] : type;
      }
      for (const std::size_t k : group.columns)
        rows.types[k] = type;
      rows.arrays.push_back(std::move(group));
    }
    i += count;
  }
}

} // namespace

void checkPointTable(const std::string& path)
{
  if (readBeginning(path, 4096).find('\0') != std::string::npos)
    throw FileError(
      FileError::Kind::OtherFormat, path, "this is a binary file, not a table of text");
  TextCursor cursor(path, TextCursor::OpenEnd::Accept);
  readTableHead(cursor);
}

PointRows readTableHead(TextCursor& cursor)
{
  Head head = findHead(cursor);
  std::string_view line;
  if (!findRow(cursor, line))
    throw FileError(FileError::Kind::Truncated, cursor.path(),
      "the table has no row below the names of its columns");
  PointRows rows;
  rows.format.separator = head.separator;
  rows.format.skipsBlankLines = true;
  rows.mayBeText = true;
  rows.place = cursor.place();
  rows.coordinates = coordinatesOf(head.names);
  const Names values = splitValues(line, rows.format);
  if (countOf(head.names) < head.names.size() && countOf(values) < head.names.size())
    head.names.pop_back();
  const auto hasComma = [&](std::size_t column)
  {
    return column < values.size() && !isNumber(values[column]) &&
           isNumber(withDecimalPoint(values[column]));
  };
  if (head.separator != ',' &&
      std::any_of(rows.coordinates.begin(), rows.coordinates.end(), hasComma))
    rows.format.decimalPoint = ',';
  for (std::size_t i = 0; i < head.names.size(); ++i)
  {
    rows.columns.push_back(
      head.names[i].empty() ? unnamedColumn(i + 1, head.names) : head.names[i]);
    std::string value = i < values.size() ? values[i] : "";
    if (rows.format.decimalPoint == ',')
      value = withDecimalPoint(value);
    std::int32_t integer = 0;
    const bool isInteger = parseInteger((value + '\n').c_str(), integer) != nullptr;
    rows.types.push_back(isInteger || value.empty() ? ColumnType::Int32
                         : isNumber(value)          ? ColumnType::Float64
                                                    : ColumnType::String);
  }
  groupColumns(rows);
  return rows;
}

} // namespace mote
