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
#include <cctype>
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

/// Whether there is so little flow through a section that means weighted with it would be noise:
/// along walls, and where as much goes in as out.
bool isWithoutFlow(const Measure& flow, const mote::SurfaceIntegrals& sums)
{
  const double eitherWay = sums.values[sums.values.size() - 2], speed = sums.values.back();
  return std::abs(flow.value) <= std::max({1e-3 * eitherWay, 1e-6 * speed, flow.error});
}

/// Writes the row of a section. `first` is the total pressure that heads refer to, and takes it
/// where it is not known. Returns whether there is no flow to weight with.
bool addRow(mote::TableColumns& row, const mote::SectionTask& task, const mote::Section& section,
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
  const bool isWithout = flows && isWithoutFlow(flow, sums);
  const auto weighted = [&]
  {
    const Measure sum = take();
    return isWithout ? Measure() : ratio(sum, flow);
  };
  for (const std::string& column : columns)
  {
    const Measure integral = take();
    addMeasure(row, column, ratio(integral, area));
    addMeasure(row, column + "_integral", integral);
    if (flows)
      addMeasure(row, column + "_flow_mean", weighted());
  }
  if (!presses)
    return isWithout;
  const Measure torque = take();
  addMeasure(row, "torque", section.slice ? Measure() : torque);
  if (!flows)
    return isWithout;
  const Measure total = weighted();
  addMeasure(row, "total_pressure", total);
  if (std::isnan(first.value))
    first = total;
  const double weight = task.density * gravity;
  addMeasure(
    row, "head", {(total.value - first.value) / weight, (total.error + first.error) / weight});
  return isWithout;
}

/// The sums of one part, of all sections.
struct PartSums
{
  std::string name;
  bool isPatch = false; ///< polygons, the boundary of a mesh or a piece of it
  std::vector<mote::SurfaceIntegrals> sections;
};

Measure totalPressureOf(const mote::SurfaceIntegrals& sums)
{
  const std::size_t count = sums.values.size(); // and see SectionSums
  const Measure flow = {sums.values[1], sums.errors[1]};
  return isWithoutFlow(flow, sums) ? Measure()
                                   : ratio({sums.values[count - 3], sums.errors[count - 3]}, flow);
}

/// What heads of patches refer to: the total pressure of a patch whose name says that it is an
/// inlet, else of the first with a flow.
Measure referenceOfPatches(const std::vector<PartSums>& all)
{
  Measure first;
  for (const bool byName : {true, false})
    for (const PartSums& part : all)
    {
      std::string name = part.name;
      std::transform(
        name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
      if (!part.isPatch || (byName && name.find("inlet") == std::string::npos))
        continue;
      for (const mote::SurfaceIntegrals& sums : part.sections)
        if (std::isnan(first.value))
          first = totalPressureOf(sums);
    }
  return first;
}

/// Those of all parts together: of meshes, where there are any, as patches bound them.
PartSums sumOf(const std::vector<PartSums>& all)
{
  const bool hasMeshes =
    std::any_of(all.begin(), all.end(), [](const PartSums& part) { return !part.isPatch; });
  PartSums sum;
  sum.name = "all";
  for (const PartSums& part : all)
    for (std::size_t k = 0; k < part.sections.size() && !(part.isPatch && hasMeshes); ++k)
      if (sum.sections.size() <= k)
        sum.sections.push_back(part.sections[k]);
      else
        sum.sections[k] = mote::together(sum.sections[k], part.sections[k]);
  return sum;
}

/// Fills the table. Returns a sentence about sections without flow, or nothing.
std::string writeTable(const mote::SectionTask& task, const std::vector<mote::Section>& sections,
  const std::vector<std::string>& columns, const std::vector<PartSums>& all, vtkTable* table)
{
  const bool hasTotals = !task.velocity.empty() && !task.pressure.empty();
  const Measure ofPatches = hasTotals ? referenceOfPatches(all) : Measure();
  mote::TableColumns rows;
  std::vector<std::string> without;
  const auto write = [&](const PartSums& part)
  {
    Measure first = part.isPatch ? ofPatches : Measure();
    for (std::size_t k = 0; k < sections.size(); ++k)
    {
      rows.Add("part", part.name);
      const bool isMet = part.sections[k].cells > 0;
      if (addRow(rows, task, sections[k], columns, part.sections[k], first) && isMet)
        without.push_back(part.name + " " + sections[k].name);
    }
  };
  for (const PartSums& part : all)
    write(part);
  if (all.size() > 1)
    write(sumOf(all));
  rows.FillTable(table);
  if (without.empty())
    return {};
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, without.size()); ++i)
    text += (i > 0 ? ", " : "") + without[i];
  return "no flow goes through, or as much in as out, so that means weighted with it are nan: " +
         text +
         (without.size() > most ? " and " + std::to_string(without.size() - most) + " more" : "");
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

  std::vector<PartSums> all;
  for (const mote::DataSetPart& part : parts)
  {
    if (!this->FindAxis(part.data, &task.origin.x, &task.axis.x))
      return "the axis of torques needs a direction of finite length above 0";
    const mote::SectionSums sums(part.data, task, columns);
    PartSums& own = all.emplace_back();
    own.name = part.name;
    own.isPatch = part.data->IsA("vtkPolyData");
    for (const mote::Section& section : this->Impl->sections)
      own.sections.push_back(sums.of(section));
  }
  this->Report = writeTable(task, this->Impl->sections, columns, all, table);
  return {};
}

/// The axis of torques of a part, of unit length; false where it has no direction.
bool vtkMoteSurfaceIntegrals::FindAxis(vtkDataSet* data, double origin[3], double axis[3])
{
  mote::Vec3d from = vectorOf(this->Origin), way = vectorOf(this->Axis);
  if (mote::Vec3d own, direction; this->AxisFromInput &&
                                  mote::readVector(data, "AxisOrigin", own) &&
                                  mote::readVector(data, "AxisDirection", direction))
  {
    from = own;
    way = direction;
  }
  const double length = glm::length(way);
  if (!(length > 0.0) || !std::isfinite(length))
    return false;
  for (int k = 0; k < 3; ++k)
    origin[k] = from[k], axis[k] = way[k] / length;
  return true;
}

int vtkMoteSurfaceIntegrals::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  table->Initialize();
  this->Report.clear();
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
