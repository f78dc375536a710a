#include "ParticleMethod.h"

namespace mote::bench
{

const std::vector<ParticleMethodEntry>& particleMethods()
{
  static const std::vector<ParticleMethodEntry> all = {
    {"cgt", "Mote's coherent grid, bundles of rays as large as suits", makeCoherentGridMethod,
      true},
    {"pkd", "Mote's P-k-d tree, bundles of rays as large as suits", makePkdTreeMethod, true},
    {"pkd8", "the same tree with 8 bytes a particle", makePkdTree8Method, true},
    {"pkd4", "the same tree with 4 bytes a particle", makePkdTree4Method, true},
    {"pkd-paper", "the P-k-d tree as published, in heap order, single rays", makePkdPaperMethod,
      true},
    {"cgt-reference", "grid with references to spheres in all cells they overlap, packets of 8x8",
      makeReferenceGridMethod, false},
    {"grid-single", "grid as Mote's, stepped through from cell to cell by single rays",
      makeSingleRayMethod, false},
    {"embree", "Embree's sphere points, the fastest of its single rays, packets and streams",
      makeEmbreeMethod, true}};
  return all;
}

} // namespace mote::bench
