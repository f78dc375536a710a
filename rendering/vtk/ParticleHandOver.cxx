// What particle mappers build, on another thread too, and hand to one another.

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

void vtkMoteParticleMapper::StopBuild()
{
  this->GetModel().stopBuild();
}

void vtkMoteParticleMapper::SetScratchSpace(std::shared_ptr<mote::ScratchSpace> space)
{
  this->GetModel().space = std::move(space);
}

bool vtkMoteParticleMapper::IsBuilding()
{
  return this->GetModel().isBuilding();
}

vtkIdType vtkMoteParticleMapper::GetNumberOfPreviewParticles()
{
  return static_cast<vtkIdType>(this->GetModel().previewed());
}

double vtkMoteParticleMapper::GetBuildProgress()
{
  return this->GetModel().buildProgress();
}

bool vtkMoteParticleMapper::IsPreview()
{
  return this->GetModel().isPreview();
}
