#include "MapperOcclusion.h"

#include "kernels/core/Error.h"

namespace mote
{

std::string MapperOcclusion::update(const ParticleStructure& structure,
  const InputKey& structureKey, vtkMTimeType changed, const OcclusionBakeOptions& o,
  const InputKey& key, const FindMaps& find)
{
  const auto before = known_.maps();
  InputKey requestKey = {double(o.side), double(o.samples), o.reach, double(o.adaptive),
    o.tolerance, double(o.dilate), o.sky.top, o.sky.bottom, o.sky.up.x, o.sky.up.y, o.sky.up.z};
  requestKey.insert(requestKey.end(), key.begin(), key.end());
  std::string problem;
  if (!before || structureKey != structureKey_ || requestKey != requestKey_)
  {
    bool found = false;
    try
    {
      if (const auto stored = find())
      {
        known_.begin(structure, o, *stored);
        found = true;
      }
    }
    catch (const Error& error)
    {
      problem = error.what();
    }
    if (!found)
      known_.begin(structure, o);
    structureKey_ = structureKey;
    requestKey_ = requestKey;
  }
  else if (seenChange_ != changed)
    known_.update(structure);
  seenChange_ = changed;
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
