#include "MapperOcclusion.h"

#include "OcclusionArrays.h"

#include "kernels/core/Error.h"
#include "kernels/particles/ParticleHash.h"

#include <cmath>
#include <sstream>

namespace mote
{

namespace
{

InputKey keyOf(const MappedParticles& particles, const OcclusionRequest& request)
{
  const OcclusionBakeOptions& o = request.options;
  const auto mapsTime = particles.field ? occlusionArraysTime(particles.field) : 0;
  return {double(o.side), double(o.samples), o.reach, double(o.adaptive), o.tolerance,
    double(request.reachChosen), double(mapsTime)};
}

/// Why the maps of the input cannot be used; empty where they can.
std::string problemOf(
  const StoredOcclusion& stored, const MappedParticles& particles, const OcclusionRequest& request)
{
  const ParticleInput input = particles.input();
  if (stored.maps.size() != input.set.count() || stored.content != hashOf(input.set))
    return "The occlusion maps of the input belong to other particles or other radii, and are not "
           "used.";
  const double wanted = request.options.reach;
  if (request.reachChosen && stored.reach != wanted &&
      !(std::abs(stored.reach - wanted) <= 1e-6 * wanted))
  {
    std::ostringstream text;
    text << "The occlusion maps of the input have a reach of " << stored.reach << " and not of "
         << wanted << ", and are not used.";
    return text.str();
  }
  return {};
}

} // namespace

std::string MapperOcclusion::begin(
  const MappedParticles& particles, const OcclusionRequest& request)
{
  std::string problem;
  try
  {
    const auto stored = particles.field ? findOcclusionArrays(particles.field) : std::nullopt;
    problem = stored ? problemOf(*stored, particles, request) : "";
    if (stored && problem.empty())
    {
      known_.begin(particles.structure, request.options, *stored);
      return {};
    }
  }
  catch (const Error& error)
  {
    problem = error.what();
  }
  known_.begin(particles.structure, request.options);
  return problem;
}

std::string MapperOcclusion::update(
  const MappedParticles& particles, const OcclusionRequest& request)
{
  const auto before = known_.maps();
  const InputKey requestKey = keyOf(particles, request);
  std::string problem;
  if (!before || particles.key != structureKey_ || requestKey != requestKey_)
  {
    problem = this->begin(particles, request);
    structureKey_ = particles.key;
    requestKey_ = requestKey;
  }
  else if (seenChange_ != particles.changed)
    known_.update(particles.structure);
  seenChange_ = particles.changed;
  this->noteChange(before);
  return problem;
}

bool MapperOcclusion::bake(
  const ParticleStructure& structure, const ParticleBits& wanted, const Progress& progress)
{
  const auto before = known_.maps();
  const bool finished = known_.bake(structure, wanted, progress);
  this->noteChange(before);
  return finished;
}

void MapperOcclusion::noteChange(const std::shared_ptr<const OcclusionMaps>& before)
{
  if (known_.maps() == before)
    return;
  complete_ = known_.countMissing() == 0;
  at_.Modified();
}

} // namespace mote
