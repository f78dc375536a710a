#ifndef MoteTextFile_h
#define MoteTextFile_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mote
{

/// A file's size and time of change: two equal stamps mean that an index made before still holds.
struct FileStamp
{
  std::uint64_t bytes = 0;
  std::int64_t nanoseconds = 0; ///< time of the last change, since the epoch
  bool operator==(const FileStamp&) const = default;
};

/// The stamp of a file. Throws FileError when there is no such file.
FileStamp stampOf(const std::string& path);

/// A regular file open for reading. Plain text is memory-mapped; gzip, told by its first two bytes
/// and not by its name, is left to GzipStream.
///
/// The map has the length of the file when it was opened, so that a file may grow meanwhile. A file
/// that another program cuts short while it is being read ends this program (SIGBUS), as with every
/// memory map, unless it calls surviveCutFiles() of kernels/core/CutFiles.h: then what is missing
/// reads as zeros.
class TextFile
{
public:
  /// Throws FileError for a missing file, a directory, a missing permission, and anything else that
  /// is not a regular file.
  explicit TextFile(const std::string& path);
  ~TextFile();
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  const std::string& path() const { return m_path; }
  bool isGzip() const { return m_gzip; }
  std::uint64_t bytes() const { return m_bytes; } ///< on disk
  int descriptor() const { return m_descriptor; }

  /// The whole text of a plain file; empty for gzip.
  std::string_view text() const { return {m_map, m_map ? static_cast<size_t>(m_bytes) : 0}; }

private:
  std::string m_path;
  int m_descriptor = -1;
  std::uint64_t m_bytes = 0;
  bool m_gzip = false;
  const char* m_map = nullptr;
};

/// Throws FileError where a name is that of a pipe, a device or the like, links followed: these may
/// never end. What is not there passes.
void requireNoStream(const std::string& path);

/// The first `count` bytes of a file's text, inflated if it is gzip; fewer when the file is shorter
/// or damaged. Throws FileError when the file cannot be opened.
std::string readBeginning(const std::string& path, std::size_t count);

} // namespace mote

#endif
