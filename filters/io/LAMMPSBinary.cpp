#include "LAMMPSBinary.h"

#include "LAMMPSHeader.h"
#include "NumberAt.h"
#include "StoreNumber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace mote
{
namespace
{

constexpr int mostColumns = 10'000;
constexpr std::size_t bytesOfValue = sizeof(double);

/// Goes through the steps of a file.
class BinaryIndexer
{
public:
  BinaryIndexer(const std::string& path, const Progress& progress)
    : m_file(path)
    , m_bytes(m_file.text())
    , m_progress(progress)
  {
  }

  LAMMPSIndex run()
  {
    while (m_at < m_bytes.size())
    {
      LAMMPSFrame frame;
      m_hasTimestep = false;
      try
      {
        readFrame(frame);
      }
      catch (const FileError& damage)
      {
        // What follows damage cannot be found: nothing marks the begin of a step.
        if (damage.kind() == FileError::Kind::Aborted)
          throw;
        if (!m_hasTimestep && m_index.frames.empty())
          throw;
        if (!m_hasTimestep)
          m_index.warning = damage.what();
        else
        {
          frame.damage = damage;
          m_index.frames.push_back(std::move(frame));
        }
        break;
      }
      m_index.frames.push_back(std::move(frame));
      if (m_progress &&
          !m_progress(static_cast<double>(m_at) / static_cast<double>(m_bytes.size())))
        throw FileError(FileError::Kind::Aborted, m_file.path(), "reading was aborted");
    }
    if (m_index.frames.empty())
      throw FileError(FileError::Kind::Truncated, m_file.path(), "the file has no time step");
    return std::move(m_index);
  }

private:
  [[noreturn]] void refuse(const std::string& sentence) const
  {
    throw FileError(
      FileError::Kind::Malformed, m_file.path(), sentence + ", at byte " + std::to_string(m_at));
  }

  std::string_view take(std::uint64_t bytes)
  {
    if (m_bytes.size() - m_at < bytes)
      throw FileError(FileError::Kind::Truncated, m_file.path(),
        "the file ends within a time step: it is truncated");
    const std::string_view taken = m_bytes.substr(m_at, bytes);
    m_at += bytes;
    return taken;
  }

  template <class Number>
  Number next()
  {
    return numberAt<Number>(take(sizeof(Number)).data(), m_isSwapped);
  }

  std::string nextText()
  {
    const auto length = next<std::int32_t>();
    if (length < 0 || length > 1'000'000)
      refuse("a text cannot be " + std::to_string(length) + " bytes long");
    return std::string(take(static_cast<std::uint64_t>(length)));
  }

  void readFrame(LAMMPSFrame& frame)
  {
    frame.start.offset = m_at;
    m_isSwapped = false;
    auto first = next<std::int64_t>();
    // A step of a named dump begins with the length of the name, below zero, in its byte order.
    const auto isLength = [](std::int64_t number) { return number < 0 && number >= -64; };
    const bool isSwappedName = !isLength(first) && isLength(swappedOf(first));
    const bool isNamed = isLength(first) || isSwappedName;
    std::int32_t revision = 0;
    if (isNamed)
    {
      take(static_cast<std::uint64_t>(-(isSwappedName ? swappedOf(first) : first)));
      const auto order = next<std::int32_t>();
      m_isSwapped = order != 1;
      revision = next<std::int32_t>();
      first = next<std::int64_t>();
    }
    frame.timestep = first;
    const auto atoms = next<std::int64_t>();
    if (atoms < 0 || static_cast<std::uint64_t>(atoms) > m_bytes.size())
      refuse("the file has no room for " + std::to_string(atoms) + " atoms");
    frame.atoms = static_cast<std::uint64_t>(atoms);
    readBox(frame.box);
    const auto columns = next<std::int32_t>();
    if (columns < 3 || columns > mostColumns)
      refuse("there are no atoms of " + std::to_string(columns) + " values");
    frame.columns = m_index.frames.empty() ? nullptr : m_index.frames.back().columns;
    if (isNamed && revision > 1)
      readNames(frame, columns);
    m_hasTimestep = frame.columns != nullptr;
    const auto chunks = readChunks(frame, columns);
    if (!frame.columns || static_cast<std::int32_t>(frame.columns->size()) != columns)
      frame.columns = guessColumns(*chunks, columns);
    frame.chunks = chunks;
  }

  static std::int64_t swappedOf(std::int64_t number)
  {
    return numberAt<std::int64_t>(reinterpret_cast<const char*>(&number), true);
  }

  void readBox(LAMMPSBox& box)
  {
    const auto kind = next<std::int32_t>(); // 0 orthogonal, 1 triclinic, 2 general triclinic
    if (kind < 0 || kind > 2)
      refuse("there is no box of kind " + std::to_string(kind));
    for (int face = 0; face < 6; ++face)
    {
      const auto flag = next<std::int32_t>();
      if (flag < 0 || flag > 3)
        refuse("there is no boundary of kind " + std::to_string(flag));
      if (face > 0 && face % 2 == 0)
        box.boundary += ' ';
      box.boundary += "pfsm"[flag];
    }
    box.general = kind == 2;
    if (box.general)
    {
      for (auto& vector : box.cell)
        nextNumbers(vector.data(), 3);
      nextNumbers(box.origin.data(), 3);
    }
    else
    {
      double rows[3][3] = {};
      for (auto& row : rows)
        nextNumbers(row, 2);
      for (auto& row : rows)
        row[2] = kind == 1 ? next<double>() : 0.0;
      setTilted(box, rows);
    }
    for (const auto& vector : box.cell)
      for (const double value : vector)
        if (!std::isfinite(value))
          refuse("the box has no finite size");
    box.known = true;
  }

  void nextNumbers(double* numbers, int count)
  {
    for (int i = 0; i < count; ++i)
      numbers[i] = next<double>();
  }

  void readNames(LAMMPSFrame& frame, std::int32_t columns)
  {
    const std::string units = nextText();
    frame.units = units.empty() && !m_index.frames.empty() ? m_index.frames.back().units : units;
    if (next<char>() != 0)
      frame.time = next<double>();
    auto names = splitValues(nextText());
    if (names.size() != static_cast<std::size_t>(columns))
      refuse("the dump names " + std::to_string(names.size()) + " of its " +
             std::to_string(columns) + " columns");
    if (!frame.columns || *frame.columns != names)
      frame.columns = std::make_shared<const std::vector<std::string>>(std::move(names));
  }

  /// What each process wrote.
  std::shared_ptr<const std::vector<LAMMPSChunk>> readChunks(
    const LAMMPSFrame& frame, std::int32_t columns)
  {
    auto chunks = std::make_shared<std::vector<LAMMPSChunk>>();
    const auto count = next<std::int32_t>();
    std::uint64_t atoms = 0;
    if (count < 0)
      refuse("there are no " + std::to_string(count) + " blocks of atoms");
    for (std::int32_t i = 0; i < count; ++i)
    {
      const auto values = next<std::int32_t>();
      if (values < 0 || values % columns != 0)
        refuse("a block of " + std::to_string(values) + " values has no whole atoms");
      const auto rows = static_cast<std::uint64_t>(values / columns);
      chunks->push_back({m_at, atoms, m_isSwapped});
      take(static_cast<std::uint64_t>(values) * bytesOfValue);
      atoms += rows;
    }
    if (atoms != frame.atoms)
      refuse("step " + std::to_string(frame.timestep) + " announces " +
             std::to_string(frame.atoms) + " atoms, and has " + std::to_string(atoms));
    return chunks;
  }

  /// Names for columns that the file does not name.
  std::shared_ptr<const std::vector<std::string>> guessColumns(
    const std::vector<LAMMPSChunk>& chunks, std::int32_t columns)
  {
    std::vector<std::string> names = {"id", "type", "x", "y", "z"};
    if (columns < 5)
      refuse("a dump of old has no names for its " + std::to_string(columns) + " columns");
    bool areFractions = !chunks.empty();
    for (std::size_t i = 0; i < chunks.size() && areFractions; ++i)
    {
      const std::size_t end = i + 1 < chunks.size() ? chunks[i + 1].offset - 4 : m_at;
      const std::size_t row = bytesOfValue * static_cast<std::size_t>(columns);
      for (std::size_t at = chunks[i].offset; at + row <= end && areFractions; at += row)
        for (std::size_t axis = 2; axis < 5; ++axis)
        {
          const auto place =
            numberAt<double>(m_bytes.data() + at + axis * bytesOfValue, m_isSwapped);
          areFractions = areFractions && place >= -0.01 && place <= 1.01;
        }
    }
    for (std::size_t axis = 2; axis < 5 && areFractions; ++axis)
      names[axis] += 's';
    while (names.size() < static_cast<std::size_t>(columns))
      names.push_back(unnamedColumn(names.size() + 1, names));
    return std::make_shared<const std::vector<std::string>>(std::move(names));
  }

  TextFile m_file;
  std::string_view m_bytes;
  std::size_t m_at = 0;
  const Progress& m_progress;
  bool m_isSwapped = false;
  bool m_hasTimestep = false; ///< enough of a step is known to list it
  LAMMPSIndex m_index;
};

} // namespace

bool looksLikeBinaryDump(std::string_view beginning)
{
  const std::string_view name = beginning.substr(0, std::min<std::size_t>(beginning.size(), 24));
  if (name.find("DUMPATOM") == 8 || name.find("DUMPCUSTOM") == 8)
    return true;
  // Without a name: a step, a number of atoms, a kind of box and the six flags of its boundary.
  if (beginning.size() < 100)
    return false;
  const auto step = numberAt<std::int64_t>(beginning.data(), false);
  const auto atoms = numberAt<std::int64_t>(beginning.data() + 8, false);
  bool isLike =
    step >= 0 && step < (std::int64_t{1} << 48) && atoms > 0 && atoms < (std::int64_t{1} << 48);
  for (std::size_t at = 16; at < 44; at += 4)
  {
    const auto flag = numberAt<std::int32_t>(beginning.data() + at, false);
    isLike = isLike && flag >= 0 && flag <= (at == 16 ? 1 : 3);
  }
  for (std::size_t at = 44; at < 92; at += 16)
  {
    const auto low = numberAt<double>(beginning.data() + at, false);
    const auto high = numberAt<double>(beginning.data() + at + 8, false);
    isLike = isLike && std::isfinite(low) && std::isfinite(high) && low < high;
  }
  return isLike;
}

LAMMPSIndex indexBinaryDump(const std::string& path, const Progress& progress)
{
  return BinaryIndexer(path, progress).run();
}

void readBinaryRows(const std::string& path, const LAMMPSFrame& frame, std::uint64_t first,
  std::uint64_t count, const std::vector<TextColumn>& targets, const RowsStored& stored,
  const Progress& progress)
{
  const TextFile file(path);
  const std::string_view bytes = file.text();
  const std::size_t row = bytesOfValue * frame.columns->size();
  for (std::size_t k = 0; k < frame.chunks->size(); ++k)
  {
    const LAMMPSChunk& chunk = (*frame.chunks)[k];
    const bool isLast = k + 1 == frame.chunks->size();
    const std::uint64_t end = isLast ? frame.atoms : (*frame.chunks)[k + 1].first;
    if (chunk.offset + (end - chunk.first) * row > bytes.size())
      throw FileError(FileError::Kind::Truncated, path, "the file has become shorter");
    const std::uint64_t from = std::max(first, chunk.first);
    const std::uint64_t to = std::min(first + count, end);
    if (from >= to)
      continue;
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(from, to, 4096),
      [&](const tbb::blocked_range<std::uint64_t>& range)
      {
        for (std::size_t column = 0; column < targets.size(); ++column)
          for (std::uint64_t atom = range.begin(); targets[column].data && atom < range.end();
               ++atom)
            storeNumber(targets[column], atom - first,
              numberAt<double>(
                bytes.data() + chunk.offset + (atom - chunk.first) * row + column * bytesOfValue,
                chunk.isSwapped));
        if (stored)
          stored(range.begin() - first, range.size());
      });
    if (progress && !progress(static_cast<double>(to - first) / static_cast<double>(count)))
      throw FileError(FileError::Kind::Aborted, path, "reading was aborted");
  }
}

} // namespace mote
