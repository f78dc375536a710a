// Which arrays hold radii, as vtkMoteParticleMapper tells others.
#include "vtkMoteParticleMapper.h"

#include "ParticleInput.h"

double vtkMoteParticleMapper::GetRadiusFactor(const char* arrayName)
{
  return arrayName ? mote::radiusFactor(arrayName) : 0.0;
}

vtkDataArray* vtkMoteParticleMapper::FindRadii(vtkPointData* data)
{
  return data ? mote::namedRadii(data) : nullptr;
}
