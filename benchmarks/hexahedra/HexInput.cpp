#include "HexInput.h"

#include "../DataFile.h"

#include <kernels/core/Error.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <filesystem>
#include <string_view>

namespace mote::bench
{

namespace
{

constexpr std::string_view pumpPrefix = "pump:";

std::vector<vtkUnstructuredGrid*> gridsIn(vtkDataObject* object)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(object))
    return {grid};
  std::vector<vtkUnstructuredGrid*> grids;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      if (auto* grid = vtkUnstructuredGrid::SafeDownCast(it->GetCurrentDataObject()))
        grids.push_back(grid);
  }
  return grids;
}

/// The pressure, or else the active scalars, or else the first array; null where there is none.
vtkDataArray* scalarOf(vtkDataSetAttributes* arrays)
{
  for (const char* name : {"pressure", "p"})
    if (vtkDataArray* array = arrays->GetArray(name))
      return array;
  if (vtkDataArray* array = arrays->GetScalars())
    return array;
  for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays->GetArray(k))
      return array;
  return nullptr;
}

/// One component as it is, several as their magnitude.
vtkNew<vtkDoubleArray> valuesOf(vtkDataArray* array)
{
  ArrayViews views;
  const ArrayView view = views.of(array);
  const int component = view.components() == 1 ? 0 : ArrayView::magnitude;
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  values->SetNumberOfValues(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < view.count(); ++i)
    values->SetValue(static_cast<vtkIdType>(i), view.value(i, component));
  return values;
}

vtkDataSetAttributes* attributesOf(vtkUnstructuredGrid* grid, bool ofCells)
{
  if (ofCells)
    return grid->GetCellData();
  return grid->GetPointData();
}

std::shared_ptr<const HexMesh> meshOf(vtkUnstructuredGrid* grid)
{
  ArrayViews views;
  HexMeshInput input;
  input.points = views.of(grid->GetPoints()->GetData());
  input.types = views.of(grid->GetCellTypesArray());
  input.offsets = views.of(grid->GetCells()->GetOffsetsArray());
  input.connectivity = views.of(grid->GetCells()->GetConnectivityArray());
  if (grid->GetFaces() != nullptr && grid->GetFaceLocations() != nullptr)
  {
    input.faces = views.of(grid->GetFaces());
    input.faceLocations = views.of(grid->GetFaceLocations());
  }
  return std::make_shared<HexMesh>(input);
}

std::optional<CylinderAxis> axisOf(vtkFieldData* arrays)
{
  vtkDataArray* origin = arrays->GetArray("AxisOrigin");
  vtkDataArray* direction = arrays->GetArray("AxisDirection");
  for (vtkDataArray* array : {origin, direction})
    if (array == nullptr || array->GetNumberOfComponents() * array->GetNumberOfTuples() != 3)
      return {};
  ArrayViews views;
  const auto vectorOf = [&](vtkDataArray* array)
  {
    const ArrayView v = views.of(array);
    const auto at = [&](std::size_t k)
    { return v.components() == 3 ? v.value(0, static_cast<int>(k)) : v.value(k); };
    return Vec3d(at(0), at(1), at(2));
  };
  return CylinderAxis{vectorOf(origin), vectorOf(direction)};
}

} // namespace

HexScalar HexInput::hexScalar() const
{
  auto* values = vtkDoubleArray::SafeDownCast(attributesOf(grid, ofCells)->GetScalars());
  return {
    ArrayView(values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfTuples()), 1), 0,
    ofCells};
}

HexInput makeHexInput(const std::string& specification)
{
  if (!std::filesystem::exists(specification) && !specification.starts_with(pumpPrefix))
    throw Error(
      "The input \"" + specification + "\" is neither pump:SCALE:PART nor a file that exists.");
  progress("making or reading %s", specification.c_str());
  const vtkSmartPointer<vtkDataObject> data = readLastStep(specification);
  const std::vector<vtkUnstructuredGrid*> grids = gridsIn(data);
  if (grids.size() != 1)
    throw Error(
      format("The input \"%s\" has %zu unstructured grids where one is wanted; of a pump, "
             "name a part: pump:SCALE:rotor.",
        specification.c_str(), grids.size()));
  vtkUnstructuredGrid* from = grids.front();
  HexInput input;
  input.name = specification;
  input.ofCells = scalarOf(from->GetPointData()) == nullptr;
  vtkDataArray* scalar = scalarOf(attributesOf(from, input.ofCells));
  if (from->GetNumberOfCells() == 0 || scalar == nullptr)
    throw Error("The input \"" + specification + "\" has no cells, or no values to show.");
  input.scalar = scalar->GetName() != nullptr ? scalar->GetName() : "";
  input.axis = axisOf(from->GetFieldData());
  input.grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  input.grid->CopyStructure(from);
  attributesOf(input.grid, input.ofCells)->SetScalars(valuesOf(scalar));
  input.mesh = meshOf(input.grid);
  if (input.mesh->cellCount() == 0)
    throw Error("The input \"" + specification + "\" has no cell that can be drawn. " +
                input.mesh->report().sentence());
  input.field = std::make_shared<HexField>(*input.mesh, input.hexScalar());
  progress("%zu cells, %s from %g to %g", input.mesh->cellCount(), input.scalar.c_str(),
    input.field->lower(), input.field->upper());
  return input;
}

std::vector<std::string> partsOf(const std::string& specification)
{
  if (!specification.starts_with(pumpPrefix) || std::filesystem::exists(specification) ||
      specification.find(':', pumpPrefix.size()) != std::string::npos)
    return {specification};
  return {specification + ":diffuser", specification + ":inlet", specification + ":rotor"};
}

std::vector<Named> hexInputs()
{
  return {{"pump:SCALE:PART", "the diffuser, inlet or rotor of a pump that is made, with its "
                              "pressure; SCALE 1 is 6.45 million cells in all"},
    {"pump:SCALE", "all three, for --tables"},
    {"FILE", "a mesh that Mote's readers read; array pressure or p, else the active scalars, "
             "else the first array, of vectors the magnitude"}};
}

} // namespace mote::bench
