#pragma once

#include <functional>
#include <string>

namespace mote::bench
{

/// What /proc/self/status says of `key`, such as RssAnon, in bytes. NaN where it says nothing.
double statusBytes(const std::string& key);

/// The most memory in bytes that the process holds at any time during the work, beyond what it held
/// before; right to some hundred kilobytes. NaN where the system does not say.
double peakExtraBytes(const std::function<void()>& work);

} // namespace mote::bench
