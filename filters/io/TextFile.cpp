#include "TextFile.h"

#include "FileError.h"
#include "GzipStream.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mote
{
namespace
{

FileError cannotOpen(const std::string& path, int error)
{
  using Kind = FileError::Kind;
  switch (error)
  {
  case ENOENT:
  case ENOTDIR:
    return {Kind::NotFound, path, "there is no such file"};
  case EACCES:
  case EPERM:
    return {Kind::CannotOpen, path, "you have no permission to read this file"};
  default:
    return {Kind::CannotOpen, path,
      std::string("this file cannot be read (") + std::strerror(error) + ")"};
  }
}

[[noreturn]] void failAsStream(const std::string& path)
{
  throw FileError(FileError::Kind::CannotOpen, path, "this is not a regular file");
}

struct stat statOf(const std::string& path)
{
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0)
    throw cannotOpen(path, errno);
  if (S_ISDIR(status.st_mode))
    throw FileError(FileError::Kind::CannotOpen, path, "this is a directory, not a file");
  if (!S_ISREG(status.st_mode))
    failAsStream(path);
  return status;
}

} // namespace

void requireNoStream(const std::string& path)
{
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))
    failAsStream(path);
}

FileStamp stampOf(const std::string& path)
{
  const struct stat status = statOf(path);
  return {static_cast<std::uint64_t>(status.st_size),
    std::int64_t{status.st_mtim.tv_sec} * 1000000000 + status.st_mtim.tv_nsec};
}

namespace
{

std::size_t pageBytes()
{
  static const auto bytes = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  return bytes;
}

std::size_t wholePages(std::uint64_t bytes)
{
  return (static_cast<std::size_t>(bytes) + pageBytes() - 1) / pageBytes() * pageBytes();
}

/// A descriptor of a file that is no stream.
int opened(const std::string& path)
{
  statOf(path); // before open: opening a pipe would wait for its writer
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    throw cannotOpen(path, errno);
  return descriptor;
}

bool isGzipMagic(std::string_view beginning)
{
  return beginning.substr(0, 2) == "\x1f\x8b";
}

/// The first bytes of a file as they are, up to `count`. A map would take longer for so few.
std::string firstBytes(const std::string& path, std::size_t count)
{
  std::string bytes(count, '\0');
  const int descriptor = opened(path);
  std::size_t filled = 0;
  for (ssize_t more = 1; more > 0 && filled < count; filled += static_cast<std::size_t>(more))
    more = std::max<ssize_t>(
      0, ::pread(descriptor, bytes.data() + filled, count - filled, static_cast<off_t>(filled)));
  ::close(descriptor);
  bytes.resize(filled);
  return bytes;
}

/// A file's text, and a page of line ends behind it: where another program changes the file while
/// it is parsed, the line ends that were counted may be gone, and a parser must still meet one.
/// Null, with errno, where there is no room.
void* mapped(int descriptor, std::uint64_t bytes)
{
  const std::size_t pages = wholePages(bytes);
  void* all = ::mmap(nullptr, pages + pageBytes(), PROT_READ | PROT_WRITE,
    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (all == MAP_FAILED)
    return nullptr;
  char* const behind = static_cast<char*>(all) + pages;
  std::memset(behind, '\n', pageBytes());
  ::mprotect(behind, pageBytes(), PROT_READ);
  if (::mmap(all, bytes, PROT_READ, MAP_PRIVATE | MAP_FIXED, descriptor, 0) != MAP_FAILED)
    return all;
  const int error = errno;
  ::munmap(all, pages + pageBytes());
  errno = error;
  return nullptr;
}

} // namespace

TextFile::TextFile(const std::string& path)
  : m_path(path)
  , m_descriptor(opened(path))
{
  struct stat status = {};
  ::fstat(m_descriptor, &status);
  m_bytes = static_cast<std::uint64_t>(status.st_size);
  char magic[2] = {};
  m_gzip = ::pread(m_descriptor, magic, 2, 0) == 2 && isGzipMagic({magic, 2});
  if (!m_gzip && m_bytes > 0)
  {
    void* map = mapped(m_descriptor, m_bytes);
    if (!map)
    {
      const int error = errno;
      ::close(m_descriptor);
      throw cannotOpen(path, error);
    }
    m_map = static_cast<const char*>(map);
    ::madvise(map, m_bytes, MADV_SEQUENTIAL);
  }
}

TextFile::~TextFile()
{
  if (m_map)
    ::munmap(const_cast<char*>(m_map), wholePages(m_bytes) + pageBytes());
  ::close(m_descriptor);
}

std::string readBeginning(const std::string& path, std::size_t count)
{
  std::string text = firstBytes(path, std::max<std::size_t>(2, count));
  if (!isGzipMagic(text))
  {
    text.resize(std::min(text.size(), count));
    return text;
  }
  const TextFile file(path);
  text.assign(count, '\0');
  std::size_t filled = 0;
  try
  {
    GzipStream stream(file);
    filled = stream.read(text.data(), count);
  }
  catch (const FileError&)
  {
    // A damaged file has no beginning to speak of; reading it in earnest says what is wrong.
  }
  text.resize(filled);
  return text;
}

} // namespace mote
