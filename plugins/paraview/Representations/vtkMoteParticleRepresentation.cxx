#include "vtkMoteParticleRepresentation.h"

#include "ParticleInput.h"
#include "vtkMoteParticleMapper.h"
#include "vtkMoteSourcePoints.h"

#include "vtkAppendPolyData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <numeric>

vtkStandardNewMacro(vtkMoteParticleRepresentation);

namespace
{

/// The points of a data set with their arrays, and no cells.
vtkSmartPointer<vtkPolyData> pointsOf(vtkPointSet* from)
{
  auto to = vtkSmartPointer<vtkPolyData>::New();
  to->SetPoints(from->GetPoints());
  to->GetPointData()->ShallowCopy(from->GetPointData());
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
  return to;
}

/// An array that the mapper takes radii from by itself: of one component and this name, in letters
/// of either case.
vtkDataArray* arrayNamed(vtkPointData* data, const std::string& name)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = data->GetArray(i);
        array && array->GetName() && array->GetNumberOfComponents() == 1 &&
        vtksys::SystemTools::LowerCase(array->GetName()) == name)
      return array;
  return nullptr;
}

/// The ranks of ParaView, each with a part of the particles.
class Ranks : public mote::ParticleParts
{
public:
  explicit Ranks(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }
  void sum(std::vector<double>& values) const override
  {
    this->Reduce(values, vtkCommunicator::SUM_OP);
  }
  void least(std::vector<double>& values) const override
  {
    this->Reduce(values, vtkCommunicator::MIN_OP);
  }
  double before(double value) const override
  {
    std::vector<double> all(static_cast<std::size_t>(this->Controller->GetNumberOfProcesses()));
    this->Controller->AllGather(&value, all.data(), 1);
    return std::accumulate(all.begin(), all.begin() + this->Controller->GetLocalProcessId(), 0.0);
  }

private:
  void Reduce(std::vector<double>& values, int operation) const
  {
    const std::vector<double> own = values;
    this->Controller->AllReduce(
      own.data(), values.data(), static_cast<vtkIdType>(values.size()), operation);
  }

  vtkMultiProcessController* Controller;
};

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
  if (parts.empty())
    return vtkSmartPointer<vtkPolyData>::New();
  if (parts.size() == 1)
    return pointsOf(parts.front());
  vtkNew<vtkAppendPolyData> append;
  for (vtkPointSet* part : parts)
    append->AddInputData(pointsOf(part));
  append->Update();
  return pointsOf(append->GetOutput());
}

/// Whether the data of this rank tell radii in the present mode.
bool vtkMoteParticleRepresentation::HasOwnRadii()
{
  if (this->RadiusMode != vtkMoteParticleMapper::RADIUS_AUTOMATIC)
    return this->RadiusMode != vtkMoteParticleMapper::RADIUS_FROM_SPACING;
  auto* ofSource = vtkMoteSourcePoints::SafeDownCast(this->Drawn->GetPoints());
  vtkPointData* data = this->Drawn->GetPointData();
  return (ofSource && ofSource->GetSource()) || arrayNamed(data, "radius") ||
         arrayNamed(data, "diameter");
}

/// The typical distance of neighbours, on whichever ranks these are; 0 where all tell radii.
double vtkMoteParticleRepresentation::GetCommonSpacing()
{
  const bool counts = this->Drawn->GetNumberOfPoints() > 0 && !this->HasOwnRadii();
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
    return counts ? mote::spacingOf(this->Drawn) : 0.0;
  const vtkNew<vtkPolyData> nothing;
  const Ranks ranks(controller);
  return mote::spacingOf(counts ? this->Drawn.Get() : nothing.Get(), &ranks);
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
  if (vtkDataArray* radius = arrayNamed(data, "radius"))
    return scale * greatestOf(radius);
  if (vtkDataArray* diameter = arrayNamed(data, "diameter"))
    return 0.5 * scale * greatestOf(diameter);
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
  const double spacing = this->GetCommonSpacing(); // asked on all ranks
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
