// The structures of Mote's.

#include "StructureMethod.h"

#include <kernels/particles/CoherentGrid.h>
#include <kernels/particles/PkdTree.h>

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

std::unique_ptr<ParticleMethod> makePkdTreeMethod(const MethodOptions& options)
{
  PkdTreeOptions build;
  build.keepIndices = false;
  return std::make_unique<StructureMethod<PkdTree, PkdTreeOptions>>(build, options.packet);
}

} // namespace mote::bench
