#include "ParticleMethod.h"

namespace mote::bench
{

const std::vector<ParticleMethodEntry>& particleMethods()
{
  static const std::vector<ParticleMethodEntry> all = {
    {"cgt", "Mote's coherent grid, bundles of rays as large as suits", makeCoherentGridMethod},
    {"embree", "Embree's sphere points, the fastest of its single rays, packets and streams",
      makeEmbreeMethod}};
  return all;
}

} // namespace mote::bench
