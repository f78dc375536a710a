#include "LocatorStructure.h"

#include "DataSetMismatch.h"
#include "GridCells.h"

#include "kernels/core/Error.h"
#include "kernels/hexahedra/TrilinearCell.h"

#include <glm/vector_relational.hpp>

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

/// By how much, in a cell's own coordinates, points may lie beside it: as for VTK's cells.
constexpr double outsideHexahedron = 1e-6, outsideCollapsed = 1e-3;

std::uint64_t timeOf(vtkObject* object)
{
  return object ? object->GetMTime() : 0;
}

/// The cells as arrays; of an unstructured grid its own, of other data sets new ones.
class CellArrays
{
public:
  explicit CellArrays(vtkDataSet* data)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
    if (grid && grid->GetCells() && grid->GetNumberOfCells() > 0)
      input = grid_.emplace(GridArrays(grid)).input();
    else
      copyCells(data);
    auto* set = vtkPointSet::SafeDownCast(data);
    points_ = DataArrayView(set && set->GetPoints() ? set->GetPoints()->GetData() : nullptr);
    input.points = points_.view;
    if (input.points.empty())
      copyPoints(data, static_cast<std::size_t>(data->GetNumberOfPoints()));
  }

  HexMeshInput input;

private:
  void copyCells(vtkDataSet* data)
  {
    vtkNew<vtkIdList> ids;
    offsets_.push_back(0);
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    {
      types_.push_back(static_cast<std::uint8_t>(data->GetCellType(i)));
      data->GetCellPoints(i, ids);
      connectivity_.insert(connectivity_.end(), ids->begin(), ids->end());
      offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
    }
    input.types = ArrayView(types_.data(), ArrayView::Type::UInt8, types_.size(), 1);
    input.offsets = ArrayView(offsets_.data(), ArrayView::Type::Int64, offsets_.size(), 1);
    input.connectivity =
      ArrayView(connectivity_.data(), ArrayView::Type::Int64, connectivity_.size(), 1);
  }

  void copyPoints(vtkDataSet* data, std::size_t count)
  {
    copied_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      data->GetPoint(static_cast<vtkIdType>(i), &copied_[i].x);
    input.points = ArrayView(copied_.empty() ? nullptr : &copied_[0].x, count, 3);
  }

  std::vector<std::uint8_t> types_;
  std::vector<std::int64_t> offsets_, connectivity_;
  std::vector<Vec3d> copied_;
  std::optional<GridCells> grid_;
  DataArrayView points_;
};

/// How far outside of a cell `p` lies, in the cell's own coordinates; infinite for more than such a
/// cell allows.
double outsideBy(const HexMesh& mesh, std::uint32_t cell, const Vec3d& p)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  const bool collapsed = mesh.cell(cell)[6] == mesh.cell(cell)[7];
  const double most = collapsed ? outsideCollapsed : outsideHexahedron;
  const HexCorners corners = mesh.corners(cell);
  const Box box = boundsOf(corners), near = box.expanded(most * glm::length(box.size()));
  Vec3d rst(0.5);
  if (glm::any(glm::lessThan(p, near.lower)) || glm::any(glm::greaterThan(p, near.upper)) ||
      !TrilinearCell(corners).coordinates(p, rst))
    return far;
  const Vec3d by = glm::abs(rst - Vec3d(0.5)) - Vec3d(0.5);
  const double largest = std::max({by.x, by.y, by.z});
  return largest <= most ? largest : far;
}

} // namespace

LocatorStructure::Key LocatorStructure::keyOf(vtkDataSet* data, const HexStructureOptions& options)
{
  Key key = {static_cast<std::uint64_t>(options.kind)};
  if (options.axis)
    for (int k = 0; k < 3; ++k)
      for (const double x : {options.axis->origin[k], options.axis->direction[k]})
        key.push_back(std::bit_cast<std::uint64_t>(x));
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    key.push_back(timeOf(grid->GetPoints()));
    key.push_back(timeOf(grid->GetCells()));
    for (vtkDataArray* array : GridArrays(grid).all())
      key.push_back(timeOf(array));
  }
  else if (auto* curved = vtkStructuredGrid::SafeDownCast(data))
  {
    key.push_back(timeOf(curved->GetPoints()));
    for (int k = 0; k < 6; ++k)
      key.push_back(static_cast<std::uint64_t>(curved->GetExtent()[k]));
    key.push_back(timeOf(curved->GetPointGhostArray()));
    key.push_back(timeOf(curved->GetCellGhostArray()));
  }
  else
    key.push_back(data->GetMTime());
  return key;
}

LocatorStructure::LocatorStructure(vtkDataSet* data, const HexStructureOptions& options)
  : key(keyOf(data, options))
  , geometry(data)
{
  if (auto* set = vtkPointSet::SafeDownCast(data); set && set->GetPoints())
    geometry = set->GetPoints();
  if (const std::string mismatch = mismatchOf(data); !mismatch.empty())
    throw Error("The cells cannot be located: " + mismatch + ".");
  mesh = std::make_shared<HexMesh>(CellArrays(data).input);
  HexStructureOptions complete = options;
  if (isCylindrical(options.kind) && !options.axis)
    complete.axis = findAxis(*mesh);
  structure = makeHexStructure(mesh, complete);
  if (isCylindrical(options.kind))
    axis = complete.axis;
  built.Modified();
}

std::uint32_t LocatorStructure::cellAt(const Vec3d& p) const
{
  const std::uint32_t holder = mote::cellAt(*structure, p);
  if (holder != HexMesh::noCell || !std::isfinite(p.x + p.y + p.z))
    return holder;
  const bool anyCollapsed = mesh->report().hexahedra < mesh->cellCount();
  const Vec3d margin(
    (anyCollapsed ? outsideCollapsed : outsideHexahedron) * glm::length(mesh->bounds().size()));
  std::uint32_t nearest = HexMesh::noCell;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t c : cellsWithin(*structure, Box{p - margin, p + margin}))
    if (const double by = outsideBy(*mesh, c, p); by < least)
    {
      least = by;
      nearest = c;
    }
  return nearest;
}

HexStructureKind structureKindNamed(const std::string& name)
{
  const auto& names = hexStructureNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error("There is no structure of the name \"" + name + "\".");
  return static_cast<HexStructureKind>(found - names.begin());
}

std::shared_ptr<const LocatorStructure> SharedStructures::get(
  vtkDataSet* data, const HexStructureOptions& options)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::erase_if(all_, [](const auto& one) { return !one->geometry; });
  const auto key = LocatorStructure::keyOf(data, options);
  const auto known =
    std::find_if(all_.begin(), all_.end(), [&](const auto& one) { return one->key == key; });
  if (known != all_.end())
    return *known;
  all_.push_back(std::make_shared<LocatorStructure>(data, options));
  return all_.back();
}

void SharedStructures::drop(const LocatorStructure* structure)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::erase_if(all_, [structure](const auto& one) { return one.get() == structure; });
}

} // namespace mote
