#include "PixelColors.h"

#include "ImageError.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <cmath>
#include <string>

namespace mote::imaging
{
namespace
{

float clampToUnit(float value)
{
  return value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f; // NaN becomes 0
}

std::uint8_t toByte(float value)
{
  return static_cast<std::uint8_t>(std::lround(255.0f * clampToUnit(value)));
}

/// One pixel: premultiplied or not, grey in the first of its values where there is only one.
struct Pixel
{
  float color[3] = {0.0f, 0.0f, 0.0f};
  float alpha = 1.0f;
};

} // namespace

vtkDataArray* findColors(vtkImageData* image)
{
  vtkDataArray* colors = image->GetPointData()->GetArray("color");
  colors = colors ? colors : image->GetPointData()->GetScalars();
  if (!colors)
    throw ImageError(vtkErrorCode::FileFormatError, "the image has no colours");
  const int type = colors->GetDataType();
  if (type != VTK_FLOAT && type != VTK_DOUBLE && type != VTK_UNSIGNED_CHAR)
  {
    throw ImageError(vtkErrorCode::FileFormatError,
      std::string("its colours are of type ") + colors->GetDataTypeAsString() +
        ", and must be float, double or unsigned char");
  }
  const int components = colors->GetNumberOfComponents();
  if (components < 1 || components > 4)
  {
    throw ImageError(vtkErrorCode::FileFormatError,
      "its colours have " + std::to_string(components) + " components, and must have 1 to 4");
  }
  return colors;
}

PixelColors::PixelColors(vtkDataArray* colors, int width, int height)
  : m_colors(colors)
  , m_width(width)
  , m_height(height)
  , m_components(colors->GetNumberOfComponents())
  , m_eightBit(colors->GetDataType() == VTK_UNSIGNED_CHAR)
{
  if (m_components % 2 == 0)
  {
    const double opaque = m_eightBit ? 255.0 : 1.0;
    const vtkIdType pixels = static_cast<vtkIdType>(width) * height;
    for (vtkIdType i = 0; i < pixels && !m_transparent; ++i)
      m_transparent = !(colors->GetComponent(i, m_components - 1) >= opaque);
  }
}

int PixelColors::channels(AlphaKind alpha) const
{
  return (m_components < 3 ? 1 : 3) + (m_transparent && alpha != AlphaKind::None ? 1 : 0);
}

template <typename T, typename Convert>
void PixelColors::forEachPixel(int row, T* out, int channels, Convert&& convert) const
{
  const int colorCount = m_components < 3 ? 1 : 3;
  const bool hasAlpha = m_components % 2 == 0;
  const double scale = m_eightBit ? 1.0 / 255.0 : 1.0;
  const vtkIdType begin = static_cast<vtkIdType>(m_height - 1 - row) * m_width;
  double tuple[4];
  for (int x = 0; x < m_width; ++x, out += channels)
  {
    m_colors->GetTuple(begin + x, tuple);
    Pixel pixel;
    for (int c = 0; c < colorCount; ++c)
      pixel.color[c] = static_cast<float>(scale * tuple[c]);
    if (hasAlpha)
      pixel.alpha = clampToUnit(static_cast<float>(scale * tuple[m_components - 1]));
    convert(pixel, out, colorCount);
  }
}

void PixelColors::encode(int row, AlphaKind alpha, std::uint8_t* out) const
{
  const int channelCount = channels(alpha);
  forEachPixel(row, out, channelCount,
    [&](const Pixel& pixel, std::uint8_t* to, int colorCount)
    {
      for (int c = 0; c < colorCount; ++c)
      {
        float value = pixel.color[c];
        if (m_transparent && alpha == AlphaKind::Straight && !m_eightBit)
        {
          value = pixel.alpha > 0.0f ? value / pixel.alpha : 0.0f;
        }
        else if (m_transparent && alpha != AlphaKind::Straight)
        {
          value = m_eightBit ? value * pixel.alpha : value;
          value += alpha == AlphaKind::None ? 1.0f - pixel.alpha : 0.0f;
        }
        to[c] = toByte(value);
      }
      if (channelCount > colorCount)
        to[colorCount] = toByte(pixel.alpha);
    });
}

void PixelColors::encode(int row, float* out) const
{
  const int channelCount = channels(AlphaKind::Premultiplied);
  forEachPixel(row, out, channelCount,
    [&](const Pixel& pixel, float* to, int colorCount)
    {
      for (int c = 0; c < colorCount; ++c)
        to[c] = m_eightBit ? pixel.color[c] * pixel.alpha : pixel.color[c];
      if (channelCount > colorCount)
        to[colorCount] = pixel.alpha;
    });
}

} // namespace mote::imaging
