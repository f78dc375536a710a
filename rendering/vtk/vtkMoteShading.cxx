#include "vtkMoteShading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteShading);

void vtkMoteShading::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AmbientOcclusionSamples: " << this->AmbientOcclusionSamples << "\n";
  os << indent << "AmbientOcclusionReach: " << this->AmbientOcclusionReach << "\n";
}
