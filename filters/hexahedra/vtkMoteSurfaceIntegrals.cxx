#include "vtkMoteSurfaceIntegrals.h"

#include "DataSetMismatch.h"
#include "DataSetParts.h"
#include "FieldVector.h"
#include "SectionSums.h"
#include "TableColumns.h"

#include "kernels/core/Error.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkMoteSurfaceIntegrals);

struct vtkMoteSurfaceIntegrals::Internals
{
  std::vector<mote::Section> sections;
  std::vector<std::string> arrays;
};

namespace
{

constexpr double gravity = 9.80665;
const double unknown = std::nan("");

mote::Vec3d vectorOf(const double* numbers)
{
  return {numbers[0], numbers[1], numbers[2]};
}

/// A number with what it may err by, as two columns.
struct Measure
{
  double value = unknown, error = unknown;
};

Measure ratio(const Measure& a, const Measure& b)
{
  if (b.value == 0.0)
    return {};
  const double value = a.value / b.value;
  return {value, (a.error + std::abs(value) * b.error) / std::abs(b.value)};
}

void addMeasure(mote::TableColumns& row, const std::string& name, const Measure& measure)
{
  row.Add(name, measure.value);
  row.Add(name + "_error", measure.error);
}

/// Writes the row of a section of one part; `first` is the total pressure of the part's first
/// section, and takes it there.
void addRow(mote::TableColumns& row, const mote::SectionTask& task, const mote::Section& section,
  const std::vector<std::string>& columns, const mote::SurfaceIntegrals& sums, Measure& first)
{
  std::size_t next = 0;
  const auto take = [&]
  {
    const Measure measure = {sums.values[next], sums.errors[next]};
    ++next;
    return measure;
  };
  const bool flows = !task.velocity.empty(), presses = !task.pressure.empty();
  row.Add("section", section.name);
  row.Add("cells", static_cast<vtkIdType>(sums.cells));
  const Measure area = take();
  addMeasure(row, "area", area);
  Measure flow;
  if (flows)
    addMeasure(row, "flow", flow = take());
  for (const std::string& column : columns)
  {
    const Measure integral = take();
    addMeasure(row, column, ratio(integral, area));
    addMeasure(row, column + "_integral", integral);
    if (flows)
      addMeasure(row, column + "_flow_mean", ratio(take(), flow));
  }
  if (!presses)
    return;
  const Measure torque = take();
  addMeasure(row, "torque", section.slice ? Measure() : torque);
  if (!flows)
    return;
  const Measure total = ratio(take(), flow);
  addMeasure(row, "total_pressure", total);
  if (std::isnan(first.value))
    first = total;
  const double weight = task.density * gravity;
  addMeasure(
    row, "head", {(total.value - first.value) / weight, (total.error + first.error) / weight});
}

/// Whether an array of this name has so many components, of those parts that have it; a sentence
/// about what is wrong, or nothing.
std::string checkArray(const std::vector<mote::DataSetPart>& parts, const std::string& name,
  int components, const char* what)
{
  bool isThere = false;
  for (const mote::DataSetPart& part : parts)
  {
    const auto array = mote::IntegratedArray::of(part.data, name);
    isThere = isThere || array.isThere();
    if (array.isThere() && components > 0 && array.components() != components)
      return std::string("the ") + what + " '" + name + "' has " +
             std::to_string(array.components()) + " components, not " + std::to_string(components);
  }
  return isThere ? "" : "there is no array '" + name + "'";
}

} // namespace

vtkMoteSurfaceIntegrals::vtkMoteSurfaceIntegrals()
  : Impl(std::make_unique<Internals>())
{
}

vtkMoteSurfaceIntegrals::~vtkMoteSurfaceIntegrals() = default;

int vtkMoteSurfaceIntegrals::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkMoteSurfaceIntegrals::AddPlane(
  const std::string& name, const double center[3], const double normal[3])
{
  mote::SliceShape shape;
  shape.point = vectorOf(center);
  shape.axis = vectorOf(normal);
  mote::Vec3d other;
  if (glm::length(shape.axis) > 0.0)
    mote::acrossAxes(shape.axis, shape.out, other);
  this->Impl->sections.push_back({name, shape});
  this->Modified();
}

void vtkMoteSurfaceIntegrals::AddHalfPlane(
  const std::string& name, const double center[3], const double axis[3], const double outwards[3])
{
  mote::SliceShape shape;
  shape.kind = mote::SliceShape::Kind::HalfPlane;
  shape.point = vectorOf(center);
  shape.axis = vectorOf(axis);
  shape.out = vectorOf(outwards);
  this->Impl->sections.push_back({name, shape});
  this->Modified();
}

void vtkMoteSurfaceIntegrals::AddCylinder(
  const std::string& name, const double center[3], const double axis[3], double radius)
{
  this->AddPlane(name, center, axis); // with a direction across
  this->Impl->sections.back().slice->kind = mote::SliceShape::Kind::Cylinder;
  this->Impl->sections.back().slice->radius = radius;
}

void vtkMoteSurfaceIntegrals::AddBoundary(const std::string& name)
{
  this->Impl->sections.push_back({name, {}});
  this->Modified();
}

void vtkMoteSurfaceIntegrals::RemoveAllSections()
{
  this->Impl->sections.clear();
  this->Modified();
}

int vtkMoteSurfaceIntegrals::GetNumberOfSections()
{
  return static_cast<int>(this->Impl->sections.size());
}

void vtkMoteSurfaceIntegrals::AddArray(const std::string& name)
{
  this->Impl->arrays.push_back(name);
  this->Modified();
}

void vtkMoteSurfaceIntegrals::RemoveAllArrays()
{
  this->Impl->arrays.clear();
  this->Modified();
}

std::string vtkMoteSurfaceIntegrals::Integrate(vtkDataObject* input, vtkTable* table)
{
  if (const std::string mismatch = mote::mismatchOf(input); !mismatch.empty())
    return mismatch;
  std::vector<mote::DataSetPart> parts = mote::partsOf(input);
  std::erase_if(parts,
    [](const auto& part)
    {
      auto* surface = vtkPolyData::SafeDownCast(part.data);
      return surface ? surface->GetNumberOfPolys() == 0 : !part.data->IsA("vtkUnstructuredGrid");
    });
  if (parts.empty())
    return "there are neither cells nor polygons to integrate over";
  if (this->Impl->sections.empty())
    return "there is no section to integrate over";
  for (const mote::Section& section : this->Impl->sections)
    if (section.slice)
      mote::SliceSurface::check(*section.slice);
  mote::SectionTask task;
  task.arrays = this->Impl->arrays;
  task.velocity = this->VelocityArrayName;
  task.pressure = this->PressureArrayName;
  task.density = this->Density;
  task.pressureFactor = this->KinematicPressure ? this->Density : 1.0;
  task.tolerance = this->Tolerance;
  std::vector<std::string> columns;
  std::string problem;
  for (const std::string& name : task.arrays)
    problem = problem.empty() ? checkArray(parts, name, 0, "array") : problem;
  if (problem.empty() && !task.velocity.empty())
    problem = checkArray(parts, task.velocity, 3, "velocity");
  if (problem.empty() && !task.pressure.empty())
    problem = checkArray(parts, task.pressure, 1, "pressure");
  if (!problem.empty())
    return problem;
  for (const std::string& name : task.arrays)
    for (const mote::DataSetPart& part : parts)
      if (const auto array = mote::IntegratedArray::of(part.data, name); array.isThere())
      {
        columns.insert(columns.end(), array.columns.begin(), array.columns.end());
        break;
      }

  mote::TableColumns rows;
  std::vector<mote::SurfaceIntegrals> all(this->Impl->sections.size());
  for (const mote::DataSetPart& part : parts)
  {
    task.origin = vectorOf(this->Origin);
    task.axis = vectorOf(this->Axis);
    if (mote::Vec3d origin, axis; this->AxisFromInput &&
                                  mote::readVector(part.data, "AxisOrigin", origin) &&
                                  mote::readVector(part.data, "AxisDirection", axis))
    {
      task.origin = origin;
      task.axis = axis;
    }
    const double length = glm::length(task.axis);
    if (!(length > 0.0) || !std::isfinite(length))
      return "the axis of torques needs a direction of finite length above 0";
    task.axis /= length;
    const mote::SectionSums sums(part.data, task, columns);
    Measure first;
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const mote::SurfaceIntegrals found = sums.of(this->Impl->sections[k]);
      rows.Add("part", part.name);
      addRow(rows, task, this->Impl->sections[k], columns, found, first);
      all[k] = all[k].values.empty() ? found : mote::together(all[k], found);
    }
  }
  Measure first;
  for (std::size_t k = 0; parts.size() > 1 && k < all.size(); ++k)
  {
    rows.Add("part", std::string("all"));
    addRow(rows, task, this->Impl->sections[k], columns, all[k], first);
  }
  rows.FillTable(table);
  return {};
}

int vtkMoteSurfaceIntegrals::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  table->Initialize();
  try
  {
    this->ErrorMessage = this->Integrate(vtkDataObject::GetData(inputVector[0]), table);
  }
  catch (const mote::Error& error)
  {
    this->ErrorMessage = error.what();
    if (this->ErrorMessage.ends_with('.'))
      this->ErrorMessage.pop_back();
  }
  if (!this->ErrorMessage.empty())
    vtkErrorMacro(<< this->ErrorMessage << ".");
  return this->ErrorMessage.empty() ? 1 : 0;
}

void vtkMoteSurfaceIntegrals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSections: " << this->GetNumberOfSections() << "\n";
  for (const std::string& name : this->Impl->arrays)
    os << indent << "Array: " << name << "\n";
  os << indent << "VelocityArrayName: " << this->VelocityArrayName << "\n";
  os << indent << "PressureArrayName: " << this->PressureArrayName << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "KinematicPressure: " << this->KinematicPressure << "\n";
  os << indent << "AxisFromInput: " << this->AxisFromInput << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2] << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
