#include "ParticleStructure.h"

namespace mote
{

std::shared_ptr<ParticleStructure> makeParticleStructure(
  const ParticleSet& particles, const ParticleStructureOptions& options, const Progress& progress)
{
  bool complete = true;
  const Progress watched = [&](double done)
  {
    complete = complete && (!progress || progress(done));
    return complete;
  };
  auto structure = std::make_shared<ParticleStructure>();
  switch (options.kind)
  {
  case ParticleStructureKind::CoherentGrid:
    structure->emplace<CoherentGrid>().build(particles, options.coherentGrid, watched);
    break;
  }
  return complete ? structure : nullptr;
}

const std::vector<std::string>& particleStructureNames()
{
  static const std::vector<std::string> names = {"coherent-grid"};
  return names;
}

} // namespace mote
