#include "LAMMPSDump.h"

#include "LAMMPSBinary.h"
#include "LAMMPSData.h"
#include "LAMMPSHeader.h"

#include <algorithm>

namespace mote
{
namespace
{

constexpr std::size_t SkipBytes = std::size_t{1} << 20;

bool startsFrame(std::string_view line)
{
  return line.starts_with("ITEM: TIMESTEP") || line.starts_with("ITEM: UNITS") ||
         line.starts_with("ITEM: TIME");
}

/// Scans one file from its beginning to its end.
class Indexer
{
public:
  Indexer(const std::string& path, const Progress& progress)
    : m_cursor(path)
    , m_progress(progress)
  {
  }

  LAMMPSIndex run(const LAMMPSIndex* before)
  {
    checkBeginning();
    if (before && !goOnAfter(*before))
      return Indexer(m_cursor.path(), m_progress).run(nullptr);
    while (indexFrame())
    {
    }
    if (m_index.frames.empty())
    {
      throw m_lastDamage
        ? *m_lastDamage
        : FileError(FileError::Kind::Truncated, m_cursor.path(), "the file has no time step");
    }
    return std::move(m_index);
  }

private:
  void checkBeginning();
  bool goOnAfter(const LAMMPSIndex& before);
  bool indexFrame();
  void skipRows(const LAMMPSFrame& frame);
  std::uint64_t skipLines(std::uint64_t lines);
  bool resynchronise();
  void report();

  TextCursor m_cursor;
  const Progress& m_progress;
  LAMMPSIndex m_index;
  std::optional<FileError> m_lastDamage;
};

void Indexer::report()
{
  if (m_progress && !m_progress(m_cursor.fraction()))
    throw FileError(FileError::Kind::Aborted, m_cursor.path(), "reading was aborted");
}

void Indexer::checkBeginning()
{
  const std::string beginning = readBeginning(m_cursor.path(), 4096);
  const auto refuse = [&](FileError::Kind kind, const std::string& sentence) -> void
  { throw FileError(kind, m_cursor.path(), sentence); };
  if (startsFrame(beginning))
    return;
  if (beginning.empty())
  {
    std::string_view line;
    m_cursor.peekLine(line); // damaged gzip says so itself
    refuse(FileError::Kind::Truncated, "the file is empty");
  }
  if (beginning.find('\0') != std::string::npos)
    refuse(FileError::Kind::OtherFormat, "this is a binary file, not a LAMMPS text dump");
  const std::string line = beginning.substr(0, std::min<std::size_t>(beginning.find('\n'), 40));
  throw FileError(FileError::Kind::OtherFormat, m_cursor.path(),
    "this is no LAMMPS text dump: expected 'ITEM: TIMESTEP', found '" + line + "'", 1);
}

/// Takes all frames but the last from an index, and reads that again, which may have been half
/// written; false where it is another one by now. Compressed text cannot be entered where its end
/// was, which has become another.
bool Indexer::goOnAfter(const LAMMPSIndex& before)
{
  if (before.frames.empty() || before.frames.back().start.snapshot)
    return false;
  const LAMMPSFrame& last = before.frames.back();
  try
  {
    m_cursor.seek(last.start);
    m_index.frames.assign(before.frames.begin(), before.frames.end() - 1);
    return indexFrame() && m_index.frames.size() == before.frames.size() &&
           m_index.frames.back().timestep == last.timestep;
  }
  catch (const FileError& damage)
  {
    if (damage.kind() == FileError::Kind::Aborted)
      throw;
    return false;
  }
}

/// Adds the next frame to the index; false at the end of the file.
bool Indexer::indexFrame()
{
  LAMMPSFrame frame;
  frame.start = m_cursor.place();
  LAMMPSHeader header(m_cursor, frame);
  if (!m_index.frames.empty())
  {
    frame.units = m_index.frames.back().units;
    frame.columns = m_index.frames.back().columns;
  }
  try
  {
    report();
    if (!header.read())
      return false;
    skipRows(frame);
  }
  catch (const FileError& damage)
  {
    if (damage.kind() == FileError::Kind::Aborted)
      throw;
    m_lastDamage = damage;
    if (!header.hasTimestep())
    {
      m_index.warning = damage.what();
      return resynchronise();
    }
    frame.damage = damage;
    m_index.frames.push_back(std::move(frame));
    return resynchronise();
  }
  m_index.frames.push_back(std::move(frame));
  return true;
}

/// Passes over a frame's atoms and makes sure that they are as many as announced.
void Indexer::skipRows(const LAMMPSFrame& frame)
{
  const auto damaged = [&](FileError::Kind kind, const std::string& sentence)
  {
    return FileError(kind, m_cursor.path(),
      "step " + std::to_string(frame.timestep) + " announces " + std::to_string(frame.atoms) +
        (frame.atoms == 1 ? " atom" : " atoms") + ", but " + sentence,
      m_cursor.line());
  };
  const std::uint64_t found = skipLines(frame.atoms);
  std::string_view line;
  if (found < frame.atoms)
  {
    const std::string after = std::to_string(found);
    throw m_cursor.peekLine(line)
      ? damaged(FileError::Kind::Malformed,
          "'" + std::string(line.substr(0, 40)) + "' follows after " + after)
      : damaged(FileError::Kind::Truncated, "the file ends after " + after + ": it is truncated");
  }
  while (m_cursor.peekLine(line) && line.find_first_not_of(" \t\r") == line.npos)
    m_cursor.nextLine(line);
  if (m_cursor.peekLine(line) && !line.starts_with("ITEM:"))
  {
    throw damaged(
      FileError::Kind::Malformed, "more follow: '" + std::string(line.substr(0, 40)) + "'");
  }
}

/// Moves past up to `lines` lines, but not past one that begins an item. Returns how many.
std::uint64_t Indexer::skipLines(std::uint64_t lines)
{
  std::uint64_t done = 0;
  while (done < lines)
  {
    const std::string_view block = m_cursor.block(SkipBytes);
    if (block.empty())
      break;
    const ByteCounts counts = countBytes(block, '\n', ':');
    if (counts.second == 0 && counts.first <= lines - done)
    {
      m_cursor.advance(block.size(), counts.first); // no colon, so no item
      done += counts.first;
      report();
      continue;
    }
    std::size_t at = 0;
    std::uint64_t passed = 0;
    while (at < block.size() && done + passed < lines && !block.substr(at).starts_with("ITEM:"))
    {
      at = block.find('\n', at) + 1;
      ++passed;
    }
    m_cursor.advance(at, passed);
    done += passed;
    report();
    if (at < block.size())
      break;
  }
  return done;
}

/// After damage: moves to the beginning of the next frame; false if there is none.
bool Indexer::resynchronise()
{
  try
  {
    std::string_view line;
    while (m_cursor.peekLine(line))
    {
      if (startsFrame(line))
        return true;
      m_cursor.nextLine(line);
      skipLines(~std::uint64_t{0});
    }
  }
  catch (const FileError& damage)
  {
    if (damage.kind() == FileError::Kind::Aborted)
      throw;
  }
  return false;
}

} // namespace

bool looksLikeLAMMPSDump(std::string_view beginning)
{
  return startsFrame(beginning) || looksLikeBinaryDump(beginning) || looksLikeLAMMPSData(beginning);
}

LAMMPSIndex indexLAMMPSDump(
  const std::string& path, const Progress& progress, const LAMMPSIndex* before)
{
  if (looksLikeBinaryDump(readBeginning(path, 128)))
    return indexBinaryDump(path, progress);
  if (looksLikeLAMMPSData(readBeginning(path, 4096)))
    return {{readLAMMPSDataHeader(path, progress)}, ""};
  return Indexer(path, progress).run(before);
}

} // namespace mote
