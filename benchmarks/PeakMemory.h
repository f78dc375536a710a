#pragma once

#include <functional>

namespace mote::bench
{

/// The most memory in bytes that the process holds at any time during the work, beyond what it held
/// before; right to some hundred kilobytes. NaN where the system does not say.
double peakExtraBytes(const std::function<void()>& work);

} // namespace mote::bench
