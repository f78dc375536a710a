// The part of vtkMoteParticleMapper that keeps occlusion maps.

#include "ParticleMapperInternals.h"

#include "vtkFieldData.h"
#include "vtkPointSet.h"

mote::MapperOcclusion* vtkMoteParticleMapper::UpdateOcclusion(const mote::OcclusionRequest* request)
{
  Internals& impl = *this->Impl;
  if (!impl.structure || impl.preview || this->GetNumberOfParticles() == 0)
    return nullptr;
  if (request)
  {
    const mote::MappedParticles particles{*impl.structure, impl.structureKey,
      impl.builtAt.GetMTime(), this->GetInput()->GetFieldData(),
      [this] { return this->DescribeParticles(); }};
    const std::string problem = impl.occlusion.update(particles, *request);
    if (!problem.empty())
      vtkWarningMacro(<< problem);
  }
  return impl.occlusion.isOf(impl.structureKey) ? &impl.occlusion : nullptr;
}

vtkIdType vtkMoteParticleMapper::GetNumberOfBakedParticles()
{
  const auto* occlusion = this->UpdateOcclusion(nullptr);
  const std::shared_ptr<const mote::OcclusionMaps> maps = occlusion ? occlusion->maps() : nullptr;
  vtkIdType count = 0;
  for (std::size_t slot = 0; maps && slot < maps->size(); ++slot)
    count += maps->isBaked(slot);
  return count;
}

vtkTypeInt64 vtkMoteParticleMapper::GetOcclusionBytes()
{
  const auto* occlusion = this->UpdateOcclusion(nullptr);
  return occlusion ? static_cast<vtkTypeInt64>(occlusion->maps()->bytes()) : 0;
}
