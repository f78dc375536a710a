#pragma once

#include <cstdint>

namespace mote::app
{

/// Memory in bytes that this process has of the machine; 0 where nobody tells.
std::uint64_t residentMemory();

} // namespace mote::app
