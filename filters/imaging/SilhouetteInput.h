/**
 * What vtkMoteSilhouetteFilter takes from its input: depths, groups and colours, slice by slice.
 */

#ifndef MoteSilhouetteInput_h
#define MoteSilhouetteInput_h

#include "kernels/imaging/Silhouettes.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace mote::imaging
{

/// The point array of one number a pixel of this name. Throws ImageError without one.
vtkDataArray* findNumbers(vtkImageData* image, const std::string& name);

/// That of depths: of this name, or for an empty one `depth`, or else the active scalars. Throws
/// ImageError without one.
vtkDataArray* findDepths(vtkImageData* image, const std::string& name);

/// Points of the input for one pixel of the output: columns [x0, x1) of rows [y0, y1), as indices
/// of point data.
struct PixelSquare
{
  std::int64_t first, rowStride;
  int width, height;
};

/**
 * The depth images of an input, of which there may be only a part, and how pixels of the output lie
 * in it.
 */
class SilhouetteInput
{
public:
  float background = 0.0f;

  /// `whole` is the whole image, and `present` the part of it that there is: six numbers as VTK's.
  void setExtents(const int* whole, const int* present, int reduction);
  void takeDepths(vtkDataArray* depths);
  void takeGroups(vtkDataArray* groups);
  /// Degrees and world units for the height of the whole image.
  void setView(bool perspective, double angle, double height, bool alongRays);

  /// Diagonal of the box around what is seen, along the image's edges and the view axis.
  double sceneSize() const;
  /// The depth image of slice `z`, and where in it the output's `extent` lies.
  DepthImage slice(int z, const int* extent, PixelBox& box) const;
  PixelSquare square(int x, int y, int z) const;

private:
  DepthImage present(int z) const;
  std::int64_t indexOf(int x, int y, int z) const;

  int m_whole[6] = {}, m_present[6] = {};
  int m_reduction = 1;
  const float* m_depth = nullptr; // m_depths, or the array's own numbers
  std::vector<float> m_depths;
  std::vector<std::uint64_t> m_groups;
  double m_tangent = 0.0, m_pixelSize = 0.0; // of a pixel
  bool m_alongRays = false;
};

/**
 * Lines of one colour over the colours of an image.
 */
class LineColors
{
public:
  LineColors() = default;
  /// Throws ImageError where the array of colours is none of colours; without one, lines are drawn
  /// over nothing.
  LineColors(vtkImageData* image, const std::string& name, const double* lines);

  /// The mean colour of a square under lines that cover `share` of it: premultiplied RGBA.
  void mix(const PixelSquare& square, float share, float* out) const;

private:
  vtkDataArray* m_colors = nullptr;
  float m_lines[3] = {};
};

} // namespace mote::imaging

#endif
