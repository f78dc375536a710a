#include "TextCursor.h"

#include "FileError.h"

#include <algorithm>
#include <cstring>

namespace mote
{
namespace
{

// Of inflated text, where a line needs no more; a small file does not take the most.
constexpr std::uint64_t LeastBufferBytes = std::uint64_t{1} << 16;
constexpr std::uint64_t MostBufferBytes = std::uint64_t{4} << 20;
constexpr std::size_t LongestLine = std::size_t{64} << 20; // far beyond any format's rows
// Snapshots cost 40 KiB each: one in 8 MiB of text is half a percent, and inflating 8 MiB again
// takes some 25 ms.
constexpr std::uint64_t SnapshotDistance = std::uint64_t{8} << 20;

/// The part of a text that consists of whole lines.
std::string_view wholeLines(std::string_view text)
{
  const void* last = text.empty() ? nullptr : ::memrchr(text.data(), '\n', text.size());
  return last ? text.substr(0, static_cast<const char*>(last) - text.data() + 1)
              : std::string_view();
}

} // namespace

TextCursor::TextCursor(const std::string& path, OpenEnd openEnd)
  : m_file(path)
  , m_openEnd(openEnd)
{
  seek(Place());
}

std::uint64_t TextCursor::offset() const
{
  return m_originOffset + static_cast<std::uint64_t>(m_position - m_origin);
}

double TextCursor::fraction() const
{
  if (m_file.bytes() == 0)
    return 1.0;
  const std::uint64_t done = m_stream ? m_stream->fileOffset() : offset();
  return std::min(1.0, static_cast<double>(done) / static_cast<double>(m_file.bytes()));
}

void TextCursor::seek(const Place& place)
{
  m_atEnd = false;
  m_line = place.line;
  if (!m_file.isGzip())
  {
    const std::string_view text = m_file.text();
    const std::string_view whole = wholeLines(text);
    m_origin = text.data();
    m_originOffset = 0;
    m_position = text.data() + std::min<std::uint64_t>(place.offset, whole.size());
    m_end = text.data() + whole.size();
    return;
  }
  m_stream = std::make_unique<GzipStream>(m_file);
  if (place.snapshot)
    m_stream->restore(*place.snapshot);
  m_snapshot = place.snapshot;
  m_nextSnapshot = nullptr;
  m_buffer.resize(std::clamp(8 * m_file.bytes(), LeastBufferBytes, MostBufferBytes));
  while (m_stream->textOffset() < place.offset)
  {
    const std::uint64_t missing = place.offset - m_stream->textOffset();
    if (m_stream->read(m_buffer.data(), std::min<std::uint64_t>(missing, m_buffer.size())) == 0)
      break;
  }
  m_filled = 0;
  m_origin = m_position = m_end = m_buffer.data();
  m_originOffset = m_stream->textOffset();
}

TextCursor::Place TextCursor::place() const
{
  const std::uint64_t here = offset();
  const bool passed = m_nextSnapshot && m_nextSnapshot->textOffset <= here;
  return {here, m_line, passed ? m_nextSnapshot : m_snapshot};
}

void TextCursor::takeSnapshot()
{
  if (m_nextSnapshot && m_nextSnapshot->textOffset <= offset())
    m_snapshot = std::move(m_nextSnapshot);
  const std::uint64_t last = m_nextSnapshot ? m_nextSnapshot->textOffset
                             : m_snapshot   ? m_snapshot->textOffset
                                            : 0;
  if (!m_nextSnapshot && m_stream->textOffset() >= last + SnapshotDistance)
    m_nextSnapshot = std::make_shared<const GzipStream::Snapshot>(m_stream->snapshot());
}

void TextCursor::acceptOpenEnd(std::string_view rest)
{
  m_atEnd = true;
  if (rest.empty())
    return;
  if (m_openEnd == OpenEnd::Reject)
  {
    throw FileError(FileError::Kind::Truncated, path(),
      "the last line has no line end, so the file may have been cut short here (if "
      "it is whole, add a line end)",
      m_line);
  }
  m_originOffset = offset();
  m_lastLine.assign(rest).push_back('\n');
  m_origin = m_position = m_lastLine.data();
  m_end = m_position + m_lastLine.size();
}

/// Moves the incomplete line behind the window to the front of the buffer and inflates more.
void TextCursor::fillFromStream()
{
  takeSnapshot();
  std::size_t rest = m_filled - static_cast<std::size_t>(m_position - m_buffer.data());
  m_originOffset = offset();
  std::memmove(m_buffer.data(), m_position, rest);
  for (;;)
  {
    const std::size_t count = m_stream->read(m_buffer.data() + rest, m_buffer.size() - rest);
    m_filled = rest + count;
    m_origin = m_position = m_buffer.data();
    m_end = m_position + wholeLines({m_position, m_filled}).size();
    if (m_position != m_end)
      return;
    if (count == 0)
    {
      acceptOpenEnd({m_position, m_filled});
      return;
    }
    if (m_filled > LongestLine)
    {
      throw FileError(FileError::Kind::OtherFormat, path(),
        "this line is longer than 64 MiB: the file is no text", m_line);
    }
    rest = m_filled;
    if (rest == m_buffer.size())
      m_buffer.resize(2 * rest);
  }
}

/// Brings lines into the empty window; false at the end of the text.
bool TextCursor::fill()
{
  if (m_atEnd)
    return false;
  if (m_stream)
    fillFromStream();
  else
    acceptOpenEnd(m_file.text().substr(static_cast<std::size_t>(m_end - m_origin)));
  return m_position != m_end;
}

/// The window ended with a line end when it was made: the file under it is another now.
void TextCursor::failChanged() const
{
  throw FileError(FileError::Kind::Truncated, path(),
    "the file was changed by another program while it was read", m_line);
}

bool TextCursor::peekLine(std::string_view& line)
{
  if (m_position == m_end && !fill())
    return false;
  const auto* lineEnd = static_cast<const char*>(
    std::memchr(m_position, '\n', static_cast<std::size_t>(m_end - m_position)));
  if (!lineEnd)
    failChanged();
  line = {m_position, static_cast<std::size_t>(lineEnd - m_position)};
  if (!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  return true;
}

bool TextCursor::nextLine(std::string_view& line)
{
  if (!peekLine(line))
    return false;
  m_position += line.size();
  m_position += *m_position == '\r' ? 2 : 1;
  ++m_line;
  return true;
}

std::string_view TextCursor::block(std::size_t bytes)
{
  if (m_position == m_end && !fill())
    return {};
  const std::string_view window(m_position, static_cast<std::size_t>(m_end - m_position));
  const std::string_view whole = wholeLines(window.substr(0, bytes));
  if (!whole.empty())
    return whole;
  const std::size_t lineEnd = window.find('\n');
  if (lineEnd == std::string_view::npos)
    failChanged();
  return window.substr(0, lineEnd + 1);
}

void TextCursor::advance(std::size_t bytes, std::uint64_t lines)
{
  m_position += bytes;
  m_line += lines;
}

ByteCounts countBytes(std::string_view text, char first, char second)
{
  // Byte-wide counters in fixed lanes, added up before they overflow: compilers turn the inner
  // loop into a few vector instructions, which std::count (64-bit counters) is not.
  constexpr std::size_t Lanes = 64;
  constexpr std::size_t Turns = 255;
  ByteCounts counts;
  const char* p = text.data();
  const char* const end = p + text.size();
  while (static_cast<std::size_t>(end - p) >= Lanes)
  {
    const std::size_t turns = std::min<std::size_t>(Turns, (end - p) / Lanes);
    std::uint8_t a[Lanes] = {};
    std::uint8_t b[Lanes] = {};
    for (std::size_t turn = 0; turn < turns; ++turn, p += Lanes)
    {
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        a[lane] = static_cast<std::uint8_t>(a[lane] + (p[lane] == first));
        b[lane] = static_cast<std::uint8_t>(b[lane] + (p[lane] == second));
      }
    }
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      counts.first += a[lane];
      counts.second += b[lane];
    }
  }
  for (; p != end; ++p)
  {
    counts.first += *p == first;
    counts.second += *p == second;
  }
  return counts;
}

} // namespace mote
