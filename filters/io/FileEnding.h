#ifndef MoteFileEnding_h
#define MoteFileEnding_h

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

namespace mote
{

/// The one of these endings, in small letters, that a file name has after something else, in
/// letters of any case; empty for none.
inline std::string endingAmong(std::string name, std::initializer_list<const char*> endings)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string ending : endings)
    if (name.size() > ending.size() && name.ends_with(ending))
      return ending;
  return {};
}

} // namespace mote

#endif
