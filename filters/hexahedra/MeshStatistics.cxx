#include "MeshStatistics.h"

#include "CollapsedCell.h"
#include "ForRanges.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// A cell, or one of its parts, and the integrals of its corners' weights, all above 0.
struct Measured
{
  explicit Measured(const CollapsedCell& of)
    : cell(of)
    , volumes(of.cornerVolumes())
    , signedVolume(volumeOf(volumes))
  {
    if (signedVolume < 0.0)
      for (double& volume : volumes)
        volume = -volume;
  }

  const CollapsedCell& cell;
  std::array<double, 8> volumes;
  double signedVolume;
};

void addQuality(CellStatistics& to, const Measured& measured)
{
  const CollapsedCell& cell = measured.cell;
  const CellQuality quality = qualityOf(cell, measured.signedVolume);
  to.hexahedra += cell.type == VTK_HEXAHEDRON || cell.type == VTK_VOXEL;
  to.wedges += cell.type == VTK_WEDGE;
  to.pyramids += cell.type == VTK_PYRAMID;
  to.tetrahedra += cell.type == VTK_TETRA;
  to.inverted += quality.inverted;
  to.zeroVolume += quality.zeroVolume;
  to.minScaledJacobian = std::min(to.minScaledJacobian, quality.scaledJacobian);
  to.sumScaledJacobian += quality.scaledJacobian;
  to.maxAspectRatio = std::max(to.maxAspectRatio, quality.aspectRatio);
}

/// Adds the values of a cell; `middle` is that of corners of the number -1.
void addValues(
  MeasuredArray& to, const std::vector<Measured>& parts, vtkIdType id, double middle, double volume)
{
  const double even = to.ofCells ? valueOf(to.array, id) : 0.0;
  ArrayStatistics cell;
  for (const Measured& part : parts)
    for (int i = 0; i < 8; ++i)
    {
      const vtkIdType point = part.cell.ids[i];
      const double value = to.ofCells ? even : point < 0 ? middle : valueOf(to.array, point);
      if (!std::isfinite(value))
      {
        ++to.statistics.nonFinite;
        return;
      }
      cell.integral += part.volumes[i] * value;
      cell.min = std::min(cell.min, value);
      cell.max = std::max(cell.max, value);
    }
  cell.volume = volume;
  to.statistics.add(cell);
}

void addRange(MeshStatistics& to, CellReader reader, vtkIdType begin, vtkIdType end)
{
  CollapsedCell cell;
  std::vector<Measured> parts;
  for (vtkIdType id = begin; id < end; ++id)
  {
    const CellReader::Answer answer = reader.read(id, cell);
    const bool isInParts = answer == CellReader::Answer::InParts;
    to.cells.cells += answer != CellReader::Answer::Hidden;
    to.cells.other += answer == CellReader::Answer::OtherType;
    to.cells.nonFinite += answer == CellReader::Answer::NonFinite;
    to.cells.polyhedra += isInParts;
    if (answer != CellReader::Answer::Taken && !isInParts)
      continue;
    parts.clear();
    if (isInParts)
      for (const CollapsedCell& part : reader.parts())
        parts.emplace_back(part);
    else
      addQuality(to.cells, parts.emplace_back(cell));
    double volume = 0.0;
    for (const Measured& part : parts)
      volume += std::abs(part.signedVolume);
    to.cells.volume += volume;
    to.cells.minVolume = std::min(to.cells.minVolume, volume);
    to.cells.maxVolume = std::max(to.cells.maxVolume, volume);
    for (MeasuredArray& array : to.arrays)
    {
      double middle = 0.0;
      if (isInParts && !array.ofCells)
        for (const std::int64_t point : reader.points())
          middle += valueOf(array.array, point) / static_cast<double>(reader.points().size());
      addValues(array, parts, id, middle, volume);
    }
  }
}

void addArrays(std::vector<MeasuredArray>& to, vtkDataSetAttributes* from, bool ofCells)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i); // null for words
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (!name.empty() && name != "vtkGhostType")
      to.push_back({array, ofCells, {}});
  }
}

} // namespace

double valueOf(vtkDataArray* array, vtkIdType tuple, int component)
{
  const int components = array->GetNumberOfComponents();
  if (component >= 0 || components == 1)
    return array->GetComponent(tuple, std::clamp(component, 0, components - 1));
  double square = 0.0;
  for (int k = 0; k < components; ++k)
    square += array->GetComponent(tuple, k) * array->GetComponent(tuple, k);
  return std::sqrt(square);
}

void CellStatistics::add(const CellStatistics& more)
{
  for (const auto member : {&CellStatistics::cells, &CellStatistics::hexahedra,
         &CellStatistics::wedges, &CellStatistics::pyramids, &CellStatistics::tetrahedra,
         &CellStatistics::polyhedra, &CellStatistics::other, &CellStatistics::inverted,
         &CellStatistics::zeroVolume, &CellStatistics::nonFinite})
    this->*member += more.*member;
  volume += more.volume;
  sumScaledJacobian += more.sumScaledJacobian;
  minVolume = std::min(minVolume, more.minVolume);
  minScaledJacobian = std::min(minScaledJacobian, more.minScaledJacobian);
  maxVolume = std::max(maxVolume, more.maxVolume);
  maxAspectRatio = std::max(maxAspectRatio, more.maxAspectRatio);
}

void ArrayStatistics::add(const ArrayStatistics& more)
{
  min = std::min(min, more.min);
  max = std::max(max, more.max);
  integral += more.integral;
  volume += more.volume;
  nonFinite += more.nonFinite;
}

MeshStatistics statisticsOf(vtkDataSet* data)
{
  MeshStatistics all;
  addArrays(all.arrays, data->GetPointData(), false);
  addArrays(all.arrays, data->GetCellData(), true);
  const vtkIdType count = data->GetNumberOfCells();
  // Blocks of one size, added in their order, so that threads do not change the sums.
  constexpr vtkIdType block = 8192;
  const vtkIdType blocks = (count + block - 1) / block;
  std::vector<MeshStatistics> partial(static_cast<std::size_t>(blocks), all);
  const CellReader reader(data);
  forEach(blocks, [&](vtkIdType b)
    { addRange(partial[b], reader, b * block, std::min(count, (b + 1) * block)); });
  for (const MeshStatistics& part : partial)
  {
    all.cells.add(part.cells);
    for (std::size_t i = 0; i < all.arrays.size(); ++i)
      all.arrays[i].statistics.add(part.arrays[i].statistics);
  }
  return all;
}

} // namespace mote
