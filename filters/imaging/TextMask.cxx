#include "TextMask.h"

#include <vtkFreeTypeTools.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>

#include FT_OUTLINE_H

namespace mote::imaging
{
namespace
{

/// Opens up what VTK's class keeps for its heirs: the face of its embedded font at some size.
class FontTools : public vtkFreeTypeTools
{
public:
  static FontTools* New()
  {
    auto* tools = new FontTools;
    tools->InitializeObjectBase();
    return tools;
  }
  /// Null if there is no such font. Valid until the next call.
  FT_Face face(vtkTextProperty* property, int size)
  {
    property->SetFontSize(size);
    FT_Size sized = nullptr;
    return this->GetSize(property, &sized) && sized ? sized->face : nullptr;
  }
};

constexpr const char* InstalledFiles[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"};

/// A character as it is drawn: raised and lowered ones are ordinary ones, smaller.
struct Character
{
  std::uint32_t code;
  double scale = 1.0;
  double rise = 0.0; // of the base line, in em
};

Character ordinary(std::uint32_t code)
{
  constexpr double scale = 0.68;
  constexpr double raised = 0.36;
  constexpr double lowered = -0.14;
  const bool isDigit = code == 0x2070 || (code >= 0x2074 && code <= 0x2079);
  if (isDigit)
    return {'0' + code - 0x2070, scale, raised};
  if (code >= 0x2080 && code <= 0x2089)
    return {'0' + code - 0x2080, scale, lowered};
  switch (code)
  {
  case 0xb9:
    return {'1', scale, raised};
  case 0xb2:
    return {'2', scale, raised};
  case 0xb3:
    return {'3', scale, raised};
  case 0x207a:
    return {'+', scale, raised};
  case 0x207b:
    return {0x2212, scale, raised};
  case 0x208a:
    return {'+', scale, lowered};
  case 0x208b:
    return {0x2212, scale, lowered};
  default:
    return {code};
  }
}

void appendUtf8(std::string& text, std::uint32_t code)
{
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x80)
  {
    text += static_cast<char>(code);
  }
  else if (code < 0x800)
  {
    text += static_cast<char>(0xc0 | (code >> 6));
    tail(0);
  }
  else if (code < 0x10000)
  {
    text += static_cast<char>(0xe0 | (code >> 12));
    tail(6);
    tail(0);
  }
  else
  {
    text += static_cast<char>(0xf0 | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// Grows the mask to hold a bitmap whose upper left pixel is at (left, top - 1), and adds it.
void addBitmap(TextMask& mask, const FT_Bitmap& bitmap, int left, int top)
{
  const int width = static_cast<int>(bitmap.width);
  const int height = static_cast<int>(bitmap.rows);
  if (width == 0 || height == 0)
    return;
  TextMask grown;
  const bool isFirst = mask.width == 0;
  grown.left = isFirst ? left : std::min(mask.left, left);
  grown.bottom = isFirst ? top - height : std::min(mask.bottom, top - height);
  grown.width = (isFirst ? left + width : std::max(mask.right(), left + width)) - grown.left;
  grown.height = (isFirst ? top : std::max(mask.top(), top)) - grown.bottom;
  grown.advance = mask.advance;
  grown.coverage.resize(static_cast<std::size_t>(grown.width) * grown.height);
  const auto at = [&](int x, int y) -> std::uint8_t&
  {
    return grown
      .coverage[static_cast<std::size_t>(y - grown.bottom) * grown.width + (x - grown.left)];
  };
  for (int y = 0; y < mask.height; ++y)
  {
    std::copy_n(&mask.coverage[static_cast<std::size_t>(y) * mask.width], mask.width,
      &at(mask.left, mask.bottom + y));
  }
  for (int row = 0; row < height; ++row)
  {
    for (int x = 0; x < width; ++x)
    {
      std::uint8_t& value = at(left + x, top - 1 - row);
      value = std::max(value, bitmap.buffer[row * bitmap.pitch + x]);
    }
  }
  mask = std::move(grown);
}

} // namespace

class TextFont::Implementation
{
public:
  explicit Implementation(const std::string& file)
  {
    addFile(file);
    for (const char* installed : InstalledFiles)
      addFile(installed);
    m_properties.emplace_back(vtkSmartPointer<vtkTextProperty>::New());
    m_properties.back()->SetFontFamilyToArial();
  }

  TextMask lay(const std::string& text, int size, bool draws)
  {
    TextMask mask;
    std::uint32_t previous = 0;
    for (const std::uint32_t code : decodeUtf8(text))
    {
      const Character character = ordinary(code);
      const int characterSize = std::max(1, static_cast<int>(std::lround(size * character.scale)));
      add(mask, character, characterSize, previous, draws, size * character.rise);
      previous = character.scale == 1.0 ? code : 0;
    }
    return mask;
  }

  std::string Missing;

private:
  void addFile(const std::string& file)
  {
    std::error_code error;
    if (!file.empty() && std::filesystem::is_regular_file(file, error))
    {
      m_properties.emplace_back(vtkSmartPointer<vtkTextProperty>::New());
      m_properties.back()->SetFontFamily(VTK_FONT_FILE);
      m_properties.back()->SetFontFile(file.c_str());
    }
  }

  /// The first font that has the character; null, with code '?', if none has.
  FT_Face findFace(std::uint32_t& code, int size)
  {
    for (const auto& property : m_properties)
    {
      const FT_Face face = m_tools->face(property, size);
      if (face && FT_Get_Char_Index(face, code) != 0)
        return face;
    }
    if (code == '?')
      return nullptr;
    appendUtf8(Missing, code);
    code = '?';
    return findFace(code, size);
  }

  void add(TextMask& mask, const Character& character, int size, std::uint32_t previous, bool draws,
    double rise)
  {
    std::uint32_t code = character.code;
    const FT_Face face = findFace(code, size);
    if (!face || FT_Load_Char(face, code, FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT) != 0 ||
        face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
      return;
    FT_Vector kerning{0, 0};
    if (previous != 0 && FT_HAS_KERNING(face))
    {
      FT_Get_Kerning(face, FT_Get_Char_Index(face, previous), FT_Get_Char_Index(face, code),
        FT_KERNING_UNFITTED, &kerning);
    }
    mask.advance += kerning.x / 64.0;
    const double whole = std::floor(mask.advance);
    const int up = static_cast<int>(std::lround(rise));
    if (draws)
    {
      FT_Outline_Translate(
        &face->glyph->outline, static_cast<FT_Pos>(std::lround(64.0 * (mask.advance - whole))), 0);
      if (FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) == 0)
      {
        addBitmap(mask, face->glyph->bitmap, static_cast<int>(whole) + face->glyph->bitmap_left,
          up + face->glyph->bitmap_top);
      }
    }
    mask.advance += face->glyph->linearHoriAdvance / 65536.0;
  }

  vtkNew<FontTools> m_tools;
  std::vector<vtkSmartPointer<vtkTextProperty>> m_properties;
};

TextFont::TextFont(const std::string& file)
  : m_implementation(std::make_unique<Implementation>(file))
{
}

TextFont::~TextFont() = default;

TextMask TextFont::draw(const std::string& text, int size)
{
  TextMask mask = m_implementation->lay(text, size, true);
  mask.text = text;
  mask.size = size;
  return mask;
}

double TextFont::width(const std::string& text, int size)
{
  return m_implementation->lay(text, size, false).advance;
}

const std::string& TextFont::missing() const
{
  return m_implementation->Missing;
}

std::vector<std::uint32_t> decodeUtf8(const std::string& text)
{
  std::vector<std::uint32_t> codes;
  for (std::size_t i = 0; i < text.size();)
  {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xc2 ? 0
                               : lead < 0xe0 ? 2
                               : lead < 0xf0 ? 3
                               : lead < 0xf5 ? 4
                                             : 0;
    std::uint32_t code = length < 2 ? lead : lead & (0x7fu >> length);
    bool isValid = length > 0 && i + length <= text.size();
    for (std::size_t k = 1; isValid && k < length; ++k)
    {
      const auto next = static_cast<unsigned char>(text[i + k]);
      isValid = (next & 0xc0) == 0x80;
      code = (code << 6) | (next & 0x3f);
    }
    codes.push_back(isValid ? code : 0xfffd);
    i += isValid ? length : 1;
  }
  return codes;
}

} // namespace mote::imaging
