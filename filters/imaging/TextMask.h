/**
 * Lines of text as antialiased coverage, through FreeType alone.
 */

#ifndef MoteTextMask_h
#define MoteTextMask_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace mote::imaging
{

/**
 * Coverage of a line of text, its pen starting at pixel (0, 0) on the base line, y up.
 */
struct TextMask
{
  int left = 0;   // of the first column
  int bottom = 0; // of the first row
  int width = 0;
  int height = 0;
  double advance = 0.0;               // of the pen, in pixels
  std::vector<std::uint8_t> coverage; // 0 to 255, row after row from the bottom
  std::string text;                   // what it says
  int size = 0;                       // pixels to the em
  bool isTurned = false;              // whether the pen goes up

  int right() const { return left + width; }
  int top() const { return bottom + height; }
};

/**
 * The font of a file, or DejaVu Sans where that is installed (as on every Debian with VTK), or the
 * sans serif font that VTK carries; the next one in this order where a font lacks a character.
 * Raised and lowered digits are made from ordinary ones; what no font has is drawn as a
 * question mark and named by missing().
 *
 * VTK's own RenderString leaves out every character beyond ASCII in 9.1.
 */
class TextFont
{
public:
  /// `file` is a TrueType or Type 1 font, or empty.
  explicit TextFont(const std::string& file);
  ~TextFont();

  /// One line of UTF-8, `size` pixels to the em.
  TextMask draw(const std::string& text, int size);
  /// Pixels that the pen moves.
  double width(const std::string& text, int size);
  /// Characters of all texts so far that no font has.
  const std::string& missing() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

/// The code points of UTF-8; what is not UTF-8 becomes U+FFFD.
std::vector<std::uint32_t> decodeUtf8(const std::string& text);

} // namespace mote::imaging

#endif
