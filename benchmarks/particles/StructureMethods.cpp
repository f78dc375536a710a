// The structures of Mote's.

#include "StructureMethod.h"

#include <kernels/particles/CoherentGrid.h>
#include <kernels/particles/PkdPaperTree.h>
#include <kernels/particles/PkdTree.h>

#include <limits>

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

std::unique_ptr<ParticleMethod> makeTree(const MethodOptions& options, PkdTreeOptions::Form form)
{
  PkdTreeOptions build;
  build.keepIndices = false;
  build.form = form;
  build.mostError = std::numeric_limits<double>::infinity(); // wrong pixels tell
  return std::make_unique<StructureMethod<PkdTree, PkdTreeOptions>>(build, options.packet);
}

} // namespace

std::unique_ptr<ParticleMethod> makePkdTreeMethod(const MethodOptions& options)
{
  return makeTree(options, PkdTreeOptions::Form::Exact);
}

std::unique_ptr<ParticleMethod> makePkdTree8Method(const MethodOptions& options)
{
  return makeTree(options, PkdTreeOptions::Form::Bytes8);
}

std::unique_ptr<ParticleMethod> makePkdTree4Method(const MethodOptions& options)
{
  return makeTree(options, PkdTreeOptions::Form::Bytes4);
}

std::unique_ptr<ParticleMethod> makePkdPaperMethod(const MethodOptions& options)
{
  PkdPaperTreeOptions build;
  build.keepIndices = false;
  return std::make_unique<StructureMethod<PkdPaperTree, PkdPaperTreeOptions>>(
    build, options.packet);
}

} // namespace mote::bench
