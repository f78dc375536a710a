#include "DecodeImage.h"

#include "ChannelGroups.h"
#include "ImageCheck.h"
#include "ImageError.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/imageio.h>

#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTypeInt64Array.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>

namespace mote::imaging
{
namespace
{

[[noreturn]] void fail(const std::string& reason)
{
  throw ImageError(vtkErrorCode::FileFormatError, reason);
}

std::unique_ptr<OIIO::ImageInput> openImage(const std::string& fileName)
{
  std::error_code ignored;
  if (!std::filesystem::exists(fileName, ignored))
    throw ImageError(vtkErrorCode::FileNotFoundError, "there is no such file");
  if (std::filesystem::is_directory(fileName, ignored))
    throw ImageError(vtkErrorCode::CannotOpenFileError, "it is a folder");
  if (!std::filesystem::is_regular_file(fileName, ignored))
    throw ImageError(vtkErrorCode::CannotOpenFileError, "it is not a regular file");
  checkImage(fileName);
  OIIO::ImageSpec wanted;
  wanted["oiio:UnassociatedAlpha"] = 1; // to multiply by it in floats, not in bytes
  auto input = OIIO::ImageInput::open(fileName, &wanted);
  if (!input)
  {
    OIIO::geterror(); // names the file again, and a version
    fail("it is no image, or of a kind that cannot be read");
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.deep)
    fail("deep images cannot be read");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
    fail("the image is empty");
  if (spec.image_bytes(true) > mostOf(std::filesystem::file_size(fileName, ignored)))
    fail("the file has no room for so many pixels");
  if (spec.depth > 1)
    fail("the image has " + std::to_string(spec.depth) + " slices, and must have one");
  return input;
}

std::vector<ChannelFacts> factsOf(const OIIO::ImageSpec& spec)
{
  std::vector<ChannelFacts> facts;
  for (int c = 0; c < spec.nchannels; ++c)
  {
    const OIIO::TypeDesc type = spec.channelformat(c);
    facts.push_back({spec.channelnames[c], type == OIIO::TypeUInt32, type == OIIO::TypeFloat});
  }
  return facts;
}

/// The pixels of a file as they are in it, top row first.
class NativePixels
{
public:
  explicit NativePixels(OIIO::ImageInput& input)
    : m_spec(input.spec())
    , m_bytes(m_spec.image_bytes(true))
  {
    if (!input.read_image(0, 0, 0, m_spec.nchannels, OIIO::TypeUnknown, m_bytes.data()))
    {
      input.geterror(); // the library's own words, or it prints them
      fail("the file is damaged, or of a kind that cannot be read");
    }
    std::size_t offset = 0;
    for (int c = 0; c < m_spec.nchannels; ++c)
    {
      m_offsets.push_back(offset);
      offset += m_spec.channelformat(c).size();
    }
  }

  const OIIO::ImageSpec& spec() const { return m_spec; }

  /// One channel as T, bottom row first, into every `stride`th value from `out` on. Integers of 8
  /// and 16 bits become floats in [0, 1].
  template <typename T>
  void take(int channel, OIIO::TypeDesc type, T* out, std::size_t stride) const
  {
    const std::size_t pixel = m_spec.pixel_bytes(true), row = pixel * m_spec.width;
    for (int y = 0; y < m_spec.height; ++y, out += stride * m_spec.width)
    {
      const unsigned char* from =
        m_bytes.data() + (m_spec.height - 1 - y) * row + m_offsets[channel];
      OIIO::convert_image(1, m_spec.width, 1, 1, from, m_spec.channelformat(channel),
        static_cast<OIIO::stride_t>(pixel), OIIO::AutoStride, OIIO::AutoStride, out, type,
        static_cast<OIIO::stride_t>(stride * sizeof(T)), OIIO::AutoStride, OIIO::AutoStride);
    }
  }

private:
  OIIO::ImageSpec m_spec;
  std::vector<unsigned char> m_bytes;
  std::vector<std::size_t> m_offsets; // of the channels in a pixel
};

/// Straight colours to premultiplied ones; light to what a screen shows, before that.
void finishColors(const OIIO::ImageSpec& spec, vtkFloatArray* colors)
{
  const bool isLight = spec.get_string_attribute("oiio:ColorSpace") == "Linear";
  const bool isStraight = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  const int components = colors->GetNumberOfComponents();
  const bool hasAlpha = components % 2 == 0;
  const int count = hasAlpha ? components - 1 : components;
  if (!isLight && !(isStraight && hasAlpha))
    return;
  const vtkIdType values = colors->GetNumberOfValues();
  for (float *pixel = colors->GetPointer(0), *end = pixel + values; pixel < end;
       pixel += components)
  {
    const float alpha = hasAlpha ? pixel[count] : 1.0f;
    for (int c = 0; c < count; ++c)
    {
      float value = isStraight || !(alpha > 0.0f) ? pixel[c] : pixel[c] / alpha;
      value = isLight ? OIIO::linear_to_sRGB(value) : value;
      pixel[c] = isStraight || alpha > 0.0f ? value * alpha : value;
    }
  }
}

void addFloats(const NativePixels& pixels, const ChannelGroup& group, vtkImageData* image)
{
  const std::size_t components = group.channels.size();
  vtkNew<vtkFloatArray> array;
  array->SetName(group.name.c_str());
  array->SetNumberOfComponents(static_cast<int>(components));
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  for (std::size_t c = 0; c < components; ++c)
    pixels.take(group.channels[c], OIIO::TypeFloat, array->GetPointer(0) + c, components);
  if (group.kind == ChannelGroup::Kind::Colors)
    finishColors(pixels.spec(), array);
  image->GetPointData()->AddArray(array);
}

/// `none` stands for -1.
void addIntegers(const NativePixels& pixels, const ChannelGroup& group, vtkImageData* image)
{
  constexpr std::uint32_t none = 0xffffffffu;
  const vtkIdType points = image->GetNumberOfPoints();
  const bool halves = group.kind == ChannelGroup::Kind::HalvesOfIntegers;
  const int words = static_cast<int>(group.channels.size()), components = halves ? 1 : words;
  std::vector<std::uint32_t> values(static_cast<std::size_t>(points) * words);
  for (int c = 0; c < words; ++c)
    pixels.take(group.channels[c], OIIO::TypeUInt32, values.data() + c, words);
  vtkNew<vtkTypeInt64Array> array;
  array->SetName(group.name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(points);
  for (vtkIdType i = 0; i < points * components; ++i)
  {
    const std::uint32_t low = values[halves ? 2 * i + 1 : i];
    const std::uint32_t high = halves ? values[2 * i] : (low == none ? none : 0);
    array->SetValue(i, static_cast<std::int64_t>(std::uint64_t(high) << 32 | low));
  }
  image->GetPointData()->AddArray(array);
}

bool areIntegers(const OIIO::ImageSpec& spec, const ChannelGroup& group)
{
  for (const int channel : group.channels)
    if (spec.channelformat(channel) != OIIO::TypeUInt32)
      return false;
  return group.kind != ChannelGroup::Kind::Colors;
}

} // namespace

ImageSize readSize(const std::string& fileName)
{
  const auto input = openImage(fileName);
  return {input->spec().width, input->spec().height};
}

void decodeImage(const std::string& fileName, vtkImageData* image)
{
  const auto input = openImage(fileName);
  const NativePixels pixels(*input);
  const OIIO::ImageSpec& spec = pixels.spec();
  image->Initialize();
  image->SetDimensions(spec.width, spec.height, 1);
  for (const ChannelGroup& group : groupChannels(factsOf(spec)))
    if (areIntegers(spec, group))
      addIntegers(pixels, group, image);
    else
      addFloats(pixels, group, image);
  vtkPointData* points = image->GetPointData();
  points->SetActiveScalars(points->HasArray("color") ? "color" : "depth");
}

} // namespace mote::imaging
