#pragma once

#include "../../core/Camera.h"
#include "../WalkCells.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mote
{

/// The boundary of a mesh as a camera sees it: which faces rays may enter by, in squares of pixels.
/// Nothing is exact here, faces may be told of where no ray meets them; none is left out.
class WalkView
{
public:
  /// A face that may be entered, and what it covers of the image, in pixels.
  struct Face
  {
    CellFace face;
    bool isUnclear;  ///< some rays may enter by it and others leave
    bool isFoldable; ///< a ray may pass it twice
    float left, right, lower, upper;
  };

  /// `rays` are the camera's in the coordinates of the mesh. In parallel.
  WalkView(const WalkCells& cells, const CameraRays& rays, int width, int height);

  const Face& face(std::uint32_t i) const { return faces_[i]; }
  /// Whether a cell has a face of the boundary that a ray may pass twice.
  bool isFoldable(std::uint32_t cell) const
  {
    return (foldable_[cell >> 5] >> (cell & 31) & 1) != 0;
  }
  /// The same, a bit a cell.
  const std::uint32_t* foldable() const { return foldable_.data(); }

  /// Appends the faces that rays through the places of a rectangle may enter by, each once.
  void gather(
    double left, double right, double lower, double upper, std::vector<std::uint32_t>& faces) const;

private:
  static constexpr int side = 8; ///< of a square, in pixels
  struct Squares
  {
    int left, right, lower, upper; ///< all inclusive
  };
  int columnOf(double x) const;
  int rowOf(double y) const;
  Squares squaresOf(const Face& face) const
  {
    return {columnOf(face.left), columnOf(face.right), rowOf(face.lower), rowOf(face.upper)};
  }
  void fillSquares();

  int columns_, rows_;
  RawVector<Face> faces_;
  std::vector<std::uint32_t> begins_, listed_; ///< faces of each square, one range after another
  std::vector<std::uint32_t> foldable_;        ///< a bit a cell
};

} // namespace mote
