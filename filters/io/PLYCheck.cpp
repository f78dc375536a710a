#include "PLYCheck.h"

#include "FileError.h"
#include "TextCursor.h"
#include "TextRows.h"

#include <cstring>
#include <vector>

namespace mote
{
namespace
{

/// A property: one value, or a list of values after their number.
struct Property
{
  std::size_t countBytes = 0; ///< of a list's number of values; 0 for one value
  std::size_t valueBytes = 0;
};

struct Element
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header
{
  enum class Format
  {
    None, ///< no PLY header
    Text,
    LittleEndian,
    BigEndian
  };
  Format format = Format::None;
  std::vector<Element> elements;
};

std::size_t bytesOf(const std::string& type)
{
  for (const char* name : {"char", "uchar", "int8", "uint8"})
    if (type == name)
      return 1;
  for (const char* name : {"short", "ushort", "int16", "uint16"})
    if (type == name)
      return 2;
  return type == "double" || type == "float64" ? 8 : 4;
}

/// Parses the header; the cursor then stands behind it.
Header readHeader(TextCursor& cursor)
{
  Header header;
  std::string_view line;
  if (!cursor.nextLine(line) || line != "ply")
    return header;
  Header::Format format = Header::Format::None;
  while (cursor.nextLine(line) && !line.starts_with("end_header"))
  {
    const std::vector<std::string> words = splitValues(line);
    if (words.size() >= 2 && words[0] == "format")
    {
      format = words[1] == "ascii"               ? Header::Format::Text
               : words[1] == "binary_big_endian" ? Header::Format::BigEndian
                                                 : Header::Format::LittleEndian;
    }
    else if (words.size() >= 3 && words[0] == "element")
    {
      header.elements.push_back({words[1], std::strtoull(words[2].c_str(), nullptr, 10), {}});
    }
    else if (words.size() >= 3 && words[0] == "property" && !header.elements.empty())
    {
      const bool list = words[1] == "list" && words.size() >= 5;
      header.elements.back().properties.push_back(
        list ? Property{bytesOf(words[2]), bytesOf(words[3])} : Property{0, bytesOf(words[1])});
    }
  }
  header.format = line.starts_with("end_header") ? format : Header::Format::None;
  return header;
}

std::uint64_t readCount(const char* at, std::size_t bytes, bool bigEndian)
{
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < bytes; ++i)
  {
    const std::size_t place = bigEndian ? bytes - 1 - i : i;
    count |= std::uint64_t{static_cast<unsigned char>(at[i])} << (8 * place);
  }
  return count;
}

/// Whether the bytes hold all elements of a binary file.
bool isWhole(std::string_view bytes, const Header& header)
{
  const bool bigEndian = header.format == Header::Format::BigEndian;
  for (const Element& element : header.elements)
  {
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
    {
      for (const Property& property : element.properties)
      {
        if (bytes.size() < property.countBytes)
          return false;
        const std::uint64_t count =
          property.countBytes > 0 ? readCount(bytes.data(), property.countBytes, bigEndian) : 1;
        bytes.remove_prefix(property.countBytes);
        if (bytes.size() / property.valueBytes < count)
          return false;
        bytes.remove_prefix(count * property.valueBytes);
      }
    }
  }
  return true;
}

} // namespace

void checkPLYIsWhole(const std::string& path)
{
  const TextFile file(path);
  TextCursor cursor(path, TextCursor::OpenEnd::Accept);
  const Header header = readHeader(cursor);
  if (file.isGzip() || header.format == Header::Format::None)
  {
    throw FileError(FileError::Kind::OtherFormat, path,
      file.isGzip() ? "PLY is not read from gzip files; unpack it first (gunzip)"
                    : "this is no PLY file: its header is missing or damaged");
  }
  bool whole = true;
  if (header.format == Header::Format::Text)
  {
    std::uint64_t expected = 0;
    for (const Element& element : header.elements)
      expected += element.count;
    const std::string_view text = file.text().substr(cursor.offset());
    const bool open = !text.empty() && text.back() != '\n';
    whole = countBytes(text, '\n', '\n').first + open >= expected;
  }
  else
  {
    whole = isWhole(file.text().substr(cursor.offset()), header);
  }
  if (!whole)
  {
    throw FileError(FileError::Kind::Truncated, path,
      "the file ends before all the elements that its header announces: it is "
      "truncated");
  }
}

} // namespace mote
