#pragma once

#include <string>

namespace mote::bench
{

/// Has the system forget the pages of a file that it holds in memory; nobody may map it meanwhile.
/// Returns how: "drop_caches", which takes a superuser and forgets all files, else "fadvise".
std::string forgetPages(const std::string& fileName);

/// The share of a file's pages, in [0, 1], that the system holds in memory.
double residentShare(const std::string& fileName);

/// Bytes that the process has caused to be read from disks. NaN where the system does not say.
double bytesReadFromDisk();

} // namespace mote::bench
