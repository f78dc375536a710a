/**
 * The point arrays of an image as channels of an OpenEXR file.
 */

#ifndef MoteImageLayers_h
#define MoteImageLayers_h

#include "PixelColors.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace mote::imaging
{

/**
 * Type of a channel's values in the file: 2, 4 and 4 bytes.
 */
enum class ChannelType
{
  Half,
  Float,
  UInt
};

struct Channel
{
  std::string name;
  ChannelType type = ChannelType::Float;
  vtkDataArray* array = nullptr; // null for a colour
  int component = 0;             // of the array, or of the colour
  bool isHighWord = false;       // of the 64-bit integer, for UInt
};

/**
 * Which channels an image has, and their rows. The rule is in vtkMoteImageWriter.h.
 */
class ImageLayers
{
public:
  /// The integer that stands for "none" (any negative value) in a UInt channel.
  static constexpr std::uint32_t None = 0xffffffffu;

  /// `colors` is findColors(image). Throws ImageError as that does.
  ImageLayers(vtkImageData* image, vtkDataArray* colors, int width, int height);

  const std::vector<Channel>& channels() const { return m_channels; }
  std::size_t bytesPerPixel() const { return m_bytesPerPixel; }
  /// Names of arrays that are left out, because they have no name or that of another channel.
  const std::vector<std::string>& leftOut() const { return m_leftOut; }

  /// Row `row` from the top, pixel after pixel, channels in order, in the machine's byte order:
  /// width * bytesPerPixel() bytes.
  void encode(int row, std::uint8_t* out) const;

private:
  void addColors();
  void addArray(vtkDataArray* array);
  bool add(std::vector<Channel> channels);

  PixelColors m_colors;
  std::vector<Channel> m_channels;
  std::vector<std::string> m_leftOut;
  std::size_t m_bytesPerPixel = 0;
  int m_width;
  int m_height;
};

} // namespace mote::imaging

#endif
