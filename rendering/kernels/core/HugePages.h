#pragma once

#include <cstddef>

namespace mote
{

/// Advises the system to keep memory that is not touched yet in pages of megabytes where it fills
/// any: look-ups all over it then miss fewer addresses. Changes nothing else.
void preferHugePages(void* memory, std::size_t bytes) noexcept;

} // namespace mote
