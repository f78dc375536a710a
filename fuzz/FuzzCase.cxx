// Any files as a case of several, of which MOTE_FUZZ_OPENS is opened: there are data, or there is
// one sentence.

#include "FilePack.h"
#include "ScratchFile.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const ScratchFile place("");
  const std::filesystem::path folder = place.path() + ".case";
  std::error_code error;
  std::filesystem::remove_all(folder, error);
  if (!std::filesystem::create_directory(folder, error))
    std::abort();
  unpack({reinterpret_cast<const char*>(bytes), size}, folder);
  readAsUsersDo((folder / MOTE_FUZZ_OPENS).string());
  return 0;
}
