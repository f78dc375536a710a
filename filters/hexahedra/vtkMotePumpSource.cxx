#include "vtkMotePumpSource.h"

#include "PumpCounts.h"
#include "PumpPart.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <optional>

vtkStandardNewMacro(vtkMotePumpSource);

struct vtkMotePumpSource::Internals
{
  std::optional<mote::pump::Part> parts[3];
  vtkMTimeType time = 0; // of the properties they were made with
};

namespace
{

constexpr const char* partNames[3] = {"inlet", "rotor", "diffuser"};

} // namespace

vtkMotePumpSource::vtkMotePumpSource()
  : Made(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkMotePumpSource::~vtkMotePumpSource() = default;

vtkIdType vtkMotePumpSource::GetNumberOfCells(double scale, int part)
{
  using namespace mote::pump;
  const double s = std::clamp(scale, leastScale, greatestScale);
  const vtkIdType counts[3] = {
    inletCounts(s).cells(), rotorCounts(s).cells(), diffuserCounts(s).cells()};
  return part == ALL ? counts[0] + counts[1] + counts[2] : counts[part - INLET];
}

int vtkMotePumpSource::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkMotePumpSource::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(info);
  vtkSmartPointer<vtkDataObject> wanted;
  if (this->Part == ALL && !vtkMultiBlockDataSet::SafeDownCast(output))
    wanted = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  else if (this->Part != ALL && !vtkUnstructuredGrid::SafeDownCast(output))
    wanted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (wanted)
    info->Set(vtkDataObject::DATA_OBJECT(), wanted);
  return 1;
}

int vtkMotePumpSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (!(this->RotationRate > 0.0) || !std::isfinite(this->RotationRate))
  {
    info->Remove(Pipeline::TIME_STEPS());
    info->Remove(Pipeline::TIME_RANGE());
    return 1; // RequestData() tells
  }
  std::vector<double> times;
  for (int i = 0; i < this->NumberOfTimeSteps; ++i)
    times.push_back(i / (this->RotationRate * this->NumberOfTimeSteps));
  const double range[2] = {times.front(), times.back()};
  info->Set(Pipeline::TIME_STEPS(), times.data(), this->NumberOfTimeSteps);
  info->Set(Pipeline::TIME_RANGE(), range, 2);
  return 1;
}

bool vtkMotePumpSource::CheckFrame()
{
  const double axis = std::hypot(this->Axis[0], this->Axis[1], this->Axis[2]);
  const double origin = std::hypot(this->Origin[0], this->Origin[1], this->Origin[2]);
  const auto isLength = [](double x) { return x > 0.0 && std::isfinite(x); };
  const char* wrong = !isLength(axis)           ? "axis must have a finite length above 0"
                      : !std::isfinite(origin)  ? "origin must be finite"
                      : !isLength(this->Radius) ? "radius must be a finite number above 0"
                      : !isLength(this->RotationRate)
                        ? "rotation rate must be a finite number above 0"
                        : nullptr;
  if (wrong)
    vtkErrorMacro(<< "The pump's " << wrong << ".");
  return !wrong;
}

void vtkMotePumpSource::MakeParts()
{
  using namespace mote::pump;
  if (this->Made->time < this->GetMTime())
  {
    for (auto& part : this->Made->parts)
      part.reset();
    this->Made->time = this->GetMTime();
  }
  Frame frame;
  frame.origin = {this->Origin[0], this->Origin[1], this->Origin[2]};
  frame.axis = glm::normalize(mote::Vec3d(this->Axis[0], this->Axis[1], this->Axis[2]));
  frame.radius = this->Radius;
  frame.angularSpeed = 2.0 * pi * this->RotationRate;
  const int precision = this->OutputPointsPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE;
  for (int i = 0; i < 3; ++i)
    if ((this->Part == ALL || this->Part - INLET == i) && !this->Made->parts[i])
    {
      this->Made->parts[i].emplace(static_cast<PartName>(i), this->Scale, frame, precision);
      this->UpdateProgress((i + 1) / 4.0);
    }
}

int vtkMotePumpSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(info);
  output->Initialize();
  if (!this->CheckFrame())
    return 0;
  this->MakeParts();
  const double time =
    info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
  if (this->Part != ALL)
    output->ShallowCopy(this->Made->parts[this->Part - INLET]->at(time));
  else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
    for (unsigned int i = 0; i < 3; ++i)
    {
      blocks->SetBlock(i, this->Made->parts[i]->at(time));
      blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), partNames[i]);
    }
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  return 1;
}

void vtkMotePumpSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Part: " << (this->Part == ALL ? "all" : partNames[this->Part - INLET]) << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RotationRate: " << this->RotationRate << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2] << "\n";
  os << indent << "NumberOfTimeSteps: " << this->NumberOfTimeSteps << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
