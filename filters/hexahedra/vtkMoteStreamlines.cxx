#include "vtkMoteStreamlines.h"

#include "DataSetParts.h"
#include "FlowInCells.h"
#include "FlowSeeds.h"
#include "vtkMoteInterpolatedVelocityField.h"

#include "kernels/core/Error.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamTracer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMoteStreamlines);

/// What is built of points and cells lives from one run to the next.
struct vtkMoteStreamlines::Internals
{
  std::shared_ptr<mote::SharedStructures> structures = std::make_shared<mote::SharedStructures>();
  vtkSmartPointer<vtkPoints> places; ///< of seeds, where they are given
};

namespace
{

/// Which vectors are meant.
struct Vectors
{
  std::string name;
  bool ofCells = false;
};

/// The first array with three components; the active vectors before all others.
std::string vectorsIn(vtkDataSetAttributes* arrays)
{
  if (vtkDataArray* active = arrays->GetVectors(); active && active->GetName())
    return active->GetName();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = arrays->GetArray(i);
        array && array->GetNumberOfComponents() == 3 && array->GetName())
      return array->GetName();
  return {};
}

/// Throws Error where there are none.
Vectors chosenVectors(const std::vector<mote::DataSetPart>& parts, vtkInformation* wanted)
{
  const char* name = wanted ? wanted->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  const auto has = [&](vtkDataSetAttributes* arrays)
  {
    vtkDataArray* array = arrays->GetArray(name);
    if (array && array->GetNumberOfComponents() != 3)
      throw mote::Error(std::string("Streamlines need vectors of three components, and '") + name +
                        "' has " + std::to_string(array->GetNumberOfComponents()) + ".");
    return array != nullptr;
  };
  const bool wantsCells = name && wanted->Get(vtkDataObject::FIELD_ASSOCIATION()) ==
                                    vtkDataObject::FIELD_ASSOCIATION_CELLS;
  for (const bool ofCells : {wantsCells, !wantsCells})
    for (const mote::DataSetPart& part : parts)
    {
      vtkDataSetAttributes* arrays =
        part.data->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
      if (name && has(arrays))
        return {name, ofCells};
      if (const std::string found = name ? std::string() : vectorsIn(arrays); !found.empty())
        return {found, ofCells};
    }
  throw mote::Error(name ? "Streamlines: there is no array '" + std::string(name) + "'."
                         : "Streamlines need an array of vectors, and there is none.");
}

/// The parts with their vectors at points; those without them are left out. Data objects of one's
/// own.
std::vector<vtkSmartPointer<vtkDataSet>> withVectors(
  const std::vector<mote::DataSetPart>& parts, const Vectors& vectors)
{
  std::vector<vtkSmartPointer<vtkDataSet>> all;
  for (const mote::DataSetPart& part : parts)
  {
    if (part.data->GetNumberOfCells() == 0)
      continue;
    vtkSmartPointer<vtkDataSet> data = vtk::TakeSmartPointer(part.data->NewInstance());
    data->ShallowCopy(part.data);
    if (vectors.ofCells && data->GetCellData()->GetArray(vectors.name.c_str()))
    {
      vtkNew<vtkCellDataToPointData> toPoints;
      toPoints->SetInputData(data);
      toPoints->Update();
      const vtkSmartPointer<vtkUnsignedCharArray> ghosts = data->GetCellGhostArray();
      data->ShallowCopy(toPoints->GetOutput());
      data->GetFieldData()->PassData(part.data->GetFieldData());
      if (ghosts)
        data->GetCellData()->AddArray(ghosts);
    }
    if (data->GetPointData()->GetArray(vectors.name.c_str()))
      all.push_back(data);
  }
  return all;
}

vtkSmartPointer<vtkMultiBlockDataSet> ownBlocks(
  const std::vector<vtkSmartPointer<vtkDataSet>>& parts)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned i = 0; i < parts.size(); ++i)
  {
    const auto own = vtk::TakeSmartPointer(parts[i]->NewInstance());
    own->ShallowCopy(parts[i]);
    blocks->SetBlock(i, own);
  }
  return blocks;
}

vtkSmartPointer<vtkPolyData> pointsOf(const mote::Vec3d* seeds, std::size_t count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < count; ++i)
    points->InsertNextPoint(&seeds[i].x);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// Turns the vectors of a point with the data that they are of.
void turnVectors(vtkPointData* arrays, vtkIdType point, const mote::Mat4d& placement)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    const bool isReal =
      array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
    if (!isReal || array->GetNumberOfComponents() != 3)
      continue;
    mote::Vec3d vector;
    array->GetTuple(point, &vector.x);
    vector = mote::turnedVector(placement, vector);
    array->SetTuple(point, &vector.x);
  }
}

constexpr const char* partArray = "MotePart"; ///< of points: which of the parts they are of

/// Has lines tell which parts their points are of.
void numberParts(const std::vector<vtkSmartPointer<vtkDataSet>>& parts)
{
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    vtkNew<vtkFloatArray> number;
    number->SetName(partArray);
    number->SetNumberOfTuples(parts[k]->GetNumberOfPoints());
    number->FillValue(static_cast<float>(k));
    parts[k]->GetPointData()->AddArray(number);
  }
}

/// Turns the vectors of lines whose points tell which parts they are of.
void turnLines(vtkPolyData* lines, const std::vector<mote::SeededMesh>& meshes)
{
  vtkDataArray* parts = lines->GetPointData()->GetArray(partArray);
  const vtkSmartPointer<vtkDataArray> numbers = parts;
  lines->GetPointData()->RemoveArray(partArray);
  for (vtkIdType i = 0; numbers && i < lines->GetNumberOfPoints(); ++i)
    if (const auto k = static_cast<std::size_t>(std::lround(numbers->GetComponent(i, 0)));
        k < meshes.size() && meshes[k].placement != mote::Mat4d(1.0))
      turnVectors(lines->GetPointData(), i, meshes[k].placement);
}

/// Seeds as vertices, with what the points of the cells around them have.
void fillSeeds(const std::vector<mote::Vec3d>& seeds,
  const std::vector<vtkSmartPointer<vtkDataSet>>& parts,
  const std::vector<mote::SeededMesh>& meshes, const Vectors& vectors, vtkPolyData* output)
{
  vtkNew<vtkAppendPolyData> all;
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  std::vector<bool> isTaken(seeds.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    mote::FlowInCells flow(parts[k], meshes[k].structure);
    flow.select(parts[k]->GetPointData()->GetArray(vectors.name.c_str()), false);
    vtkNew<vtkPolyData> own;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkGenericCell> cell;
    own->GetPointData()->InterpolateAllocate(parts[k]->GetPointData());
    std::vector<double> weights(static_cast<std::size_t>(parts[k]->GetMaxCellSize()));
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      if (isTaken[i] || !flow.find(seeds[i]))
        continue;
      isTaken[i] = true;
      double unused[3];
      parts[k]->GetCell(flow.cell(), cell);
      flow.weights(cell, unused, weights.data());
      const vtkIdType point = points->InsertNextPoint(&seeds[i].x);
      vertices->InsertNextCell(1, &point);
      own->GetPointData()->InterpolatePoint(
        parts[k]->GetPointData(), point, cell->GetPointIds(), weights.data());
      if (meshes[k].placement != mote::Mat4d(1.0))
        turnVectors(own->GetPointData(), point, meshes[k].placement);
    }
    own->SetPoints(points);
    own->SetVerts(vertices);
    all->AddInputData(own);
  }
  if (parts.empty())
    return;
  all->Update();
  output->ShallowCopy(all->GetOutput());
  output->GetPointData()->SetActiveVectors(vectors.name.c_str());
}

} // namespace

vtkMoteStreamlines::vtkMoteStreamlines()
  : Impl(std::make_unique<Internals>())
{
  this->SetNumberOfOutputPorts(2);
}

vtkMoteStreamlines::~vtkMoteStreamlines() = default;

int vtkMoteStreamlines::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

namespace
{

std::vector<mote::Vec3d> seedsOf(
  vtkMoteStreamlines* filter, const std::vector<mote::SeededMesh>& meshes)
{
  const auto count = static_cast<std::size_t>(filter->GetNumberOfSeeds());
  if (vtkPoints* places = filter->GetSeedPlaces())
  {
    std::vector<mote::Vec3d> seeds(static_cast<std::size_t>(places->GetNumberOfPoints()));
    for (std::size_t i = 0; i < seeds.size(); ++i)
      places->GetPoint(static_cast<vtkIdType>(i), &seeds[i].x);
    return seeds;
  }
  const double *from = filter->GetPoint1(), *to = filter->GetPoint2();
  return filter->GetSeedsOnLine()
           ? mote::seedsAlong({from[0], from[1], from[2]}, {to[0], to[1], to[2]}, count)
           : mote::seedsWithin(meshes, count);
}

/// The lines through the seeds, in pieces.
std::vector<vtkSmartPointer<vtkPolyData>> tracedFrom(vtkMoteStreamlines* filter,
  vtkMoteInterpolatedVelocityField* field, const std::vector<mote::Vec3d>& seeds,
  const std::vector<vtkSmartPointer<vtkDataSet>>& parts, const std::string& vectors)
{
  // Each task has tracers and data objects of its own, over the same arrays.
  vtkBoundingBox bounds;
  for (const auto& part : parts)
    bounds.AddBounds(part->GetBounds());
  const double length = filter->GetMaximumLength() > 0.0 ? filter->GetMaximumLength()
                                                         : 2.0 * bounds.GetDiagonalLength();
  const std::size_t tasks = std::min<std::size_t>(
    seeds.size(), 8 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()));
  std::vector<vtkSmartPointer<vtkPolyData>> lines(tasks);
  tbb::parallel_for(std::size_t{0}, tasks,
    [&](std::size_t task)
    {
      const std::size_t first = seeds.size() * task / tasks;
      const std::size_t end = seeds.size() * (task + 1) / tasks;
      vtkNew<vtkStreamTracer> tracer;
      tracer->SetInputDataObject(ownBlocks(parts));
      tracer->SetSourceData(pointsOf(seeds.data() + first, end - first));
      tracer->SetInterpolatorPrototype(field);
      tracer->SetInputArrayToProcess(
        0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vectors.c_str());
      tracer->SetIntegratorTypeToRungeKutta45();
      tracer->SetIntegrationDirectionToBoth();
      tracer->SetMaximumPropagation(length);
      tracer->SetMaximumNumberOfSteps(filter->GetMaximumNumberOfSteps());
      tracer->SetComputeVorticity(false);
      tracer->Update();
      lines[task] = tracer->GetOutput();
    });
  return lines;
}

} // namespace

void vtkMoteStreamlines::SetSeedPlaces(vtkPoints* places)
{
  if (this->Impl->places == places)
    return;
  this->Impl->places = places;
  this->Modified();
}

vtkPoints* vtkMoteStreamlines::GetSeedPlaces()
{
  return this->Impl->places;
}

int vtkMoteStreamlines::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  this->ErrorMessage.clear();
  std::vector<vtkSmartPointer<vtkDataSet>> parts;
  std::vector<mote::SeededMesh> meshes;
  Vectors vectors;
  try
  {
    const auto given = mote::partsOf(vtkDataObject::GetData(inputs[0], 0));
    vectors = chosenVectors(given, this->GetInformation()->Has(INPUT_ARRAYS_TO_PROCESS())
                                     ? this->GetInputArrayInformation(0)
                                     : nullptr);
    parts = withVectors(given, vectors);
    mote::HexStructureOptions options;
    options.kind = mote::HexStructureKind::CartesianBvh;
    for (const auto& part : parts)
    {
      meshes.push_back({this->Impl->structures->get(part, options), mote::placementOf(part),
        part->GetCellGhostArray()});
    }
  }
  catch (const mote::Error& error)
  {
    this->ErrorMessage = error.what();
    vtkErrorMacro(<< error.what());
    return 1;
  }
  const std::vector<mote::Vec3d> seeds = seedsOf(this, meshes);
  fillSeeds(seeds, parts, meshes, vectors, vtkPolyData::GetData(outputs, 1));
  if (!this->ComputeLines || seeds.empty() || parts.empty())
    return 1;
  const bool isTurned = std::any_of(meshes.begin(), meshes.end(),
    [](const auto& mesh) { return mesh.placement != mote::Mat4d(1.0); });
  if (isTurned)
    numberParts(parts);

  vtkNew<vtkMoteInterpolatedVelocityField> field;
  field->Shared = this->Impl->structures;
  const auto lines = tracedFrom(this, field, seeds, parts, vectors.name);
  vtkNew<vtkAppendPolyData> all;
  for (const auto& some : lines)
    if (some->GetNumberOfCells() > 0)
      all->AddInputData(some);
  if (all->GetNumberOfInputConnections(0) > 0)
  {
    all->Update();
    output->ShallowCopy(all->GetOutput());
    if (isTurned)
      turnLines(output, meshes);
  }
  return 1;
}

void vtkMoteStreamlines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSeeds: " << this->NumberOfSeeds << "\n";
  os << indent << "SeedsOnLine: " << (this->SeedsOnLine ? "on" : "off") << "\n";
  for (const auto& [name, point] :
    {std::pair("Point1: ", this->Point1), {"Point2: ", this->Point2}})
    os << indent << name << point[0] << " " << point[1] << " " << point[2] << "\n";
  os << indent << "SeedPlaces: " << this->GetSeedPlaces() << "\n";
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "MaximumNumberOfSteps: " << this->MaximumNumberOfSteps << "\n";
  os << indent << "ComputeLines: " << (this->ComputeLines ? "on" : "off") << "\n";
}
