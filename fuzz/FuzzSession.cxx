// Any bytes as a session: there are settings, which are the same when they are written and read
// again, or there is one sentence.

#include "base/Failure.h"
#include "table/Session.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace mote::app;
  const std::string place = "/tmp/session.json";
  try
  {
    const Settings settings =
      parseSession(std::string(reinterpret_cast<const char*>(bytes), size), place);
    const std::string written = sessionText(settings, place);
    if (sessionText(parseSession(written, place), place) != written)
    {
      std::fprintf(stderr, "another session when it is read again: %s\n", written.c_str());
      std::abort();
    }
  }
  catch (const Failure& failure)
  {
    if (std::string(failure.what()).empty())
      std::abort();
  }
  return 0;
}
