#pragma once

#include "HexMesh.h"
#include "HexRay.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mote
{

/// The part [in, out) of a line that lies in a cell, in the line's own parameter, and the faces by
/// which the line enters and leaves: 0 to 5, with the corners 0321, 4567, 0154, 3762, 0473, 1265.
struct CellInterval
{
  double in = 0.0;
  double out = 0.0;
  std::uint8_t inFace = noFace;
  std::uint8_t outFace = noFace;

  /// What of it lies within [tMin, tMax], as a span of a ray: empty where tIn >= tOut.
  CellSpan within(std::uint32_t cell, double tMin, double tMax) const
  {
    return {cell, std::max(in, tMin), std::min(out, tMax), in < tMin ? noFace : inFace,
      out > tMax ? noFace : outFace};
  }
};

/// A point of a face, as four corners of the cell and their weights, which are bilinear and add up
/// to 1 but for rounding. From the cells on both sides the same corners come in the same order with
/// the same weights, and so value() gives the same to the last bit.
struct FacePoint
{
  std::array<std::uint8_t, 4> corners{};
  std::array<double, 4> weights{};

  /// The value of a scalar; `ofCorner(i)` is that of the cell's corner i, 0 to 7.
  template <typename OfCorner>
  double value(const OfCorner& ofCorner) const
  {
    return weights[0] * ofCorner(corners[0]) + weights[1] * ofCorner(corners[1]) +
           weights[2] * ofCorner(corners[2]) + weights[3] * ofCorner(corners[3]);
  }
};

/// The parts of a line in one cell, in order. A cell with eight corners has up to six: each of the
/// faces is passed twice at most.
struct CellIntervals
{
  std::array<CellInterval, 6> of;
  int count = 0;

  const CellInterval* begin() const { return of.data(); }
  const CellInterval* end() const { return of.data() + count; }
};

/// The spans that a ray has in some cells, as many as there is room for.
class SpanBatch
{
public:
  bool hasRoom() const { return count_ + mostOfCell <= of_.size(); }
  void clear() { count_ = 0; }
  void add(const CellSpan& span)
  {
    of_[count_] = span;
    count_ += span.tIn < span.tOut ? 1 : 0;
  }
  const CellSpan* begin() const { return of_.data(); }
  const CellSpan* end() const { return of_.data() + count_; }

private:
  static constexpr std::size_t mostOfCell = 6;
  std::array<CellSpan, 16 + mostOfCell> of_;
  std::size_t count_ = 0;
};

/// The frame in which a line is the third axis: a shear, and an order of axes.
struct LineFrame
{
  Vec3d origin; ///< in the frame's order of axes
  int kx, ky, kz;
  double shearX, shearY;
  double inverse; ///< t of z

  Vec3d at(const Vec3d& p) const
  {
    const double z = p[kz] - origin.z;
    return {p[kx] - origin.x - shearX * z, p[ky] - origin.y - shearY * z, z};
  }
};

/// A line, ready to be intersected with cells: exact in what it decides, and equal on both sides of
/// every face.
///
/// How. Corners are moved into a frame in which the line is the third axis (subtracted, then
/// sheared, as in Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013). That is
/// rounded, but a corner becomes the same numbers whatever cell it is looked at from, and from
/// there on nothing that decides *whether* a face is passed is rounded:
///
/// - A face's edges are straight, so how often the line passes the face, leaving counted +1 and
///   entering -1, is the winding number of a plane quadrilateral about the line. It is the sum over
///   the edges of whether the edge passes the half-line y = 0, x > 0, decided by the exact sign of
///   x1 y2 - x2 y1 (rounded products, and their rounding errors where these are equal). What lies
///   on y = 0 counts as below, what passes at x = 0 not at all: the line is thought to be moved by
///   an infinitely small step. An edge adds the same number with the other sign to the faces on
///   its two sides. So every cell is left as often as it is entered, along edges and through
///   corners as well, and no line gets lost between two faces.
/// - A bilinear map of the plane takes a value at most twice, with opposite orientations. A winding
///   number of +1 or -1 is thus one point, the root with that orientation; 0 is none or two, and
///   both lie inside of the face or neither.
/// - The roots, and t on the face, are found from the face's corners in an order that depends on
///   their places in the mesh alone (the least one first, then its lesser neighbour). The cells on
///   both sides get the same t to the last bit, also where their points are different but equal.
///
/// A cell is where the sum over the passed faces is above zero. For cells that do not cross
/// themselves that is their inside. Over all cells of a mesh the sums add up to the mesh's own
/// winding number, whatever was rounded: nothing is lost. Two cells can both claim something only
/// where a third one is thinner than the rounding of t.
///
/// The bilinear patch's roots: Reshetov, "Cool Patches", Ray Tracing Gems, 2019, chapter 8; the
/// choice among them there is by comparing with 0 and 1, which leaves gaps at edges.
class CrossingLine
{
public:
  /// The line origin + t direction; `direction` is finite and not zero, of any length.
  CrossingLine(const Vec3d& origin, const Vec3d& direction);

  /// Where the line is in the cell. True where it is anywhere.
  bool intersect(const HexMesh& mesh, std::size_t cell, CellIntervals& intervals) const;
  bool intersect(const HexCorners& corners, CellIntervals& intervals) const;
  /// Adds the parts between tMin and tMax that the line has in cells[0] to cells[count - 1], in
  /// this order, until there is no room. Gives how many cells were looked at: call again for the
  /// others.
  std::size_t addSpans(const HexMesh& mesh, const std::uint32_t* cells, std::size_t count,
    double tMin, double tMax, SpanBatch& spans) const;

  /// Where the line enters or leaves a cell by `face`, 0 to 5, which an interval or a span of this
  /// line and cell named. Nothing is iterated: values at the ends of spans need no coordinates
  /// within the cell.
  FacePoint entry(const HexMesh& mesh, std::size_t cell, std::uint8_t face) const
  {
    return facePoint(mesh, cell, face, -1);
  }
  FacePoint exit(const HexMesh& mesh, std::size_t cell, std::uint8_t face) const
  {
    return facePoint(mesh, cell, face, 1);
  }

  const LineFrame& frame() const { return frame_; }

private:
  FacePoint facePoint(const HexMesh& mesh, std::size_t cell, std::uint8_t face, int leaving) const;

  LineFrame frame_;
};

/// Whether points are in cells, with one answer for every point: points of faces belong to the cell
/// on one side, the same one whichever is asked. It is asked by a line through the point, of a
/// direction that is parallel to nothing usual, and 1e-14 of the mesh's size behind the point: so
/// points on edges and corners, where t is nothing but rounding, are asked beside
/// them. Of points that near to the mesh's outside some are in no cell.
class CrossingPoint
{
public:
  /// `size` is the mesh's, the same for all of its cells.
  CrossingPoint(const Vec3d& point, double size);

  bool isIn(const HexMesh& mesh, std::size_t cell) const;
  bool isIn(const HexCorners& corners) const;

private:
  bool isIn(const CellIntervals& intervals) const;

  CrossingLine line_;
  double at_;
};

} // namespace mote
