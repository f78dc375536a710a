#include "Memory.h"

#include <kernels/core/MemoryLimit.h>

#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

namespace mote::app
{

std::uint64_t residentMemory()
{
  std::uint64_t all = 0, resident = 0;
  const long page = ::sysconf(_SC_PAGESIZE);
  if (!(std::ifstream("/proc/self/statm") >> all >> resident) || page <= 0)
    return 0;
  return resident * static_cast<std::uint64_t>(page);
}

namespace
{

// Sanitizers have more addresses than any machine has memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif

} // namespace

void keepToMemoryOfGroup()
{
  const std::uint64_t limit = groupMemory();
  rlimit data{};
  if (isSanitized || limit >= machineMemory() || ::getrlimit(RLIMIT_DATA, &data) != 0)
    return;
  // Others of the group, and what the kernel keeps for it, have the rest.
  const rlim_t own = limit - limit / 16;
  if (data.rlim_cur != RLIM_INFINITY && data.rlim_cur <= own)
    return;
  data.rlim_cur = own;
  ::setrlimit(RLIMIT_DATA, &data);
}

} // namespace mote::app
