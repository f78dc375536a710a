#include "GridCells.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace mote
{

namespace
{

ContentHash hashOf(const DataArrayView& array)
{
  if (array.view.empty())
    return {};
  const auto numbers = array.view.count() * static_cast<std::size_t>(array.view.components());
  const std::uint64_t shape[3] = {static_cast<std::uint64_t>(array.view.type()), array.view.count(),
    static_cast<std::uint64_t>(array.view.components())};
  return combine(mote::hashOf(shape, sizeof shape),
    mote::hashOf(
      array.view.data(), numbers * static_cast<std::size_t>(array.owner->GetDataTypeSize())));
}

} // namespace

GridArrays::GridArrays(vtkUnstructuredGrid* grid)
  : points(grid->GetPoints() ? grid->GetPoints()->GetData() : nullptr)
  , types(grid->GetCellTypesArray())
  , offsets(grid->GetCells() ? grid->GetCells()->GetOffsetsArray() : nullptr)
  , connectivity(grid->GetCells() ? grid->GetCells()->GetConnectivityArray() : nullptr)
  , faces(grid->GetFaces())
  , faceLocations(grid->GetFaceLocations())
{
}

GridCells::GridCells(const GridArrays& arrays)
{
  const auto all = arrays.all();
  std::transform(all.begin(), all.end(), views_.begin(),
    [](vtkDataArray* array) { return DataArrayView(array); });
}

HexMeshInput GridCells::input() const
{
  return {
    views_[0].view, views_[1].view, views_[2].view, views_[3].view, views_[4].view, views_[5].view};
}

ContentHash GridCells::hash() const
{
  ContentHash hash;
  for (const DataArrayView& array : views_)
    hash = combine(hash, hashOf(array));
  return hash;
}

} // namespace mote
