#include "EncodeImage.h"

#include "EncodePNG.h"
#include "ImageError.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>

namespace mote::imaging
{

void requireEncoder(FileFormat format)
{
  if (format != FileFormat::PNG)
    imageCodecs();
}

EncodedImage encodeImage(vtkImageData* image, FileFormat format, const EncodeOptions& options)
{
  int size[3];
  image->GetDimensions(size);
  if (size[0] < 1 || size[1] < 1 || size[2] < 1)
    throw ImageError(vtkErrorCode::FileFormatError, "the image is empty");
  if (size[2] > 1)
  {
    throw ImageError(vtkErrorCode::FileFormatError,
      "the image has " + std::to_string(size[2]) + " slices, and must have one");
  }
  if (format == FileFormat::PNG)
    return {encodePNG(image, options), {}};
  return imageCodecs().encode(image, format, options);
}

} // namespace mote::imaging
