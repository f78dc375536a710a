#ifndef MoteMostArrays_h
#define MoteMostArrays_h

#include <cstddef>
#include <string>

namespace mote
{

/// Data sets look for an array by going through the names of all: more take minutes.
constexpr std::size_t mostArrays = 10000;

/// What is wrong with more, "arrays" or whatever they are called in the file.
inline std::string tooMany(const std::string& what)
{
  return "more than " + std::to_string(mostArrays) + " " + what + " are not read";
}

} // namespace mote

#endif
