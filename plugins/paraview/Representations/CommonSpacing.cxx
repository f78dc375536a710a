#include "CommonSpacing.h"

#include "DataParts.h"
#include "ParticleInput.h"

#include "vtkCommunicator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <numeric>
#include <vector>

namespace mote
{

namespace
{

constexpr const char* spacingName = "MoteSpacing";

/// The ranks of ParaView, each with a part of the particles.
class Ranks : public ParticleParts
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

} // namespace

double commonSpacingOf(vtkPolyData* particles)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
    return particles ? spacingOf(particles) : 0.0;
  const vtkNew<vtkPolyData> nothing;
  const Ranks ranks(controller);
  const auto own = withoutMarkedPoints(particles ? particles : nothing.Get());
  return spacingOf(vtkPolyData::SafeDownCast(own), &ranks);
}

void keepSpacing(double spacing, vtkPolyData* particles)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(spacingName);
  array->InsertNextValue(spacing);
  particles->GetFieldData()->AddArray(array);
}

double keptSpacingOf(vtkPolyData* particles)
{
  vtkDataArray* array = particles->GetFieldData()->GetArray(spacingName);
  return array && array->GetNumberOfTuples() > 0 ? array->GetTuple1(0) : 0.0;
}

} // namespace mote
