#include "EncodeOther.h"

#include "ImageError.h"
#include "ImageLayers.h"
#include "MemoryFile.h"
#include "PixelColors.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>

namespace mote::imaging
{
namespace
{

using EncodeRow = std::function<void(int row, std::uint8_t* out)>;

/// The texts that a TIFF has a place for in its main directory.
constexpr const char* TIFFNames[] = {
  "Software", "ImageDescription", "Artist", "Copyright", "DocumentName", "HostComputer"};

/// Rows that are handed over at once: several blocks of 16, EXR's unit of compression.
constexpr int BatchRows = 64;
/// libjpeg ends the process when asked for more.
constexpr int LargestJPEG = 65500;

[[noreturn]] void failWithLibraryError(const OIIO::ImageOutput* output)
{
  std::string reason = output ? output->geterror() : OIIO::geterror();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  while (!reason.empty() && (reason.back() == ' ' || reason.back() == '.'))
    reason.pop_back();
  throw ImageError(vtkErrorCode::UnknownError,
    reason.empty() ? std::string("the image library gave no reason") : reason);
}

const char* pluginOf(FileFormat format)
{
  switch (format)
  {
  case FileFormat::JPEG:
    return "jpeg";
  case FileFormat::TIFF:
    return "tiff";
  default:
    return "openexr";
  }
}

void setAttributes(OIIO::ImageSpec& spec, FileFormat format, const EncodeOptions& options)
{
  spec.attribute("Software", "Mote " MOTE_VERSION);
  for (const auto& [name, value] : options.attributes)
  {
    // What every format has a place for has this name.
    const bool isDescription = name == "Description" || name == "description";
    const std::string kept = isDescription ? "ImageDescription" : name;
    const auto isKnown = [&](const char* known) { return kept == known; };
    if (format != FileFormat::TIFF ||
        std::any_of(std::begin(TIFFNames), std::end(TIFFNames), isKnown))
      spec.attribute(kept, value);
  }
  if (format != FileFormat::TIFF)
  {
    // In a TIFF this would need an Exif directory, after which libtiff 4.5 does not write the main
    // directory to memory, and says nothing.
    spec.attribute("oiio:ColorSpace", format == FileFormat::EXR ? "Linear" : "sRGB");
  }
  switch (format)
  {
  case FileFormat::JPEG:
    spec.attribute("Compression", "jpeg:" + std::to_string(options.quality));
    // Halved colour resolution would blur text and the edges of small particles.
    spec.attribute("jpeg:subsampling", "4:4:4");
    break;
  default:
    spec.attribute("compression", "zip");
  }
}

/// Whether a TIFF is whole. OpenImageIO 2.4 reports an error (no Exif data) for every good one.
bool canReadBack(const std::vector<unsigned char>& bytes, const OIIO::ImageSpec& spec)
{
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  const auto input = OIIO::ImageInput::open("memory.tif", nullptr, &memory);
  std::vector<std::uint8_t> pixels(spec.image_bytes());
  return input && input->spec().width == spec.width && input->spec().height == spec.height &&
         input->spec().nchannels == spec.nchannels &&
         input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, pixels.data());
}

std::vector<unsigned char> writeRows(
  OIIO::ImageSpec spec, FileFormat format, const EncodeOptions& options, const EncodeRow& encodeRow)
{
  setAttributes(spec, format, options);
  MemoryFile memory; // outlives what writes to it
  std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(pluginOf(format));
  if (!output || !output->supports("ioproxy") || !output->set_ioproxy(&memory) ||
      !output->open(pluginOf(format), spec))
    failWithLibraryError(output.get());
  const std::size_t rowBytes = spec.scanline_bytes(true);
  std::vector<std::uint8_t> batch(rowBytes * std::min(BatchRows, spec.height));
  for (int begin = 0; begin < spec.height; begin += BatchRows)
  {
    const int end = std::min(begin + BatchRows, spec.height);
    for (int row = begin; row < end; ++row)
      encodeRow(row, batch.data() + (row - begin) * rowBytes);
    if (!output->write_scanlines(begin, end, 0, OIIO::TypeUnknown, batch.data()))
      failWithLibraryError(output.get());
    if (options.progress && !options.progress(static_cast<double>(end) / spec.height))
      throw ImageError(vtkErrorCode::UserError, "it was stopped");
  }
  const bool isClosed = output->close();
  const bool isTIFF = format == FileFormat::TIFF;
  std::vector<unsigned char> bytes = memory.takeBytes();
  if (!isClosed || (isTIFF ? !canReadBack(bytes, spec) : output->has_error()))
    failWithLibraryError(output.get());
  output->geterror(); // or the library prints what nobody asked for
  return bytes;
}

EncodedImage encodeBytes(
  vtkDataArray* colors, const int size[2], FileFormat format, const EncodeOptions& options)
{
  const AlphaKind alpha = format == FileFormat::JPEG ? AlphaKind::None : AlphaKind::Premultiplied;
  const PixelColors pixels(colors, size[0], size[1]);
  const int channels = pixels.channels(alpha);
  OIIO::ImageSpec spec(size[0], size[1], channels, OIIO::TypeUInt8);
  spec.alpha_channel = channels % 2 == 0 ? channels - 1 : -1;
  if (channels == 2)
    spec.channelnames = {"Y", "A"};
  const auto encodeRow = [&](int row, std::uint8_t* out) { pixels.encode(row, alpha, out); };
  return {writeRows(spec, format, options, encodeRow), {}};
}

EncodedImage encodeLayers(
  vtkImageData* image, vtkDataArray* colors, const int size[2], const EncodeOptions& options)
{
  const ImageLayers layers(image, colors, size[0], size[1]);
  const int count = static_cast<int>(layers.channels().size());
  OIIO::ImageSpec spec(size[0], size[1], count, OIIO::TypeFloat);
  spec.channelnames.clear();
  for (const Channel& channel : layers.channels())
  {
    const int index = static_cast<int>(spec.channelnames.size());
    spec.alpha_channel = channel.name == "A" ? index : spec.alpha_channel;
    spec.z_channel = channel.name == "Z" ? index : spec.z_channel;
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(channel.type == ChannelType::Half    ? OIIO::TypeHalf
                                  : channel.type == ChannelType::Float ? OIIO::TypeFloat
                                                                       : OIIO::TypeUInt32);
  }
  const auto encodeRow = [&](int row, std::uint8_t* out) { layers.encode(row, out); };
  return {writeRows(spec, FileFormat::EXR, options, encodeRow), layers.leftOut()};
}

} // namespace

EncodedImage encodeOther(vtkImageData* image, FileFormat format, const EncodeOptions& options)
{
  int size[3];
  image->GetDimensions(size);
  if (format == FileFormat::JPEG && std::max(size[0], size[1]) > LargestJPEG)
  {
    throw ImageError(vtkErrorCode::FileFormatError,
      "JPEG images have at most 65500 rows and columns, and this one has " +
        std::to_string(size[1]) + " rows and " + std::to_string(size[0]) + " columns");
  }
  vtkDataArray* colors = findColors(image);
  return format == FileFormat::EXR ? encodeLayers(image, colors, size, options)
                                   : encodeBytes(colors, size, format, options);
}

} // namespace mote::imaging
