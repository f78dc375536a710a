// The structures of Mote's.

#include "StructureMethod.h"

#include <kernels/particles/CoherentGrid.h>
#include <kernels/particles/PkdPaperTree.h>
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

namespace
{

std::unique_ptr<ParticleMethod> makeTree(const MethodOptions& options, bool compact)
{
  PkdTreeOptions build;
  build.keepIndices = false;
  build.compact = compact;
  return std::make_unique<StructureMethod<PkdTree, PkdTreeOptions>>(build, options.packet);
}

} // namespace

std::unique_ptr<ParticleMethod> makePkdTreeMethod(const MethodOptions& options)
{
  return makeTree(options, false);
}

std::unique_ptr<ParticleMethod> makeCompactPkdTreeMethod(const MethodOptions& options)
{
  return makeTree(options, true);
}

std::unique_ptr<ParticleMethod> makePkdPaperMethod(const MethodOptions& options)
{
  PkdPaperTreeOptions build;
  build.keepIndices = false;
  return std::make_unique<StructureMethod<PkdPaperTree, PkdPaperTreeOptions>>(
    build, options.packet);
}

} // namespace mote::bench
