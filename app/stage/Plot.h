#pragma once

#include "Arrays.h"
#include "PickedSet.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace mote::app
{

/// Whose values are plotted.
enum class Plotted
{
  All,
  Visible, ///< particles and cells that are not hidden, and points that shown cells have
  Picked
};

/// What along each axis: an array as --color-by names it, or x, y, z of points. Without a second
/// name it is a histogram.
struct PlotChoice
{
  std::array<std::string, 2> names;
  Plotted of = Plotted::All;
  bool operator==(const PlotChoice&) const = default;
};

/// How many have which values: counts of width * height equal parts of the ranges, row after row
/// from the least of the second value.
struct Plot
{
  int width = 0, height = 0; ///< height is 1 for a histogram; both 0: there are no values
  std::array<double, 2> least{}, most{};
  std::vector<std::uint32_t> counts;
  std::uint32_t highest = 0;
  std::int64_t total = 0;
  std::string what; ///< particles, points, cells, or values where parts differ

  bool isEmpty() const { return counts.empty(); }
};

/// Counts, in parallel. Both values must be of points or both of cells, of the same part; values
/// that are not finite count nowhere. Ranges are those of all values, whoever is plotted.
Plot plotOf(const std::vector<std::unique_ptr<Part>>& parts, const PickedSet& picked,
  const PlotChoice& choice, int width, int height);

/// A range of one value is given room about it, so that it lies in the middle.
void makeRoom(double range[2]);

/// The least and greatest value of an array in what is shown, as `selection`, which is in force,
/// leaves it; false where nothing is.
bool rangeOfShown(const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& choice,
  const SelectionSettings& selection, double range[2]);

/// The names of the numbers that points, or cells, of a data set have, one of each component.
std::vector<std::string> numbersOf(vtkDataSet* data, bool ofCells);

/// The names that a choice may have: x, y, z, and all numbers that the parts have.
std::vector<std::string> plottable(const std::vector<std::unique_ptr<Part>>& parts);

} // namespace mote::app
