// Makes calls to the system fail, in the process that loads this library first (LD_PRELOAD):
//   MOTE_FAULT=CALL:N    the Nth CALL fails; with CALL:N+ all from there on. With CALL:N! the
//                        process is killed in place of the call. CALL is open, read, write, fsync,
//                        rename, link, map, memory, or cut: then a file that is mapped, and may
//                        only be read, is cut to half its length.
//   MOTE_FAULT_IN=FOLDER only files in this folder count, other than for memory
//   MOTE_FAULT_BYTES=B   blocks of memory of this size and more count
//   MOTE_FAULT_LOG=FILE  gets a line for each call that counts: CALL N PLACE, where equal numbers
//                        PLACE mean that the calls came from the same place of the program.

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

namespace
{

enum Call
{
  Open,
  Read,
  Write,
  Sync,
  Rename,
  Link,
  Map,
  Memory,
  Cut,
  callCount
};
constexpr const char* names[callCount] = {
  "open", "read", "write", "fsync", "rename", "link", "map", "memory", "cut"};
constexpr int errors[callCount] = {EIO, EIO, ENOSPC, EIO, EIO, EIO, ENOMEM, ENOMEM, 0};

/// What the environment asks for.
struct Plan
{
  int call = callCount;
  long first = 0;
  bool goesOn = false, kills = false;
  const char* folder = nullptr;
  std::size_t bytes = SIZE_MAX;
  int log = -1;

  Plan()
  {
    folder = std::getenv("MOTE_FAULT_IN");
    if (const char* text = std::getenv("MOTE_FAULT_BYTES"))
      bytes = std::strtoull(text, nullptr, 10);
    if (const char* text = std::getenv("MOTE_FAULT_LOG"))
      log = static_cast<int>(
        ::syscall(SYS_openat, AT_FDCWD, text, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    const char* fault = std::getenv("MOTE_FAULT");
    const char* colon = fault ? std::strchr(fault, ':') : nullptr;
    for (int i = 0; colon && i < callCount; ++i)
      if (std::strlen(names[i]) == static_cast<std::size_t>(colon - fault) &&
          std::strncmp(fault, names[i], std::strlen(names[i])) == 0)
        call = i;
    char* end = nullptr;
    first = colon ? std::strtol(colon + 1, &end, 10) : 0;
    goesOn = end && *end == '+';
    kills = end && *end == '!';
  }
};

std::atomic<bool> isReady{false};
std::atomic<long> counts[callCount];
thread_local bool isInside = false;

const Plan& plan()
{
  static const Plan made;
  return made;
}

struct Begin
{
  Begin()
  {
    plan();
    void* frames[4];
    ::backtrace(frames, 4); // loads a library at its first call
    isReady = true;
  }
} begin;

/// A number for the chain of callers.
std::uint64_t placeOf()
{
  void* frames[24];
  const int count = ::backtrace(frames, 24);
  std::uint64_t number = 1469598103934665603u;
  for (int i = 2; i < count; ++i)
    number = (number ^ reinterpret_cast<std::uintptr_t>(frames[i])) * 1099511628211u;
  return number;
}

/// Counts a call, and says whether it has to fail.
bool fails(Call call)
{
  if (isInside)
    return false;
  isInside = true;
  const long n = ++counts[call];
  if (plan().log >= 0)
  {
    char line[64];
    const int length = std::snprintf(line, sizeof(line), "%s %ld %llu\n", names[call], n,
      static_cast<unsigned long long>(placeOf()));
    [[maybe_unused]] const long done =
      ::syscall(SYS_write, plan().log, line, static_cast<std::size_t>(length));
  }
  isInside = false;
  if (call != plan().call || !(n == plan().first || (plan().goesOn && n > plan().first)))
    return false;
  if (plan().kills)
    ::kill(::getpid(), SIGKILL);
  errno = errors[call];
  return true;
}

bool isInFolder(const char* path)
{
  return isReady && plan().folder && path &&
         std::strncmp(path, plan().folder, std::strlen(plan().folder)) == 0;
}

/// What an open file is called; one that has no name any more does as long as it may be `nameless`.
bool isInFolder(int file, bool nameless = true)
{
  if (!isReady || !plan().folder || file < 0)
    return false;
  const int before = errno;
  char link[32], path[4096];
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", file);
  const ssize_t length = ::readlink(link, path, sizeof(path) - 1);
  errno = before;
  if (length < 0)
    return false;
  path[length] = '\0';
  return isInFolder(path) && (nameless || !std::strstr(path, " (deleted)"));
}

/// The function of the same name that this library hides.
template <typename Function>
Function* hidden(const char* name)
{
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool memoryFails(std::size_t bytes)
{
  return isReady && bytes >= plan().bytes && fails(Memory);
}

/// What open and open64 do; `mode` is there where a file may be made.
int openFile(const char* path, int flags, std::va_list mode)
{
  if (isInFolder(path) && fails(Open))
    return -1;
  const bool isMade = (flags & (O_CREAT | O_TMPFILE)) != 0;
  return static_cast<int>(
    ::syscall(SYS_openat, AT_FDCWD, path, flags, isMade ? va_arg(mode, int) : 0));
}

/// Another program would do it while the file is in use: here it is done before its first use.
void cut(int file)
{
  struct stat facts;
  char link[32];
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", file);
  const bool isInput = ::fstat(file, &facts) == 0 && (facts.st_mode & S_IWUSR) == 0;
  if (isInput && isInFolder(file, false) && fails(Cut) &&
      (::chmod(link, 0600) != 0 || ::truncate(link, facts.st_size / 2) != 0))
    std::perror("faults: a file could not be cut");
}

/// What mmap and mmap64 do, whose hidden function is `real`.
template <typename Real>
void* map(
  Real* real, void* at, std::size_t bytes, int protection, int flags, int file, off_t offset)
{
  if (file >= 0 ? isInFolder(file) && fails(Map) : memoryFails(bytes))
    return MAP_FAILED;
  void* const result = real(at, bytes, protection, flags, file, offset);
  if (file >= 0 && result != MAP_FAILED)
    cut(file);
  return result;
}

} // namespace

#define HIDDEN(name) static auto* const real = hidden<decltype(name)>(#name)

extern "C"
{

  int open(const char* path, int flags, ...)
  {
    std::va_list list;
    va_start(list, flags);
    const int file = openFile(path, flags, list);
    va_end(list);
    return file;
  }

  int open64(const char* path, int flags, ...)
  {
    std::va_list list;
    va_start(list, flags);
    const int file = openFile(path, flags, list);
    va_end(list);
    return file;
  }

  FILE* fopen(const char* path, const char* mode)
  {
    HIDDEN(fopen);
    return isInFolder(path) && fails(Open) ? nullptr : real(path, mode);
  }

  FILE* fopen64(const char* path, const char* mode)
  {
    HIDDEN(fopen64);
    return isInFolder(path) && fails(Open) ? nullptr : real(path, mode);
  }

  ssize_t read(int file, void* to, std::size_t bytes)
  {
    HIDDEN(read);
    return isInFolder(file) && fails(Read) ? -1 : real(file, to, bytes);
  }

  ssize_t pread(int file, void* to, std::size_t bytes, off_t at)
  {
    HIDDEN(pread);
    return isInFolder(file) && fails(Read) ? -1 : real(file, to, bytes, at);
  }

  ssize_t pread64(int file, void* to, std::size_t bytes, off64_t at)
  {
    HIDDEN(pread64);
    return isInFolder(file) && fails(Read) ? -1 : real(file, to, bytes, at);
  }

  ssize_t readv(int file, const iovec* parts, int count)
  {
    HIDDEN(readv);
    return isInFolder(file) && fails(Read) ? -1 : real(file, parts, count);
  }

  std::size_t fread(void* to, std::size_t size, std::size_t count, FILE* file)
  {
    HIDDEN(fread);
    return isInFolder(::fileno(file)) && fails(Read) ? 0 : real(to, size, count, file);
  }

  ssize_t write(int file, const void* from, std::size_t bytes)
  {
    HIDDEN(write);
    return isInFolder(file) && fails(Write) ? -1 : real(file, from, bytes);
  }

  ssize_t pwrite(int file, const void* from, std::size_t bytes, off_t at)
  {
    HIDDEN(pwrite);
    return isInFolder(file) && fails(Write) ? -1 : real(file, from, bytes, at);
  }

  ssize_t pwrite64(int file, const void* from, std::size_t bytes, off64_t at)
  {
    HIDDEN(pwrite64);
    return isInFolder(file) && fails(Write) ? -1 : real(file, from, bytes, at);
  }

  ssize_t writev(int file, const iovec* parts, int count)
  {
    HIDDEN(writev);
    return isInFolder(file) && fails(Write) ? -1 : real(file, parts, count);
  }

  std::size_t fwrite(const void* from, std::size_t size, std::size_t count, FILE* file)
  {
    HIDDEN(fwrite);
    return isInFolder(::fileno(file)) && fails(Write) ? 0 : real(from, size, count, file);
  }

  int fsync(int file)
  {
    HIDDEN(fsync);
    return isInFolder(file) && fails(Sync) ? -1 : real(file);
  }

  int rename(const char* from, const char* to)
  {
    HIDDEN(rename);
    return isInFolder(to) && fails(Rename) ? -1 : real(from, to);
  }

  int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags)
  {
    HIDDEN(linkat);
    return isInFolder(to) && fails(Link) ? -1 : real(fromFolder, from, toFolder, to, flags);
  }

  void* mmap(void* at, std::size_t bytes, int protection, int flags, int file, off_t offset)
  {
    HIDDEN(mmap);
    return map(real, at, bytes, protection, flags, file, offset);
  }

  void* mmap64(void* at, std::size_t bytes, int protection, int flags, int file, off64_t offset)
  {
    HIDDEN(mmap64);
    return map(real, at, bytes, protection, flags, file, offset);
  }

  // The C library's own names, as dlsym takes memory itself.
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);
  void* __libc_memalign(std::size_t, std::size_t);

  void* malloc(std::size_t bytes)
  {
    return memoryFails(bytes) ? nullptr : __libc_malloc(bytes);
  }

  void* calloc(std::size_t count, std::size_t size)
  {
    return memoryFails(count * size) ? nullptr : __libc_calloc(count, size);
  }

  void* realloc(void* old, std::size_t bytes)
  {
    return memoryFails(bytes) ? nullptr : __libc_realloc(old, bytes);
  }

  void* memalign(std::size_t boundary, std::size_t bytes)
  {
    return memoryFails(bytes) ? nullptr : __libc_memalign(boundary, bytes);
  }

  void* aligned_alloc(std::size_t boundary, std::size_t bytes)
  {
    return memoryFails(bytes) ? nullptr : __libc_memalign(boundary, bytes);
  }

  int posix_memalign(void** to, std::size_t boundary, std::size_t bytes)
  {
    if (memoryFails(bytes))
      return ENOMEM;
    *to = __libc_memalign(boundary, bytes);
    return *to ? 0 : ENOMEM;
  }

} // extern "C"
