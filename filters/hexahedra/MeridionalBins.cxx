#include "MeridionalBins.h"

#include "ForRanges.h"
#include "MeridionalCell.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

/// Whether corners tell that a cell has nothing within the limits.
bool isOutside(const CollapsedCell& cell, const Axis& axis, const Limits& limits)
{
  const auto all = [&cell](const auto& holds)
  { return std::all_of(cell.corners.begin(), cell.corners.end(), holds); };
  return all([&](const Vec3d& p) { return axis.along(p) < limits.axial[0]; }) ||
         all([&](const Vec3d& p) { return axis.along(p) > limits.axial[1]; }) ||
         all([&](const Vec3d& p) { return axis.from(p) < limits.radial[0]; });
}

/// The mean of a polyhedron's point values.
Vec3d middleOf(vtkDataArray* array, const std::vector<std::int64_t>& points)
{
  Vec3d sum(0.0);
  for (const std::int64_t point : points)
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      sum[k] += array->GetComponent(point, k);
  return sum / static_cast<double>(points.size());
}

/// Reads a cell's values; false where one is not finite. Corners of the number -1 have `middle`.
bool readValues(
  Sampled& into, vtkDataArray* array, bool ofCells, vtkIdType cell, const Vec3d& middle)
{
  const int components = array->GetNumberOfComponents();
  bool finite = true;
  for (int c = 0; c < 8; ++c)
    for (int k = 0; k < components; ++k)
    {
      const vtkIdType point = ofCells ? cell : into.cell.ids[c];
      into.values[c][k] = point < 0 ? middle[k] : array->GetComponent(point, k);
      finite = finite && std::isfinite(into.values[c][k]);
    }
  return finite;
}

} // namespace

std::size_t BinGrid::at(double along, double from) const
{
  if (along < limits.axial[0] || along > limits.axial[1] || from < limits.radial[0] ||
      from > limits.radial[1])
    return this->count();
  const int i = std::clamp(static_cast<int>((along - first) / size), 0, axial - 1);
  const int j = std::clamp(static_cast<int>((from - inner) / size), 0, radial - 1);
  return static_cast<std::size_t>(j) * axial + i;
}

BinGrid binsFor(
  const std::vector<vtkDataSet*>& data, const Axis& axis, const Limits& limits, int resolution)
{
  double low = std::numeric_limits<double>::infinity(), high = -low, radius = 0.0;
  for (vtkDataSet* one : data)
    for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
    {
      Vec3d p;
      one->GetPoint(i, &p.x);
      const double along = axis.along(p), from = axis.from(p);
      if (!std::isfinite(along) || !std::isfinite(from))
        continue;
      low = std::min(low, along);
      high = std::max(high, along);
      radius = std::max(radius, from);
    }
  BinGrid grid;
  const double longer = std::max(high - low, radius);
  if (!(longer > 0.0))
    return grid;
  grid.size = longer / resolution;
  grid.limits = limits;
  grid.first = std::max(low, limits.axial[0]);
  grid.inner = std::max(0.0, limits.radial[0]);
  const double last = std::min(high, limits.axial[1]), outer = std::min(radius, limits.radial[1]);
  if (grid.first > last || grid.inner > outer)
    return grid;
  const auto count = [&](double length)
  { return std::max(1, static_cast<int>(std::ceil(length / grid.size - 1e-9))); };
  grid.axial = count(last - grid.first);
  grid.radial = count(outer - grid.inner);
  return grid;
}

vtkIdType addToBins(std::vector<Bin>& bins, const BinGrid& grid, const Axis& axis, vtkDataSet* data,
  vtkDataArray* array, bool ofCells, double middle)
{
  // A few runs of cells with bins of their own, added in their order: threads do not change sums.
  constexpr vtkIdType runs = 16;
  const vtkIdType count = data->GetNumberOfCells();
  const bool isVector = array->GetNumberOfComponents() == 3;
  std::vector<std::vector<Bin>> partial(runs);
  std::vector<vtkIdType> leftOut(runs, 0);
  const CellReader first(data);
  forEach(runs,
    [&](vtkIdType run)
    {
      partial[run].resize(grid.count());
      CellReader reader(first);
      Sampled sampled{};
      sampled.middle = middle;
      std::vector<CollapsedCell> parts;
      for (vtkIdType id = count * run / runs; id < count * (run + 1) / runs; ++id)
      {
        const CellReader::Answer answer = reader.read(id, sampled.cell);
        const bool isInParts = answer == CellReader::Answer::InParts;
        if (answer != CellReader::Answer::Taken && !isInParts)
          continue;
        parts.assign(1, sampled.cell);
        if (isInParts)
          parts = reader.parts();
        const Vec3d mean = isInParts && !ofCells ? middleOf(array, reader.points()) : Vec3d(0.0);
        for (const CollapsedCell& part : parts)
        {
          sampled.cell = part;
          if (isOutside(part, axis, grid.limits))
            continue;
          if (!readValues(sampled, array, ofCells, id, mean))
          {
            ++leftOut[run];
            break;
          }
          sampled.side = volumeOf(part.cornerVolumes()) < 0.0 ? -1.0 : 1.0;
          addCell(partial[run], grid, axis, sampled, isVector);
        }
      }
    });
  vtkIdType sum = 0;
  for (vtkIdType run = 0; run < runs; ++run)
  {
    sum += leftOut[run];
    for (std::size_t i = 0; i < bins.size(); ++i)
    {
      bins[i].volume += partial[run][i].volume;
      for (int k = 0; k < 4; ++k)
        bins[i].sums[k] += partial[run][i].sums[k];
    }
  }
  return sum;
}

} // namespace mote
