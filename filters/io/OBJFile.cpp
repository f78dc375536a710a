#include "OBJFile.h"

#include "FileError.h"
#include "ParseNumber.h"
#include "TextCursor.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

namespace mote
{
namespace
{

/// What corners have numbers of, in the order in which they are written.
enum Kind : std::size_t
{
  Vertex,
  Texture,
  Normal,
  Kinds
};

/// How many of a kind there are so far, and which one was asked for. Those that follow count too.
struct Items
{
  std::int64_t count = 0;
  std::int64_t highest = 0;
  std::uint64_t line = 0; ///< where the highest is asked for
};

class Reader
{
public:
  explicit Reader(const std::string& path)
    : m_cursor(path, TextCursor::OpenEnd::Accept)
  {
  }

  OBJFile read(const Progress& progress)
  {
    constexpr std::uint64_t often = 1 << 16; // lines
    while (nextLine())
    {
      readLine();
      if (m_line % often == 0 && progress && !progress(m_cursor.fraction()))
        throw FileError(FileError::Kind::Aborted, m_cursor.path(), "reading was aborted");
    }
    const std::array<const char*, Kinds> names = {"vertices", "texture coordinates", "normals"};
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      const Items& items = m_items[kind];
      m_line = items.line;
      if (items.highest > items.count)
        fail("number " + std::to_string(items.highest) + " is asked for, and there are " +
             std::to_string(items.count) + " " + names[kind]);
    }
    if (!m_file.colors.empty())
      m_file.colors.resize(m_file.places.size(), 1.0f);
    return std::move(m_file);
  }

private:
  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw FileError(FileError::Kind::Malformed, m_cursor.path(), sentence, m_line);
  }

  /// The next line's words, which nextWord() then gives.
  bool nextLine()
  {
    m_line = m_cursor.line();
    if (!m_cursor.nextLine(m_rest))
      return false;
    if (m_rest.find('\0') != m_rest.npos)
      fail("this line holds a zero byte: it is no text");
    return true;
  }

  /// The next word of the line, which a character ends that endsToken(); empty at the line's end.
  std::string_view nextWord()
  {
    while (!m_rest.empty() && endsToken(m_rest.front()))
      m_rest.remove_prefix(1);
    const auto length = static_cast<std::size_t>(tokenEnd(m_rest.data()) - m_rest.data());
    const std::string_view word = m_rest.substr(0, length);
    m_rest.remove_prefix(word.size());
    return word;
  }

  void readLine()
  {
    const std::string_view command = nextWord();
    if (command == "v")
      readVertex();
    else if (command == "vt")
      readNumbers(Texture, 1);
    else if (command == "vn")
      for (const double value : readNumbers(Normal, 3))
        m_file.normals.push_back(static_cast<float>(value));
    else if (command == "f")
      readCell(3, Kinds, m_file.faces);
    else if (command == "l")
      readCell(2, Normal, m_file.lines);
    else if (command == "p")
      readCell(1, Texture, m_file.points);
    else if (command == "usemtl")
      m_file.materials.begin(restOfLine());
    else if (command == "g")
      m_file.groups.begin(restOfLine());
    else if (command == "o")
      m_file.objects.begin(restOfLine());
  }

  std::string_view restOfLine()
  {
    while (!m_rest.empty() && endsToken(m_rest.front()))
      m_rest.remove_prefix(1);
    while (!m_rest.empty() && endsToken(m_rest.back()))
      m_rest.remove_suffix(1);
    return m_rest;
  }

  std::array<double, 3> readNumbers(Kind kind, std::size_t count)
  {
    std::array<double, 3> values = {};
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::string_view word = nextWord();
      if (word.empty() || !parseDouble(word.data(), values[i]))
        fail("expected " + std::to_string(count) + (count == 1 ? " number" : " numbers") +
             (word.empty() ? std::string() : ", found '" + std::string(word) + "'"));
    }
    ++m_items[kind].count;
    return values;
  }

  /// A place, and behind it nothing, a weight, or red, green and blue, and whatever follows these.
  void readVertex()
  {
    const std::array<double, 3> place = readNumbers(Vertex, 3);
    std::array<double, 3> color = {};
    std::size_t count = 0;
    while (count < 3)
    {
      const std::string_view word = nextWord();
      if (word.empty() || !parseDouble(word.data(), color[count]))
        break;
      ++count;
    }
    if (count == 3)
    {
      m_file.colors.resize(m_file.places.size(), 1.0f); // white for those before
      for (const double value : color)
        m_file.colors.push_back(static_cast<float>(value));
    }
    m_file.places.insert(m_file.places.end(), place.begin(), place.end());
  }

  /// Corners up to the line's end, and those of the following lines behind a backslash.
  void readCell(std::size_t fewest, std::size_t kinds, OBJFile::Cells& cells)
  {
    std::size_t corners = 0;
    std::string_view word;
    while (word = nextWord(), !word.empty())
    {
      if (word == "\\" && m_rest.empty())
      {
        if (!nextLine())
          fail("a line is to follow this one");
        continue;
      }
      cells.corners.push_back(readCorner(word, kinds));
      ++corners;
    }
    if (corners < fewest)
      fail("expected " + std::to_string(fewest) + " numbers or more, found " +
           std::to_string(corners));
    cells.ends.push_back(static_cast<std::int64_t>(cells.corners.size()));
    cells.materials.push_back(m_file.materials.current);
    cells.groups.push_back(m_file.groups.current);
    cells.objects.push_back(m_file.objects.current);
  }

  /// A vertex, and behind slashes its texture coordinates and its normal, which may be left out.
  OBJFile::Corner readCorner(std::string_view word, std::size_t kinds)
  {
    const char* at = word.data();
    const char* const end = at + word.size();
    std::array<std::int64_t, Kinds> numbers = {-1, -1, -1};
    for (std::size_t kind = Vertex; kind < kinds; ++kind)
    {
      const bool leftOut = kind == Texture && *at == '/';
      if (!leftOut)
        at = readNumber(at, m_items[kind], word, numbers[kind]);
      if (at == end)
        return {numbers[Vertex], numbers[Normal]};
      if (*at++ != '/')
        break;
    }
    failCorner(word);
  }

  /// `index` is that of an item, from 0.
  const char* readNumber(const char* at, Items& items, std::string_view word, std::int64_t& index)
  {
    const bool negative = passSign(at);
    const char* const first = at;
    std::uint64_t size = 0;
    passDigits(at, size);
    if (at == first || at - first > 10 ||
        size > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
      failCorner(word);
    // Numbers below zero count back from the last one so far, those above from the first.
    const std::int64_t number = negative ? items.count + 1 - static_cast<std::int64_t>(size)
                                         : static_cast<std::int64_t>(size);
    if (number < 1 || size == 0)
      fail("'" + std::string(word) + "' asks for something before the first");
    if (number > items.highest)
    {
      items.highest = number;
      items.line = m_line;
    }
    index = number - 1;
    return at;
  }

  [[noreturn]] void failCorner(std::string_view word) const
  {
    fail("expected numbers such as 1, 1/2, 1/2/3 or 1//3, found '" + std::string(word) + "'");
  }

  TextCursor m_cursor;
  std::string_view m_rest;
  std::uint64_t m_line = 0;
  std::array<Items, Kinds> m_items;
  OBJFile m_file;
};

} // namespace

void OBJFile::Groups::begin(std::string_view name)
{
  const auto [entry, isNew] =
    numbers.try_emplace(std::string(name), static_cast<std::int32_t>(names.size()));
  current = entry->second;
  if (isNew)
    names.emplace_back(name);
}

OBJFile readOBJ(const std::string& path, const Progress& progress)
{
  return Reader(path).read(progress);
}

} // namespace mote
