/**
 * The colours of an image as rows from the top, in the encodings that image files want.
 */

#ifndef MotePixelColors_h
#define MotePixelColors_h

#include <cstdint>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace mote::imaging
{

/**
 * How a file keeps transparency.
 */
enum class AlphaKind
{
  Straight,      // colours not multiplied by alpha (PNG)
  Premultiplied, // colours multiplied by alpha (TIFF, EXR)
  None           // the image over white (JPEG)
};

/**
 * The point array `color`, or the active scalars without one. Throws ImageError if there is none,
 * if it does not have 1 to 4 components (grey, grey and alpha, RGB, RGBA), or if it is neither
 * float, double nor unsigned char.
 */
vtkDataArray* findColors(vtkImageData* image);

/**
 * Floats are premultiplied by their alpha, 8-bit colours are not.
 */
class PixelColors
{
public:
  /// `colors` has width * height tuples, bottom row first, and outlives this object.
  PixelColors(vtkDataArray* colors, int width, int height);

  /// Whether some pixel has an alpha below 1.
  bool isTransparent() const { return m_transparent; }
  /// Channels that an encoding has: 1 or 3, and one more with alpha.
  int channels(AlphaKind alpha) const;

  /// Row `row` from the top in 8 bits, rounded, NaN as 0: width * channels(alpha) values.
  void encode(int row, AlphaKind alpha, std::uint8_t* out) const;
  /// Row `row` from the top as premultiplied floats: width * channels(Premultiplied) values.
  void encode(int row, float* out) const;

private:
  template <typename T, typename Convert>
  void forEachPixel(int row, T* out, int channels, Convert&& convert) const;

  vtkDataArray* m_colors;
  int m_width;
  int m_height;
  int m_components;
  bool m_eightBit;
  bool m_transparent = false;
};

} // namespace mote::imaging

#endif
