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
  ParticleStructureKind kind = options.kind;
  if (kind == ParticleStructureKind::Automatic)
    kind = particles.count() <= automaticGridParticles ? ParticleStructureKind::CoherentGrid
                                                       : ParticleStructureKind::PkdTree;
  if (kind == ParticleStructureKind::CoherentGrid)
    ensure<CoherentGrid>(*used).build(particles, options.coherentGrid, watched);
  else if (kind == ParticleStructureKind::PkdTree)
    ensure<PkdTree>(*used).build(particles, options.pkdTree, watched);
  else
    ensure<PkdPaperTree>(*used).build(particles, options.pkdPaper, watched);
  return complete ? used : nullptr;
}

const std::vector<std::string>& particleStructureNames()
{
  static const std::vector<std::string> names = {"auto", "coherent-grid", "pkd-tree", "pkd-paper"};
  return names;
}

} // namespace mote
