#pragma once

#include "CoherentGrid.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace mote
{

/// Every structure that can hold particles for ray casting. A new one is one more alternative here
/// and one more entry in ParticleStructure.cpp.
using ParticleStructure = std::variant<CoherentGrid>;

/// Which structure to build.
enum class ParticleStructureKind
{
  CoherentGrid
};

struct ParticleStructureOptions
{
  ParticleStructureKind kind = ParticleStructureKind::CoherentGrid;
  CoherentGridOptions coherentGrid;
};

/// Builds the structure that the options name over the particles. Throws Error for malformed sets.
/// An interrupted build (see Progress) gives null.
std::shared_ptr<ParticleStructure> makeParticleStructure(const ParticleSet& particles,
  const ParticleStructureOptions& options = {}, const Progress& progress = {});

/// The names of the structures, for options and messages, in the order of ParticleStructureKind.
const std::vector<std::string>& particleStructureNames();

/// Calls `visit` with the structure that the variant holds.
template <typename Visit>
decltype(auto) withStructure(const ParticleStructure& structure, const Visit& visit)
{
  return std::visit(visit, structure);
}

} // namespace mote
