/**
 * What a legend shows, and where on the image each of its parts goes.
 */

#ifndef MoteLegendLayout_h
#define MoteLegendLayout_h

#include "Canvas.h"
#include "TextMask.h"
#include "TickValues.h"

#include <optional>
#include <string>
#include <vector>

namespace mote::imaging
{

struct Category
{
  std::string label;
  Color color;
};

struct LegendContent
{
  std::string title;
  TickSet ticks;                    // of a bar
  std::vector<Category> categories; // instead of a bar, if not empty
  std::optional<Color> below;
  std::optional<Color> above;
  std::optional<Color> nan;
};

enum class SwatchShape
{
  Square,
  Up,  // a triangle: values above the range
  Down // values below the range
};

struct Swatch
{
  Rect rect;
  Color color;
  SwatchShape shape = SwatchShape::Square;
};

struct PlacedText
{
  TextMask mask;
  int x = 0; // of the pen, on the base line
  int y = 0;
};

struct LegendLayout
{
  Rect panel;   // around all the rest
  Rect bar;     // around the colours alone; around the swatches, of categories
  int unit = 0; // the em of the labels, in pixels
  int line = 1; // width of lines, in pixels
  std::vector<Rect> marks;
  std::vector<Swatch> swatches;
  std::vector<PlacedText> texts;
};

/// Rows of the bar of a legend in an image of that height.
int barHeight(int imageHeight);
/// The em of the labels: 2.2 % of the image's height, at least 9 pixels, times `scale`.
int labelSize(int imageWidth, int imageHeight, double scale);

struct Placement
{
  int imageWidth = 0;
  int imageHeight = 0;
  int unit = 0;     // labelSize()
  int reserved = 0; // rows at the bottom that belong to the caption
  bool isLeft = false;
  bool isCaptionOnTop = false;
};

LegendLayout layOutLegend(TextFont& font, const LegendContent& content, const Placement& placement);

/// Lines at the lower left corner, or the upper one.
LegendLayout layOutCaption(TextFont& font, const std::string& text, const Placement& placement);

} // namespace mote::imaging

#endif
