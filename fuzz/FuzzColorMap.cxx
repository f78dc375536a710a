// Any bytes as the file of a colour map: there are two colours or more, of shares from 0 to 1, or
// there is one sentence.

#include "base/Failure.h"
#include "stage/ColorMapFile.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace mote::app;
  try
  {
    const ColorMapFile map =
      parseColorMap(std::string(reinterpret_cast<const char*>(bytes), size), "a file");
    bool isRight = map.colors.size() >= 2;
    for (const Color& color : map.colors)
      for (const double share : color)
        isRight = isRight && share >= 0.0 && share <= 1.0;
    if (!isRight)
    {
      std::fprintf(stderr, "colours that are none\n");
      std::abort();
    }
  }
  catch (const Failure& failure)
  {
    const std::string sentence = failure.what();
    if (sentence.empty() || sentence.find('\n') != sentence.npos)
    {
      std::fprintf(stderr, "not one line: %s\n", sentence.c_str());
      std::abort();
    }
  }
  return 0;
}
