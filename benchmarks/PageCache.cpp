#include "PageCache.h"

#include <kernels/core/MappedFile.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <vector>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace mote::bench
{

std::string forgetPages(const std::string& fileName)
{
  ::sync(); // pages that are still to be written cannot be forgotten
  std::ofstream drop("/proc/sys/vm/drop_caches");
  drop << "3";
  drop.close();
  if (drop)
    return "drop_caches";
  if (const int file = ::open(fileName.c_str(), O_RDONLY | O_CLOEXEC); file >= 0)
  {
    ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    ::close(file);
  }
  return "fadvise";
}

double residentShare(const std::string& fileName)
{
  const MappedFile file(fileName);
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  std::vector<unsigned char> resident((file.size() + page - 1) / page);
  if (resident.empty() ||
      ::mincore(const_cast<unsigned char*>(file.data()), file.size(), resident.data()) != 0)
    return 0.0;
  const auto held = std::count_if(
    resident.begin(), resident.end(), [](unsigned char state) { return (state & 1) != 0; });
  return static_cast<double>(held) / static_cast<double>(resident.size());
}

double bytesReadFromDisk()
{
  std::ifstream counts("/proc/self/io");
  std::string key;
  double value = 0.0;
  while (counts >> key >> value)
    if (key == "read_bytes:")
      return value;
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace mote::bench
