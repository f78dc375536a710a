#include "BoxFiles.h"

#include "Part.h"
#include "SimulationBox.h"

#include <vtkAlgorithm.h>
#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkMoteReaderTable.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;

const std::string ofBoxes = "_boundingBox";

bool isAnyOf(const std::string& text, std::initializer_list<const char*> words)
{
  return std::find(words.begin(), words.end(), text) != words.end();
}

/// Without its ending.
std::string pathStem(const std::string& file)
{
  return fs::path(file).replace_extension().string();
}

std::optional<std::string> boxFileBeside(const std::string& file)
{
  if (!isAnyOf(fs::path(file).extension().string(), {".vtk", ".vtp", ".vtu"}))
    return {};
  for (const char* ending : {".vtk", ".vtr", ".vtu"})
  {
    std::error_code error;
    if (const std::string box = pathStem(file) + ofBoxes + ending; fs::is_regular_file(box, error))
      return box;
  }
  return {};
}

/// A box that is the only cell.
std::optional<SimulationBox> boxOfCell(vtkDataSet* data)
{
  if (data->GetNumberOfCells() != 1)
    return {};
  const int type = data->GetCellType(0);
  if (type != VTK_HEXAHEDRON && type != VTK_VOXEL)
    return {};
  vtkPoints* const corners = data->GetCell(0)->GetPoints();
  const std::array<vtkIdType, 3> ends =
    type == VTK_VOXEL ? std::array<vtkIdType, 3>{1, 2, 4} : std::array<vtkIdType, 3>{1, 3, 4};
  SimulationBox box{};
  corners->GetPoint(0, box.origin);
  for (std::size_t v = 0; v < 3; ++v)
  {
    corners->GetPoint(ends[v], box.vectors[v]);
    for (int axis = 0; axis < 3; ++axis)
      box.vectors[v][axis] -= box.origin[axis];
  }
  return box;
}

std::optional<SimulationBox> boxIn(const std::string& file)
{
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(file, error);
  const auto data = reader ? vtkMoteReaderTable::Read(reader, error) : nullptr;
  auto* set = vtkDataSet::SafeDownCast(data);
  return set ? boxOfCell(set) : std::nullopt;
}

void addNumbers(vtkDataSet* to, const char* name, const double* numbers, int count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count / 3);
  std::copy_n(numbers, count, array->GetPointer(0));
  to->GetFieldData()->AddArray(array);
}

} // namespace

std::vector<std::string> withoutBoxFiles(const std::vector<std::string>& files)
{
  std::set<std::string> stems;
  for (const std::string& file : files)
    stems.insert(pathStem(file));
  std::vector<std::string> others;
  for (const std::string& file : files)
  {
    std::string stem = pathStem(file);
    const bool isOfBox = stem.ends_with(ofBoxes);
    stem.resize(stem.size() - (isOfBox ? ofBoxes.size() : 0));
    if (!isOfBox || stems.count(stem) == 0)
      others.push_back(file);
  }
  return others;
}

void addBoxOfFile(vtkDataSet* particles, const std::string& file)
{
  if (Part::isMesh(particles) || simulationBoxOf(particles))
    return;
  const auto beside = boxFileBeside(file);
  const auto box = beside ? boxIn(*beside) : std::nullopt;
  if (!box)
    return;
  addNumbers(particles, "box", &box->vectors[0][0], 9);
  addNumbers(particles, "box_origin", box->origin, 3);
}

} // namespace mote::app
