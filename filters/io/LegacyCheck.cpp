#include "LegacyCheck.h"

#include "FileError.h"
#include "MostArrays.h"
#include "TextFile.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>

namespace mote
{
namespace
{

using Size = std::uint64_t;

/// No count of a file is above this: its product with 100,000 components of 64 bits fits into Size.
constexpr Size mostValues = Size{1} << 40;

bool isBlank(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

std::string lowerCase(std::string_view word)
{
  std::string lower(word);
  for (char& c : lower)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// How values of a type are stored.
struct ValueType
{
  Size bits = 0; ///< in binary files; 0 for strings
  bool isWhole = false;
};

/// Goes through a file as VTK's readers do.
class LegacyChecker
{
public:
  LegacyChecker(const std::string& path, std::string_view text)
    : m_path(path)
    , m_text(text)
  {
  }

  void check() { checkSet(0); }

private:
  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw FileError(FileError::Kind::Malformed, m_path, sentence);
  }

  [[noreturn]] void failTruncated(const std::string& what) const
  {
    throw FileError(
      FileError::Kind::Truncated, m_path, "the file ends where " + what + " should be");
  }

  std::string_view nextLine()
  {
    const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
    const std::string_view line = m_text.substr(m_at, end - m_at);
    m_at = std::min(end + 1, m_text.size());
    return line;
  }

  /// The next word; empty at the file's end.
  std::string_view nextWord()
  {
    while (m_at < m_text.size() && isBlank(m_text[m_at]))
      ++m_at;
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && !isBlank(m_text[m_at]))
      ++m_at;
    return m_text.substr(begin, m_at - begin);
  }

  std::string_view requireWord(const char* what)
  {
    const std::string_view word = nextWord();
    if (word.empty())
      failTruncated(what);
    if (word.size() > 255)
      fail(
        "a word of " + std::to_string(word.size()) + " bytes stands where " + what + " should be");
    return word;
  }

  /// Moves past the next word if it is this keyword.
  bool passWord(const char* keyword)
  {
    const std::size_t before = m_at;
    if (lowerCase(nextWord()) == keyword)
      return true;
    m_at = before;
    return false;
  }

  static std::string quoted(std::string_view word)
  {
    return "'" + std::string(word.substr(0, 40)) + "'";
  }

  Size requireCount(const char* what)
  {
    const std::string_view word = requireWord(what);
    Size count = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || end != word.data() + word.size() || count > mostValues)
      fail(quoted(word) + " stands where " + what + " should be");
    return count;
  }

  ValueType requireType()
  {
    static const std::map<std::string, ValueType> types = {{"bit", {1, true}}, {"char", {8, true}},
      {"signed_char", {8, true}}, {"unsigned_char", {8, true}}, {"short", {16, true}},
      {"unsigned_short", {16, true}}, {"int", {32, true}}, {"unsigned_int", {32, true}},
      {"long", {64, true}}, {"unsigned_long", {64, true}}, {"vtktypeint64", {64, true}},
      {"vtktypeuint64", {64, true}}, {"vtkidtype", {32, true}}, {"float", {32, false}},
      {"double", {64, false}}, {"string", {0, false}}, {"utf8_string", {0, false}}};
    const std::string_view word = requireWord("a type");
    const auto found = types.find(lowerCase(word));
    if (found == types.end())
      fail(quoted(word) + " is no type of values");
    return found->second;
  }

  /// Three lines, of which the third says whether values are text or bytes.
  void checkHead()
  {
    const std::string_view first = nextLine();
    constexpr std::string_view begin = "# vtk DataFile Version ";
    if (!first.starts_with(begin))
      throw FileError(FileError::Kind::OtherFormat, m_path, "is no VTK legacy file");
    m_hasOffsets = first.size() > begin.size() && first[begin.size()] >= '5';
    if (nextLine().size() > 255)
      fail("its title is longer than 255 bytes");
    const std::string_view format = requireWord("ASCII or BINARY");
    m_isText = lowerCase(format) == "ascii";
    if (!m_isText && lowerCase(format) != "binary")
      fail("expected ASCII or BINARY, found " + quoted(format));
    nextLine();
  }

  /// A whole file, or one of the files that a file of blocks holds.
  void checkSet(int depth)
  {
    checkHead();
    std::string keyword = lowerCase(nextWord());
    while (keyword == "field" || keyword == "metadata")
    {
      checkKeyword(keyword);
      keyword = lowerCase(nextWord());
    }
    if (keyword.empty() || (depth > 0 && keyword == "endchild"))
      return; // fields alone
    if (keyword != "dataset")
      fail("expected DATASET, found " + quoted(keyword));
    static const std::set<std::string> known = {"polydata", "structured_points", "structured_grid",
      "rectilinear_grid", "unstructured_grid", "multiblock"};
    const std::string kind = lowerCase(requireWord("the kind of the data set"));
    if (!known.contains(kind))
      throw FileError(FileError::Kind::OtherFormat, m_path,
        quoted(kind) + " is no kind of data set that is read from VTK legacy files");
    while (!(keyword = lowerCase(nextWord())).empty() && !(depth > 0 && keyword == "endchild"))
    {
      if (kind == "multiblock" && keyword == "children")
        checkChildren();
      else if (kind == "multiblock" && keyword == "child")
        checkChild(depth);
      else
        checkKeyword(keyword);
    }
  }

  void checkChildren()
  {
    const Size count = requireCount("the number of blocks");
    if (count > m_text.size())
      fail("the file has no room for " + std::to_string(count) + " blocks");
  }

  void checkChild(int depth)
  {
    constexpr int deepest = 100;
    if (depth == deepest)
      fail("its blocks are more than " + std::to_string(deepest) + " levels deep");
    nextLine(); // the block's type and name
    const bool isText = m_isText;
    checkSet(depth + 1);
    m_isText = isText;
  }

  void checkKeyword(const std::string& keyword)
  {
    if (checkStructure(keyword) || checkAttribute(keyword))
      return;
    if (keyword == "metadata")
      passMetadata();
    else
      fail("the word " + quoted(keyword) + " is no keyword of VTK legacy files here");
  }

  /// Information about arrays, up to an empty line.
  void passMetadata()
  {
    nextLine();
    std::string_view line;
    do
      line = nextLine();
    while (!std::all_of(line.begin(), line.end(), isBlank));
  }

  bool checkStructure(const std::string& keyword)
  {
    static const std::map<std::string, std::size_t> numbers = {
      {"origin", 3}, {"spacing", 3}, {"aspect_ratio", 3}};
    static const std::set<std::string> lists = {
      "vertices", "lines", "polygons", "triangle_strips", "cells"};
    static const std::set<std::string> coordinates = {
      "x_coordinates", "y_coordinates", "z_coordinates"};
    if (keyword == "dimensions")
      checkDimensions();
    else if (keyword == "points")
    {
      const Size count = requireCount("the number of points");
      checkValues(3 * count, requireType());
    }
    else if (coordinates.contains(keyword))
    {
      const Size count = requireCount("the number of coordinates");
      checkValues(count, requireType());
    }
    else if (lists.contains(keyword))
      checkCells();
    else if (keyword == "cell_types")
      checkValues(requireCount("the number of cells"), {32, true});
    else if (const auto found = numbers.find(keyword); found != numbers.end())
      checkNumbers(found->second, false);
    else
      return false;
    return true;
  }

  void checkDimensions()
  {
    Size points = 1;
    for (int axis = 0; axis < 3; ++axis)
      points = std::min(mostValues, points * std::max<Size>(requireCount("three dimensions"), 1));
    // Any values of them take a bit at least.
    if (points > std::max<Size>(1'000'000, 8 * m_text.size()))
      fail("the file has no room for values at " + std::to_string(points) + " points");
  }

  /// A list of cells: their numbers of points with these points, or offsets and points apart.
  void checkCells()
  {
    const Size cells = requireCount("the number of cells");
    const Size values = requireCount("the size of the list of cells");
    if (m_hasOffsets)
    {
      if (!passWord("offsets"))
        fail("expected OFFSETS");
      checkValues(cells, requireType());
      if (!passWord("connectivity"))
        fail("expected CONNECTIVITY");
      checkValues(values, requireType());
      return;
    }
    const std::size_t begin = m_at;
    checkValues(values, {32, true});
    const std::size_t end = m_at;
    m_at = begin;
    passLineEnd();
    Size left = values;
    for (Size cell = 0; cell < cells; ++cell)
    {
      const Size points = left > 0 ? nextInteger() : 0;
      if (left == 0 || points > left - 1)
        fail("the cells do not fill the list of " + std::to_string(values) + " numbers");
      left -= points + 1;
      for (Size i = 0; i < points; ++i)
        nextInteger();
    }
    if (left > 0)
      fail("the list of cells has " + std::to_string(left) + " numbers too many");
    m_at = end;
  }

  /// One of a list of cells, which checkValues() has been through; at most 32 bits.
  Size nextInteger()
  {
    std::int64_t value = 0;
    if (m_isText)
    {
      const std::string_view word = nextWord();
      std::from_chars(word.data() + word.starts_with('+'), word.data() + word.size(), value);
    }
    else
    {
      std::uint32_t bits = 0;
      for (std::size_t i = 0; i < 4; ++i)
        bits = bits << 8 | static_cast<unsigned char>(m_text[m_at + i]);
      m_at += 4;
      value = static_cast<std::int32_t>(bits);
    }
    return value < 0 ? mostValues : static_cast<Size>(value);
  }

  bool checkAttribute(const std::string& keyword)
  {
    static const std::map<std::string, Size> components = {{"vectors", 3}, {"normals", 3},
      {"tensors", 9}, {"tensors6", 6}, {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    if (keyword == "point_data" || keyword == "cell_data")
      m_arrays = 0, m_tuples = requireCount("the number of values");
    else if (keyword == "scalars")
      checkScalars();
    else if (keyword == "color_scalars")
      checkColors(m_tuples);
    else if (keyword == "lookup_table")
      checkColors(4);
    else if (keyword == "texture_coordinates")
    {
      requireWord("a name");
      const Size each = requireCount("the number of texture coordinates");
      checkValues(m_tuples * std::min<Size>(each, 4), requireType());
    }
    else if (keyword == "field")
      checkField();
    else if (const auto found = components.find(keyword); found != components.end())
    {
      requireWord("a name");
      checkValues(m_tuples * found->second, requireType());
    }
    else
      return false;
    if (++m_arrays > mostArrays)
      fail(tooMany("arrays"));
    return true;
  }

  void checkScalars()
  {
    requireWord("a name");
    const ValueType type = requireType();
    Size each = 1;
    if (!passWord("lookup_table"))
    {
      each = requireCount("the number of components");
      if (!passWord("lookup_table"))
        fail("expected LOOKUP_TABLE");
    }
    requireWord("the name of a table of colours");
    if (each < 1 || each > 100'000)
      fail("there are no scalars of " + std::to_string(each) + " components");
    checkValues(m_tuples * each, type);
  }

  /// Colours: numbers from 0 to 1 in text, a byte each otherwise.
  void checkColors(Size colors)
  {
    requireWord("a name");
    const Size each = requireCount("the number of colours or components");
    if (each > 100'000)
      fail("there are no " + std::to_string(each) + " colours or components");
    checkValues(colors * each, {8, false});
  }

  void checkField()
  {
    requireWord("a name");
    const Size arrays = requireCount("the number of arrays");
    m_arrays += std::min<Size>(arrays, mostArrays);
    for (Size array = 0; array < arrays; ++array)
    {
      if (passWord("metadata"))
        passMetadata();
      if (requireWord("the name of an array") == "NULL_ARRAY")
        continue;
      const Size each = requireCount("the number of components");
      const Size tuples = requireCount("the number of values");
      if (each > 100'000)
        fail("there is no array of " + std::to_string(each) + " components");
      checkValues(each * tuples, requireType());
    }
  }

  /// What the file is short of is told before anything is read.
  void checkValues(Size count, const ValueType& type)
  {
    const bool isText = m_isText || type.bits == 0;
    const Size left = m_text.size() - m_at;
    const Size bytes = isText ? count : (count * type.bits + 7) / 8;
    if (bytes > left)
      throw FileError(FileError::Kind::Truncated, m_path,
        "the file has no room for the " + std::to_string(count) +
          " values that it announces: it is truncated");
    if (type.bits == 0)
      passStrings(count);
    else if (m_isText)
      checkNumbers(count, type.isWhole);
    else
    {
      passLineEnd();
      if (bytes > m_text.size() - m_at)
        failTruncated("the last values");
      m_at += bytes;
      if (m_at < m_text.size() && !isBlank(m_text[m_at]))
        fail("values are not followed by a line's end");
    }
  }

  void passLineEnd()
  {
    if (!m_isText)
      nextLine();
  }

  void checkNumbers(Size count, bool whole)
  {
    for (Size i = 0; i < count; ++i)
    {
      const std::string_view word = nextWord();
      if (word.empty())
        failTruncated("a number");
      if (!(whole ? isNumber<std::int64_t>(word) : isNumber<double>(word)))
        fail("expected " + std::string(whole ? "a whole number" : "a number") + ", found " +
             quoted(word));
    }
  }

  template <class Number>
  static bool isNumber(std::string_view word)
  {
    word.remove_prefix(word.starts_with('+'));
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error != std::errc::invalid_argument && end == word.data() + word.size();
  }

  /// A line each in text; in binary files a length and as many bytes.
  void passStrings(Size count)
  {
    nextLine();
    for (Size i = 0; i < count; ++i)
    {
      if (m_at >= m_text.size())
        failTruncated("a text");
      if (m_isText)
        nextLine();
      else
        m_at += std::min<Size>(stringLength(), m_text.size() - m_at);
    }
  }

  /// The first two bits tell how many bytes, 8, 4, 2 or 1, have the length.
  Size stringLength()
  {
    const auto first = static_cast<unsigned char>(m_text[m_at]);
    const std::size_t bytes = std::size_t{8} >> (first >> 6);
    Size length = first & 0x3f;
    for (std::size_t i = 1; i < bytes; ++i)
    {
      if (m_at + i >= m_text.size())
        failTruncated("a text");
      length = length << 8 | static_cast<unsigned char>(m_text[m_at + i]);
    }
    m_at += bytes;
    return length;
  }

  const std::string& m_path;
  std::string_view m_text;
  std::size_t m_at = 0;
  bool m_isText = true;
  bool m_hasOffsets = false;       ///< of the lists of cells
  Size m_tuples = 0, m_arrays = 0; ///< of the attributes that follow
};

} // namespace

void checkLegacyVTK(const std::string& path)
{
  const TextFile file(path);
  if (!file.isGzip())
    LegacyChecker(path, file.text()).check();
}

} // namespace mote
