#include "ImageLayers.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/imageio.h>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace mote::imaging
{
namespace
{

std::size_t bytesOf(ChannelType type)
{
  return type == ChannelType::Half ? 2 : 4;
}

/// 64-bit integers of one component from a tuple on; negative ones, "none", as all bits set.
template <typename T>
void readIntegers(const T* values, int stride, int count, std::vector<std::uint64_t>& out)
{
  for (int i = 0; i < count; ++i, values += stride)
  {
    if constexpr (std::is_integral_v<T>)
    {
      const bool none = std::is_signed_v<T> && *values < T(0);
      out[i] = none ? ~std::uint64_t(0) : static_cast<std::uint64_t>(*values);
    }
  }
}

void readIntegers(
  vtkDataArray* array, vtkIdType tuple, int component, int count, std::vector<std::uint64_t>& out)
{
  const int stride = array->GetNumberOfComponents();
  switch (array->GetDataType())
  {
    vtkTemplateMacro(
      readIntegers(static_cast<const VTK_TT*>(array->GetVoidPointer(tuple * stride + component)),
        stride, count, out));
  default: // bits
    for (int i = 0; i < count; ++i)
      out[i] = static_cast<std::uint64_t>(array->GetComponent(tuple + i, component));
  }
}

bool isInteger(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

/// Whether some value does not fit beside ImageLayers::None in 32 bits.
bool needsTwoWords(vtkDataArray* array)
{
  if (array->GetDataTypeSize() < 4)
    return false;
  const vtkIdType count = array->GetNumberOfValues();
  std::vector<std::uint64_t> values(4096);
  // Read as if it had one component.
  for (vtkIdType begin = 0; begin < count; begin += static_cast<vtkIdType>(values.size()))
  {
    const int n = static_cast<int>(std::min<vtkIdType>(values.size(), count - begin));
    switch (array->GetDataType())
    {
      vtkTemplateMacro(
        readIntegers(static_cast<const VTK_TT*>(array->GetVoidPointer(begin)), 1, n, values));
    }
    const auto isLarge = [](std::uint64_t v)
    { return v >= ImageLayers::None && v != ~std::uint64_t(0); };
    if (std::any_of(values.begin(), values.begin() + n, isLarge))
      return true;
  }
  return false;
}

std::string componentName(const std::string& name, int component, int components)
{
  if (components == 1)
    return name;
  return name + "." +
         (components <= 3 ? std::string(1, "XYZ"[component]) : std::to_string(component));
}

/// From the values that a screen shows to light, which is what an EXR holds. Alpha stays, and what
/// it multiplies is brought to light before it.
void toLight(std::vector<float>& colors, int channels)
{
  const bool hasAlpha = channels % 2 == 0;
  const int count = hasAlpha ? channels - 1 : channels;
  for (std::size_t pixel = 0; pixel < colors.size(); pixel += channels)
  {
    const float alpha = hasAlpha ? colors[pixel + count] : 1.0f;
    for (int c = 0; c < count && alpha > 0.0f; ++c)
      colors[pixel + c] = alpha * OIIO::sRGB_to_linear(colors[pixel + c] / alpha);
  }
}

} // namespace

ImageLayers::ImageLayers(vtkImageData* image, vtkDataArray* colors, int width, int height)
  : m_colors(colors, width, height)
  , m_width(width)
  , m_height(height)
{
  addColors();
  vtkPointData* points = image->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i); // null if it does not hold numbers
    if (array && array != colors)
      addArray(array);
  }
}

void ImageLayers::addColors()
{
  const int count = m_colors.channels(AlphaKind::Premultiplied);
  std::vector<std::string> names =
    count < 3 ? std::vector<std::string>{"Y", "A"} : std::vector<std::string>{"R", "G", "B", "A"};
  std::vector<Channel> channels;
  for (int c = 0; c < count; ++c)
    channels.push_back({names[c], ChannelType::Half, nullptr, c, false});
  add(std::move(channels));
}

void ImageLayers::addArray(vtkDataArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  const int components = array->GetNumberOfComponents();
  const bool integer = isInteger(array);
  const bool twoWords = integer && needsTwoWords(array);
  std::vector<Channel> channels;
  for (int c = 0; c < components; ++c)
  {
    const std::string own = componentName(name, c, components);
    if (twoWords)
    {
      channels.push_back({own + ".high", ChannelType::UInt, array, c, true});
      channels.push_back({own + ".low", ChannelType::UInt, array, c, false});
    }
    else if (integer)
    {
      channels.push_back({own, ChannelType::UInt, array, c, false});
    }
    else if (name == "normal" && components == 3)
    {
      channels.push_back({componentName("N", c, 3), ChannelType::Half, array, c, false});
    }
    else
    {
      const bool isDepth = name == "depth" && components == 1;
      channels.push_back({isDepth ? "Z" : own, ChannelType::Float, array, c, false});
    }
  }
  if (name.empty() || !add(std::move(channels)))
    m_leftOut.push_back(name);
}

/// All of them, or none if one of their names is taken.
bool ImageLayers::add(std::vector<Channel> channels)
{
  for (const Channel& channel : channels)
  {
    const auto hasName = [&](const Channel& other) { return other.name == channel.name; };
    if (std::any_of(m_channels.begin(), m_channels.end(), hasName))
      return false;
  }
  for (Channel& channel : channels)
  {
    m_bytesPerPixel += bytesOf(channel.type);
    m_channels.push_back(std::move(channel));
  }
  return true;
}

void ImageLayers::encode(int row, std::uint8_t* out) const
{
  const int colorCount = m_colors.channels(AlphaKind::Premultiplied);
  std::vector<float> colors(static_cast<std::size_t>(m_width) * colorCount);
  m_colors.encode(row, colors.data());
  toLight(colors, colorCount);
  std::vector<float> floats(m_width);
  std::vector<std::uint64_t> integers(m_width);
  std::vector<std::uint8_t> encoded(static_cast<std::size_t>(m_width) * 4);
  const vtkIdType begin = static_cast<vtkIdType>(m_height - 1 - row) * m_width;
  std::size_t offset = 0;
  for (const Channel& channel : m_channels)
  {
    if (channel.type == ChannelType::UInt)
      readIntegers(channel.array, begin, channel.component, m_width, integers);
    for (int x = 0; x < m_width; ++x)
    {
      if (channel.type == ChannelType::UInt)
      {
        const std::uint32_t word =
          static_cast<std::uint32_t>(channel.isHighWord ? integers[x] >> 32 : integers[x]);
        std::memcpy(&encoded[4 * static_cast<std::size_t>(x)], &word, 4);
      }
      else
      {
        floats[x] =
          channel.array
            ? static_cast<float>(channel.array->GetComponent(begin + x, channel.component))
            : colors[static_cast<std::size_t>(x) * colorCount + channel.component];
      }
    }
    if (channel.type != ChannelType::UInt)
    {
      const bool half = channel.type == ChannelType::Half;
      OIIO::convert_pixel_values(OIIO::TypeFloat, floats.data(),
        half ? OIIO::TypeHalf : OIIO::TypeFloat, encoded.data(), m_width);
    }
    const std::size_t size = bytesOf(channel.type);
    for (int x = 0; x < m_width; ++x)
      std::memcpy(out + x * m_bytesPerPixel + offset, &encoded[x * size], size);
    offset += size;
  }
}

} // namespace mote::imaging
