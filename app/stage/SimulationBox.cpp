#include "SimulationBox.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>

namespace mote::app
{

std::optional<SimulationBox> simulationBoxOf(vtkDataSet* data)
{
  vtkDataArray* vectors = data->GetFieldData()->GetArray("box");
  vtkDataArray* origin = data->GetFieldData()->GetArray("box_origin");
  if (!vectors || vectors->GetNumberOfValues() != 9)
    return std::nullopt;
  const auto value = [](vtkDataArray* array, int i)
  {
    const int components = array->GetNumberOfComponents();
    return array->GetComponent(i / components, i % components);
  };
  SimulationBox box{};
  for (int i = 0; i < 9; ++i)
    box.vectors[i / 3][i % 3] = value(vectors, i);
  for (int i = 0; origin && origin->GetNumberOfValues() == 3 && i < 3; ++i)
    box.origin[i] = value(origin, i);
  return box;
}

std::array<double, 3> cornerOf(const SimulationBox& box, int number)
{
  std::array<double, 3> corner = {box.origin[0], box.origin[1], box.origin[2]};
  for (int v = 0; v < 3; ++v)
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] += ((number >> v) & 1) * box.vectors[v][axis];
  return corner;
}

SimulationBox replicated(const SimulationBox& box, const std::vector<int>& counts)
{
  SimulationBox all = box;
  for (int v = 0; v < 3 && counts.size() == 3; ++v)
    for (double& along : all.vectors[v])
      along *= counts[static_cast<std::size_t>(v)];
  return all;
}

SimulationBox boxOfBounds(const double bounds[6])
{
  SimulationBox box{};
  for (int i = 0; i < 3; ++i)
  {
    box.origin[i] = bounds[2 * i];
    box.vectors[i][i] = bounds[2 * i + 1] - bounds[2 * i];
  }
  return box;
}

} // namespace mote::app
