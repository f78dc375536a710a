#include "vtkMoteClipCylinder.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMoteClipCylinder);

void vtkMoteClipCylinder::SetZeroAngle(double x, double y, double z)
{
  if (this->ZeroAngle[0] == x && this->ZeroAngle[1] == y && this->ZeroAngle[2] == z)
    return;
  this->ZeroAngle[0] = x;
  this->ZeroAngle[1] = y;
  this->ZeroAngle[2] = z;
  this->Modified();
}

void vtkMoteClipCylinder::GetZeroAngle(double direction[3])
{
  std::copy_n(this->ZeroAngle, 3, direction);
  double across[3];
  vtkMath::Cross(this->Axis, direction, across);
  const double least = 1e-9 * vtkMath::Norm(this->Axis) * vtkMath::Norm(direction);
  if (vtkMath::Norm(across) > least)
    return;
  const bool isAlongX = std::abs(this->Axis[0]) > 0.9 * vtkMath::Norm(this->Axis);
  direction[0] = isAlongX ? 0.0 : 1.0;
  direction[1] = isAlongX ? 1.0 : 0.0;
  direction[2] = 0.0;
}

void vtkMoteClipCylinder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* numbers, int count)
  {
    os << indent << name << ":";
    for (int k = 0; k < count; ++k)
      os << " " << numbers[k];
    os << "\n";
  };
  double zero[3];
  this->GetZeroAngle(zero);
  print("Center", this->Center, 3);
  print("Axis", this->Axis, 3);
  print("ZeroAngle", zero, 3);
  print("RadiusRange", this->RadiusRange, 2);
  print("HeightRange", this->HeightRange, 2);
  print("AngleRange", this->AngleRange, 2);
}
