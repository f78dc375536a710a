#pragma once

#include "../core/ArrayView.h"
#include "../core/Box.h"
#include "../core/RawVector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace mote
{

/// The cell types that a HexMesh takes, with VTK's numbers.
enum class HexCellType : std::uint8_t
{
  Tetrahedron = 10,
  Voxel = 11,
  Hexahedron = 12,
  Wedge = 13,
  Pyramid = 14,
  Polyhedron = 42 ///< given by its faces
};

/// Cells with points farther along a coordinate are no part of any scene: structures have bounds in
/// float, and volumes are products.
constexpr double farthestPoint = 1e30;

/// How the points of a cell become the eight corners of a hexahedron, whose i-th corner is the
/// cell's point of[i]. Corners of wedges, pyramids and tetrahedra coincide.
struct CollapsedCorners
{
  int points = 0; ///< that the cell has; 0 for types with any number, or that are no HexCellType
  std::array<std::uint8_t, 8> of{};
};
CollapsedCorners collapsedCorners(int type);

/// Cells as the user gave them: views, nothing is copied. Cell i is of type types[i] and has the
/// points connectivity[offsets[i]] to connectivity[offsets[i + 1] - 1], in VTK's order. Faces of
/// the polyhedron i begin at faces[faceLocations[i]]: their number, then for each the number of its
/// points and these, in either direction.
struct HexMeshInput
{
  ArrayView points;        ///< three components, any type
  ArrayView types;         ///< n values; VTK's numbers
  ArrayView offsets;       ///< n + 1 values
  ArrayView connectivity;  ///< point numbers
  ArrayView faces;         ///< empty where there are no polyhedra
  ArrayView faceLocations; ///< n values, or none
};

/// What became of the cells of an input; cells count once, in parts or not.
struct HexMeshReport
{
  std::size_t cells = 0;        ///< in the input
  std::size_t kept = 0;         ///< in the mesh
  std::size_t hexahedra = 0;    ///< of the kept ones; voxels are among them
  std::size_t wedges = 0;       ///< of the kept ones
  std::size_t pyramids = 0;     ///< of the kept ones
  std::size_t tetrahedra = 0;   ///< of the kept ones
  std::size_t polyhedra = 0;    ///< of the kept ones
  std::size_t inParts = 0;      ///< of the kept ones: cut about their middle
  std::size_t otherTypes = 0;   ///< left out
  std::size_t flat = 0;         ///< of those: points, lines and surfaces
  std::size_t unfit = 0;        ///< left out: polyhedra that are not closed, or too concave
  std::size_t nonFinite = 0;    ///< left out: a corner has a coordinate that is not finite
  std::size_t tooFar = 0;       ///< left out: one is beyond farthestPoint
  std::size_t zeroVolume = 0;   ///< left out
  std::size_t inverted = 0;     ///< kept: the corners, listed inside out, are mirrored
  std::size_t selfCrossing = 0; ///< kept: the Jacobian's sign changes inside of the cell
  double volume = 0.0;          ///< of the kept cells

  /// One sentence about what was left out or mended; empty where there is nothing to say.
  std::string sentence() const;
};

/// The eight corners of a cell, in VTK's order of a hexahedron.
using HexCorners = std::array<Vec3d, 8>;

/// Cells with eight corners and trilinear insides; faces are bilinear patches. An owned copy.
///
/// Wedges, pyramids and tetrahedra are hexahedra with corners that coincide, voxels are put in
/// order. Polyhedra with other faces, and cells that cross themselves where their middle sees all
/// of their faces, are several cells: pyramids and tetrahedra to the middle (see FacedCell). Points
/// are kept in double, as they come: cells 1e6 away from the origin keep their shape.
class HexMesh
{
public:
  using Cell = std::array<std::uint32_t, 8>;
  static constexpr std::uint32_t noCell = 0xffffffffU;

  HexMesh() = default;
  /// Copies what is usable, in parallel. Throws Error where the arrays do not fit together, where a
  /// cell has not as many points as its type, or names a point or a face that is not there, and
  /// where there are more than 2^32 - 2 points or cells, parts and middles included.
  explicit HexMesh(const HexMeshInput& input);

  std::size_t cellCount() const { return cells_.size(); }
  /// Of the input.
  std::size_t pointCount() const { return points_.size() - middleCount(); }
  /// With the middles of cells in parts, which come after the input's points.
  std::size_t allPointCount() const { return points_.size(); }
  std::size_t middleCount() const { return middleEnds_.size(); }
  /// The points whose mean, of places and values, is point pointCount() + `i`.
  std::span<const std::uint32_t> aroundMiddle(std::size_t i) const
  {
    const std::uint32_t begin = i == 0 ? 0 : middleEnds_[i - 1];
    return {aroundMiddles_.data() + begin, middleEnds_[i] - begin};
  }
  const Vec3d& point(std::size_t i) const { return points_[i]; }
  const Cell& cell(std::size_t c) const { return cells_[c]; }
  const Cell* cells() const { return cells_.data(); }
  /// The input's number of cell `c`; parts of one cell follow one another.
  std::size_t inputCell(std::size_t c) const { return inputCells_.empty() ? c : inputCells_[c]; }
  HexCorners corners(std::size_t c) const
  {
    HexCorners corners;
    for (std::size_t i = 0; i < 8; ++i)
      corners[i] = points_[cells_[c][i]];
    return corners;
  }

  /// Of the corners of all cells.
  const Box& bounds() const { return bounds_; }
  const HexMeshReport& report() const { return report_; }
  std::size_t bytes() const;

private:
  struct Parts;
  void addParts(const std::vector<Parts>& parts);

  RawVector<Vec3d> points_;
  RawVector<Cell> cells_;
  RawVector<std::uint32_t> inputCells_; ///< empty where all cells were kept as they are
  RawVector<std::uint32_t> middleEnds_, aroundMiddles_;
  Box bounds_;
  HexMeshReport report_;
};

/// The volume of a trilinear cell, negative where it is inside out.
double cellVolume(const HexCorners& corners);

/// The size below which a cell's volume is nothing but rounding: of the product of its mean edges
/// along r, s and t, and of its points' own places.
double negligibleVolume(const HexCorners& corners);

/// The middle of a cell's corners.
Vec3d cellCenter(const HexCorners& corners);

Box boundsOf(const HexCorners& corners);

/// A box as a cell.
HexCorners cornersOf(const Box& box);

} // namespace mote
