// The header of a .mote file: from memory to bytes and, distrusting them, back.

#include "detail/FileHeader.h"

#include "Error.h"

#include <algorithm>
#include <cstddef>

namespace mote
{

namespace
{

constexpr std::uint32_t otherByteOrder = 0x04030201;
constexpr std::size_t checksumAt = offsetof(FileBeginning, checksum);

/// FNV-1a, the checksum itself left out. Each step can be undone, so that no change of one byte
/// goes unnoticed.
std::uint64_t checksumOf(const unsigned char* data, std::size_t size)
{
  std::uint64_t sum = 0xcbf29ce484222325u;
  for (std::size_t i = 0; i < size; ++i)
  {
    const bool isOwn = i >= checksumAt && i < checksumAt + sizeof(FileBeginning::checksum);
    sum = (sum ^ (isOwn ? 0 : data[i])) * 0x100000001b3u;
  }
  return sum;
}

std::uint64_t padded(std::uint64_t bytes)
{
  return (bytes + FileSection::alignment - 1) / FileSection::alignment * FileSection::alignment;
}

void append(std::vector<unsigned char>& to, const void* data, std::size_t size)
{
  const auto* from = static_cast<const unsigned char*>(data);
  to.insert(to.end(), from, from + size);
}

void append(std::vector<unsigned char>& to, const std::string& text)
{
  const auto length = static_cast<std::uint32_t>(text.size());
  append(to, &length, sizeof(length));
  append(to, text.data(), text.size());
}

/// Takes values from a block of memory and never more than it holds.
class Cursor
{
public:
  Cursor(const std::string& name, const unsigned char* data, std::size_t size)
    : name_(name)
    , at_(data)
    , left_(size)
  {
  }

  void take(void* to, std::size_t size)
  {
    need(size);
    std::memcpy(to, at_, size);
    at_ += size;
    left_ -= size;
  }
  template <typename T>
  T take()
  {
    T value;
    take(&value, sizeof(value));
    return value;
  }
  std::string takeText()
  {
    const auto length = take<std::uint32_t>();
    need(length);
    std::string text(reinterpret_cast<const char*>(at_), length);
    at_ += length;
    left_ -= length;
    return text;
  }
  std::size_t left() const { return left_; }
  void need(std::size_t size) const
  {
    if (size > left_)
      failDamaged(name_, "its table of arrays ends too early");
  }

private:
  const std::string& name_;
  const unsigned char* at_;
  std::size_t left_;
};

FileTableRow takeRow(const std::string& name, std::uint32_t roles, Cursor& cursor)
{
  FileTableRow row;
  FileEntry& entry = row.entry;
  entry = cursor.take<FileEntry>();
  const auto type = static_cast<ArrayView::Type>(entry.type);
  const std::size_t size = entry.type < 256 ? bytesOf(type) : 0;
  if (size == 0 || entry.components < 1 || entry.components > (1u << 20) || entry.role >= roles)
    failDamaged(name, "an array in its table is of no known kind");
  const std::uint64_t tuple = size * entry.components;
  if (entry.section.bytes / tuple != entry.tuples || entry.section.bytes % tuple != 0)
    failDamaged(name, "an array in its table has not the size of its values");
  cursor.need((entry.components + 1) * sizeof(FileArray::Range));
  row.array.ranges.resize(entry.components + 1);
  for (FileArray::Range& range : row.array.ranges)
    range = cursor.take<FileArray::Range>();
  row.array.finite = entry.finite != 0;
  row.array.name = cursor.takeText();
  if (entry.componentNames != 0 && entry.componentNames != entry.components)
    failDamaged(name, "an array in its table has not a name for every component");
  for (std::uint32_t k = 0; k < entry.componentNames; ++k)
    row.array.components.push_back(cursor.takeText());
  return row;
}

} // namespace

void failDamaged(const std::string& name, const std::string& how)
{
  throw Error(name + ": the file is damaged: " + how);
}

std::size_t bytesOf(ArrayView::Type type)
{
  using Type = ArrayView::Type;
  switch (type)
  {
  case Type::Int8:
  case Type::UInt8:
    return 1;
  case Type::Int16:
  case Type::UInt16:
    return 2;
  case Type::Float32:
  case Type::Int32:
  case Type::UInt32:
    return 4;
  case Type::Float64:
  case Type::Int64:
  case Type::UInt64:
    return 8;
  case Type::None:
    break;
  }
  return 0;
}

FileTableRow rowFor(const NamedArray& array, std::uint32_t role, std::uint64_t tuples)
{
  FileTableRow row{};
  static_cast<NamedArray&>(row.array) = array;
  const auto components = static_cast<std::size_t>(array.values.components());
  if (row.array.components.size() != components)
    row.array.components.clear();
  row.entry = {{0, tuples * components * bytesOf(array.values.type())}, tuples, role,
    static_cast<std::uint32_t>(array.values.type()), static_cast<std::uint32_t>(components), 1,
    static_cast<std::uint32_t>(row.array.components.size()), 0};
  row.array.ranges.resize(components + 1);
  return row;
}

std::vector<unsigned char> packHeaderBlock(
  const void* header, std::size_t headerBytes, const FileTable& table)
{
  std::vector<unsigned char> block;
  append(block, header, headerBytes);
  for (const FileTableRow& row : table.rows)
  {
    append(block, &row.entry, sizeof(row.entry));
    for (const FileArray::Range& range : row.array.ranges)
      append(block, &range, sizeof(range));
    append(block, row.array.name);
    for (const std::string& component : row.array.components)
      append(block, component);
  }
  // Where there are none, there are zeros, or nothing.
  if (const std::uint64_t count = table.more.size(); count > 0)
  {
    append(block, &count, sizeof(count));
    append(block, table.more.data(), count * sizeof(FileSection));
  }
  block.resize(padded(block.size()));
  FileBeginning beginning;
  std::memcpy(&beginning, block.data(), sizeof(beginning));
  beginning.headerBytes = block.size();
  std::memcpy(block.data(), &beginning, sizeof(beginning));
  beginning.checksum = checksumOf(block.data(), block.size());
  std::memcpy(block.data(), &beginning, sizeof(beginning));
  return block;
}

void checkBeginning(
  const std::string& name, const FileKind& kind, const unsigned char* data, std::uint64_t size)
{
  const auto begins = std::min<std::uint64_t>(size, kind.magic.size());
  if (size == 0)
    throw Error(name + ": the file is empty");
  if (std::memcmp(data, kind.magic.data(), begins) != 0)
    throw Error(name + ": this is no file of " + kind.what + " that Mote has written");
  if (size < kind.headerBytes)
    throw Error(name + ": the file is cut short");
  FileBeginning header;
  std::memcpy(&header, data, sizeof(header));
  if (header.byteOrder == otherByteOrder)
    throw Error(name + ": this file was written on a machine with another order of bytes");
  if (header.byteOrder != FileBeginning::theByteOrder)
    failDamaged(name, "its mark of the order of bytes is none");
  if (header.version != kind.version)
    throw Error(name + ": this file has version " + std::to_string(header.version) +
                " of the format, and version " + std::to_string(kind.version) +
                " is what is read here");
  if (header.headerBytes < kind.headerBytes || header.headerBytes % FileSection::alignment != 0)
    failDamaged(name, "its header has no right size");
  if (header.headerBytes > size)
    throw Error(name + ": the file is cut short, or its header is damaged");
  if (checksumOf(data, header.headerBytes) != header.checksum)
    failDamaged(name, "its header is not what was written");
  if (header.fileBytes > size)
    throw Error(name + ": the file is cut short: it has " + std::to_string(size) + " of " +
                std::to_string(header.fileBytes) + " bytes");
}

FileTable takeTable(const std::string& name, const FileKind& kind, const unsigned char* data,
  std::uint64_t headerBytes, std::uint64_t arrays)
{
  FileTable table;
  Cursor cursor(name, data + kind.headerBytes, headerBytes - kind.headerBytes);
  if (arrays > headerBytes / sizeof(FileEntry))
    failDamaged(name, "its table of arrays ends too early");
  for (std::uint64_t k = 0; k < arrays; ++k)
    table.rows.push_back(takeRow(name, kind.roles, cursor));
  const auto count = cursor.left() < sizeof(std::uint64_t) ? 0 : cursor.take<std::uint64_t>();
  if (count > cursor.left() / sizeof(FileSection))
    failDamaged(name, "its table of arrays ends too early");
  for (std::uint64_t k = 0; k < count; ++k)
    table.more.push_back(cursor.take<FileSection>());
  return table;
}

void checkSections(const std::string& name, const FileBeginning& header,
  std::vector<FileSection> sections, const FileTable& table)
{
  for (const FileTableRow& row : table.rows)
    sections.push_back(row.entry.section);
  sections.insert(sections.end(), table.more.begin(), table.more.end());
  std::erase_if(sections, [](const FileSection& s) { return s.bytes == 0; });
  std::sort(sections.begin(), sections.end(),
    [](const FileSection& a, const FileSection& b) { return a.offset < b.offset; });
  std::uint64_t end = header.headerBytes;
  for (const FileSection& s : sections)
  {
    if (s.offset % FileSection::alignment != 0)
      failDamaged(name, "a part of it does not begin at a page");
    if (s.offset < end)
      failDamaged(name, "parts of it overlap");
    if (s.offset > header.fileBytes || s.bytes > header.fileBytes - s.offset)
      failDamaged(name, "a part of it lies behind its end");
    end = s.offset + s.bytes;
  }
}

} // namespace mote
