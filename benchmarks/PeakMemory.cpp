// The kernel keeps the largest number of resident pages of a process, and forgets it on request.
// That counts whoever allocates in whatever way: operator new, Embree's own blocks and TBB's pools
// alike, which hooks for malloc do not, and it misses no moment, as samples would. Pages that are
// reserved and never touched do not count.

#include "PeakMemory.h"

#include <malloc.h>

#include <fstream>
#include <limits>
#include <sstream>

namespace mote::bench
{

namespace
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Makes the peak what is resident now.
bool forgetPeak()
{
  std::ofstream file("/proc/self/clear_refs");
  file << "5";
  file.close();
  return static_cast<bool>(file);
}

} // namespace

double statusBytes(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
    if (line.rfind(key + ':', 0) == 0)
    {
      double kilobytes = unknown;
      std::istringstream(line.substr(key.size() + 1)) >> kilobytes;
      return 1024.0 * kilobytes;
    }
  return unknown;
}

double peakExtraBytes(const std::function<void()>& work)
{
  // What earlier work has freed and the allocator still holds would be reused unseen.
  malloc_trim(0);
  const bool works = forgetPeak();
  const double before = statusBytes("VmRSS");
  work();
  return works ? statusBytes("VmHWM") - before : unknown;
}

} // namespace mote::bench
