// Any bytes as a file of one format: there are data, or there is one sentence.

#include "ScratchFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static ScratchFile file(MOTE_FUZZ_ENDING);
  file.write(bytes, size);
  readAsUsersDo(file.path());
  return 0;
}
