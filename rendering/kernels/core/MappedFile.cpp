#include "MappedFile.h"

#include "Error.h"
#include "MemoryLimit.h"

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

/// Closes a file when it is done with.
struct Descriptor
{
  int number;
  ~Descriptor()
  {
    if (number >= 0)
      ::close(number);
  }
};

[[noreturn]] void fail(const std::string& name, const std::string& reason)
{
  throw Error(name + ": " + reason);
}

} // namespace

MappedFile::MappedFile(const std::string& name, Paging paging)
  : name_(name)
  , paging_(paging)
{
  // Opening a pipe would wait for somebody to write.
  const Descriptor file{::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.number < 0)
    fail(name, errno == ENOENT ? "there is no such file" : std::strerror(errno));
  struct stat facts;
  if (::fstat(file.number, &facts) != 0)
    fail(name, std::strerror(errno));
  if (!S_ISREG(facts.st_mode))
    fail(name, S_ISDIR(facts.st_mode) ? "this is a folder" : "this is not a regular file");
  size_ = static_cast<std::uint64_t>(facts.st_size);
  if (size_ == 0)
    return;
  void* memory = ::mmap(nullptr, size_, PROT_READ, MAP_SHARED, file.number, 0);
  if (memory == MAP_FAILED)
    fail(name, std::string("the file cannot be mapped into memory (") + std::strerror(errno) + ")");
  // Rays jump, but what lies beside a page is wanted soon, and reading it too takes half the time
  // while there is room for it. Only advice; no matter if refused.
  if (size_ > physicalMemory())
    paging_ = Paging::Single;
  if (paging_ == Paging::Single)
    ::madvise(memory, size_, MADV_RANDOM);
  data_ = static_cast<const unsigned char*>(memory);
}

void MappedFile::fetch(std::uint64_t offset, std::uint64_t bytes) const
{
  if (offset < size_) // only advice, too
    ::madvise(
      const_cast<unsigned char*>(data_) + offset, std::min(bytes, size_ - offset), MADV_WILLNEED);
}

MappedFile::~MappedFile()
{
  if (data_)
    ::munmap(const_cast<unsigned char*>(data_), size_);
}

} // namespace mote
