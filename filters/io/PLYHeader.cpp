#include "PLYHeader.h"

#include "FileError.h"
#include "MostArrays.h"
#include "TextCursor.h"
#include "TextRows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace mote
{
namespace
{

using Words = std::vector<std::string>;
using Element = PLYHeader::Element;
using Property = PLYHeader::Property;
using Type = PLYHeader::Type;

struct NamedNumber
{
  const char* name;
  PLYHeader::Number number;
};

constexpr NamedNumber numbers[] = {{"char", {Type::Signed, 1}}, {"int8", {Type::Signed, 1}},
  {"uchar", {Type::Unsigned, 1}}, {"uint8", {Type::Unsigned, 1}}, {"short", {Type::Signed, 2}},
  {"int16", {Type::Signed, 2}}, {"ushort", {Type::Unsigned, 2}}, {"uint16", {Type::Unsigned, 2}},
  {"int", {Type::Signed, 4}}, {"int32", {Type::Signed, 4}}, {"uint", {Type::Unsigned, 4}},
  {"uint32", {Type::Unsigned, 4}}, {"float", {Type::Float, 4}}, {"float32", {Type::Float, 4}},
  {"double", {Type::Float, 8}}, {"float64", {Type::Float, 8}}};

/// Names that vtkPLYReader takes for a list, or for one value, without a look at which it is.
bool isTakenAsList(const std::string& name)
{
  return name == "vertex_indices" || name == "texcoord";
}

bool isTakenAsValue(const std::string& name)
{
  static const std::array names = {"x", "y", "z", "u", "v", "s", "t", "texture_u", "texture_v",
    "nx", "ny", "nz", "red", "green", "blue", "alpha", "diffuse_red", "diffuse_green",
    "diffuse_blue", "intensity", "texnumber"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Items>
bool holds(const Items& items, const std::string& name)
{
  return std::any_of(
    items.begin(), items.end(), [&name](const auto& item) { return item.name == name; });
}

/// Reads a header line by line.
class HeaderReader
{
public:
  explicit HeaderReader(TextCursor& cursor)
    : m_cursor(cursor)
  {
  }

  PLYHeader read()
  {
    std::string_view line;
    if (!m_cursor.nextLine(line) || line != "ply")
      throw FileError(FileError::Kind::OtherFormat, m_cursor.path(),
        "this is no PLY file: its header is missing");
    Words words;
    while (words = nextWords(), words.front() != "end_header")
      take(words);
    if (!m_hasFormat)
      fail("the header ends without a line 'format'");
    checkLastElement();
    return std::move(m_header);
  }

private:
  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw FileError(
      FileError::Kind::Malformed, m_cursor.path(), sentence, std::max<std::uint64_t>(m_line, 1));
  }

  Words nextWords()
  {
    m_line = m_cursor.line();
    std::string_view line;
    if (!m_cursor.nextLine(line))
      throw FileError(FileError::Kind::Truncated, m_cursor.path(),
        "the file ends in its header, before 'end_header'");
    if (line.size() > longestPLYLine)
      fail("this line of the header is longer than " + std::to_string(longestPLYLine) + " bytes");
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; };
    if (std::any_of(line.begin(), line.end(), isControl))
      fail("this line of the header holds control characters");
    Words words = splitValues(line);
    if (words.empty())
      fail("this line of the header is empty");
    return words;
  }

  void take(const Words& words)
  {
    const std::string& first = words.front();
    if (first == "format")
      takeFormat(words);
    else if (first == "element")
      takeElement(words);
    else if (first == "property")
      takeProperty(words);
    else if (first != "comment" && first != "obj_info")
      fail("a line of a PLY header does not begin with '" + first + "'");
  }

  void takeFormat(const Words& words)
  {
    const std::string name = words.size() == 3 ? words[1] : "";
    if (name == "ascii")
      m_header.format = PLYHeader::Format::Text;
    else if (name == "binary_little_endian")
      m_header.format = PLYHeader::Format::LittleEndian;
    else if (name == "binary_big_endian")
      m_header.format = PLYHeader::Format::BigEndian;
    else
      fail("expected 'format ascii 1.0', or binary_little_endian or binary_big_endian");
    m_hasFormat = true;
  }

  void takeElement(const Words& words)
  {
    checkLastElement();
    if (words.size() != 3)
      fail("expected 'element NAME COUNT'");
    Element element;
    element.name = words[1];
    const std::string& count = words[2];
    const auto [end, error] =
      std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error != std::errc() || end != count.data() + count.size() ||
        element.count > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
      fail("expected a number of elements up to 2147483647, found '" + count + "'");
    if (holds(m_header.elements, element.name) ||
        element.name.find("vertex_index") != std::string::npos)
      fail("an element cannot be called '" + element.name + "' here");
    if (m_header.elements.size() == mostArrays)
      fail(tooMany("elements"));
    m_header.elements.push_back(std::move(element));
  }

  void takeProperty(const Words& words)
  {
    if (m_header.elements.empty())
      fail("a property stands before the first element");
    const bool list = words.size() > 1 && words[1] == "list";
    if (words.size() != (list ? 5u : 3u))
      fail("expected 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
    Property property;
    property.name = nameOf(words.back());
    property.value = numberOf(words[list ? 3 : 1]);
    if (list)
      property.count = numberOf(words[2]);
    if (property.count.type == Type::Float)
      fail("the number of a list's values is no " + words[2]);
    std::vector<Property>& properties = m_header.elements.back().properties;
    if (holds(properties, property.name))
      fail("a second property '" + property.name + "' of one element");
    if (list ? isTakenAsValue(property.name) : isTakenAsList(property.name))
      fail("'" + property.name + (list ? "' is one value, no list" : "' is a list"));
    if (properties.size() == mostArrays)
      fail(tooMany("properties"));
    properties.push_back(std::move(property));
  }

  /// vtkPLYReader calls everything that begins like this by one name.
  static std::string nameOf(const std::string& written)
  {
    const std::size_t at = written.find("vertex_index");
    return at == written.npos ? written : written.substr(0, at) + "vertex_indices";
  }

  PLYHeader::Number numberOf(const std::string& name) const
  {
    for (const NamedNumber& known : numbers)
    {
      if (name == known.name)
        return known.number;
    }
    fail("'" + name + "' is no type of a PLY file");
  }

  void checkLastElement() const
  {
    if (!m_header.elements.empty() && m_header.elements.back().properties.empty())
      fail("the element '" + m_header.elements.back().name + "' has no properties");
  }

  TextCursor& m_cursor;
  PLYHeader m_header;
  bool m_hasFormat = false;
  std::uint64_t m_line = 0;
};

} // namespace

const PLYHeader::Property* PLYHeader::Element::find(const std::string& property) const
{
  const auto found = std::find_if(properties.begin(), properties.end(),
    [&property](const Property& one) { return one.name == property; });
  return found == properties.end() ? nullptr : &*found;
}

bool PLYHeader::Element::hasLists() const
{
  return std::any_of(
    properties.begin(), properties.end(), [](const Property& one) { return one.isList(); });
}

std::size_t PLYHeader::Element::bytes() const
{
  std::size_t bytes = 0;
  for (const Property& property : properties)
    bytes += property.value.bytes;
  return bytes;
}

const PLYHeader::Element* PLYHeader::find(const std::string& element) const
{
  const auto found = std::find_if(elements.begin(), elements.end(),
    [&element](const Element& one) { return one.name == element; });
  return found == elements.end() ? nullptr : &*found;
}

PLYHeader readPLYHeader(TextCursor& cursor)
{
  return HeaderReader(cursor).read();
}

} // namespace mote
