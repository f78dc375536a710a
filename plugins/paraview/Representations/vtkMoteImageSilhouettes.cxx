#include "vtkMoteImageSilhouettes.h"

#include "vtkMoteSilhouettes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteImageSilhouettes);

vtkMoteImageSilhouettes::vtkMoteImageSilhouettes()
{
  this->SetDepthModeToOrthographic();
}

vtkMoteImageSilhouettes::~vtkMoteImageSilhouettes() = default;

void vtkMoteImageSilhouettes::SelectDepthArray(int, int, int, int, const char* name)
{
  this->SetDepthArrayName(name ? name : "");
}

void vtkMoteImageSilhouettes::SetThreshold(double step)
{
  this->GetSilhouettes()->SetThreshold(step);
}

void vtkMoteImageSilhouettes::SetThresholdMode(int mode)
{
  this->GetSilhouettes()->SetThresholdMode(mode);
}

void vtkMoteImageSilhouettes::SetThickness(double pixels)
{
  this->GetSilhouettes()->SetThickness(pixels);
}

void vtkMoteImageSilhouettes::SetHulls(int on)
{
  this->GetSilhouettes()->SetHulls(on != 0);
}
