#include "CutFiles.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace mote
{

namespace
{

std::atomic<bool> wasCut{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");
long pageSize = 4096;

/// Puts a page of zeros where the file has none any more.
void onBusError(int signal, siginfo_t* info, void*)
{
  const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  void* page = reinterpret_cast<void*>(address - address % static_cast<std::uintptr_t>(pageSize));
  const bool isMissing = info->si_code == BUS_ADRERR;
  if (isMissing && ::mmap(page, static_cast<std::size_t>(pageSize), PROT_READ,
                     MAP_PRIVATE | MAP_FIXED | MAP_ANONYMOUS, -1, 0) != MAP_FAILED)
    wasCut = true;
  else
    std::signal(signal, SIG_DFL); // comes again, and ends the program
}

} // namespace

void surviveCutFiles()
{
  pageSize = ::sysconf(_SC_PAGESIZE);
  struct sigaction action = {};
  action.sa_sigaction = onBusError;
  action.sa_flags = SA_SIGINFO;
  ::sigaction(SIGBUS, &action, nullptr);
}

bool fileWasCut()
{
  return wasCut;
}

bool takeFileCut()
{
  return wasCut.exchange(false);
}

} // namespace mote
