#include "vtkMoteSilhouettes.h"

#include "kernels/imaging/Silhouettes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteSilhouettes);

mote::SilhouetteOptions vtkMoteSilhouettes::MakeOptions(double step) const
{
  mote::SilhouetteOptions options;
  options.step = step;
  options.stepInPixels = this->StepInPixels;
  options.hulls = this->Hulls;
  options.thickness = this->Thickness;
  options.leastThickness = this->LeastThickness;
  options.leastOpacity = this->LeastOpacity;
  options.fullStep = this->FullStep;
  options.centered = this->Centered;
  return options;
}

void vtkMoteSilhouettes::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const modes[] = {"World", "Radii", "SceneSize"};
  const auto onOff = [](bool on) { return on ? "On" : "Off"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << onOff(this->Enabled) << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "ThresholdMode: " << modes[this->ThresholdMode] << "\n";
  os << indent << "StepInPixels: " << this->StepInPixels << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "LeastThickness: " << this->LeastThickness << "\n";
  os << indent << "LeastOpacity: " << this->LeastOpacity << "\n";
  os << indent << "FullStep: " << this->FullStep << "\n";
  os << indent << "Hulls: " << onOff(this->Hulls) << "\n";
  os << indent << "Centered: " << onOff(this->Centered) << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n";
  os << indent << "GroupArrayName: " << this->GroupArrayName << "\n";
}
