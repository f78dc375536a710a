#pragma once

#include "FaceAdjacency.h"
#include "HexField.h"
#include "WalkViews.h"

#include <memory>

namespace mote
{

/// A mesh and a scalar as rays need them that go from cell to cell, see CellWalk: which cells lie
/// side by side, places and values in float, and how far each cell's scalar may be from a line.
///
/// Takes 24 bytes a cell for the adjacency, which another scalar on the same mesh shares, and 16
/// bytes a point and 4 to 8 bytes a cell for the scalar.
class WalkCells
{
public:
  /// A point, as toLocal() has it, and the scalar there, which counts from the field's offset.
  struct alignas(16) Point
  {
    float x, y, z, value;
  };

  /// In parallel. The mesh is kept alive; the field must be on it. `views` are those of other
  /// fields on the mesh; null where there are none.
  WalkCells(std::shared_ptr<const HexMesh> mesh, std::shared_ptr<const FaceAdjacency> adjacency,
    const HexField& field, std::shared_ptr<WalkViews> views = nullptr);

  const HexMesh& mesh() const { return *mesh_; }
  const FaceAdjacency& adjacency() const { return *adjacency_; }
  const std::shared_ptr<const FaceAdjacency>& sharedAdjacency() const { return adjacency_; }
  WalkViews& views() const { return *views_; }
  /// Places count from the middle of the mesh's bounds, along each axis in units of their size:
  /// flat meshes lose nothing in float.
  Vec3d toLocal(const Vec3d& p) const { return (p - center_) / size_; }
  Vec3d toMesh(const Vec3d& p) const { return center_ + size_ * p; }
  const Vec3d& size() const { return size_; }

  bool isOfCells() const { return !ofCells_.empty(); }
  const Point* points() const { return points_.data(); }
  /// Of each cell, bendOf() the scalar; infinite where the scalar has a NaN. Has the sign of minus
  /// where the cell has a face of the boundary that is not plane.
  const float* bends() const { return bends_.data(); }
  /// The scalar in each cell, where it has values of cells; else null.
  const float* ofCells() const { return ofCells_.empty() ? nullptr : ofCells_.data(); }

  /// Without the mesh.
  std::size_t bytes() const;

private:
  std::shared_ptr<const HexMesh> mesh_;
  std::shared_ptr<const FaceAdjacency> adjacency_;
  std::shared_ptr<WalkViews> views_;
  Vec3d center_{0.0}, size_{1.0};
  RawVector<Point> points_;
  RawVector<float> bends_, ofCells_;
};

} // namespace mote
