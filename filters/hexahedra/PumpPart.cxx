#include "PumpPart.h"

#include "ForRanges.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace mote::pump
{

namespace
{

/// Density of water, kg/m3.
constexpr double density = 1000.0;

Plane planeOf(PartName name, double scale)
{
  switch (name)
  {
  case PartName::Inlet:
    return inletPlane(inletCounts(scale));
  case PartName::Rotor:
    return rotorPlane(rotorCounts(scale));
  case PartName::Diffuser:
    break;
  }
  return diffuserPlane(diffuserCounts(scale));
}

/// Two directions square to the axis; x and y themselves if that is z.
Mat3d basisOf(const Vec3d& axis)
{
  const Vec3d aside = std::abs(axis.x) > 0.9 ? Vec3d(0.0, 1.0, 0.0) : Vec3d(1.0, 0.0, 0.0);
  const Vec3d x = glm::normalize(aside - glm::dot(aside, axis) * axis);
  return {x, glm::cross(axis, x), axis};
}

void addVector(vtkFieldData* data, const char* name, const Vec3d& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->InsertNextTuple3(value.x, value.y, value.z);
  data->AddArray(array);
}

void setUnit(vtkAbstractArray* array, const char* unit)
{
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
}

} // namespace

Part::Part(PartName name, double scale, const Frame& frame, int precision)
  : name_(name)
  , frame_(frame)
  , basis_(basisOf(frame.axis))
  , mesh_(vtkSmartPointer<vtkUnstructuredGrid>::New())
{
  const Plane plane = planeOf(name, scale);
  rhythm_ = rhythmOf(plane.vertices.front().region);
  this->makePoints(plane, precision);
  this->makeCells(plane);
  addVector(mesh_->GetFieldData(), "AxisOrigin", frame.origin);
  addVector(mesh_->GetFieldData(), "AxisDirection", frame.axis);
}

void Part::makePoints(const Plane& plane, int precision)
{
  const auto sheet = static_cast<vtkIdType>(plane.vertices.size());
  const vtkIdType count = sheet * static_cast<vtkIdType>(plane.layers.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  setUnit(points->GetData(), "m");
  points->SetNumberOfPoints(count);
  flow_.resize(static_cast<std::size_t>(count));
  const auto place = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const PlaneVertex& vertex = plane.vertices[i % sheet];
      const double layer = plane.layers[i / sheet];
      const Point at = placeOf(vertex, layer);
      const Vec3d world = frame_.origin + frame_.radius * (basis_ * Vec3d(at.x, at.y, at.z));
      points->SetPoint(i, world.x, world.y, world.z);
      SteadyFlow flow = steadyFlow(vertex, layer);
      const Vec3d velocity = basis_ * Vec3d(flow.velocity[0], flow.velocity[1], flow.velocity[2]);
      for (int k = 0; k < 3; ++k)
        flow.velocity[k] = static_cast<float>(velocity[k]);
      flow_[i] = flow;
    }
  };
  forRanges(count, place);
  points->Modified();
  points->GetBounds(); // so that nobody's asking changes the time of change
  mesh_->SetPoints(points);
}

void Part::makeCells(const Plane& plane)
{
  const auto sheet = static_cast<vtkIdType>(plane.vertices.size());
  const auto quads = static_cast<vtkIdType>(plane.quads.size());
  const vtkIdType count = quads * static_cast<vtkIdType>(plane.layers.size() - 1);
  vtkNew<vtkIdTypeArray> corners, offsets;
  corners->SetNumberOfValues(8 * count);
  offsets->SetNumberOfValues(count + 1);
  offsets->SetValue(count, 8 * count);
  forRanges(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        offsets->SetValue(i, 8 * i);
        const vtkIdType first = i / quads * sheet;
        const auto& quad = plane.quads[i % quads];
        for (int k = 0; k < 8; ++k)
          corners->SetValue(8 * i + k, first + (k < 4 ? 0 : sheet) + quad[k % 4]);
      }
    });
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  mesh_->SetCells(VTK_HEXAHEDRON, cells);
}

vtkSmartPointer<vtkUnstructuredGrid> Part::at(double seconds) const
{
  const auto count = static_cast<vtkIdType>(flow_.size());
  vtkNew<vtkFloatArray> pressure, velocity;
  pressure->SetName("pressure");
  pressure->SetNumberOfValues(count);
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  velocity->SetNumberOfTuples(count);
  setUnit(pressure, "Pa");
  setUnit(velocity, "m/s");
  const double phase = frame_.angularSpeed * seconds, tip = frame_.angularSpeed * frame_.radius;
  const auto pulsePhase = static_cast<float>(std::remainder(rhythm_.pulses * phase, 2.0 * pi));
  const auto wavePhase = static_cast<float>(std::remainder(rhythm_.waves * phase, 2.0 * pi));
  const Vec3d spin = name_ == PartName::Rotor ? frame_.angularSpeed * frame_.axis : Vec3d(0.0);
  vtkPoints* points = mesh_->GetPoints();
  forRanges(count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const SteadyFlow& flow = flow_[i];
        const float pulse =
          flow.pulse * std::exp(2.0F * (std::cos(flow.pulsePhase - pulsePhase) - 1.0F));
        const float wave = flow.wave * std::cos(flow.wavePhase - wavePhase);
        pressure->SetValue(
          i, static_cast<float>(density * tip * tip) * (flow.pressure + pulse + wave));
        const float gain = static_cast<float>(tip) * (1.0F + rhythm_.pulseGain * pulse - wave);
        Vec3d carried(0.0);
        if (name_ == PartName::Rotor)
        {
          points->GetPoint(i, &carried.x);
          carried = glm::cross(spin, carried - frame_.origin);
        }
        float* v = velocity->GetPointer(3 * i);
        for (int k = 0; k < 3; ++k)
          v[k] = static_cast<float>(carried[k]) + gain * flow.velocity[k];
      }
    });
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->ShallowCopy(mesh_);
  grid->GetPointData()->SetScalars(pressure);
  grid->GetPointData()->SetVectors(velocity);
  return grid;
}

} // namespace mote::pump
