#ifndef MoteNumberAt_h
#define MoteNumberAt_h

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace mote
{

/// A number of a file at any place, of this machine's byte order or the other one.
template <class Number>
Number numberAt(const char* at, bool swapped)
{
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), at, sizeof(Number));
  if (swapped)
    std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

} // namespace mote

#endif
