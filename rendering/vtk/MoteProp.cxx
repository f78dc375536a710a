#include "MoteProp.h"

namespace mote
{

std::shared_ptr<MoteProp> meshPropOf(vtkProp* prop);     // MeshProp.cxx
std::shared_ptr<MoteProp> particlePropOf(vtkProp* prop); // ParticleProp.cxx
std::shared_ptr<MoteProp> volumePropOf(vtkProp* prop);   // VolumeProp.cxx

std::shared_ptr<MoteProp> motePropOf(vtkProp* prop)
{
  for (const auto find : {particlePropOf, meshPropOf, volumePropOf})
    if (auto found = find(prop))
      return found;
  return nullptr;
}

} // namespace mote
