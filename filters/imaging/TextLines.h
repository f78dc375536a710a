/**
 * Text that wraps, shrinks and is cut to fit a width.
 */

#ifndef MoteTextLines_h
#define MoteTextLines_h

#include "TextMask.h"

#include <string>
#include <vector>

namespace mote::imaging
{

struct TextLines
{
  std::vector<std::string> lines;
  int size = 0; // pixels to the em
};

/**
 * `text` in at most `most` lines no wider than `width` pixels: broken at spaces and line breaks,
 * then in smaller letters down to 70 % of `size` or 8 pixels, then cut off with an ellipsis.
 */
TextLines wrapText(TextFont& font, const std::string& text, int size, double width, int most);

/// `text`, or as much of its beginning as fits the width, with an ellipsis.
std::string cutText(TextFont& font, const std::string& text, int size, double width);

} // namespace mote::imaging

#endif
