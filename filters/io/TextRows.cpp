#include "TextRows.h"

#include "FileError.h"
#include "ParseNumber.h"

#include <algorithm>
#include <optional>
#include <tbb/parallel_for.h>

namespace mote
{
namespace
{

// A batch is what runs between two calls of progress: some 20 ms on one core. A piece is what one
// thread takes at a time; small enough that counting its lines leaves it in the cache.
constexpr std::size_t BatchBytes = std::size_t{16} << 20;
constexpr std::size_t PieceBytes = std::size_t{128} << 10;

enum class Trouble
{
  NotNumber,
  TooFew,
  TooMany,
  Widen
};

/// The first thing wrong in a piece.
struct Fault
{
  Trouble trouble = Trouble::NotNumber;
  std::uint64_t row = 0;
  std::size_t column = 0;
  const char* token = nullptr;
  const char* lineBegin = nullptr;
};

/// Whole lines of a batch, and the rows they are.
struct Piece
{
  std::string_view text;
  std::uint64_t firstRow = 0;
  std::uint64_t rows = 0;
  std::size_t bytes = 0; ///< that the rows took
  std::optional<Fault> fault;
};

const char* skipBlanks(const char* p)
{
  while (*p != '\n' && endsToken(*p))
    ++p;
  return p;
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

/// Parses one line; returns the beginning of the next, or null after describing the fault.
const char* parseRow(
  const std::vector<TextColumn>& columns, std::uint64_t row, const char* p, Fault& fault)
{
  const char* const lineBegin = p;
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    p = skipBlanks(p);
    if (*p == '\n')
    {
      fault = {Trouble::TooFew, row, c, p, lineBegin};
      return nullptr;
    }
    const char* const end = storeValue(columns[c], row, p);
    if (!end)
    {
      const ColumnType type = columns[c].type;
      double number = 0;
      const bool widen = (type == ColumnType::Int32 || type == ColumnType::Int64) &&
                         parseDouble(p, number) != nullptr;
      fault = {widen ? Trouble::Widen : Trouble::NotNumber, row, c, p, lineBegin};
      return nullptr;
    }
    p = end;
  }
  p = skipBlanks(p);
  if (*p != '\n')
  {
    fault = {Trouble::TooMany, row, columns.size(), p, lineBegin};
    return nullptr;
  }
  return p + 1;
}

void parsePiece(Piece& piece, const std::vector<TextColumn>& columns, const RowsStored& stored)
{
  const char* p = piece.text.data();
  const char* const end = p + piece.text.size();
  for (std::uint64_t row = piece.firstRow; row < piece.firstRow + piece.rows; ++row)
  {
    Fault fault{Trouble::TooFew, row, 0, p, p};
    // Past the end only where another program has changed the file since its lines were counted.
    p = p < end ? parseRow(columns, row, p, fault) : nullptr;
    if (!p)
    {
      piece.fault = fault;
      return;
    }
  }
  piece.bytes = static_cast<std::size_t>(p - piece.text.data());
  if (stored && piece.rows > 0)
    stored(piece.firstRow, piece.rows);
}

std::vector<Piece> cutIntoPieces(std::string_view text)
{
  std::vector<Piece> pieces;
  while (!text.empty())
  {
    // Without a line end only where another program has changed the file meanwhile.
    const std::size_t lineEnd =
      std::min(text.find('\n', std::min(PieceBytes, text.size()) - 1), text.size() - 1);
    pieces.push_back({text.substr(0, lineEnd + 1), 0, 0, 0, {}});
    text.remove_prefix(lineEnd + 1);
  }
  return pieces;
}

std::string countOf(std::size_t count, const char* noun)
{
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

/// The fault as a sentence for the user.
FileError describe(const Fault& fault, const std::vector<TextColumn>& columns,
  const TextCursor& cursor, std::uint64_t line)
{
  const auto column = static_cast<std::uint64_t>(fault.token - fault.lineBegin) + 1;
  const char* lineEnd = fault.token;
  while (*lineEnd != '\n')
    ++lineEnd;
  const std::string_view whole(
    fault.lineBegin, static_cast<std::size_t>(lineEnd - fault.lineBegin));
  const std::size_t found = splitValues(whole).size();
  std::string sentence;
  switch (fault.trouble)
  {
  case Trouble::TooFew:
    sentence = "expected " + countOf(columns.size(), "value") + ", found " +
               (found == 0 ? "an empty line" : "only " + std::to_string(found)) + " ('" +
               columns[fault.column].name + "' is missing)";
    break;
  case Trouble::TooMany:
    sentence = "expected " + countOf(columns.size(), "value") + ", found " + std::to_string(found);
    break;
  default:
    sentence = "expected a number for '" + columns[fault.column].name + "', found '" +
               std::string(fault.token, tokenEnd(fault.token)).substr(0, 40) + "'";
  }
  return {FileError::Kind::Malformed, cursor.path(), sentence, line, column};
}

/// A 32-bit column that holds a larger integer becomes 64-bit, every other one a float.
WidenColumn widened(const Fault& fault, const std::vector<TextColumn>& columns)
{
  std::int64_t integer = 0;
  const bool fits = columns[fault.column].type == ColumnType::Int32 &&
                    parseInteger(fault.token, integer) != nullptr;
  return {fault.column, fits ? ColumnType::Int64 : ColumnType::Float64};
}

/// Finds which rows the pieces are, at most `rows` of them, and parses them.
void parseBatch(std::vector<Piece>& pieces, std::uint64_t firstRow, std::uint64_t rows,
  const std::vector<TextColumn>& columns, const RowsStored& stored)
{
  tbb::parallel_for(std::size_t{0}, pieces.size(),
    [&](std::size_t i) { pieces[i].rows = countBytes(pieces[i].text, '\n', '\n').first; });
  for (Piece& piece : pieces)
  {
    piece.firstRow = firstRow;
    piece.rows = std::min(piece.rows, rows);
    firstRow += piece.rows;
    rows -= piece.rows;
  }
  tbb::parallel_for(
    std::size_t{0}, pieces.size(), [&](std::size_t i) { parsePiece(pieces[i], columns, stored); });
}

void report(const Progress& progress, double fraction, const TextCursor& cursor)
{
  if (progress && !progress(fraction))
    throw FileError(FileError::Kind::Aborted, cursor.path(), "reading was aborted");
}

} // namespace

RowsResult readRows(TextCursor& cursor, std::uint64_t rows, const std::vector<TextColumn>& columns,
  const RowsStored& stored, const Progress& progress)
{
  std::uint64_t done = 0;
  while (done < rows)
  {
    report(progress, static_cast<double>(done) / static_cast<double>(rows), cursor);
    const std::string_view text = cursor.block(BatchBytes);
    if (text.empty())
    {
      throw FileError(FileError::Kind::Truncated, cursor.path(),
        "the file ends after " + std::to_string(done) + " of " + std::to_string(rows) + " rows",
        cursor.line());
    }
    std::vector<Piece> pieces = cutIntoPieces(text);
    parseBatch(pieces, done, rows - done, columns, stored);
    std::size_t bytes = 0;
    std::uint64_t lines = 0;
    for (const Piece& piece : pieces)
    {
      if (piece.fault && piece.fault->trouble == Trouble::Widen)
        return {false, widened(*piece.fault, columns)};
      if (piece.fault)
        throw describe(*piece.fault, columns, cursor, cursor.line() + piece.fault->row - done);
      bytes += piece.bytes;
      lines += piece.rows;
    }
    cursor.advance(bytes, lines);
    done += lines;
  }
  report(progress, 1.0, cursor);
  return {};
}

std::string unnamedColumn(std::size_t number, const std::vector<std::string>& taken)
{
  std::string name = "column" + std::to_string(number);
  while (std::find(taken.begin(), taken.end(), name) != taken.end())
    name += '_';
  return name;
}

std::vector<std::string> splitValues(std::string_view line)
{
  std::vector<std::string> values;
  std::size_t at = 0;
  while (at < line.size())
  {
    const std::size_t begin = at;
    while (at < line.size() && !endsToken(line[at]))
      ++at;
    if (at > begin)
      values.emplace_back(line.substr(begin, at - begin));
    ++at;
  }
  return values;
}

std::vector<std::string> peekValues(TextCursor& cursor)
{
  std::string_view line;
  return cursor.peekLine(line) ? splitValues(line) : std::vector<std::string>();
}

} // namespace mote
