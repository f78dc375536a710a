#include "Memory.h"

#include <fstream>

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

} // namespace mote::app
