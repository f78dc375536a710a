#include "vtkMoteSlice.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteSlice);

void vtkMoteSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const names[] = {"Plane", "HalfPlane", "Cylinder", "UnrolledCylinder"};
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  os << indent << "Shape: " << names[this->Shape] << "\n";
  print("Center", this->Center);
  print("Axis", this->Axis);
  print("Outwards", this->Outwards);
  os << indent << "Radius: " << this->Radius << "\n";
}
