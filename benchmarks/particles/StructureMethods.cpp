// The structures of Mote's.

#include "StructureMethod.h"

#include <kernels/particles/CoherentGrid.h>

namespace mote::bench
{

std::unique_ptr<ParticleMethod> makeCoherentGridMethod(const MethodOptions& options)
{
  CoherentGridOptions build;
  build.keepIndices = false;
  build.cellsPerParticle = options.lambda;
  return std::make_unique<StructureMethod<CoherentGrid, CoherentGridOptions>>(
    build, options.packet);
}

} // namespace mote::bench
