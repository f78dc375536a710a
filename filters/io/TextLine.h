#ifndef MoteTextLine_h
#define MoteTextLine_h

#include "TextRows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mote
{

enum class Trouble
{
  NotNumber,
  TooFew,
  TooMany,
  Widen
};

/// The first thing wrong in some lines.
struct Fault
{
  Trouble trouble = Trouble::TooFew;
  std::size_t column = 0;
  const char* token = nullptr;
  const char* lineBegin = nullptr;
  ColumnType wider = ColumnType::Skip; ///< of Widen
};

/// Where the next line begins.
inline std::size_t lineEnd(std::string_view text, std::size_t from)
{
  return std::min(text.find('\n', from), text.size() - 1) + 1;
}

bool isBlankLine(std::string_view line, const RowFormat& format);

/// Passes through whole lines, a row after the other.
class TextLines
{
public:
  /// The text must live, and end with a line end.
  TextLines(std::string_view text, const RowFormat& format);

  /// Where the format says so.
  void skipBlankLines();
  /// Stores the values of the next line, and moves on; false after describing the fault, within the
  /// text.
  bool parseRow(const std::vector<TextColumn>& columns, std::uint64_t row, Fault& fault);
  /// Bytes of the text before the next line.
  std::size_t passed() const { return static_cast<std::size_t>(m_at - m_begin); }

private:
  const char* original(const char* p) const { return m_text.data() + (p - m_begin); }
  const char* parseBlanks(
    const std::vector<TextColumn>& columns, std::uint64_t row, Fault& fault) const;
  const char* parseFields(
    const std::vector<TextColumn>& columns, std::uint64_t row, Fault& fault) const;
  const char* storeField(const TextColumn& column, std::uint64_t row, const char* p) const;

  std::string_view m_text;
  RowFormat m_format;
  /// The text with other separators and no quotes; empty where the text is taken as it is.
  std::vector<char> m_copy;
  const char* m_begin = nullptr; ///< of the text or the copy
  const char* m_at = nullptr;
};

} // namespace mote

#endif
