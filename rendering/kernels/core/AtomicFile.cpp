#include "AtomicFile.h"

#include "CutFiles.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace mote
{
namespace
{

[[noreturn]] void fail(WriteError::Kind kind, const std::string& name, const std::string& reason)
{
  throw WriteError(kind, "Cannot write \"" + name + "\": " + reason + ".");
}

[[noreturn]] void failCut(const std::string& name)
{
  fail(WriteError::Kind::CannotOpen, name, "a file that it is made of was cut short meanwhile");
}

} // namespace

void throwWriteError(const std::string& name, int error)
{
  switch (error)
  {
  case ENOSPC:
    fail(WriteError::Kind::NoSpace, name, "the disk is full");
  case EDQUOT:
    fail(WriteError::Kind::NoSpace, name, "the disk quota is used up");
  case EFBIG:
    fail(WriteError::Kind::NoSpace, name, "the file is larger than the limit on files");
  case EROFS:
    fail(WriteError::Kind::CannotOpen, name, "the file system is read-only");
  case EACCES:
  case EPERM:
    fail(WriteError::Kind::CannotOpen, name, "no permission to write in its folder");
  case ENAMETOOLONG:
    fail(WriteError::Kind::CannotOpen, name, "the name is too long");
  default:
    fail(WriteError::Kind::CannotOpen, name, std::strerror(error));
  }
}

namespace
{

/// The file that is to be replaced or made: the end of the chain where `name` is a symbolic link.
fs::path resolve(const std::string& name)
{
  constexpr int mostLinks = 40; // as the system follows
  std::error_code error;
  fs::path path = fs::absolute(name, error);
  for (int link = 0; link < mostLinks && !error && fs::is_symlink(path, error); ++link)
    if (const fs::path target = fs::read_symlink(path, error); !error)
      path = path.parent_path() / target;
  return path;
}

void checkTarget(const std::string& name, const fs::path& target)
{
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status))
    fail(WriteError::Kind::CannotOpen, name, "it is a folder");
  if (error && status.type() == fs::file_type::none)
    throwWriteError(name, error.value());
  if (fs::exists(status) && !fs::is_regular_file(status))
    fail(WriteError::Kind::CannotOpen, name, "it is not a regular file");
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
    fail(WriteError::Kind::CannotOpen, name, "the file is write-protected");
}

void checkFolder(const std::string& name, const fs::path& folder)
{
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status) && status.type() != fs::file_type::none)
    fail(WriteError::Kind::CannotOpen, name, "its folder does not exist");
  if (status.type() != fs::file_type::none && !fs::is_directory(status))
    fail(WriteError::Kind::CannotOpen, name, "what should be its folder is a file");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throwWriteError(name, errno);
}

std::string makeTemporaryName(const fs::path& folder)
{
  std::random_device random;
  char name[32];
  std::snprintf(name, sizeof(name), ".mote-%08x%04x.tmp", random(), random() & 0xffffu);
  return (folder / name).string();
}

/// A file without a name in a folder, or -1 where there are none.
int openUnnamed(const fs::path& folder, int access)
{
#ifdef O_TMPFILE
  return ::open(folder.c_str(), O_TMPFILE | access | O_CLOEXEC, 0666);
#else
  return -1;
#endif
}

/// A new file in a folder, whose name it tells; -1, with the reason in errno, where there is none.
int openTemporary(const fs::path& folder, int access, std::string& name)
{
  for (int attempt = 0; attempt < 100; ++attempt)
  {
    name = makeTemporaryName(folder);
    const int file = ::open(name.c_str(), access | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST)
      return file;
  }
  return -1;
}

/// A new name outlives a power cut only once its folder is on the disk. Some file systems know no
/// such thing, and the file is whole without it.
void syncFolder(const fs::path& file)
{
  const int folder = ::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0)
    return;
  ::fsync(folder);
  ::close(folder);
}

/// Where the system shows an open file.
std::string linkTo(int file)
{
  return "/proc/self/fd/" + std::to_string(file);
}

} // namespace

int openNameless(const std::string& beside)
{
  const fs::path folder = resolve(beside).parent_path();
  int file = openUnnamed(folder, O_RDWR);
  std::string name;
  if (file < 0 && (file = openTemporary(folder, O_RDWR, name)) >= 0)
    ::unlink(name.c_str());
  if (file < 0)
    throwWriteError(beside, errno);
  return file;
}

void moveIntoPlace(const std::string& written, const std::string& name)
{
  if (fileWasCut())
    failCut(name);
  const int file = ::open(written.c_str(), O_RDONLY | O_CLOEXEC);
  int error = file < 0 || (::fsync(file) != 0 && errno != EINVAL) ? errno : 0;
  if (file >= 0)
    ::close(file);
  if (error == 0 && ::rename(written.c_str(), name.c_str()) != 0)
    error = errno;
  if (error != 0)
    throwWriteError(name, error);
  syncFolder(fs::absolute(name));
}

void checkWritable(const std::string& name)
{
  if (name.empty())
    throw WriteError(WriteError::Kind::CannotOpen, "A file to write needs a name.");
  const fs::path target = resolve(name);
  checkFolder(name, target.parent_path());
  checkTarget(name, target);
}

AtomicFile::AtomicFile(const std::string& name)
  : name_(name)
{
  checkWritable(name);
  const fs::path target = resolve(name);
  targetName_ = target.string();
  struct stat old;
  const bool replaces = ::stat(targetName_.c_str(), &old) == 0;
  this->open();
  if (replaces && ::fchmod(descriptor_, old.st_mode & 0777) != 0)
  {
    // Some file systems have no permissions; the new file's own will do there.
  }
}

void AtomicFile::open()
{
  const fs::path folder = fs::path(targetName_).parent_path();
  descriptor_ = openUnnamed(folder, O_WRONLY);
  if (descriptor_ >= 0 && ::access(linkTo(descriptor_).c_str(), F_OK) == 0)
    return;
  if (descriptor_ >= 0) // it could not be given a name
    ::close(descriptor_);
  descriptor_ = openTemporary(folder, O_WRONLY, temporaryName_);
  if (descriptor_ < 0)
  {
    temporaryName_.clear();
    throwWriteError(name_, errno);
  }
}

AtomicFile::~AtomicFile()
{
  remove();
}

void AtomicFile::remove()
{
  if (descriptor_ >= 0)
  {
    ::close(descriptor_);
    descriptor_ = -1;
  }
  if (!temporaryName_.empty())
  {
    ::unlink(temporaryName_.c_str());
    temporaryName_.clear();
  }
}

template <typename Put>
void AtomicFile::putAll(const void* data, std::size_t size, const Put& put)
{
  const auto* from = static_cast<const unsigned char*>(data);
  for (std::size_t done = 0; done < size;)
  {
    const ssize_t written = put(from + done, size - done, done);
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
    {
      const int error = written < 0 ? errno : ENOSPC;
      remove();
      throwWriteError(name_, error);
    }
    done += static_cast<std::size_t>(written);
  }
}

void AtomicFile::write(const void* data, std::size_t size)
{
  putAll(data, size,
    [this](const unsigned char* from, std::size_t left, std::size_t)
    { return ::write(descriptor_, from, left); });
}

void AtomicFile::rewrite(std::uint64_t offset, const void* data, std::size_t size)
{
  putAll(data, size,
    [&](const unsigned char* from, std::size_t left, std::size_t done)
    { return ::pwrite(descriptor_, from, left, static_cast<off_t>(offset + done)); });
}

std::string AtomicFile::openName() const
{
  return temporaryName_.empty() ? linkTo(descriptor_) : temporaryName_;
}

/// Gives the file a temporary name, which it needs to replace another. Returns the system's error.
int AtomicFile::giveName()
{
  for (int attempt = 0; attempt < 100; ++attempt)
  {
    const std::string name = makeTemporaryName(fs::path(targetName_).parent_path());
    if (::linkat(
          AT_FDCWD, linkTo(descriptor_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
    {
      temporaryName_ = name;
      return 0;
    }
    if (errno != EEXIST)
      break;
  }
  return errno;
}

void AtomicFile::commit()
{
  if (fileWasCut())
  {
    remove();
    failCut(name_);
  }
  // Quotas and network file systems report a full disk only here. A descriptor is gone after
  // close() whatever that returns.
  int error = ::fsync(descriptor_) != 0 && errno != EINVAL ? errno : 0;
  if (error == 0 && temporaryName_.empty())
    error = this->giveName();
  if (::close(descriptor_) != 0 && error == 0 && errno != EINTR)
    error = errno;
  descriptor_ = -1;
  if (error == 0 && ::rename(temporaryName_.c_str(), targetName_.c_str()) != 0)
    error = errno;
  if (error != 0)
  {
    remove();
    throwWriteError(name_, error);
  }
  temporaryName_.clear();
  syncFolder(targetName_);
}

} // namespace mote
