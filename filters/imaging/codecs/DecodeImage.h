/**
 * Files of images as point arrays, through OpenImageIO.
 */

#ifndef MoteDecodeImage_h
#define MoteDecodeImage_h

#include "ImageCodecs.h"

namespace mote::imaging
{

/// ImageCodecs::readSize().
ImageSize readSize(const std::string& fileName);

/// ImageCodecs::decode().
void decodeImage(const std::string& fileName, vtkImageData* image);

} // namespace mote::imaging

#endif
