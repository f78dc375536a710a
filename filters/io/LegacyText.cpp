#include "LegacyText.h"

#include "FileError.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>

namespace mote
{
namespace
{

bool isBlank(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

template <class Number>
bool isNumber(std::string_view word)
{
  word.remove_prefix(word.starts_with('+'));
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error != std::errc::invalid_argument && end == word.data() + word.size();
}

} // namespace

std::string LegacyText::lowerCase(std::string_view word)
{
  std::string lower(word);
  for (char& c : lower)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

std::string LegacyText::quoted(std::string_view word)
{
  return "'" + std::string(word.substr(0, 40)) + "'";
}

void LegacyText::fail(const std::string& sentence) const
{
  throw FileError(FileError::Kind::Malformed, m_path, sentence);
}

void LegacyText::failTruncated(const std::string& what) const
{
  throw FileError(FileError::Kind::Truncated, m_path, "the file ends where " + what + " should be");
}

std::string_view LegacyText::nextLine()
{
  const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
  const std::string_view line = m_text.substr(m_at, end - m_at);
  m_at = std::min(end + 1, m_text.size());
  return line;
}

std::string_view LegacyText::nextWord()
{
  while (m_at < m_text.size() && isBlank(m_text[m_at]))
    ++m_at;
  const std::size_t begin = m_at;
  while (m_at < m_text.size() && !isBlank(m_text[m_at]))
    ++m_at;
  return m_text.substr(begin, m_at - begin);
}

std::string_view LegacyText::requireWord(const char* what)
{
  const std::string_view word = nextWord();
  if (word.empty())
    failTruncated(what);
  if (word.size() > 255)
    fail("a word of " + std::to_string(word.size()) + " bytes stands where " + what + " should be");
  return word;
}

bool LegacyText::passWord(const char* keyword)
{
  const std::size_t before = m_at;
  if (lowerCase(nextWord()) == keyword)
    return true;
  m_at = before;
  return false;
}

LegacyText::Size LegacyText::requireCount(const char* what)
{
  const std::string_view word = requireWord(what);
  Size count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size() || count > mostValues)
    fail(quoted(word) + " stands where " + what + " should be");
  return count;
}

LegacyText::ValueType LegacyText::requireType()
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

void LegacyText::checkValues(Size count, const ValueType& type)
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

void LegacyText::passLineEnd()
{
  if (!m_isText)
    nextLine();
}

void LegacyText::checkNumbers(Size count, bool whole)
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

/// A line each in text; in binary files a length and as many bytes.
void LegacyText::passStrings(Size count)
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
LegacyText::Size LegacyText::stringLength()
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

LegacyText::Size LegacyText::nextInteger(Size bits)
{
  std::int64_t value = 0;
  if (m_isText)
  {
    const std::string_view word = nextWord();
    std::from_chars(word.data() + word.starts_with('+'), word.data() + word.size(), value);
  }
  else
  {
    std::uint64_t read = 0;
    for (Size i = 0; i < bits / 8; ++i)
      read = read << 8 | static_cast<unsigned char>(m_text[m_at + i]);
    m_at += bits / 8;
    value = bits == 32 ? static_cast<std::int32_t>(read) : static_cast<std::int64_t>(read);
  }
  return value < 0 ? mostValues : static_cast<Size>(value);
}

} // namespace mote
