#include "vtkMoteAreaLight.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteAreaLight);

void vtkMoteAreaLight::CopyShadows(vtkLight* light)
{
  if (auto* other = vtkMoteAreaLight::SafeDownCast(light))
  {
    this->SetShadows(other->Shadows);
    this->SetSize(other->Size);
    this->SetSamples(other->Samples);
  }
}

vtkLight* vtkMoteAreaLight::ShallowClone()
{
  vtkMoteAreaLight* clone = vtkMoteAreaLight::New();
  clone->vtkLight::DeepCopy(this);
  clone->SetTransformMatrix(this->GetTransformMatrix()); // shared, as vtkLight does
  clone->CopyShadows(this);
  return clone;
}

void vtkMoteAreaLight::DeepCopy(vtkLight* light)
{
  this->vtkLight::DeepCopy(light);
  this->CopyShadows(light);
}

void vtkMoteAreaLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shadows: " << (this->Shadows ? "On" : "Off") << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
}
