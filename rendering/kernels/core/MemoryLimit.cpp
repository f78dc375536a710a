#include "MemoryLimit.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include <unistd.h>

namespace mote
{

namespace
{

namespace fs = std::filesystem;

constexpr std::uint64_t noLimit = std::numeric_limits<std::uint64_t>::max();

/// Of a group and those above it. "max" is no number.
std::uint64_t leastLimit(const fs::path& root, const fs::path& group, const char* file)
{
  std::uint64_t least = noLimit;
  for (fs::path at = group.relative_path();; at = at.parent_path())
  {
    std::uint64_t limit = 0;
    if (std::ifstream(root / at / file) >> limit && limit > 0)
      least = std::min(least, limit);
    if (at.empty())
      return least;
  }
}

} // namespace

std::uint64_t machineMemory()
{
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0
           ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page)
           : noLimit;
}

std::uint64_t groupMemoryIn(const std::string& groups, const fs::path& root)
{
  std::uint64_t least = noLimit;
  std::istringstream lines(groups);
  for (std::string line; std::getline(lines, line);)
  {
    // number:controllers:path, with no controllers in version 2
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos)
      continue;
    const std::string controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
    const std::string path = line.substr(second + 1);
    if (controllers == ",,")
      least = std::min(least, leastLimit(root, path, "memory.max"));
    else if (controllers.find(",memory,") != std::string::npos)
      least = std::min(least, leastLimit(root / "memory", path, "memory.limit_in_bytes"));
  }
  return least;
}

std::uint64_t groupMemory()
{
  std::ifstream file("/proc/self/cgroup");
  const std::string groups{std::istreambuf_iterator<char>(file), {}};
  return groupMemoryIn(groups, "/sys/fs/cgroup");
}

std::uint64_t physicalMemory()
{
  return std::min(machineMemory(), groupMemory());
}

} // namespace mote
