#ifndef MoteColorByte_h
#define MoteColorByte_h

#include <algorithm>

namespace mote
{

/// A channel of a colour, from 0 to 255, as a byte; what lies outside counts as the nearer end, and
/// what is not a number as 0.
inline unsigned char colorByte(double value)
{
  return static_cast<unsigned char>(value > 0.0 ? std::min(value, 255.0) + 0.5 : 0.0);
}

} // namespace mote

#endif
