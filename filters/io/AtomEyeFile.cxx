#include "AtomEyeFile.h"

#include "FileError.h"
#include "ParseNumber.h"
#include "PolyDataParts.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace mote
{
namespace
{

std::string_view trimmed(std::string_view text)
{
  while (!text.empty() && endsToken(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && endsToken(text.back()))
    text.remove_suffix(1);
  return text;
}

class AtomEye final : public StepSource
{
public:
  explicit AtomEye(const std::string& path)
    : m_path(path)
  {
    TextCursor cursor(path, TextCursor::OpenEnd::Accept);
    readHeader(cursor);
    m_rows = cursor.place();
  }

  std::vector<double> times() const override { return {0.0}; }

  void read(const SourceRequest& request, vtkPolyData* output) override
  {
    RowLayout layout(m_particles);
    layout.addPositions();
    layout.add("mass", ColumnType::Float64);
    const std::size_t element = layout.add("element", ColumnType::String);
    if (m_hasVelocities)
      layout.add("v", ColumnType::Float64, 3);
    for (const std::string& name : m_auxiliary)
      layout.add(name, ColumnType::Float64);
    PointRows rows = layout.rowsFor(request);
    NumberedWords words;
    words.column = element;
    rows.words = &words;
    makePointRows(
      std::move(rows),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored&)
      {
        readAtoms(first, count, targets, request.progress, words.table);
        return RowsResult();
      },
      output);
    addTypes(words, typesOf(words.table.words(), true), output);
    addBox(m_cell, {0, 0, 0}, "pp pp pp", output);
  }

private:
  [[noreturn]] void fail(const std::string& sentence, std::uint64_t line) const
  {
    throw FileError(FileError::Kind::Malformed, m_path, sentence, line);
  }

  /// The next line with something in it, without its comment.
  bool nextLine(TextCursor& cursor, std::string_view& text) const
  {
    std::string_view line;
    while (cursor.nextLine(line))
    {
      text = trimmed(line.substr(0, line.find('#')));
      if (!text.empty())
        return true;
    }
    return false;
  }

  double numberOf(std::string_view text, std::uint64_t line) const
  {
    const std::vector<std::string> words = splitValues(text);
    double value = 0;
    if (words.empty() || !parseDouble(words[0].c_str(), value))
      fail("expected a number, found '" + std::string(text.substr(0, 40)) + "'", line);
    return value;
  }

  /// Lines "NAME = VALUE" up to the first atom.
  void readHeader(TextCursor& cursor)
  {
    m_hasVelocities = true;
    std::string_view text;
    TextCursor::Place before = cursor.place();
    while (before = cursor.place(), nextLine(cursor, text))
    {
      const std::uint64_t line = cursor.line() - 1;
      if (text == ".NO_VELOCITY.")
      {
        m_hasVelocities = false;
        continue;
      }
      const std::size_t sign = text.find('=');
      if (sign == text.npos)
        break; // an atom
      take(std::string(trimmed(text.substr(0, sign))), trimmed(text.substr(sign + 1)), line);
    }
    cursor.seek(before);
    finish();
  }

  void take(const std::string& name, std::string_view value, std::uint64_t line)
  {
    if (name == "Number of particles")
    {
      const double count = numberOf(value, line);
      if (!(count >= 0 && count < 1e12))
        fail("there are no " + std::string(value.substr(0, 40)) + " particles", line);
      m_particles = static_cast<std::uint64_t>(count);
      m_hasCount = true;
    }
    else if (name == "A")
      m_length = numberOf(value, line);
    else if (name == "R")
      m_rate = numberOf(value, line);
    else if (name.size() == 7 && name.starts_with("H0(") && name[4] == ',' && name[6] == ')' &&
             name[3] >= '1' && name[3] <= '3' && name[5] >= '1' && name[5] <= '3')
      m_cell[static_cast<std::size_t>(3 * (name[3] - '1') + name[5] - '1')] = numberOf(value, line);
    else if (name == "entry_count")
    {
      m_entries = static_cast<std::size_t>(std::clamp(numberOf(value, line), 0.0, 1000.0));
      m_isExtended = true;
    }
    else if (name.starts_with("auxiliary["))
      m_auxiliary.emplace_back(trimmed(value.substr(0, value.find('['))));
  }

  void finish()
  {
    if (!m_hasCount)
      throw FileError(FileError::Kind::OtherFormat, m_path,
        "this is no AtomEye file: it has no 'Number of particles'");
    // A coordinate is a digit and a blank at least; gzip makes a byte of up to 1032.
    const TextFile file(m_path);
    const std::uint64_t most = file.bytes() / 6 * (file.isGzip() ? 1032 : 1) + 1;
    if (m_particles > most)
      throw FileError(FileError::Kind::Truncated, m_path,
        "the file has no room for the " + std::to_string(m_particles) +
          " particles that it announces: it is truncated");
    for (double& value : m_cell)
      value *= m_length;
    // What the file counts but does not name is named by its number.
    const std::size_t fixed = m_hasVelocities ? 6 : 3;
    if (m_isExtended && m_entries < fixed)
      fail("an entry_count of " + std::to_string(m_entries) + " has no room for positions", 0);
    const std::size_t named = m_auxiliary.size();
    const std::size_t wanted = m_isExtended ? m_entries - fixed : 0;
    m_auxiliary.resize(wanted);
    for (std::size_t i = named; i < wanted; ++i)
      m_auxiliary[i] = unnamedColumn(fixed + i + 1, m_auxiliary);
  }

  /// One line after the other: the mass and the element are those of all atoms that follow.
  void readAtoms(std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
    const Progress& progress, WordTable& words) const
  {
    TextCursor cursor(m_path, TextCursor::OpenEnd::Accept);
    cursor.seek(m_rows);
    std::string element;
    double mass = 0;
    const std::size_t fixed = m_hasVelocities ? 6 : 3;
    const std::size_t entries = fixed + m_auxiliary.size();
    std::vector<double> values(entries + 2);
    std::string_view text;
    for (std::uint64_t atom = 0; atom < m_particles;)
    {
      if (!nextLine(cursor, text))
        throw FileError(FileError::Kind::Truncated, m_path,
          "the file ends after " + std::to_string(atom) + " of " + std::to_string(m_particles) +
            " atoms: it is truncated");
      const std::uint64_t line = cursor.line() - 1;
      std::string_view row = text;
      if (!m_isExtended)
      {
        mass = wordNumber(row, line);
        element = std::string(nextWord(row));
      }
      else if (isOneWord(text))
      {
        mass = wordNumber(row, line);
        if (!nextLine(cursor, text))
          continue; // which is told above
        element = std::string(text);
        continue;
      }
      for (std::size_t i = 0; i < entries; ++i)
        values[i] = wordNumber(row, line);
      words.numberOf(element);
      if (atom >= first && atom < first + count)
        store(values, fixed, mass, element, atom - first, targets);
      if (++atom % 65536 == 0 && progress && !progress(cursor.fraction()))
        throw FileError(FileError::Kind::Aborted, m_path, "reading was aborted");
    }
  }

  static std::string_view nextWord(std::string_view& text)
  {
    text = trimmed(text);
    std::size_t length = 0;
    while (length < text.size() && !endsToken(text[length]))
      ++length;
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    return word;
  }

  double wordNumber(std::string_view& text, std::uint64_t line) const
  {
    const std::string_view word = nextWord(text);
    double value = 0;
    // The line's end, or a blank, follows in memory.
    if (word.empty() || parseDouble(word.data(), value) != word.data() + word.size())
      fail(word.empty() ? "this line has too few values"
                        : "expected a number, found '" + std::string(word.substr(0, 40)) + "'",
        line);
    return value;
  }

  static bool isOneWord(std::string_view text)
  {
    return std::none_of(text.begin(), text.end(), endsToken);
  }

  void store(const std::vector<double>& values, std::size_t fixed, double mass,
    const std::string& element, std::uint64_t row, const std::vector<TextColumn>& targets) const
  {
    const auto cartesian = [&](const double* s, std::size_t axis)
    { return s[0] * m_cell[axis] + s[1] * m_cell[3 + axis] + s[2] * m_cell[6 + axis]; };
    std::size_t column = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      storeNumber(targets[column++], row, cartesian(values.data(), axis));
    storeNumber(targets[column++], row, mass);
    storeText(targets[column++], row, element);
    for (std::size_t axis = 0; axis < (m_hasVelocities ? 3u : 0u); ++axis)
      storeNumber(targets[column++], row, m_rate * cartesian(values.data() + 3, axis));
    for (std::size_t i = fixed; i < fixed + m_auxiliary.size(); ++i)
      storeNumber(targets[column++], row, values[i]);
  }

  std::string m_path;
  TextCursor::Place m_rows;
  std::uint64_t m_particles = 0;
  bool m_hasCount = false, m_hasVelocities = true, m_isExtended = false;
  double m_length = 1, m_rate = 1;
  std::array<double, 9> m_cell{}; ///< a, b, c
  std::size_t m_entries = 0;
  std::vector<std::string> m_auxiliary;
};

} // namespace

bool looksLikeAtomEye(std::string_view beginning)
{
  return beginning.find("Number of particles") != beginning.npos;
}

std::unique_ptr<StepSource> openAtomEye(const std::string& path)
{
  return std::make_unique<AtomEye>(path);
}

} // namespace mote
