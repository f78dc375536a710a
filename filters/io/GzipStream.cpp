#include "GzipStream.h"

#include "FileError.h"
#include "TextFile.h"

#include <algorithm>
#include <limits>
#include <new>
#include <unistd.h>
#include <zlib.h>

namespace mote
{
namespace
{

constexpr std::uint64_t LeastInputBytes = 4096, MostInputBytes = 256 * 1024;
constexpr int GzipOnly = 15 + 16; // inflateInit2: largest window, gzip header expected

} // namespace

struct GzipStream::State
{
  State() = default;
  State(const State& other)
  {
    // inflateCopy reads its source only, but zlib's prototype does not say so.
    if (inflateCopy(&z, const_cast<z_stream*>(&other.z)) != Z_OK)
      throw std::bad_alloc();
  }
  State& operator=(const State&) = delete;
  ~State() { inflateEnd(&z); }

  z_stream z = {};
};

GzipStream::GzipStream(const TextFile& file)
  : m_file(file)
  , m_state(std::make_unique<State>())
  , m_input(std::clamp(file.bytes(), LeastInputBytes, MostInputBytes))
{
  if (inflateInit2(&m_state->z, GzipOnly) != Z_OK)
    throw std::bad_alloc();
}

GzipStream::~GzipStream() = default;

std::uint64_t GzipStream::fileOffset() const
{
  return m_inputOffset - m_state->z.avail_in;
}

bool GzipStream::fillInput()
{
  const ssize_t count =
    ::pread(m_file.descriptor(), m_input.data(), m_input.size(), static_cast<off_t>(m_inputOffset));
  if (count <= 0)
    return false;
  m_inputOffset += static_cast<std::uint64_t>(count);
  m_state->z.next_in = m_input.data();
  m_state->z.avail_in = static_cast<uInt>(count);
  return true;
}

/// After the end of a member: goes on with the next one, or finishes. Like gzip itself, this takes
/// what is not a member (zeros that a tape drive added) as the end.
void GzipStream::nextMember()
{
  z_stream& z = m_state->z;
  if ((z.avail_in == 0 && !fillInput()) || *z.next_in != 0x1f)
  {
    m_finished = true;
    return;
  }
  inflateReset(&z);
}

std::size_t GzipStream::read(char* out, std::size_t count)
{
  z_stream& z = m_state->z;
  std::size_t done = 0;
  while (done < count && !m_finished)
  {
    z.next_out = reinterpret_cast<Bytef*>(out + done);
    z.avail_out =
      static_cast<uInt>(std::min<std::size_t>(count - done, std::numeric_limits<uInt>::max()));
    const uInt offered = z.avail_out;
    try
    {
      inflateMore();
    }
    catch (const FileError&)
    {
      // The next call meets the same damage again, and reports it then.
      if (done + (offered - z.avail_out) == 0)
        throw;
      m_textOffset += offered - z.avail_out;
      return done + (offered - z.avail_out);
    }
    done += offered - z.avail_out;
    m_textOffset += offered - z.avail_out;
  }
  return done;
}

/// One call of inflate, with input to work on.
void GzipStream::inflateMore()
{
  z_stream& z = m_state->z;
  if (z.avail_in == 0 && !fillInput())
  {
    throw FileError(FileError::Kind::Truncated, m_file.path(),
      "the gzip data end too early: the file is truncated");
  }
  const int status = inflate(&z, Z_NO_FLUSH);
  if (status == Z_STREAM_END)
  {
    nextMember();
  }
  else if (status != Z_OK && status != Z_BUF_ERROR)
  {
    throw FileError(FileError::Kind::Malformed, m_file.path(),
      std::string("the gzip data are damaged (") + (z.msg ? z.msg : zError(status)) + ")");
  }
}

GzipStream::Snapshot GzipStream::snapshot() const
{
  return {m_textOffset, fileOffset(), m_finished, std::make_shared<const State>(*m_state)};
}

void GzipStream::restore(const Snapshot& snapshot)
{
  m_state = std::make_unique<State>(*snapshot.state);
  m_state->z.avail_in = 0; // the copy's input lies in a buffer of long ago
  m_inputOffset = snapshot.fileOffset;
  m_textOffset = snapshot.textOffset;
  m_finished = snapshot.finished;
}

} // namespace mote
