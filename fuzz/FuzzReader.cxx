// Any bytes as a file of one format: there are data, or there is one sentence.

#include "ScratchFile.h"

#include <string_view>

namespace
{

/// Files of HDF5 are told by their bytes, whatever their name, and read with the help of a child
/// process, which takes longer than all else: they are for their own fuzzers.
bool isForOthers(std::string_view bytes)
{
  const std::string_view ending = MOTE_FUZZ_ENDING;
  const bool isOfHDF5 = ending == ".hdf5" || ending == ".vtkhdf" || ending == ".cgns";
  return !isOfHDF5 && bytes.substr(0, 4) == "\x89HDF";
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  if (isForOthers({reinterpret_cast<const char*>(bytes), size}))
    return -1; // and not into the corpus
  static ScratchFile file(MOTE_FUZZ_ENDING);
  file.write(bytes, size);
  readAsUsersDo(file.path());
  return 0;
}
