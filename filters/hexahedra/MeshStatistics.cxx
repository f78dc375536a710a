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

void addCell(CellStatistics& to, const CollapsedCell& cell, double volume)
{
  const CellQuality quality = qualityOf(cell, volume);
  to.hexahedra += cell.type == VTK_HEXAHEDRON || cell.type == VTK_VOXEL;
  to.wedges += cell.type == VTK_WEDGE;
  to.pyramids += cell.type == VTK_PYRAMID;
  to.tetrahedra += cell.type == VTK_TETRA;
  to.inverted += quality.inverted;
  to.zeroVolume += quality.zeroVolume;
  to.volume += std::abs(volume);
  to.minVolume = std::min(to.minVolume, std::abs(volume));
  to.maxVolume = std::max(to.maxVolume, std::abs(volume));
  to.minScaledJacobian = std::min(to.minScaledJacobian, quality.scaledJacobian);
  to.sumScaledJacobian += quality.scaledJacobian;
  to.maxAspectRatio = std::max(to.maxAspectRatio, quality.aspectRatio);
}

void addValues(MeasuredArray& to, const CollapsedCell& cell, vtkIdType id,
  const std::array<double, 8>& volumes, double volume)
{
  const double side = volume < 0.0 ? -1.0 : 1.0;
  double values[8], integral = 0.0, least = HUGE_VAL, most = -HUGE_VAL;
  for (int i = 0; i < 8; ++i)
  {
    values[i] = to.ofCells && i > 0 ? values[0] : valueOf(to.array, to.ofCells ? id : cell.ids[i]);
    if (!std::isfinite(values[i]))
    {
      ++to.statistics.nonFinite;
      return;
    }
    integral += side * volumes[i] * values[i];
    least = std::min(least, values[i]);
    most = std::max(most, values[i]);
  }
  to.statistics.integral += integral;
  to.statistics.volume += std::abs(volume);
  to.statistics.min = std::min(to.statistics.min, least);
  to.statistics.max = std::max(to.statistics.max, most);
}

void addRange(MeshStatistics& to, CellReader reader, vtkIdType begin, vtkIdType end)
{
  CollapsedCell cell;
  for (vtkIdType id = begin; id < end; ++id)
  {
    const CellReader::Answer answer = reader.read(id, cell);
    to.cells.cells += answer != CellReader::Answer::Hidden;
    to.cells.other += answer == CellReader::Answer::OtherType;
    to.cells.nonFinite += answer == CellReader::Answer::NonFinite;
    if (answer != CellReader::Answer::Taken)
      continue;
    const auto volumes = cell.cornerVolumes();
    double volume = 0.0;
    for (const double part : volumes)
      volume += part;
    addCell(to.cells, cell, volume);
    for (MeasuredArray& array : to.arrays)
      addValues(array, cell, id, volumes, volume);
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
  for (const auto member :
    {&CellStatistics::cells, &CellStatistics::hexahedra, &CellStatistics::wedges,
      &CellStatistics::pyramids, &CellStatistics::tetrahedra, &CellStatistics::other,
      &CellStatistics::inverted, &CellStatistics::zeroVolume, &CellStatistics::nonFinite})
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
