#include "ParticleMethod.h"

namespace mote::bench
{

const std::vector<ParticleMethodEntry>& particleMethods()
{
  static const std::vector<ParticleMethodEntry> all = []
  {
    const std::vector<ParticleMethodEntry> peers = {
      {"cgt-reference", "grid with references to spheres in all cells they overlap, packets of 8x8",
        makeReferenceGridMethod, false},
      {"grid-single", "grid as Mote's, stepped through from cell to cell by single rays",
        makeSingleRayMethod, false},
      {"embree", "Embree's sphere points, the fastest of its single rays, packets and streams",
        makeEmbreeMethod, true}};
    std::vector<ParticleMethodEntry> methods = structureMethods();
    methods.insert(methods.end(), peers.begin(), peers.end());
    return methods;
  }();
  return all;
}

} // namespace mote::bench
