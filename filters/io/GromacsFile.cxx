#include "GromacsFile.h"

#include "FileError.h"
#include "ParseNumber.h"
#include "PolyDataParts.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace mote
{
namespace
{

/// Residue number and name, atom name and number: five columns each.
constexpr std::size_t fieldWidth = 5, fieldsWidth = 4 * fieldWidth;
constexpr std::uint64_t mostNumbered = 99'999; ///< which five digits hold

struct Frame
{
  std::uint64_t atoms = 0;
  std::optional<double> time;
  TextCursor::Place rows;
  std::uint64_t firstLine = 0;
  std::array<double, 9> box{}; ///< a, b, c
  std::size_t width = 0;       ///< of a number's columns
  bool hasVelocities = false;
};

std::optional<double> timeOf(std::string_view title)
{
  const std::size_t at = title.rfind("t=");
  if (at == title.npos)
    return {};
  const std::vector<std::string> words = splitValues(title.substr(at + 2));
  double time = 0;
  return !words.empty() && parseDouble(words[0].c_str(), time) ? std::optional(time) : std::nullopt;
}

/// The columns that a number takes: from one decimal point to the next.
std::size_t widthOf(std::string_view row)
{
  const std::size_t first = row.find('.', fieldsWidth);
  const std::size_t second = first == row.npos ? row.npos : row.find('.', first + 1);
  return second == row.npos ? 0 : second - first;
}

class Gromacs final : public StepSource
{
public:
  Gromacs(const std::string& path, const Progress& progress)
    : m_path(path)
  {
    TextCursor cursor(path, TextCursor::OpenEnd::Accept);
    std::string_view title;
    while (cursor.nextLine(title))
    {
      if (splitValues(title).empty() && !m_frames.empty())
        continue; // blank lines at the end
      m_frames.push_back(frameOf(cursor, title, progress));
    }
    setTimes();
  }

  std::vector<double> times() const override
  {
    std::vector<double> times;
    for (const Frame& frame : m_frames)
      times.push_back(*frame.time);
    return times;
  }

  void read(const SourceRequest& request, vtkPolyData* output) override
  {
    const Frame& frame = m_frames[request.step];
    RowLayout layout(frame.atoms);
    layout.addPositions();
    layout.add("id", ColumnType::Int64);
    layout.add("residue", ColumnType::Int32);
    layout.add("residue_name", ColumnType::String);
    const std::size_t name = layout.add("name", ColumnType::String);
    if (frame.hasVelocities)
      layout.add("v", ColumnType::Float64, 3);
    PointRows rows = layout.rowsFor(request);
    NumberedWords words;
    words.column = name;
    rows.words = &words;
    TextCursor cursor(m_path, TextCursor::OpenEnd::Accept);
    if (!request.piece.isAll())
      numberAll(cursor, frame, words.table); // alike in all pieces
    makePointRows(
      std::move(rows),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored&)
      {
        readAtoms(cursor, frame, first, count, targets, request.progress);
        return RowsResult();
      },
      output);
    addTypes(words, typesOf(words.table.words(), false), output);
    addBox(frame.box, {0, 0, 0}, "pp pp pp", output);
    addText(output->GetFieldData(), "units", "nm, ps");
  }

private:
  [[noreturn]] void fail(const std::string& sentence, std::uint64_t line) const
  {
    throw FileError(m_frames.empty() ? FileError::Kind::OtherFormat : FileError::Kind::Malformed,
      m_path, sentence, line);
  }

  std::string_view requireLine(TextCursor& cursor, const char* what) const
  {
    std::string_view line;
    if (!cursor.nextLine(line))
      throw FileError(FileError::Kind::Truncated, m_path,
        std::string("the file ends where ") + what + " should be: it is truncated", cursor.line());
    return line;
  }

  Frame frameOf(TextCursor& cursor, std::string_view title, const Progress& progress) const
  {
    Frame frame;
    frame.time = timeOf(title);
    const std::uint64_t line = cursor.line();
    const std::string count(requireLine(cursor, "the number of atoms"));
    const std::vector<std::string> words = splitValues(count);
    std::int64_t atoms = -1;
    if (words.size() != 1 || !parseInteger(words[0].c_str(), atoms) || atoms < 0)
      fail("expected the number of atoms of a GROMACS frame, found '" + count.substr(0, 40) + "'",
        line);
    frame.atoms = static_cast<std::uint64_t>(atoms);
    frame.rows = cursor.place();
    frame.firstLine = cursor.line();
    for (std::uint64_t atom = 0; atom < frame.atoms; ++atom)
    {
      const std::string_view row = requireLine(cursor, "an atom");
      if (atom == 0)
        measure(frame, row);
      if (atom % 65536 == 0 && progress && !progress(cursor.fraction()))
        throw FileError(FileError::Kind::Aborted, m_path, "reading was aborted");
    }
    readBox(frame, requireLine(cursor, "the box"), cursor.line() - 1);
    return frame;
  }

  void measure(Frame& frame, std::string_view row) const
  {
    frame.width = widthOf(row);
    if (frame.width < 3 || frame.width > 30 || row.size() < fieldsWidth + 3 * frame.width)
      fail("this is no atom of a GROMACS file: '" + std::string(row.substr(0, 40)) + "'",
        frame.firstLine);
    // Velocities have one decimal more, in the same width.
    frame.hasVelocities = row.size() >= fieldsWidth + 6 * frame.width;
  }

  /// Three lengths, or nine: the diagonal, then what is beside it.
  void readBox(Frame& frame, std::string_view line, std::uint64_t number) const
  {
    const std::vector<std::string> words = splitValues(line);
    std::array<double, 9> v{};
    const bool isKnown = words.size() == 3 || words.size() == 9;
    for (std::size_t i = 0; isKnown && i < words.size(); ++i)
      if (!parseDouble(words[i].c_str(), v[i]))
        fail("expected the lengths of the box, found '" + words[i] + "'", number);
    if (!isKnown)
      fail(
        "expected a box of three numbers or nine, found " + std::to_string(words.size()), number);
    frame.box = {v[0], v[3], v[4], v[5], v[1], v[6], v[7], v[8], v[2]};
  }

  void setTimes()
  {
    if (m_frames.empty())
      throw FileError(FileError::Kind::Truncated, m_path, "the file is empty");
    const auto isBefore = [](const Frame& a, const Frame& b)
    { return a.time && b.time && *a.time < *b.time; };
    bool areTold = m_frames.front().time.has_value();
    for (std::size_t i = 1; i < m_frames.size(); ++i)
      areTold = areTold && isBefore(m_frames[i - 1], m_frames[i]);
    for (std::size_t i = 0; !areTold && i < m_frames.size(); ++i)
      m_frames[i].time = static_cast<double>(i);
  }

  static std::string_view trimmed(std::string_view field)
  {
    while (!field.empty() && field.front() == ' ')
      field.remove_prefix(1);
    while (!field.empty() && field.back() == ' ')
      field.remove_suffix(1);
    return field;
  }

  void numberAll(TextCursor& cursor, const Frame& frame, WordTable& table) const
  {
    cursor.seek(frame.rows);
    std::string_view line;
    for (std::uint64_t atom = 0; atom < frame.atoms && cursor.nextLine(line); ++atom)
      if (line.size() >= fieldsWidth)
        table.numberOf(std::string(trimmed(line.substr(2 * fieldWidth, fieldWidth))));
  }

  /// A block of lines at a time: their ends one after the other, their values in parallel.
  void readAtoms(TextCursor& cursor, const Frame& frame, std::uint64_t first, std::uint64_t count,
    const std::vector<TextColumn>& targets, const Progress& progress) const
  {
    constexpr std::size_t blockBytes = std::size_t{8} << 20;
    cursor.seek(frame.rows);
    std::uint64_t atom = 0; // of the frame
    std::vector<std::string_view> lines;
    while (atom < first + count)
    {
      const std::string_view block = cursor.block(blockBytes);
      lines.clear();
      std::size_t at = 0;
      while (at < block.size() && atom + lines.size() < first + count)
      {
        const std::size_t end = block.find('\n', at);
        lines.push_back(block.substr(at, end - at));
        at = end + 1;
      }
      if (lines.empty())
        throw FileError(FileError::Kind::Truncated, m_path, "the file has become shorter");
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lines.size(), 1000),
        [&](const tbb::blocked_range<std::size_t>& range)
        {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
            if (atom + i >= first)
              readAtom(frame, lines[i], atom + i, first, targets);
        });
      cursor.advance(at, lines.size());
      atom += lines.size();
      if (progress && !progress(static_cast<double>(atom) / static_cast<double>(first + count)))
        throw FileError(FileError::Kind::Aborted, m_path, "reading was aborted");
    }
  }

  void readAtom(const Frame& frame, std::string_view line, std::uint64_t atom, std::uint64_t first,
    const std::vector<TextColumn>& targets) const
  {
    const std::uint64_t row = atom - first;
    const std::size_t numbers = frame.hasVelocities ? 6 : 3;
    const auto field = [&](std::size_t at, std::size_t width)
    { return trimmed(line.substr(at, width)); };
    if (line.size() < fieldsWidth + numbers * frame.width)
      fail("this line has " + std::to_string(line.size()) + " columns, and the frame's first has " +
             std::to_string(fieldsWidth + numbers * frame.width),
        frame.firstLine + atom);
    for (std::size_t i = 0; i < numbers; ++i)
    {
      const std::string_view text = field(fieldsWidth + i * frame.width, frame.width);
      storeNumber(targets[i < 3 ? i : i + 4], row, numberOf<double>(text, frame, atom));
    }
    const auto written = numberOf<std::int64_t>(field(15, fieldWidth), frame, atom);
    const bool isCounted = frame.atoms > mostNumbered;
    storeNumber(targets[3], row, isCounted ? static_cast<std::int64_t>(atom + 1) : written);
    storeNumber(targets[4], row, numberOf<std::int64_t>(field(0, fieldWidth), frame, atom));
    storeText(targets[5], row, field(fieldWidth, fieldWidth));
    storeText(targets[6], row, field(2 * fieldWidth, fieldWidth));
  }

  template <class Number>
  Number numberOf(std::string_view text, const Frame& frame, std::uint64_t atom) const
  {
    Number value{};
    const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      fail("expected a number, found '" + std::string(text) + "'", frame.firstLine + atom);
    return value;
  }

  std::string m_path;
  std::vector<Frame> m_frames;
};

} // namespace

std::unique_ptr<StepSource> openGromacs(const std::string& path, const Progress& progress)
{
  return std::make_unique<Gromacs>(path, progress);
}

} // namespace mote
