#pragma once

#include <array>
#include <optional>
#include <vector>

class vtkDataSet;

namespace mote::app
{

/// A parallelepiped: the cell that a simulation ran in.
struct SimulationBox
{
  double origin[3];
  double vectors[3][3];
};

/// What readers leave in the field data as "box" (nine values: three vectors) and "box_origin".
std::optional<SimulationBox> simulationBoxOf(vtkDataSet* data);

/// One of its eight corners: bit i of the number says whether vector i is added to the origin.
std::array<double, 3> cornerOf(const SimulationBox& box, int number);

/// The box of so many images along each vector; of one where there are no three counts.
SimulationBox replicated(const SimulationBox& box, const std::vector<int>& counts);

/// A box along the axes.
SimulationBox boxOfBounds(const double bounds[6]);

} // namespace mote::app
