#pragma once

#include <cstdint>

namespace mote::app
{

/// Memory in bytes that this process has of the machine; 0 where nobody tells.
std::uint64_t residentMemory();

/// Keeps this process below the memory limit of the control group that it is in, if there is one,
/// as containers and batch systems set it: allocations fail then, and a sentence says so, where the
/// system would kill it without a word.
void keepToMemoryOfGroup();

} // namespace mote::app
