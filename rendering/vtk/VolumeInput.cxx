#include "VolumeInput.h"

#include "kernels/core/Error.h"

#include "vtkCellArray.h"
#include "vtkUnstructuredGrid.h"

namespace mote
{

namespace
{

InputKey keyOf(const HexStructureOptions& options)
{
  InputKey key = {double(options.kind)};
  if (options.axis)
    for (const Vec3d& v : {options.axis->origin, options.axis->direction})
      key.insert(key.end(), {v.x, v.y, v.z});
  return key;
}

} // namespace

bool VolumeGeometry::hasCellsOf(vtkUnstructuredGrid* grid)
{
  if (!grid->GetCells() || grid->GetNumberOfCells() == 0)
    return false;
  const GridArrays arrays(grid);
  InputKey key;
  for (vtkDataArray* array : arrays.all())
    addArray(key, array);
  if (key != seenKey_)
  {
    seen_ = GridCells(arrays).hash();
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
  auto mesh = std::make_shared<const HexMesh>(GridCells(GridArrays(grid)).input());
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
