#include "AtomicFile.h"

#include "ImageError.h"

#include <vtkErrorCode.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace mote::imaging
{
namespace
{

[[noreturn]] void fail(unsigned long code, const std::string& name, const std::string& reason)
{
  throw ImageError(code, "Cannot write \"" + name + "\": " + reason + ".");
}

[[noreturn]] void failWithSystemError(const std::string& name, int error)
{
  switch (error)
  {
  case ENOSPC:
    fail(vtkErrorCode::OutOfDiskSpaceError, name, "the disk is full");
  case EDQUOT:
    fail(vtkErrorCode::OutOfDiskSpaceError, name, "the disk quota is used up");
  case EFBIG:
    fail(vtkErrorCode::OutOfDiskSpaceError, name, "the file is larger than the limit on files");
  case EROFS:
    fail(vtkErrorCode::CannotOpenFileError, name, "the file system is read-only");
  case EACCES:
  case EPERM:
    fail(vtkErrorCode::CannotOpenFileError, name, "no permission to write in its folder");
  case ENAMETOOLONG:
    fail(vtkErrorCode::CannotOpenFileError, name, "the name is too long");
  default:
    fail(vtkErrorCode::CannotOpenFileError, name, std::strerror(error));
  }
}

/// The file that is to be replaced: the end of the chain where `name` is a symbolic link.
fs::path resolve(const std::string& name)
{
  std::error_code error;
  fs::path path = fs::absolute(name, error);
  if (!error && fs::is_symlink(path, error))
  {
    const fs::path target = fs::weakly_canonical(path, error);
    path = error ? path : target;
  }
  return path;
}

void checkTarget(const std::string& name, const fs::path& target)
{
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status))
  {
    fail(vtkErrorCode::CannotOpenFileError, name, "it is a folder");
  }
  if (error && status.type() == fs::file_type::none)
  {
    failWithSystemError(name, error.value());
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    fail(vtkErrorCode::CannotOpenFileError, name, "it is not a regular file");
  }
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
  {
    fail(vtkErrorCode::CannotOpenFileError, name, "the file is write-protected");
  }
}

void checkFolder(const std::string& name, const fs::path& folder)
{
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status) && status.type() != fs::file_type::none)
  {
    fail(vtkErrorCode::CannotOpenFileError, name, "its folder does not exist");
  }
  if (status.type() != fs::file_type::none && !fs::is_directory(status))
  {
    fail(vtkErrorCode::CannotOpenFileError, name, "what should be its folder is a file");
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
  {
    failWithSystemError(name, errno);
  }
}

std::string makeTemporaryName(const fs::path& folder)
{
  std::random_device random;
  char name[32];
  std::snprintf(name, sizeof(name), ".mote-%08x%04x.tmp", random(), random() & 0xffffu);
  return (folder / name).string();
}

} // namespace

void checkWritable(const std::string& name)
{
  if (name.empty())
  {
    throw ImageError(vtkErrorCode::NoFileNameError, "The image needs a file name.");
  }
  const fs::path target = resolve(name);
  checkFolder(name, target.parent_path());
  checkTarget(name, target);
}

AtomicFile::AtomicFile(const std::string& name)
  : m_name(name)
{
  checkWritable(name);
  const fs::path target = resolve(name);
  m_targetName = target.string();
  struct stat old;
  const bool replaces = ::stat(m_targetName.c_str(), &old) == 0;
  for (int attempt = 0; attempt < 100 && m_descriptor < 0; ++attempt)
  {
    m_temporaryName = makeTemporaryName(target.parent_path());
    m_descriptor = ::open(m_temporaryName.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (m_descriptor < 0 && errno != EEXIST)
    {
      break;
    }
  }
  if (m_descriptor < 0)
  {
    m_temporaryName.clear();
    failWithSystemError(name, errno);
  }
  if (replaces && ::fchmod(m_descriptor, old.st_mode & 0777) != 0)
  {
    // Some file systems have no permissions; the new file's own will do there.
  }
}

AtomicFile::~AtomicFile()
{
  remove();
}

void AtomicFile::remove()
{
  if (m_descriptor >= 0)
  {
    ::close(m_descriptor);
    m_descriptor = -1;
  }
  if (!m_temporaryName.empty())
  {
    ::unlink(m_temporaryName.c_str());
    m_temporaryName.clear();
  }
}

void AtomicFile::write(const unsigned char* data, std::size_t size)
{
  while (size > 0)
  {
    const ssize_t written = ::write(m_descriptor, data, size);
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      const int error = written < 0 ? errno : ENOSPC;
      remove();
      failWithSystemError(m_name, error);
    }
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

void AtomicFile::commit()
{
  // Quotas and network file systems report a full disk only here. A descriptor is gone after
  // close() whatever that returns.
  int error = ::fsync(m_descriptor) != 0 && errno != EINVAL ? errno : 0;
  if (::close(m_descriptor) != 0 && error == 0 && errno != EINTR)
  {
    error = errno;
  }
  m_descriptor = -1;
  if (error == 0 && ::rename(m_temporaryName.c_str(), m_targetName.c_str()) != 0)
  {
    error = errno;
  }
  if (error != 0)
  {
    remove();
    failWithSystemError(m_name, error);
  }
  m_temporaryName.clear();
}

} // namespace mote::imaging
