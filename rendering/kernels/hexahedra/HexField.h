#pragma once

#include "HexMesh.h"
#include "HexRay.h"
#include "TrilinearCell.h"

#include <span>

namespace mote
{

struct HangingPoint;

/// A scalar of a mesh's input: component `component` (or ArrayView::magnitude) of values of the
/// input's points or of the input's cells.
struct HexScalar
{
  ArrayView values;
  int component = 0;
  bool ofCells = false;
  /// Where it is not 0, of values with three components: the vector's part along this direction, in
  /// place of a component.
  Vec3d along{0.0};
};

/// A scalar on a mesh, at its points (trilinear in each cell) or one value a cell: an owned copy,
/// 4 bytes a value. Values count from the middle of their range, so that float keeps 6e-8 of half
/// the range whatever the values are: 101325 +- 1 Pa loses nothing that is seen.
class HexField
{
public:
  HexField() = default;
  /// Copies in parallel. Throws Error where there is another number of values than of points or of
  /// the input's cells, no such component, or a range above 6.8e38.
  HexField(const HexMesh& mesh, const HexScalar& scalar);
  /// A field of cells as one of points: the mean of the input's cells around each, of those that
  /// have a number, the nearer the more they count, by one over the distance of their middles.
  /// Points that hang have what lies between the corners of their faces. In parallel; the result
  /// does not depend on the number of threads.
  static HexField atPoints(
    const HexMesh& mesh, const HexField& ofCells, std::span<const HangingPoint> hanging = {});

  bool isOfCells() const { return ofCells_; }
  /// What the kept values count from.
  double offset() const { return offset_; }
  /// The least and greatest finite value, as the user gave them; lower > upper where there is none.
  double lower() const { return lower_; }
  double upper() const { return upper_; }

  /// From offset(); NaN where the input has NaN or an infinity.
  float ofPoint(std::size_t point) const { return values_[point]; }
  float ofCell(std::size_t cell) const { return values_[cell]; }
  CornerValues corners(const HexMesh::Cell& cell) const
  {
    CornerValues v;
    for (std::size_t i = 0; i < 8; ++i)
      v[i] = values_[cell[i]];
    return v;
  }

  void prefetch(std::size_t point) const { __builtin_prefetch(&values_[point]); }

  std::size_t bytes() const { return values_.size() * sizeof(float); }

private:
  void addMiddles(const HexMesh& mesh);

  RawVector<float> values_; ///< of points or of the mesh's cells
  double offset_ = 0.0;
  double lower_ = std::numeric_limits<double>::infinity();
  double upper_ = -std::numeric_limits<double>::infinity();
  bool ofCells_ = false;
};

/// The least and greatest value in each cell, counted from the field's offset. A cell with a NaN
/// has the range of all numbers, so that no query passes it over. In parallel.
RawVector<ScalarRange> cellRanges(const HexMesh& mesh, const HexField& field);

} // namespace mote
