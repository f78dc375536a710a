#pragma once

#include "CoherentGrid.h"
#include "PkdPaperTree.h"
#include "PkdTree.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace mote
{

/// Every structure that can hold particles for ray casting. A new one is one more alternative here
/// and one more entry in ParticleStructure.cpp.
using ParticleStructure = std::variant<CoherentGrid, PkdTree, PkdPaperTree>;

/// Which structure to build.
enum class ParticleStructureKind
{
  Automatic, ///< the coherent grid up to automaticGridParticles, the P-k-d tree above
  CoherentGrid,
  PkdTree,
  PkdPaper ///< the published P-k-d tree, to compare with
};

/// The grid casts a camera's rays faster, the tree takes 12.5 bytes a particle and not 20.
constexpr std::size_t automaticGridParticles = 100'000'000;

struct ParticleStructureOptions
{
  ParticleStructureKind kind = ParticleStructureKind::Automatic;
  CoherentGridOptions coherentGrid;
  PkdTreeOptions pkdTree;
  PkdPaperTreeOptions pkdPaper;
};

/// Builds the structure that the options name over the particles, in `used` where that is given and
/// of the right kind, so that its memory is used again. Throws Error for malformed sets. An
/// interrupted build (see Progress) gives null.
std::shared_ptr<ParticleStructure> makeParticleStructure(const ParticleSet& particles,
  const ParticleStructureOptions& options = {}, const Progress& progress = {},
  std::shared_ptr<ParticleStructure> used = {});

/// The names of the structures, for options and messages, in the order of ParticleStructureKind.
const std::vector<std::string>& particleStructureNames();

/// Calls `visit` with the structure that the variant holds.
template <typename Visit>
decltype(auto) withStructure(const ParticleStructure& structure, const Visit& visit)
{
  return std::visit(visit, structure);
}

} // namespace mote
