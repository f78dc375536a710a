/**
 * What is drawn into an image as elements of SVG, so that it can be read at any size.
 */

#ifndef MoteSvgDrawing_h
#define MoteSvgDrawing_h

#include "Canvas.h"

#include <string>
#include <utility>
#include <vector>

namespace mote::imaging
{

/**
 * Elements in the order in which they are added. All coordinates are pixels of an image so high, y
 * up; in the elements y goes down, as SVG has it.
 */
class SvgDrawing
{
public:
  using Points = std::vector<std::pair<double, double>>;

  explicit SvgDrawing(int height);

  void addRectangle(const Rect& rect, double radius, const Color& color);
  void addPolygon(const Points& points, const Color& color);
  void addDot(double x, double y, double radius, const Color& color);
  /// A line through points; `dash` is the length of dashes and gaps, 0 for none.
  void addLine(const Points& points, double width, double dash, const Color& color);
  /// The text itself, as wide as the mask's, its pen starting at (x, y).
  void addText(const TextMask& mask, int x, int y, const Color& color);

  /// What is added until endGroup() belongs together, has a name and is cut off at the rectangle.
  void beginGroup(const std::string& name, const Rect& inside);
  void endGroup();

  const std::string& elements() const { return m_elements; }

private:
  std::string points(const Points& points) const;

  int m_height;
  std::string m_elements;
};

} // namespace mote::imaging

#endif
