// The library behind imageCodecs(): what it exports is moteImageCodecs().

#include "DecodeImage.h"
#include "EncodeOther.h"

#include "ImageCodecs.h"

namespace mote::imaging
{
namespace
{

class OpenImageCodecs : public ImageCodecs
{
public:
  ImageSize readSize(const std::string& fileName) const override
  {
    return imaging::readSize(fileName);
  }
  void decode(const std::string& fileName, vtkImageData* image) const override
  {
    decodeImage(fileName, image);
  }
  EncodedImage encode(
    vtkImageData* image, FileFormat format, const EncodeOptions& options) const override
  {
    return encodeOther(image, format, options);
  }
};

} // namespace
} // namespace mote::imaging

extern "C" const mote::imaging::ImageCodecs* moteImageCodecs()
{
  static const mote::imaging::OpenImageCodecs codecs;
  return &codecs;
}
