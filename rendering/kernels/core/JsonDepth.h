#pragma once

#include <cstddef>
#include <string_view>

namespace mote
{

/// Whether lists and objects of a text in JSON lie in one another more than a hundred deep. No file
/// that is read has that, and libraries copy, print and look through such values by functions that
/// call themselves until the stack is full.
inline bool isDeepJson(std::string_view text)
{
  int depth = 0;
  bool isQuoted = false;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i];
    if (isQuoted && c == '\\')
      ++i; // what follows is no end
    else if (c == '"')
      isQuoted = !isQuoted;
    else if (!isQuoted && (c == '[' || c == '{') && ++depth > 100)
      return true;
    else if (!isQuoted && (c == ']' || c == '}'))
      --depth;
  }
  return false;
}

} // namespace mote
