#include "VolumeInput.h"

#include "kernels/core/Error.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

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

InputKey keyOf(vtkUnstructuredGrid* grid)
{
  InputKey key;
  addArray(key, grid->GetPoints() ? grid->GetPoints()->GetData() : nullptr);
  addArray(key, grid->GetCellTypesArray());
  addArray(key, grid->GetCells()->GetOffsetsArray());
  addArray(key, grid->GetCells()->GetConnectivityArray());
  return key;
}

InputKey keyOf(const HexStructureOptions& options)
{
  InputKey key = {double(options.kind)};
  if (options.axis)
    for (const Vec3d& v : {options.axis->origin, options.axis->direction})
      key.insert(key.end(), {v.x, v.y, v.z});
  return key;
}

} // namespace

GridCells::GridCells(vtkUnstructuredGrid* grid)
  : points(grid->GetPoints() ? grid->GetPoints()->GetData() : nullptr)
  , types(grid->GetCellTypesArray())
  , offsets(grid->GetCells()->GetOffsetsArray())
  , connectivity(grid->GetCells()->GetConnectivityArray())
{
}

HexMeshInput GridCells::input() const
{
  return {points.view, types.view, offsets.view, connectivity.view};
}

ContentHash GridCells::hash() const
{
  ContentHash hash;
  for (const DataArrayView* array : {&points, &types, &offsets, &connectivity})
    hash = combine(hash, hashOf(*array));
  return hash;
}

bool VolumeGeometry::hasCellsOf(vtkUnstructuredGrid* grid)
{
  if (!grid->GetCells() || grid->GetNumberOfCells() == 0)
    return false;
  InputKey key = keyOf(grid);
  if (key != seenKey_)
  {
    seen_ = GridCells(grid).hash();
    seenKey_ = std::move(key);
  }
  return mesh_ && seen_ == content_;
}

bool VolumeGeometry::fits(vtkUnstructuredGrid* grid, const HexStructureOptions& options)
{
  return hasCellsOf(grid) && structure_ && keyOf(options) == structureKey_;
}

bool VolumeGeometry::takeCells(vtkUnstructuredGrid* grid)
{
  if (hasCellsOf(grid))
    return false;
  mesh_ = nullptr;
  structure_ = nullptr;
  adjacency_ = nullptr;
  if (!grid->GetCells() || grid->GetNumberOfCells() == 0)
    throw Error("The input has no cells.");
  auto mesh = std::make_shared<const HexMesh>(GridCells(grid).input());
  if (mesh->cellCount() == 0)
    throw Error("No cell of the input can be drawn. " + mesh->report().sentence());
  mesh_ = std::move(mesh);
  content_ = seen_;
  return true;
}

void VolumeGeometry::build(const HexStructureOptions& options)
{
  structure_ = nullptr; // before the next one takes memory
  structure_ = makeHexStructure(mesh_, options);
  structureKey_ = keyOf(options);
}

void VolumeGeometry::setRanges(const HexField& field)
{
  if (structure_.use_count() > 1)
    structure_ = std::make_shared<HexStructure>(*structure_);
  mote::setRanges(*structure_, field);
}

std::shared_ptr<const WalkCells> VolumeGeometry::makeWalk(const HexField& field)
{
  if (!adjacency_)
    adjacency_ = std::make_shared<FaceAdjacency>(*mesh_);
  return std::make_shared<WalkCells>(mesh_, adjacency_, field);
}

} // namespace mote
