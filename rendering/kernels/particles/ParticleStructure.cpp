#include "ParticleStructure.h"

#include "../core/Alternatives.h"

namespace mote
{

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
  withAlternative<ParticleStructure>(static_cast<std::size_t>(kind) - 1,
    [&]<typename Structure>(std::type_identity<Structure>)
    {
      if (!std::holds_alternative<Structure>(*used))
        used->emplace<Structure>();
      std::get<Structure>(*used).build(particles, options.of<Structure>(), watched);
    });
  return complete ? used : nullptr;
}

const std::vector<std::string>& particleStructureNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> all = alternativeNames<ParticleStructure>();
    all.insert(all.begin(), "auto");
    return all;
  }();
  return names;
}

} // namespace mote
