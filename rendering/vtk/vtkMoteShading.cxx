#include "vtkMoteShading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteShading);

void vtkMoteShading::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  os << indent << "Mode: " << (this->Mode == PATH_TRACED ? "PathTraced" : "Local") << "\n";
  os << indent << "MaximumBounces: " << this->MaximumBounces << "\n";
  print("SkyTop", this->SkyTop);
  print("SkyBottom", this->SkyBottom);
  print("SkyUp", this->SkyUp);
  os << indent << "AmbientOcclusionSamples: " << this->AmbientOcclusionSamples << "\n";
  os << indent << "AmbientOcclusionReach: " << this->AmbientOcclusionReach << "\n";
  os << indent << "CloudTolerance: " << this->CloudTolerance << "\n";
}
