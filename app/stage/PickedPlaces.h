#pragma once

#include "PickedSet.h"

#include <array>
#include <vector>

class vtkDataSet;

namespace mote::app
{

/// Where a mark of what is picked stands.
struct PickedPlace
{
  std::size_t part = 0;
  vtkIdType id = 0;
  bool isCell = false;                       ///< which has edges, and no place
  vtkSmartPointer<vtkTransform> placed = {}; ///< of a cell: from its data to where it is seen
  std::array<double, 3> at{};
  double radius = 0.0; ///< as drawn; 0 for cells
};

/// The edges of a cell where it is seen, as pairs of ends.
using CellEdge = std::array<std::array<double, 3>, 2>;
std::vector<CellEdge> edgesOf(vtkDataSet* data, vtkIdType cell, vtkTransform* placed);

/// Of what is picked in these parts and shown now, images too. Of more than ten thousand evenly
/// taken ones: a hundred thousand marks would take a second a frame.
std::vector<PickedPlace> placesOf(
  const PickedSet::Parts& parts, const PickedSet& picked, const std::vector<std::size_t>& shown);

} // namespace mote::app
