#include "ParticleStructure.h"

namespace mote
{

namespace
{

/// What `structure` holds, anew where it is of another type.
template <typename Structure>
Structure& ensure(ParticleStructure& structure)
{
  return std::holds_alternative<Structure>(structure) ? std::get<Structure>(structure)
                                                      : structure.emplace<Structure>();
}

} // namespace

std::shared_ptr<ParticleStructure> makeParticleStructure(const ParticleSet& particles,
  const ParticleStructureOptions& options, const Progress& progress,
  std::shared_ptr<ParticleStructure> used)
{
  bool complete = true;
  const Progress watched = [&](double done)
  {
    complete = complete && (!progress || progress(done));
    return complete;
  };
  if (!used)
    used = std::make_shared<ParticleStructure>();
  const bool grid = options.kind == ParticleStructureKind::Automatic
                      ? particles.count() <= automaticGridParticles
                      : options.kind == ParticleStructureKind::CoherentGrid;
  if (grid)
    ensure<CoherentGrid>(*used).build(particles, options.coherentGrid, watched);
  else
    ensure<PkdTree>(*used).build(particles, options.pkdTree, watched);
  return complete ? used : nullptr;
}

const std::vector<std::string>& particleStructureNames()
{
  static const std::vector<std::string> names = {"auto", "coherent-grid", "pkd-tree"};
  return names;
}

} // namespace mote
