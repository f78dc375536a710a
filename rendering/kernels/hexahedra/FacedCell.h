#pragma once

#include "HexMesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace mote
{

/// A cell as its faces tell it, and its way into cells with eight corners: as it is, or in parts,
/// pyramids over its faces to its middle. Scratch memory, for one cell after another.
///
/// A quadrilateral is the base of one pyramid, and so stays the bilinear patch that it is in a
/// hexahedron on its other side; a triangle is that of a tetrahedron. Faces of more points are
/// fans of quadrilaterals and triangles, which depend on their points alone, so that the two cells
/// of a face cut it alike.
class FacedCell
{
public:
  /// Eight of the cell's points, by their places in ids(); its middle is middlePlace().
  using Part = std::array<std::uint32_t, 8>;

  void clear();
  /// A face as a polygon of point numbers; it may be listed from inside or outside.
  void addFace(const std::int64_t* ids, std::size_t count);
  /// Takes the faces that HexMeshInput has of cell `cell`. Throws Error where a face or one of
  /// `points` points is not there.
  void read(const ArrayView& faces, std::size_t location, std::size_t cell, std::size_t points);
  /// Takes a hexahedron or a cell whose corners coincide, by their numbers.
  void setCell(const std::array<std::int64_t, 8>& corners);

  /// To be called when the faces are complete; then `places` is to be filled.
  void complete();
  /// The numbers of the points that faces name, each once, in ascending order.
  const std::vector<std::int64_t>& ids() const { return ids_; }
  std::vector<Vec3d> places; ///< of these points

  /// The corners where the faces are those of a hexahedron, wedge, pyramid or tetrahedron, which
  /// may be inside out.
  std::optional<Part> whole() const;

  /// Cuts the cell about its middle. False where the faces do not close, or where the middle does
  /// not see all of them from inside: nothing can be drawn of these parts.
  bool cut();
  const std::vector<Part>& parts() const { return parts_; }
  std::uint32_t middlePlace() const { return static_cast<std::uint32_t>(ids_.size()); }
  /// The mean of the places.
  const Vec3d& middle() const { return middle_; }
  HexCorners cornersOf(const Part& part) const;
  double volume() const { return volume_; } ///< of the parts

private:
  /// A face of at least three points, from the least one on towards the lesser neighbour.
  struct Polygon
  {
    std::size_t first = 0, count = 0; ///< in polygons_
    bool isTurned = false;            ///< against how it was listed
  };
  /// A quadrilateral, or a triangle with the last corner twice.
  using Patch = std::array<std::uint32_t, 4>;

  void addPolygon(const std::uint32_t* places, std::size_t count);
  void makePatches(const Polygon& polygon);
  double fanQuality(const std::uint32_t* p, std::size_t n, std::size_t start) const;
  bool isConvex(const Patch& patch) const;
  bool cutFace(const Polygon& polygon);
  bool isClosed();

  std::vector<std::int64_t> faces_; ///< count and point numbers, face after face
  std::vector<std::int64_t> ids_;
  std::vector<std::uint32_t> polygons_;
  std::vector<Polygon> all_;
  std::vector<Patch> patches_;
  std::vector<std::array<std::uint32_t, 2>> edges_; ///< as faces have them, seen from outside
  std::vector<Part> parts_;
  std::vector<std::uint32_t> scratch_;
  std::vector<std::int64_t> face_;
  Vec3d middle_{0.0};
  double volume_ = 0.0;
};

/// Throws Error: a cell names a point that is not there.
[[noreturn]] void refusePoint(double id, std::size_t points, std::size_t cell);

/// A point's number, if there is one of so many.
inline std::int64_t checkedPoint(double id, std::size_t points, std::size_t cell)
{
  if (!(id >= 0.0 && id < static_cast<double>(points)))
    refusePoint(id, points, cell);
  return static_cast<std::int64_t>(id);
}

} // namespace mote
