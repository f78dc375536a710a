#include "VolumeInput.h"

#include "GridParts.h"

#include "kernels/core/Error.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
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
  this->lookForWelds(grid);
  return mesh_ && seen_ == content_ && areWelded_ == isWelded_;
}

void VolumeGeometry::lookForWelds(vtkUnstructuredGrid* grid)
{
  if (!(weldsContent_ == seen_))
  {
    welds_ = nullptr;
    if (hasManyPoints(grid))
    {
      PointSets parts(grid->GetNumberOfPoints());
      parts.joinCells(grid);
      if (auto welds = weldsOf(grid, parts); !welds.empty())
        welds_ = std::make_shared<const std::vector<vtkIdType>>(std::move(welds));
    }
    weldsContent_ = seen_;
    valuesKey_.clear();
    areWelded_ = false;
  }
  if (!welds_)
    return;
  InputKey key = {0.0}; // not empty
  vtkPointData* values = grid->GetPointData();
  for (int i = 0; i < values->GetNumberOfArrays(); ++i)
    addArray(key, values->GetArray(i));
  if (key == valuesKey_)
    return;
  valuesKey_ = std::move(key);
  areWelded_ = true;
  for (int i = 0; i < values->GetNumberOfArrays() && areWelded_; ++i)
    if (vtkDataArray* array = values->GetArray(i))
      areWelded_ = haveOneValue(array, *welds_);
}

bool VolumeGeometry::hasStructure(const HexStructureOptions& options) const
{
  return structure_ && keyOf(options) == structureKey_;
}

void VolumeGeometry::forgetStructure()
{
  structure_ = nullptr;
  built_ = nullptr;
}

bool VolumeGeometry::takeCells(vtkUnstructuredGrid* grid)
{
  if (hasCellsOf(grid))
    return false;
  mesh_ = nullptr;
  structure_ = nullptr;
  adjacency_ = nullptr;
  hangingPoints_ = nullptr;
  if (!grid->GetCells() || grid->GetNumberOfCells() == 0)
    throw Error("The input has no cells.");
  GridArrays arrays(grid);
  vtkSmartPointer<vtkCellArray> welded;
  if (areWelded_)
  {
    welded = weldedCells(grid, *welds_);
    arrays.connectivity = welded->GetConnectivityArray();
  }
  auto mesh = std::make_shared<const HexMesh>(GridCells(arrays).input());
  if (mesh->cellCount() == 0)
    throw Error("No cell of the input can be drawn. " + mesh->report().sentence());
  mesh_ = std::move(mesh);
  content_ = seen_;
  isWelded_ = areWelded_;
  return true;
}

void VolumeGeometry::build(const HexStructureOptions& options)
{
  structure_ = nullptr; // before the next one takes memory
  structure_ = makeHexStructure(mesh_, options);
  built_ = std::make_shared<const char>();
  structureKey_ = keyOf(options);
}

void VolumeGeometry::setRanges(const HexField& field)
{
  if (!structure_)
    return;
  if (structure_.use_count() > 1)
    structure_ = std::make_shared<HexStructure>(*structure_);
  mote::setRanges(*structure_, field);
}

void VolumeGeometry::findNeighbours()
{
  if (adjacency_)
    return;
  adjacency_ = std::make_shared<FaceAdjacency>(*mesh_);
  views_ = std::make_shared<WalkViews>();
}

const std::vector<HangingPoint>& VolumeGeometry::hangingPoints()
{
  if (!hangingPoints_)
    hangingPoints_ = std::make_shared<const std::vector<HangingPoint>>(hangingPointsOf(*mesh_));
  return *hangingPoints_;
}

std::shared_ptr<const WalkCells> VolumeGeometry::makeWalk(const HexField& field)
{
  this->findNeighbours();
  return std::make_shared<WalkCells>(mesh_, adjacency_, field, views_);
}

void VolumeGeometry::addMemory(std::vector<std::pair<const void*, std::size_t>>& pieces) const
{
  if (mesh_)
    pieces.emplace_back(mesh_.get(), mesh_->bytes());
  if (adjacency_)
  {
    pieces.emplace_back(adjacency_.get(), adjacency_->bytes());
    pieces.emplace_back(views_.get(), views_->bytes());
  }
  if (structure_)
    withStructure(*structure_,
      [&](const auto& s)
      {
        pieces.emplace_back(built_.get(), s.bytes() - s.ownBytes());
        pieces.emplace_back(structure_.get(), s.ownBytes());
      });
}

std::shared_ptr<const HiddenCells> HiddenOfMesh::of(
  const std::shared_ptr<const HexMesh>& mesh, VisibleCells& visible)
{
  const InputKey& key = visible.key(static_cast<vtkIdType>(mesh->report().cells));
  if (mesh_ == mesh && key_ == key)
    return hidden_;
  hidden_ = key.empty() ? nullptr
                        : std::make_shared<const HiddenCells>(*mesh, visible.get()->GetPointer(0));
  mesh_ = mesh;
  key_ = key;
  return hidden_;
}

std::vector<std::pair<const void*, std::size_t>> BuiltVolume::memory() const
{
  std::vector<std::pair<const void*, std::size_t>> pieces;
  geometry.addMemory(pieces);
  if (field)
    pieces.emplace_back(field.get(), field->bytes());
  if (followed.field)
  {
    pieces.emplace_back(followed.field.get(), followed.field->bytes());
    withStructure(*followed.structure,
      [&](const auto& s) { pieces.emplace_back(followed.structure.get(), s.ownBytes()); });
  }
  if (walk)
    pieces.emplace_back(walk.get(), walk->bytes() - walk->adjacency().bytes());
  return pieces;
}

} // namespace mote
