#include "CellValues.h"

#include "Arrays.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

std::optional<CellWeights> weightsAt(
  vtkDataSet* data, vtkIdType cell, const std::array<double, 3>& place)
{
  constexpr double near = 1e-3; // of the cell's size: places of hits are rounded
  vtkNew<vtkGenericCell> shape;
  data->GetCell(cell, shape);
  const int count = static_cast<int>(shape->GetNumberOfPoints());
  std::vector<double> weights(static_cast<std::size_t>(count), 0.0);
  double closest[3], coordinates[3], distance2 = 0.0;
  int part = 0;
  if (shape->EvaluatePosition(place.data(), closest, part, coordinates, distance2, weights.data()) <
        0 ||
      !(distance2 <= near * near * shape->GetLength2()))
    return {};
  CellWeights found;
  for (int i = 0; i < count; ++i)
  {
    const double weight = weights[static_cast<std::size_t>(i)];
    if (!std::isfinite(weight))
      return {};
    found.emplace_back(shape->GetPointId(i), weight);
  }
  return found;
}

vtkIdType nearestCorner(vtkDataSet* data, vtkIdType cell, const std::array<double, 3>& place)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  vtkIdType nearest = -1;
  double least = HUGE_VAL;
  for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
  {
    double at[3];
    data->GetPoint(corners->GetId(i), at);
    const double distance = vtkMath::Distance2BetweenPoints(at, place.data());
    if (distance < least)
      least = distance, nearest = corners->GetId(i);
  }
  return nearest;
}

CellWeights evenWeights(vtkDataSet* data, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  CellWeights found;
  for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    found.emplace_back(corners->GetId(i), 1.0 / static_cast<double>(corners->GetNumberOfIds()));
  return found;
}

double valueBetween(const CellWeights& weights, vtkDataArray* array, int component)
{
  const auto between = [&](int one)
  {
    double sum = 0.0;
    for (const auto& [point, weight] : weights)
      sum += weight * array->GetComponent(point, one);
    return sum;
  };
  const int components = array->GetNumberOfComponents();
  if (component != ArrayChoice::magnitude || components == 1)
    return between(std::max(component, 0));
  double square = 0.0;
  for (int one = 0; one < components; ++one)
    square += between(one) * between(one);
  return std::sqrt(square);
}

} // namespace mote::app
