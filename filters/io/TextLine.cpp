#include "TextLine.h"

#include "ParseNumber.h"

#include <cstring>
#include <limits>
#include <string>

namespace mote
{
namespace
{

/// What separators become in the copy: ParseNumber.h ends a value there.
constexpr char fieldEnd = '\x01';

const char* skipBlanks(const char* p)
{
  while (*p != '\n' && endsToken(*p))
    ++p;
  return p;
}

bool endsField(char c)
{
  return c == fieldEnd || c == '\n';
}

/// Likewise within a field.
const char* skipBlanksOfField(const char* p)
{
  while (!endsField(*p) && endsToken(*p))
    ++p;
  return p;
}

/// Where the field at `p` ends.
const char* endOfField(const char* p)
{
  while (!endsField(*p))
    ++p;
  return p;
}

/// Puts `fieldEnd` where a separator is, a point for the decimal comma, and a blank for quotes, so
/// that all stay at their places.
void translate(std::vector<char>& text, const RowFormat& format)
{
  const char separator = format.hasSeparator() ? format.separator : fieldEnd;
  const auto plain = [&](char c)
  {
    c = c == fieldEnd ? ' ' : c;
    c = c == separator ? fieldEnd : c;
    return c == format.decimalPoint ? '.' : c;
  };
  if (!format.hasSeparator() || !std::memchr(text.data(), '"', text.size()))
  {
    std::transform(text.begin(), text.end(), text.begin(), plain);
    return;
  }
  bool isQuoted = false, isAtBegin = true; // of a field
  for (char& c : text)
  {
    const bool isLineEnd = c == '\n';
    const bool isQuote = c == '"' && (isQuoted || isAtBegin);
    isQuoted = !isLineEnd && isQuoted != isQuote;
    c = isQuote ? ' ' : isQuoted ? (c == fieldEnd ? ' ' : c) : plain(c);
    isAtBegin = isLineEnd || c == fieldEnd || (isAtBegin && endsToken(c));
  }
}

/// The text of a field without the blanks and the quotes around it; of two quotes in quotes one.
std::string unquoted(std::string_view field)
{
  while (!field.empty() && endsToken(field.front()))
    field.remove_prefix(1);
  while (!field.empty() && endsToken(field.back()))
    field.remove_suffix(1);
  if (!field.starts_with('"'))
    return std::string(field);
  std::string text;
  bool isQuoted = false;
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    const bool isQuote = field[i] == '"';
    isQuoted = isQuoted != isQuote;
    if (!isQuote || (isQuoted && i > 0 && field[i - 1] == '"'))
      text.push_back(field[i]);
  }
  return text;
}

/// Stores the value at `p` for a row; returns its end, or null.
const char* storeValue(const TextColumn& column, std::uint64_t row, const char* p)
{
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(row) * column.stride;
  switch (column.type)
  {
  case ColumnType::Float64:
    return parseDouble(p, static_cast<double*>(column.data)[at]);
  case ColumnType::Float32:
  {
    double value = 0;
    p = parseDouble(p, value);
    static_cast<float*>(column.data)[at] = static_cast<float>(value);
    return p;
  }
  case ColumnType::Int32:
    return parseInteger(p, static_cast<std::int32_t*>(column.data)[at]);
  case ColumnType::Int64:
    return parseInteger(p, static_cast<std::int64_t*>(column.data)[at]);
  case ColumnType::String:
  {
    const char* const end = tokenEnd(p);
    static_cast<std::string*>(column.data)[at].assign(p, end);
    return end;
  }
  case ColumnType::Word:
  {
    const char* const end = tokenEnd(p);
    static_cast<std::int32_t*>(column.data)[at] = column.words->numberOf(std::string(p, end));
    return end;
  }
  case ColumnType::Skip:
    break;
  }
  return tokenEnd(p);
}

/// What a column becomes where it meets the value at `p`, which it cannot hold; Skip where it may
/// not. isWhole(end) tells whether that ends the value.
template <typename IsWhole>
ColumnType widened(const TextColumn& column, const char* p, const IsWhole& isWhole)
{
  const bool isInteger = column.type == ColumnType::Int32 || column.type == ColumnType::Int64;
  std::int64_t integer = 0;
  double number = 0;
  if (column.type == ColumnType::Int32 && isWhole(parseInteger(p, integer)))
    return ColumnType::Int64;
  if (isInteger && (endsField(*p) || isWhole(parseDouble(p, number))))
    return ColumnType::Float64;
  return column.mayBeText ? ColumnType::String : ColumnType::Skip;
}

} // namespace

bool isBlankLine(std::string_view line, const RowFormat& format)
{
  return std::all_of(line.begin(), line.end(),
    [&](char c)
    { return endsToken(c) || (format.hasSeparator() && (c == format.separator || c == '"')); });
}

TextLines::TextLines(std::string_view text, const RowFormat& format)
  : m_text(text)
  , m_format(format)
  , m_begin(text.data())
{
  if (format.hasSeparator() || format.decimalPoint != '.')
  {
    m_copy.assign(text.begin(), text.end());
    translate(m_copy, format);
    m_copy.push_back('\n'); // another program may have changed the file
    m_begin = m_copy.data();
  }
  m_at = m_begin;
}

void TextLines::skipBlankLines()
{
  while (m_format.skipsBlankLines && passed() < m_text.size())
  {
    const std::size_t end = lineEnd(m_text, passed());
    if (!isBlankLine(m_text.substr(passed(), end - passed()), m_format))
      return;
    m_at = m_begin + end;
  }
}

bool TextLines::parseRow(const std::vector<TextColumn>& columns, std::uint64_t row, Fault& fault)
{
  // Past the end only where another program has changed the file since its lines were counted.
  const char* next = nullptr;
  if (passed() < m_text.size())
    next = m_format.hasSeparator() ? this->parseFields(columns, row, fault)
                                   : this->parseBlanks(columns, row, fault);
  else
    fault.token = m_at;
  if (next)
    m_at = next;
  else
  {
    fault.token = this->original(fault.token);
    fault.lineBegin = this->original(m_at);
  }
  return next != nullptr;
}

/// Parses one line; returns the beginning of the next, or null after describing the fault.
const char* TextLines::parseBlanks(
  const std::vector<TextColumn>& columns, std::uint64_t row, Fault& fault) const
{
  const char* p = m_at;
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    p = skipBlanks(p);
    if (*p == '\n')
    {
      fault = {Trouble::TooFew, c, p};
      return nullptr;
    }
    const char* const end = storeValue(columns[c], row, p);
    if (!end)
    {
      const ColumnType wider =
        widened(columns[c], p, [](const char* stop) { return stop != nullptr; });
      fault = {
        wider == ColumnType::Skip ? Trouble::NotNumber : Trouble::Widen, c, p, nullptr, wider};
      return nullptr;
    }
    if (columns[c].type == ColumnType::String && m_begin != m_text.data()) // with its commas
      static_cast<std::string*>(
        columns[c].data)[static_cast<std::ptrdiff_t>(row) * columns[c].stride]
        .assign(this->original(p), this->original(end));
    p = end;
  }
  p = skipBlanks(p);
  if (m_format.comment != '\0' && *p == m_format.comment)
    p = std::find(p, m_begin + m_text.size(), '\n');
  if (*p != '\n')
  {
    fault = {Trouble::TooMany, columns.size(), p};
    return nullptr;
  }
  return p + 1;
}

/// The same, of fields with separators between them.
const char* TextLines::parseFields(
  const std::vector<TextColumn>& columns, std::uint64_t row, Fault& fault) const
{
  const char* p = m_at;
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    if (c > 0 && *p++ == '\n')
    {
      fault = {Trouble::TooFew, c, p - 1};
      return nullptr;
    }
    p = skipBlanksOfField(p);
    const auto isWhole = [](const char* stop)
    { return stop && endsField(*skipBlanksOfField(stop)); };
    const char* const end = this->storeField(columns[c], row, p);
    if (!isWhole(end))
    {
      const ColumnType wider = widened(columns[c], p, isWhole);
      while (p > m_at && *this->original(p - 1) == '"')
        --p;
      fault = {
        wider == ColumnType::Skip ? Trouble::NotNumber : Trouble::Widen, c, p, nullptr, wider};
      return nullptr;
    }
    p = skipBlanksOfField(end);
  }
  if (*p == fieldEnd)
    p = skipBlanksOfField(p + 1);
  if (*p != '\n')
  {
    fault = {Trouble::TooMany, columns.size(), p};
    return nullptr;
  }
  return p + 1;
}

const char* TextLines::storeField(const TextColumn& column, std::uint64_t row, const char* p) const
{
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(row) * column.stride;
  const bool isFloat = column.type == ColumnType::Float32 || column.type == ColumnType::Float64;
  const bool isNumber =
    isFloat || column.type == ColumnType::Int32 || column.type == ColumnType::Int64;
  if (isFloat && endsField(*p)) // no number
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (column.type == ColumnType::Float32)
      static_cast<float*>(column.data)[at] = static_cast<float>(none);
    else
      static_cast<double*>(column.data)[at] = none;
    return column.mayBeEmpty ? p : nullptr;
  }
  if (isNumber)
    return storeValue(column, row, p);
  const char* const end = endOfField(p);
  if (column.type == ColumnType::Skip)
    return end;
  // Quotes have become blanks in the copy.
  const char* begin = p;
  while (begin > m_at && !endsField(begin[-1]))
    --begin;
  std::string word = unquoted({this->original(begin), static_cast<std::size_t>(end - begin)});
  if (column.type == ColumnType::String)
    static_cast<std::string*>(column.data)[at] = std::move(word);
  else
    static_cast<std::int32_t*>(column.data)[at] = column.words->numberOf(std::move(word));
  return end;
}

std::vector<std::string> splitValues(std::string_view line, const RowFormat& format)
{
  if (!format.hasSeparator())
    return splitValues(line);
  std::vector<char> copy(line.begin(), line.end());
  copy.push_back('\n');
  translate(copy, format);
  std::vector<std::string> values;
  for (const char* p = copy.data();; ++p)
  {
    const char* const end = endOfField(p);
    values.push_back(unquoted(
      line.substr(static_cast<std::size_t>(p - copy.data()), static_cast<std::size_t>(end - p))));
    p = end;
    if (*p == '\n')
      return values;
  }
}

} // namespace mote
