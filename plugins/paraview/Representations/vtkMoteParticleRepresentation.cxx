#include "vtkMoteParticleRepresentation.h"

#include "CommonSpacing.h"
#include "PointParts.h"
#include "vtkMoteParticleMapper.h"
#include "vtkMoteSourcePoints.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMoteParticleRepresentation);

namespace
{

double greatestOf(vtkDataArray* array)
{
  const double* range = array ? array->GetFiniteRange(0) : nullptr;
  return range && range[0] <= range[1] ? std::max(0.0, range[1]) : 0.0;
}

} // namespace

vtkMoteParticleRepresentation::vtkMoteParticleRepresentation() = default;
vtkMoteParticleRepresentation::~vtkMoteParticleRepresentation() = default;

vtkMapper* vtkMoteParticleRepresentation::GetMapper()
{
  return this->Mapper;
}

vtkSmartPointer<vtkPointSet> vtkMoteParticleRepresentation::Collect(
  const std::vector<vtkPointSet*>& parts)
{
  return mote::collectPoints(parts);
}

void vtkMoteParticleRepresentation::Connect(vtkAlgorithmOutput* piece)
{
  this->Superclass::Connect(piece);
  // A ghost that light goes through would hide what this rank has behind it.
  this->Mapper->SetMeetsGhosts(this->HaveBoxesAndGhosts && !this->IsTranslucent());
}

/// Whether the data of this rank tell radii in the present mode.
bool vtkMoteParticleRepresentation::HasOwnRadii()
{
  if (this->RadiusMode != vtkMoteParticleMapper::RADIUS_AUTOMATIC)
    return this->RadiusMode != vtkMoteParticleMapper::RADIUS_FROM_SPACING;
  auto* ofSource = vtkMoteSourcePoints::SafeDownCast(this->Drawn->GetPoints());
  return (ofSource && ofSource->GetSource()) ||
         vtkMoteParticleMapper::FindRadii(this->Drawn->GetPointData());
}

/// The typical distance of neighbours, on whichever ranks these are; 0 where all tell radii.
double vtkMoteParticleRepresentation::GetCommonSpacing()
{
  auto* particles = vtkPolyData::SafeDownCast(this->Drawn);
  const bool counts = particles->GetNumberOfPoints() > 0 && !this->HasOwnRadii();
  const double found = mote::commonSpacingOf(counts ? particles : nullptr); // asked on all ranks
  const double kept = mote::keptSpacingOf(particles);
  return kept > 0.0 && counts ? kept : found;
}

double vtkMoteParticleRepresentation::GetLargestRadius()
{
  vtkPointData* data = this->Drawn->GetPointData();
  const double scale = this->Mapper->GetRadiusScale();
  switch (this->Mapper->GetRadiusMode())
  {
  case vtkMoteParticleMapper::RADIUS_CONSTANT:
    return scale * this->Mapper->GetRadius();
  case vtkMoteParticleMapper::RADIUS_BY_ARRAY:
    return scale * greatestOf(data->GetArray(this->Mapper->GetRadiusArrayName()));
  default:
    break;
  }
  if (vtkDataArray* radii = vtkMoteParticleMapper::FindRadii(data))
    return scale * vtkMoteParticleMapper::GetRadiusFactor(radii->GetName()) * greatestOf(radii);
  // What only the mapper can tell.
  this->Mapper->SetInputData(this->Drawn);
  double drawn[6], points[6], most = 0.0;
  this->Mapper->GetBounds(drawn);
  this->Drawn->GetPoints()->GetBounds(points);
  for (int i = 0; i < 6; ++i)
    most = std::max(most, std::abs(drawn[i] - points[i]));
  return most;
}

double vtkMoteParticleRepresentation::GetReach()
{
  const double spacing = this->GetCommonSpacing();
  this->Mapper->SetRadiusMode(
    spacing > 0.0 ? vtkMoteParticleMapper::RADIUS_CONSTANT : this->RadiusMode);
  this->Mapper->SetRadius(spacing > 0.0 ? 0.5 * spacing : this->Radius);
  return this->Drawn->GetNumberOfPoints() > 0 ? this->GetLargestRadius() : 0.0;
}

void vtkMoteParticleRepresentation::SetRadiusMode(int mode)
{
  this->RadiusMode = mode;
  this->MarkModified(); // bounds change
}

void vtkMoteParticleRepresentation::SelectRadiusArray(int, int, int, int, const char* name)
{
  this->Mapper->SetRadiusArrayName(name);
  this->MarkModified();
}

void vtkMoteParticleRepresentation::SetRadius(double radius)
{
  this->Radius = radius;
  this->MarkModified();
}

void vtkMoteParticleRepresentation::SetRadiusScale(double scale)
{
  this->Mapper->SetRadiusScale(scale);
  this->MarkModified();
}

void vtkMoteParticleRepresentation::SetStructureName(const char* name)
{
  this->Mapper->SetStructureName(name);
}

void vtkMoteParticleRepresentation::SetSamplesPerPixel(int samples)
{
  this->Mapper->SetSamplesPerPixel(samples);
}

void vtkMoteParticleRepresentation::SetUseVisibilityRange(int on)
{
  this->Mapper->SetUseVisibilityRange(on);
}

void vtkMoteParticleRepresentation::SelectVisibilityArray(int, int, int, int, const char* name)
{
  this->Mapper->SetVisibilityArrayName(name);
}

void vtkMoteParticleRepresentation::SetVisibilityRange(double low, double high)
{
  this->Mapper->SetVisibilityRange(low, high);
}

void vtkMoteParticleRepresentation::SetPixelsOfError(double pixels)
{
  this->Mapper->SetPixelsOfError(pixels);
}
