#include "HugePages.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace mote
{

void preferHugePages(void* memory, std::size_t bytes) noexcept
{
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + page - 1) / page * page,
                       end = (begin + bytes) / page * page;
  if (first < end)
    ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE); // no matter if refused
}

} // namespace mote
