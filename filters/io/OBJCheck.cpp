#include "OBJCheck.h"

#include "FileError.h"
#include "ParseNumber.h"
#include "TextCursor.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace mote
{
namespace
{

/// vtkOBJReader keeps the name of a material in 100 bytes.
constexpr std::size_t longestMaterial = 99;

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

class Checker
{
public:
  explicit Checker(const std::string& path)
    : m_cursor(path, TextCursor::OpenEnd::Accept)
  {
  }

  void check()
  {
    while (nextLine())
      checkLine();
    const std::array<const char*, Kinds> names = {"vertices", "texture coordinates", "normals"};
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      const Items& items = m_items[kind];
      m_line = items.line;
      if (items.highest > items.count)
        fail("number " + std::to_string(items.highest) + " is asked for, and there are " +
             std::to_string(items.count) + " " + names[kind]);
    }
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

  void checkLine()
  {
    const std::string_view command = nextWord();
    if (command == "v")
      checkNumbers(Vertex, 3);
    else if (command == "vt")
      checkNumbers(Texture, 1);
    else if (command == "vn")
      checkNumbers(Normal, 3);
    else if (command == "f")
      checkCorners(3, Kinds);
    else if (command == "l")
      checkCorners(2, Normal);
    else if (command == "p")
      checkCorners(1, Texture);
    else if (command == "usemtl" && nextWord().size() > longestMaterial)
      fail("the name of a material has at most " + std::to_string(longestMaterial) + " bytes");
  }

  void checkNumbers(Kind kind, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::string_view word = nextWord();
      double value = 0;
      if (word.empty() || !parseDouble(word.data(), value))
        fail("expected " + std::to_string(count) + (count == 1 ? " number" : " numbers") +
             (word.empty() ? std::string() : ", found '" + std::string(word) + "'"));
    }
    ++m_items[kind].count;
  }

  /// Corners up to the line's end, and those of the following lines behind a backslash.
  void checkCorners(std::size_t fewest, std::size_t kinds)
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
      checkCorner(word, kinds);
      ++corners;
    }
    if (corners < fewest)
      fail("expected " + std::to_string(fewest) + " numbers or more, found " +
           std::to_string(corners));
  }

  /// A vertex, and behind slashes its texture coordinates and its normal, which may be left out.
  void checkCorner(std::string_view word, std::size_t kinds)
  {
    const char* at = word.data();
    const char* const end = at + word.size();
    for (std::size_t kind = Vertex; kind < kinds; ++kind)
    {
      const bool leftOut = kind == Texture && *at == '/';
      if (!leftOut)
        at = checkNumber(at, m_items[kind], word);
      if (at == end)
        return;
      if (*at++ != '/')
        break;
    }
    failCorner(word);
  }

  const char* checkNumber(const char* at, Items& items, std::string_view word)
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
};

} // namespace

void checkOBJ(const std::string& path)
{
  Checker(path).check();
}

} // namespace mote
