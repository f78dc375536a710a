// The structures of Mote's.

#include "StructureMethod.h"

#include <kernels/particles/ParticleStructure.h>

#include <limits>

namespace mote::bench
{

namespace
{

/// `adapt` sets what the method's build options have of their own.
template <typename Structure, typename Adapt>
std::unique_ptr<ParticleMethod> makeMethod(const MethodOptions& options, const Adapt& adapt)
{
  typename Structure::Options build;
  build.keepIndices = false;
  adapt(build);
  return std::make_unique<StructureMethod<Structure>>(build, options.packet);
}

template <typename Structure>
std::unique_ptr<ParticleMethod> makeMethod(const MethodOptions& options)
{
  return makeMethod<Structure>(options, [](auto&) {});
}

std::unique_ptr<ParticleMethod> makeGrid(const MethodOptions& options)
{
  return makeMethod<CoherentGrid>(
    options, [&](CoherentGridOptions& build) { build.cellsPerParticle = options.lambda; });
}

template <PkdTreeOptions::Form FORM>
std::unique_ptr<ParticleMethod> makeTree(const MethodOptions& options)
{
  return makeMethod<PkdTree>(options,
    [](PkdTreeOptions& build)
    {
      build.form = FORM;
      build.mostError = std::numeric_limits<double>::infinity(); // wrong pixels tell
    });
}

} // namespace

std::vector<ParticleMethodEntry> structureMethods()
{
  using Form = PkdTreeOptions::Form;
  return {{"cgt", "Mote's coherent grid, bundles of rays as large as suits", makeGrid, true},
    {"pkd", "Mote's P-k-d tree, bundles of rays as large as suits", makeTree<Form::Exact>, true},
    {"pkd8", "the same tree with 8 bytes a particle", makeTree<Form::Bytes8>, true},
    {"pkd4", "the same tree with 4 bytes a particle", makeTree<Form::Bytes4>, true},
    {"pkd-paper", "the P-k-d tree as published, in heap order, single rays",
      makeMethod<PkdPaperTree>, true}};
}

} // namespace mote::bench
