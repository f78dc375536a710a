#pragma once

#include "HexMesh.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace mote
{

/// A face of a cell, 0 to 5 in the order of CellInterval.
struct CellFace
{
  std::uint32_t cell = 0;
  std::uint8_t face = 0;

  bool operator==(const CellFace&) const = default;
};

/// Which cells share the faces of a mesh: 24 bytes a cell, and 8 for each face of the boundary.
///
/// Two faces are one where they name the same points in opposite directions; of more than two the
/// cells with the least numbers are paired. All others are boundary: the mesh's outside, and both
/// sides of interfaces whose points are not the same. Faces that are collapsed to a line or a point
/// are neither, because nothing passes them.
class FaceAdjacency
{
public:
  FaceAdjacency() = default;
  /// In parallel; the result does not depend on the number of threads. Throws Error for more than
  /// 715,827,881 cells.
  explicit FaceAdjacency(const HexMesh& mesh);

  /// The cell behind a face of a cell, or HexMesh::noCell.
  std::uint32_t next(std::size_t cell, std::size_t face) const { return next_[cell][face]; }
  /// The faces that are no other cell's, in the order of cells and faces.
  const RawVector<CellFace>& boundary() const { return boundary_; }

  const std::array<std::uint32_t, 6>* data() const { return next_.data(); }
  std::size_t bytes() const;

private:
  RawVector<std::array<std::uint32_t, 6>> next_;
  RawVector<CellFace> boundary_;
};

} // namespace mote
