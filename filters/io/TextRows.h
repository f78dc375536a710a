#ifndef MoteTextRows_h
#define MoteTextRows_h

#include "TextCursor.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <tbb/concurrent_unordered_map.h>
#include <vector>

namespace mote
{

/// What a column of a text table becomes.
enum class ColumnType
{
  Skip, ///< passed over, whatever it holds
  Int32,
  Int64,
  Float32, ///< rounded once more, from the double
  Float64,
  String,
  Word ///< a number, Int32, that stands for the text; see WordTable
};

/// Gives every word that occurs a number, in no order. Thread-safe.
class WordTable
{
public:
  std::int32_t numberOf(std::string word)
  {
    const auto found = m_numbers.find(word);
    return found != m_numbers.end() ? found->second
                                    : m_numbers.emplace(std::move(word), m_next++).first->second;
  }
  /// One more than the largest number that was given.
  std::int32_t end() const { return m_next; }
  /// All words and their numbers; while nobody asks for one.
  const tbb::concurrent_unordered_map<std::string, std::int32_t>& numbers() const
  {
    return m_numbers;
  }

  std::set<std::string> words() const
  {
    std::set<std::string> all;
    for (const auto& [word, number] : m_numbers)
      all.insert(word);
    return all;
  }

private:
  tbb::concurrent_unordered_map<std::string, std::int32_t> m_numbers;
  std::atomic<std::int32_t> m_next{0};
};

/// How the lines of a table are read.
struct RowFormat
{
  /// Between two values: this character, with blanks around it or without, or, where it is a blank,
  /// blanks. With a character values may be empty, which is NaN, stand in double quotes, within
  /// which it separates nothing, and have one more behind the last; words may hold blanks.
  char separator = ' ';
  char decimalPoint = '.';      ///< of numbers
  char comment = '\0';          ///< begins one behind the values of a line, where blanks separate
  bool skipsBlankLines = false; ///< and those of separators and quotes only

  bool hasSeparator() const { return separator != ' '; }
};

/// One column and where its values go.
struct TextColumn
{
  std::string name; ///< for messages
  ColumnType type = ColumnType::Skip;
  void* data = nullptr;       ///< of the type, std::string for String; null for Skip
  std::ptrdiff_t stride = 1;  ///< from one row's value to the next, in elements
  WordTable* words = nullptr; ///< of a Word
  bool mayBeEmpty = true;     ///< in formats with a separator, and not only Skip and text
  bool mayBeText = false;     ///< asks for text where a value is no number
};

/// Columns that make one array, a component each.
struct ColumnGroup
{
  std::string name;
  std::vector<std::size_t> columns;
  bool namesComponents = true; ///< by those of the columns
};

/// Called after rows [first, first + count) have been stored; from any thread, for disjoint rows.
using RowsStored = std::function<void(std::uint64_t first, std::uint64_t count)>;

/// Asked for when a column holds a value that its type is too narrow for: `column` should become
/// `type` (a wider integer, a float, or text), with new space, and the rows be read again.
struct WidenColumn
{
  std::size_t column = 0;
  ColumnType type = ColumnType::Skip;
};

/// How readRows ended.
struct RowsResult
{
  bool complete = true; ///< all rows are stored
  WidenColumn widen;    ///< otherwise: what has to change before another try
};

/// Reads `rows` lines of values from the cursor's place into the columns' space,
/// with every core and the same result whatever their number. Progress goes from 0 to 1.
///
/// Throws FileError, which names the line and the column: for a value that is no number in a number
/// column, too few or too many values in a line, too few lines (Truncated), and when `progress`
/// asks to stop (Aborted). What was stored by then is of no use.
RowsResult readRows(TextCursor& cursor, std::uint64_t rows, const std::vector<TextColumn>& columns,
  const RowsStored& stored, const Progress& progress, const RowFormat& format = {});

/// How many rows there are from the cursor's place on, which is the end of the text then.
std::uint64_t countRows(TextCursor& cursor, const RowFormat& format = {});
/// Passes over so many rows, or what there is of them.
void skipRows(TextCursor& cursor, std::uint64_t rows, const RowFormat& format = {});

/// The values of the next line, which stays the next one; empty at the end of the text.
std::vector<std::string> peekValues(TextCursor& cursor);

/// The name of a column that its file does not name, by its number from 1: "column5". Underscores
/// tell it from those that are taken.
std::string unnamedColumn(std::size_t number, const std::vector<std::string>& taken = {});

/// The blank-separated values of a line.
std::vector<std::string> splitValues(std::string_view line);
/// The values of a line of a format, without the blanks and quotes around them.
std::vector<std::string> splitValues(std::string_view line, const RowFormat& format);

} // namespace mote

#endif
