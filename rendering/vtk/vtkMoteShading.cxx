#include "vtkMoteShading.h"

#include "kernels/core/Error.h"
#include "kernels/occlusion/OcclusionBake.h"
#include "kernels/scene/Scene.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkMoteShading);

namespace
{

constexpr int usualSamples = 4; // rays a hit

} // namespace

vtkMoteShading::vtkMoteShading()
{
  const mote::OcclusionBakeOptions usual;
  this->BakeSide = usual.side;
  this->BakeSamples = usual.samples;
  this->BakeAdaptive = usual.adaptive;
  this->BakeTolerance = usual.tolerance;
}

void vtkMoteShading::SetAmbientOcclusion(int how)
{
  how = std::clamp<int>(how, OCCLUSION_NONE, OCCLUSION_BAKED);
  if (this->AmbientOcclusion == how)
    return;
  this->AmbientOcclusion = how;
  if (how != OCCLUSION_NONE && this->AmbientOcclusionSamples == 0)
    this->AmbientOcclusionSamples = usualSamples;
  this->Modified();
}

void vtkMoteShading::SetAmbientOcclusionSamples(int samples)
{
  samples = std::clamp(samples, 0, mote::OcclusionOptions::mostRays);
  int how = this->AmbientOcclusion;
  if (samples > 0 && how == OCCLUSION_NONE)
    how = OCCLUSION_LIVE;
  else if (samples == 0 && how == OCCLUSION_LIVE)
    how = OCCLUSION_NONE;
  if (this->AmbientOcclusion == how && this->AmbientOcclusionSamples == samples)
    return;
  this->AmbientOcclusion = how;
  this->AmbientOcclusionSamples = samples;
  this->Modified();
}

void vtkMoteShading::SetBakeSide(int side)
{
  try
  {
    mote::OcclusionMaps::levelOf(side);
  }
  catch (const mote::Error& error)
  {
    vtkErrorMacro(<< error.what());
    return;
  }
  if (this->BakeSide == side)
    return;
  this->BakeSide = side;
  this->Modified();
}

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
  static const char* const occlusions[] = {"None", "Live", "Baked"};
  os << indent << "AmbientOcclusion: " << occlusions[this->AmbientOcclusion] << "\n";
  os << indent << "AmbientOcclusionSamples: " << this->AmbientOcclusionSamples << "\n";
  os << indent << "AmbientOcclusionReach: " << this->AmbientOcclusionReach << "\n";
  os << indent << "BakeSide: " << this->BakeSide << "\n";
  os << indent << "BakeSamples: " << this->BakeSamples << "\n";
  os << indent << "BakeAdaptive: " << (this->BakeAdaptive ? "On" : "Off") << "\n";
  os << indent << "BakeTolerance: " << this->BakeTolerance << "\n";
  os << indent << "CloudTolerance: " << this->CloudTolerance << "\n";
}
