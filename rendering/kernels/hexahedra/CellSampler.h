#pragma once

#include "CellCrossings.h"
#include "HexField.h"
#include "TrilinearCell.h"

#include <cmath>

namespace mote
{

/// The cell that a ray is in, to be asked for values of a field at points of the ray: where in the
/// cell a point is, is found from where the last one was.
class CellSampler
{
public:
  CellSampler(const HexMesh& mesh, const HexField& field)
    : mesh_(mesh)
    , field_(field)
  {
  }

  /// Goes to a cell. Nothing is computed but whether it has a value.
  void enter(std::uint32_t cell)
  {
    if (cell == cell_)
      return;
    cell_ = cell;
    hasShape_ = false;
    if (field_.isOfCells())
      values_.fill(field_.ofCell(cell));
    else
      values_ = field_.corners(mesh_.cell(cell));
    double sum = 0.0;
    for (const double v : values_)
      sum += v;
    isNaN_ = std::isnan(sum);
  }

  const HexMesh& mesh() const { return mesh_; }
  std::uint32_t cell() const { return cell_; }
  bool isNaN() const { return isNaN_; }
  bool isConstant() const { return field_.isOfCells(); }
  const CornerValues& values() const { return values_; }
  const TrilinearCell& shape()
  {
    if (!hasShape_)
    {
      shape_ = TrilinearCell(mesh_, cell_);
      hasShape_ = true;
      rst_ = Vec3d(0.5);
    }
    return shape_;
  }

  /// The trilinear value at a point of the cell, and, next to it, rst(). A cell's value where
  /// values are of cells.
  double trilinear(const Vec3d& p)
  {
    if (isConstant())
      return values_[0];
    locate(p);
    return weighted(values_, TrilinearCell::weights(rst_));
  }
  /// The trilinear value where the ray enters and leaves the cell: on a face it needs no place
  /// within the cell, and is the same to the last bit from both sides.
  double entry(const CrossingLine& line, const CellSpan& span, const HexRay& ray)
  {
    return span.inFace == noFace ? trilinear(ray.origin + span.tIn * ray.direction)
                                 : valueOf(line.entry(mesh_, cell_, span.inFace));
  }
  double exit(const CrossingLine& line, const CellSpan& span, const HexRay& ray)
  {
    return span.outFace == noFace ? trilinear(ray.origin + span.tOut * ray.direction)
                                  : valueOf(line.exit(mesh_, cell_, span.outFace));
  }
  /// The mean of the corners' values by the inverse of their distance.
  double byDistance(const Vec3d& p)
  {
    return isConstant() ? values_[0] : weighted(values_, shape().inverseDistanceWeights(p));
  }
  /// The gradient of the trilinear value at a point; 0 where values are of cells.
  Vec3d gradient(const Vec3d& p)
  {
    if (isConstant())
      return Vec3d(0.0);
    locate(p);
    return shape_.gradient(values_, rst_);
  }

private:
  double valueOf(const FacePoint& point) const
  {
    return point.value([this](std::size_t i) { return values_[i]; });
  }
  void locate(const Vec3d& p)
  {
    shape();
    if (!shape_.coordinates(p, rst_, rst_))
      return;
    // The map of a warped cell takes some points from outside, too.
    for (int corner = 0; corner < 8 && isFarOutside(rst_); ++corner)
      if (Vec3d other;
          shape_.coordinates(p, other,
            Vec3d(corner & 1 ? 0.8 : 0.2, corner & 2 ? 0.8 : 0.2, corner & 4 ? 0.8 : 0.2)) &&
          !isFarOutside(other))
        rst_ = other;
    // Points on faces are within to rounding.
    rst_ = glm::clamp(rst_, Vec3d(0.0), Vec3d(1.0));
  }
  static bool isFarOutside(const Vec3d& rst)
  {
    return std::abs(rst.x - 0.5) > 0.51 || std::abs(rst.y - 0.5) > 0.51 ||
           std::abs(rst.z - 0.5) > 0.51;
  }

  const HexMesh& mesh_;
  const HexField& field_;
  std::uint32_t cell_ = HexMesh::noCell;
  bool isNaN_ = false;
  bool hasShape_ = false;
  CornerValues values_{};
  TrilinearCell shape_{HexCorners{}};
  Vec3d rst_{0.5};
};

} // namespace mote
