#include "ScratchSpace.h"

#include "AtomicFile.h"
#include "HugePages.h"

#include <algorithm>
#include <cerrno>
#include <new>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace mote
{

namespace
{

/// A piece of memory, and what has to be given back with it.
struct Mapping
{
  void* memory = MAP_FAILED;
  std::uint64_t bytes = 0;
  std::shared_ptr<std::atomic<std::uint64_t>> used; ///< null where it lies in a file

  ~Mapping()
  {
    if (memory != MAP_FAILED)
      ::munmap(memory, bytes);
    if (used)
      *used -= bytes;
  }
};

/// Takes disk blocks for a file. A page that finds none when it is written to would end the
/// process.
int reserve(int file, std::uint64_t bytes)
{
  int error = EINTR;
  while (error == EINTR)
    error = ::posix_fallocate(file, 0, static_cast<off_t>(bytes));
  return error;
}

} // namespace

ScratchSpace::ScratchSpace(const std::string& beside, std::uint64_t budget)
  : beside_(beside)
  , budget_(budget)
  , used_(std::make_shared<std::atomic<std::uint64_t>>(0))
{
}

std::shared_ptr<void> ScratchSpace::allocate(std::uint64_t bytes, bool inFile)
{
  auto mapping = std::make_shared<Mapping>();
  mapping->bytes = bytes;
  int file = -1;
  if (!inFile && (*used_ += bytes) <= budget_)
    mapping->used = used_;
  else
  {
    *used_ -= inFile ? 0 : bytes;
    usesFiles_ = true;
    file = openNameless(beside_);
    if (const int error = reserve(file, bytes); error != 0)
    {
      ::close(file);
      throwWriteError(beside_, error);
    }
  }
  mapping->memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
    file < 0 ? MAP_PRIVATE | MAP_ANONYMOUS : MAP_SHARED, file, 0);
  if (file >= 0)
    ::close(file);
  if (mapping->memory == MAP_FAILED)
    throw std::bad_alloc();
  if (file < 0)
    preferHugePages(mapping->memory, bytes);
  return {mapping, mapping->memory};
}

} // namespace mote
