#include "TextRows.h"

#include "FileError.h"
#include "ParseNumber.h"
#include "TextLine.h"

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

/// Whole lines of a batch, and the rows they are.
struct Piece
{
  std::string_view text;
  std::uint64_t firstRow = 0;
  std::uint64_t rows = 0;
  std::size_t bytes = 0; ///< that the rows took, with the blank lines behind them
  std::optional<Fault> fault;
};

/// Rows in whole lines of text.
std::uint64_t rowsIn(std::string_view text, const RowFormat& format)
{
  if (!format.skipsBlankLines)
    return countBytes(text, '\n', '\n').first;
  std::uint64_t rows = 0;
  for (std::size_t at = 0; at < text.size(); at = lineEnd(text, at))
    rows += !isBlankLine(text.substr(at, lineEnd(text, at) - at), format);
  return rows;
}

void parsePiece(Piece& piece, const std::vector<TextColumn>& columns, const RowsStored& stored,
  const RowFormat& format)
{
  TextLines lines(piece.text, format);
  for (std::uint64_t row = piece.firstRow; row < piece.firstRow + piece.rows; ++row)
  {
    Fault fault;
    lines.skipBlankLines();
    if (!lines.parseRow(columns, row, fault))
    {
      piece.fault = fault;
      return;
    }
  }
  lines.skipBlankLines();
  piece.bytes = lines.passed();
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
  const RowFormat& format, const TextCursor& cursor, std::uint64_t line)
{
  const auto column = static_cast<std::uint64_t>(fault.token - fault.lineBegin) + 1;
  const char* lineEnd = fault.token;
  while (*lineEnd != '\n')
    ++lineEnd;
  const std::string_view whole(
    fault.lineBegin, static_cast<std::size_t>(lineEnd - fault.lineBegin));
  const std::size_t found = splitValues(whole, format).size();
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
  {
    const auto rest = splitValues(
      std::string_view(fault.token, static_cast<std::size_t>(lineEnd - fault.token)), format);
    const std::string value = rest.empty() ? "" : rest.front().substr(0, 40);
    sentence = "expected a number for '" + columns[fault.column].name + "', found " +
               (value.empty() ? "nothing" : "'" + value + "'");
  }
  }
  return {FileError::Kind::Malformed, cursor.path(), sentence, line, column};
}

/// Finds which rows the pieces are, at most `rows` of them, and parses them.
void parseBatch(std::vector<Piece>& pieces, std::uint64_t firstRow, std::uint64_t rows,
  const std::vector<TextColumn>& columns, const RowsStored& stored, const RowFormat& format)
{
  tbb::parallel_for(std::size_t{0}, pieces.size(),
    [&](std::size_t i) { pieces[i].rows = rowsIn(pieces[i].text, format); });
  for (Piece& piece : pieces)
  {
    piece.firstRow = firstRow;
    piece.rows = std::min(piece.rows, rows);
    firstRow += piece.rows;
    rows -= piece.rows;
  }
  tbb::parallel_for(std::size_t{0}, pieces.size(),
    [&](std::size_t i) { parsePiece(pieces[i], columns, stored, format); });
}

void report(const Progress& progress, double fraction, const TextCursor& cursor)
{
  if (progress && !progress(fraction))
    throw FileError(FileError::Kind::Aborted, cursor.path(), "reading was aborted");
}

} // namespace

RowsResult readRows(TextCursor& cursor, std::uint64_t rows, const std::vector<TextColumn>& columns,
  const RowsStored& stored, const Progress& progress, const RowFormat& format)
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
    parseBatch(pieces, done, rows - done, columns, stored, format);
    std::size_t bytes = 0;
    std::uint64_t lines = 0, read = 0;
    for (const Piece& piece : pieces)
    {
      if (piece.fault && piece.fault->trouble == Trouble::Widen)
        return {false, {piece.fault->column, piece.fault->wider}};
      const auto linesOf = [&](std::size_t n)
      { return countBytes(piece.text.substr(0, n), '\n', '\n').first; };
      if (piece.fault)
      {
        lines += linesOf(static_cast<std::size_t>(piece.fault->lineBegin - piece.text.data()));
        throw describe(*piece.fault, columns, format, cursor, cursor.line() + lines);
      }
      bytes += piece.bytes;
      lines += format.skipsBlankLines ? linesOf(piece.bytes) : piece.rows;
      read += piece.rows;
    }
    cursor.advance(bytes, lines);
    done += read;
  }
  report(progress, 1.0, cursor);
  return {};
}

std::uint64_t countRows(TextCursor& cursor, const RowFormat& format)
{
  std::uint64_t rows = 0;
  for (;;)
  {
    const std::string_view block = cursor.block(BatchBytes / 16);
    if (block.empty())
      return rows;
    rows += rowsIn(block, format);
    cursor.advance(block.size(), countBytes(block, '\n', '\n').first);
  }
}

void skipRows(TextCursor& cursor, std::uint64_t rows, const RowFormat& format)
{
  while (rows > 0)
  {
    std::string_view text = cursor.block(BatchBytes / 4);
    if (text.empty())
      return; // which who reads on will tell
    std::uint64_t count = rowsIn(text, format);
    if (count > rows)
    {
      std::size_t bytes = 0;
      for (count = 0; count < rows; bytes = lineEnd(text, bytes))
        count += !format.skipsBlankLines ||
                 !isBlankLine(text.substr(bytes, lineEnd(text, bytes) - bytes), format);
      text = text.substr(0, bytes);
    }
    cursor.advance(text.size(), countBytes(text, '\n', '\n').first);
    rows -= count;
  }
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
