#include "PLYFile.h"

#include "FileError.h"
#include "ParseNumber.h"
#include "TextCursor.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <type_traits>

namespace mote
{
namespace
{

using Element = PLYHeader::Element;
using Property = PLYHeader::Property;

[[noreturn]] void failTruncated(const std::string& path)
{
  throw FileError(FileError::Kind::Truncated, path,
    "the file ends before all the elements that its header announces: it is truncated");
}

/// The values of a binary file, one after the other.
class BinaryValues
{
public:
  BinaryValues(const std::string& path, std::string_view bytes, bool bigEndian)
    : m_path(path)
    , m_bytes(bytes)
    , m_bigEndian(bigEndian)
  {
  }

  void beginElement() {}
  void endElement() {}

  double next(PLYHeader::Number number)
  {
    const char* const at = m_bytes.data();
    skip(number.bytes);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < number.bytes; ++i)
    {
      const std::size_t place = m_bigEndian ? number.bytes - 1 - i : i;
      bits |= std::uint64_t{static_cast<unsigned char>(at[i])} << (8 * place);
    }
    if (number.type == PLYHeader::Type::Unsigned)
      return static_cast<double>(bits);
    if (number.type == PLYHeader::Type::Signed)
    {
      const unsigned above = 64 - 8 * static_cast<unsigned>(number.bytes);
      return static_cast<double>(static_cast<std::int64_t>(bits << above) >> above);
    }
    return real(bits, number.bytes);
  }

  /// Passes values by without a look.
  void skip(std::uint64_t bytes)
  {
    if (m_bytes.size() < bytes)
      failTruncated(m_path);
    m_bytes.remove_prefix(bytes);
  }

  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw FileError(FileError::Kind::Malformed, m_path, sentence);
  }

private:
  static double real(std::uint64_t bits, std::size_t bytes)
  {
    if (bytes == sizeof(double))
    {
      double value = 0;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    }
    const auto narrow = static_cast<std::uint32_t>(bits);
    float value = 0;
    std::memcpy(&value, &narrow, sizeof value);
    return value;
  }

  const std::string& m_path;
  std::string_view m_bytes;
  bool m_bigEndian;
};

/// The values of a text file, of which every element has a line.
class TextValues
{
public:
  explicit TextValues(TextCursor& cursor)
    : m_cursor(cursor)
  {
  }

  void beginElement()
  {
    m_line = m_cursor.line();
    std::string_view line;
    if (!m_cursor.nextLine(line))
      failTruncated(m_cursor.path());
    if (line.size() > longestPLYLine)
      fail("a line of a PLY file has at most " + std::to_string(longestPLYLine) + " bytes");
    m_at = line.data();
    m_end = m_at + line.size();
  }

  void endElement()
  {
    skipBlanks();
    if (m_at != m_end)
      fail("this line has more values than its element");
  }

  double next(PLYHeader::Number /*number*/)
  {
    skipBlanks();
    if (m_at == m_end)
      fail("this line has fewer values than its element");
    double value = 0;
    const char* const end = parseDouble(m_at, value);
    if (!end)
      fail("expected a number, found '" + std::string(m_at, tokenEnd(m_at)) + "'");
    m_at = end;
    return value;
  }

  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw FileError(FileError::Kind::Malformed, m_cursor.path(), sentence, m_line);
  }

private:
  /// Blanks that other readers know.
  void skipBlanks()
  {
    while (m_at != m_end && (*m_at == ' ' || *m_at == '\t' || *m_at == '\r'))
      ++m_at;
  }

  TextCursor& m_cursor;
  std::uint64_t m_line = 0;
  const char* m_at = nullptr;
  const char* m_end = nullptr;
};

/// Whether a list is that of a face's corners.
bool areCorners(const Element& element, const Property& property)
{
  return element.name == "face" && property.name == "vertex_indices";
}

/// Where the values of an element go: to a column for each property, or null, and the corners of
/// faces.
struct Targets
{
  std::vector<PLYColumn*> columns;
  PLYFile* faces = nullptr;
};

template <class Values>
void walkList(
  Values& values, const Property& property, bool areCorners, double points, PLYFile* faces)
{
  constexpr int most = std::numeric_limits<int>::max();
  const double count = values.next(property.count);
  if (!(count >= 0 && count <= most))
  {
    char told[32]; // of any size, and no whole number, where the file is damaged
    std::snprintf(told, sizeof told, "%.15g", count);
    values.fail("a list of " + std::string(told) + " '" + property.name + "', and there can be " +
                std::to_string(most));
  }
  for (auto left = static_cast<std::uint64_t>(count); left > 0; --left)
  {
    const double value = values.next(property.value);
    if (!areCorners)
      continue;
    if (!(value >= 0 && value < points))
      values.fail("a face has a point that is not there: there are " +
                  std::to_string(static_cast<std::uint64_t>(points)) + " points, from 0");
    faces->corners.push_back(static_cast<std::int64_t>(value));
  }
  if (areCorners)
    faces->ends.push_back(static_cast<std::int64_t>(faces->corners.size()));
}

template <class Values>
void walk(Values& values, const Element& element, double points, const Targets& targets)
{
  for (std::uint64_t i = 0; i < element.count; ++i)
  {
    values.beginElement();
    for (std::size_t k = 0; k < element.properties.size(); ++k)
    {
      const Property& property = element.properties[k];
      if (property.isList())
        walkList(values, property, areCorners(element, property), points, targets.faces);
      else if (const double value = values.next(property.value); targets.columns[k])
        targets.columns[k]->add(value);
    }
    values.endElement();
  }
}

/// Whether the elements are vertices or faces.
bool isRead(const Element& element)
{
  return element.name == "vertex" || element.name == "face";
}

/// Vertices and faces come first.
void checkElements(const PLYHeader& header, const std::string& path)
{
  const auto fail = [&path](const std::string& sentence)
  { throw FileError(FileError::Kind::Malformed, path, sentence); };
  const Element* const vertex = header.find("vertex");
  if (!vertex || !vertex->find("x") || !vertex->find("y") || !vertex->find("z"))
    fail("a PLY file needs an element 'vertex' with x, y and z");
  const Element* const face = header.find("face");
  if (face && !face->find("vertex_indices"))
    fail("the element 'face' has no list 'vertex_indices'");
  const auto firstOther = std::find_if_not(header.elements.begin(), header.elements.end(), isRead);
  if (std::any_of(firstOther, header.elements.end(), isRead))
    fail("the element '" + firstOther->name + "' must stand behind vertices and faces");
}

/// Reads all values.
PLYFile readValues(const PLYHeader& header, const TextFile& file, TextCursor& cursor)
{
  PLYFile found;
  found.vertices = header.find("vertex")->count;
  const auto points = static_cast<double>(found.vertices);
  for (const Element& element : header.elements)
    for (const Property& property : element.properties)
      if (isRead(element) && !property.isList())
        found.columns.push_back({element.name, property.name, property.value, {}});
  TextValues text(cursor);
  BinaryValues binary(file.path(),
    file.text().substr(std::min<std::size_t>(cursor.offset(), file.text().size())),
    header.format == PLYHeader::Format::BigEndian);
  for (const Element& element : header.elements)
  {
    Targets targets{std::vector<PLYColumn*>(element.properties.size(), nullptr), &found};
    for (PLYColumn& column : found.columns)
      for (std::size_t k = 0; k < targets.columns.size() && column.element == element.name; ++k)
        if (element.properties[k].name == column.name)
          targets.columns[k] = &column;
    if (header.format == PLYHeader::Format::Text)
      walk(text, element, points, targets);
    else if (element.hasLists() || isRead(element))
      walk(binary, element, points, targets);
    else
      binary.skip(element.count * element.bytes());
  }
  return found;
}

template <class Value>
void append(std::vector<char>& bytes, double value)
{
  const auto own = static_cast<Value>(value);
  const auto* const at = reinterpret_cast<const char*>(&own);
  bytes.insert(bytes.end(), at, at + sizeof own);
}

template <class Value>
double valueAt(const std::vector<char>& bytes, std::size_t i)
{
  Value value;
  std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
  return static_cast<double>(value);
}

/// Calls visit(Value()) with the type of a number.
template <class Visit>
auto withType(const PLYHeader::Number& number, const Visit& visit)
{
  const bool isUnsigned = number.type == PLYHeader::Type::Unsigned;
  if (number.type == PLYHeader::Type::Float)
    return number.bytes == sizeof(double) ? visit(double()) : visit(float());
  switch (number.bytes)
  {
  case 1:
    return isUnsigned ? visit(std::uint8_t()) : visit(std::int8_t());
  case 2:
    return isUnsigned ? visit(std::uint16_t()) : visit(std::int16_t());
  default:
    return isUnsigned ? visit(std::uint32_t()) : visit(std::int32_t());
  }
}

} // namespace

double PLYColumn::value(std::size_t i) const
{
  return withType(number, [&](auto type) { return valueAt<decltype(type)>(bytes, i); });
}

void PLYColumn::add(double value)
{
  withType(number,
    [&](auto type)
    {
      using Value = decltype(type);
      // What a text says of a type that cannot hold it.
      if constexpr (std::is_integral_v<Value>)
        value = value >= double(std::numeric_limits<Value>::min()) &&
                    value <= double(std::numeric_limits<Value>::max())
                  ? value
                  : 0.0;
      append<Value>(bytes, value);
    });
}

const PLYColumn* PLYFile::find(std::string_view element, std::string_view name) const
{
  const auto found = std::find_if(columns.begin(), columns.end(),
    [&](const PLYColumn& column) { return column.element == element && column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

PLYFile readPLY(const std::string& path)
{
  const TextFile file(path);
  if (file.isGzip())
    throw FileError(FileError::Kind::OtherFormat, path,
      "PLY is not read from gzip files; unpack it first (gunzip)");
  TextCursor cursor(path, TextCursor::OpenEnd::Accept);
  const PLYHeader header = readPLYHeader(cursor);
  checkElements(header, path);
  return readValues(header, file, cursor);
}

} // namespace mote
