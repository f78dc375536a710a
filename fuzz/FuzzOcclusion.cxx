// Any bytes as a file of occlusion maps: there are maps whose every texel can be looked up, or
// there is a sentence.

#include "ScratchFile.h"

#include "kernels/core/Error.h"
#include "kernels/occlusion/OcclusionFile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static ScratchFile file(".moteao");
  file.write(bytes, size);
  try
  {
    const mote::StoredOcclusion stored = mote::readOcclusionFile(file.path());
    const auto count = std::min<std::size_t>(stored.maps.size(), 1000);
    for (std::size_t i = 0; i < count; ++i)
      for (const mote::Vec3f& direction : {mote::Vec3f(0.0f, 0.0f, 1.0f),
             mote::Vec3f(-0.6f, 0.8f, 0.0f), mote::Vec3f(0.0f, -0.6f, -0.8f)})
        if (std::isnan(stored.maps.at(i, direction)))
          std::abort();
  }
  catch (const mote::Error&)
  {
  }
  return 0;
}
