// How particle mappers hand structures to one another.

#include "vtkMoteParticleMapper.h"

#include "ParticleModel.h"

std::shared_ptr<const mote::BuiltParticles> vtkMoteParticleMapper::GetBuilt()
{
  return this->GetModel().built();
}

void vtkMoteParticleMapper::OfferBuilt(std::shared_ptr<const mote::BuiltParticles> built)
{
  this->GetModel().offer(std::move(built));
}
