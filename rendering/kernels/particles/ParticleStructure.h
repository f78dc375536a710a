#pragma once

#include "CoherentGrid.h"
#include "IsParticleStructure.h"
#include "PkdPaperTree.h"
#include "PkdTree.h"

#include <memory>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace mote
{

// One by one, so that the compiler names what a listed structure lacks.
template <IsParticleStructure Structure>
using CheckedParticleStructure = Structure;
template <typename... Structures>
using ParticleStructureOf = std::variant<CheckedParticleStructure<Structures>...>;

/// Every structure over particles. What they offer is written at IsParticleStructure; ask through
/// withStructure(), once for many rays. docs/architecture.md says how one is added.
using ParticleStructure = ParticleStructureOf<CoherentGrid, PkdTree, PkdPaperTree>;

/// Which structure to build: Automatic, or an alternative of ParticleStructure, in their order.
enum class ParticleStructureKind
{
  Automatic, ///< the coherent grid up to automaticGridParticles, the P-k-d tree above
  CoherentGrid,
  PkdTree,
  PkdPaper ///< the published P-k-d tree, to compare with
};
static_assert(std::variant_size_v<ParticleStructure> ==
                static_cast<std::size_t>(ParticleStructureKind::PkdPaper),
  "ParticleStructureKind names the alternatives of ParticleStructure in their order.");

/// The grid casts a camera's rays faster, the tree takes 12.5 bytes a particle and not 20.
constexpr std::size_t automaticGridParticles = 100'000'000;

struct ParticleStructureOptions
{
  ParticleStructureKind kind = ParticleStructureKind::Automatic;
  CoherentGridOptions coherentGrid;
  PkdTreeOptions pkdTree;
  PkdPaperTreeOptions pkdPaper;

  /// Those of a structure.
  template <typename Structure>
  const typename Structure::Options& of() const
  {
    return std::get<const typename Structure::Options&>(std::tie(coherentGrid, pkdTree, pkdPaper));
  }
};

/// Builds the structure that the options name over the particles, in `used` where that is given and
/// of the right kind, so that its memory is used again. Throws Error for malformed sets. An
/// interrupted build (see Progress) gives null.
std::shared_ptr<ParticleStructure> makeParticleStructure(const ParticleSet& particles,
  const ParticleStructureOptions& options = {}, const Progress& progress = {},
  std::shared_ptr<ParticleStructure> used = {});

/// "auto" and the names of the structures, in the order of ParticleStructureKind.
const std::vector<std::string>& particleStructureNames();

/// Calls `visit` with the structure that the variant holds.
template <typename Visit>
decltype(auto) withStructure(const ParticleStructure& structure, const Visit& visit)
{
  return std::visit(visit, structure);
}

} // namespace mote
