#include "FlowInCells.h"

#include "FlowSeeds.h"
#include "LocatorQueries.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>

namespace mote
{

Mat4d placementOf(vtkDataSet* data)
{
  Mat4d placement(1.0);
  vtkDataArray* array = data->GetFieldData()->GetArray("Placement");
  if (!array || array->GetNumberOfComponents() * array->GetNumberOfTuples() != 16)
    return placement;
  for (int k = 0; k < 16; ++k)
    placement[k % 4][k / 4] = array->GetVariantValue(k).ToDouble();
  return placement;
}

Vec3d turnedVector(const Mat4d& placement, const Vec3d& vector)
{
  return transformVector(placement, vector) / scaleOf(placement);
}

FlowInCells::FlowInCells(vtkDataSet* data, std::shared_ptr<const LocatorStructure> structure)
  : data_(data)
  , toWorld_(placementOf(data))
  , toData_(glm::inverse(toWorld_))
  , ghosts_(data->GetCellGhostArray())
  , structure_(std::move(structure))
{
}

void FlowInCells::select(vtkDataArray* vectors, bool ofCells)
{
  if (vectors == selected_ && ofCells == ofCells_)
    return;
  selected_ = vectors;
  ofCells_ = ofCells;
  vectors_ = DataArrayView(vectors);
  entered_.fill({});
}

/// Reads what is needed of a cell.
void FlowInCells::enter(std::uint32_t cell, Entered& entered) const
{
  const HexMesh& mesh = *structure_->mesh;
  entered.cell = cell;
  entered.inputCell = static_cast<vtkIdType>(mesh.inputCell(cell));
  entered.shape.emplace(mesh, cell);
  entered.box = boundsOf(entered.shape->corners());
  entered.rst = Vec3d(0.5);
  const auto read = [&](std::size_t tuple)
  {
    return Vec3d(
      vectors_.view.value(tuple, 0), vectors_.view.value(tuple, 1), vectors_.view.value(tuple, 2));
  };
  if (ofCells_)
    return entered.velocities.fill(read(static_cast<std::size_t>(entered.inputCell)));
  for (std::size_t i = 0; i < 8; ++i)
  {
    const std::size_t point = mesh.cell(cell)[i];
    Vec3d& velocity = entered.velocities[i];
    if (point < mesh.pointCount())
    {
      velocity = read(point);
      continue;
    }
    // The middle of a polyhedron has the mean of what is around it.
    const auto around = mesh.aroundMiddle(point - mesh.pointCount());
    velocity = Vec3d(0.0);
    for (const std::uint32_t one : around)
      velocity += read(one) / static_cast<double>(around.size());
  }
}

bool FlowInCells::isHeld(Entered& entered, const Vec3d& p) const
{
  if (entered.cell == HexMesh::noCell || glm::any(glm::lessThan(p, entered.box.lower)) ||
      glm::any(glm::greaterThan(p, entered.box.upper)))
    return false;
  constexpr double slack = 1e-9; // of a face: the other side knows the same
  Vec3d rst = entered.rst;
  if (!entered.shape->converges(p, rst) || std::min({rst.x, rst.y, rst.z}) < -slack ||
      std::max({rst.x, rst.y, rst.z}) > 1.0 + slack)
    return false;
  entered.rst = rst;
  return true;
}

bool FlowInCells::find(const Vec3d& inWorld)
{
  if (!structure_ || !selected_)
    return false;
  const Vec3d p = transformPoint(toData_, inWorld);
  p_ = p;
  std::size_t held = last_, tried = 0;
  while (tried < entered_.size() && !this->isHeld(entered_[held], p))
    held = (last_ + ++tried) % entered_.size();
  if (tried == entered_.size())
  {
    const std::uint32_t cell = structure_->cellAt(p);
    if (cell == HexMesh::noCell || isHiddenCell(ghosts_, structure_->mesh->inputCell(cell)))
      return false;
    held = next_;
    next_ = (next_ + 1) % entered_.size();
    Entered& entered = entered_[held];
    this->enter(cell, entered);
    entered.shape->coordinates(p, entered.rst);
    entered.rst = glm::clamp(entered.rst, Vec3d(0.0), Vec3d(1.0)); // a little beside the mesh
  }
  last_ = held;
  shares_ = TrilinearCell::weights(entered_[held].rst);
  return true;
}

void FlowInCells::velocity(double f[3]) const
{
  Vec3d sum(0.0);
  for (std::size_t i = 0; i < 8; ++i)
    sum += shares_[i] * entered_[last_].velocities[i];
  sum = turnedVector(toWorld_, sum);
  std::copy_n(&sum.x, 3, f);
}

void FlowInCells::weights(vtkGenericCell* cell, double pcoords[3], double* weights) const
{
  const int type = cell->GetCellType();
  if (type != VTK_HEXAHEDRON && type != VTK_VOXEL)
    return evaluate(*structure_->mesh, entered_[last_].cell, cell, p_, pcoords, weights);
  std::copy_n(&entered_[last_].rst.x, 3, pcoords);
  const vtkIdType* points = cell->GetPointIds()->GetPointer(0);
  const HexMesh::Cell& corners = structure_->mesh->cell(entered_[last_].cell);
  std::fill_n(weights, 8, 0.0);
  // Cells that are inside out have their corners in another order.
  for (std::size_t i = 0; i < 8; ++i)
    weights[std::find(points, points + 8, static_cast<vtkIdType>(corners[i])) - points] +=
      shares_[i];
}

} // namespace mote
