#pragma once

#include <vtkType.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace mote::app
{

/// The points of a cell, and how much the values of each count.
using CellWeights = std::vector<std::pair<vtkIdType, double>>;

/// Those of interpolation at a place; none where the cell does not reach it.
std::optional<CellWeights> weightsAt(
  vtkDataSet* data, vtkIdType cell, const std::array<double, 3>& place);

/// The corner of a cell that is nearest to a place, the first of several; -1 of a cell without.
vtkIdType nearestCorner(vtkDataSet* data, vtkIdType cell, const std::array<double, 3>& place);

/// Those of the mean.
CellWeights evenWeights(vtkDataSet* data, vtkIdType cell);

/// A component's value between the points, or with ArrayChoice::magnitude that of the vector there.
double valueBetween(const CellWeights& weights, vtkDataArray* array, int component);

} // namespace mote::app
