#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace mote
{

/// Memory of the machine in bytes; the greatest number where nobody tells.
std::uint64_t machineMemory();

/// The least limit in bytes of the control groups that the process is in, as containers and batch
/// systems set them; the greatest number for none.
std::uint64_t groupMemory();

/// Memory of the machine, or of the control groups, whichever is less.
std::uint64_t physicalMemory();

/// What groupMemory() finds where `groups` is the text of /proc/self/cgroup, and control groups of
/// version 1 or 2 are mounted at `root`.
std::uint64_t groupMemoryIn(const std::string& groups, const std::filesystem::path& root);

} // namespace mote
