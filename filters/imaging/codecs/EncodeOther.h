/**
 * JPEG, TIFF and OpenEXR files in memory, through OpenImageIO.
 */

#ifndef MoteEncodeOther_h
#define MoteEncodeOther_h

#include "ImageCodecs.h"

namespace mote::imaging
{

/// ImageCodecs::encode().
EncodedImage encodeOther(vtkImageData* image, FileFormat format, const EncodeOptions& options);

} // namespace mote::imaging

#endif
