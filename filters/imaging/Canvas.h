/**
 * Drawing into the colours of an image.
 */

#ifndef MoteCanvas_h
#define MoteCanvas_h

#include "TextMask.h"

#include <functional>

class vtkDataArray;

namespace mote::imaging
{

class SvgDrawing;

/// Straight (not premultiplied), each in [0, 1].
struct Color
{
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  double alpha = 1.0;
};

/// Relative luminance of an sRGB colour, as the Web Content Accessibility Guidelines define it.
double luminance(const Color& color);
/// Ratio in [1, 21] of two luminances, by which those guidelines judge legibility: 4.5 is readable.
double contrast(double luminance, double otherLuminance);

/// Pixels [x0, x1) by [y0, y1), y up.
struct Rect
{
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool isEmpty() const { return x1 <= x0 || y1 <= y0; }
  Rect moved(int x, int y) const { return {x0 + x, y0 + y, x1 + x, y1 + y}; }
  Rect grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
  Rect clipped(int width, int height) const;
};

/**
 * Colours with 3 or 4 components: floats premultiplied by alpha, or 8-bit ones that are not.
 * What lies outside of the image is not drawn.
 */
class Canvas
{
public:
  /// What is drawn goes to `svg`, too, if there is one; shapes and blended pixels do not.
  Canvas(vtkDataArray* colors, int width, int height, SvgDrawing* svg = nullptr);

  int width() const { return m_width; }
  int height() const { return m_height; }
  SvgDrawing* svg() { return m_svg; }

  /// A pixel over white paper, opaque.
  Color seen(int x, int y) const;
  void blend(int x, int y, const Color& color, double coverage);
  void fill(const Rect& rect, const Color& color);
  /// Share of each pixel of `rect` that the shape covers, given the pixel's centre.
  void fillShape(
    const Rect& rect, const Color& color, const std::function<double(double, double)>& coverage);
  void fillRounded(const Rect& rect, double radius, const Color& color);
  void draw(const TextMask& mask, int x, int y, const Color& color);

private:
  vtkDataArray* m_colors;
  int m_width;
  int m_height;
  int m_components;
  SvgDrawing* m_svg;
  double m_scale; // of stored values to [0, 1]
};

} // namespace mote::imaging

#endif
