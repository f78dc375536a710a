/**
 * Images as the bytes of a file.
 */

#ifndef MoteEncodeImage_h
#define MoteEncodeImage_h

#include "ImageCodecs.h"

namespace mote::imaging
{

/// Throws ImageError as encodeImage() where the library of a format cannot be loaded.
void requireEncoder(FileFormat format);

/**
 * The whole file, in memory, so that a full disk is met by AtomicFile alone. `image` has one slice
 * in z. PNG through libpng, what else there is through OpenImageIO. Throws ImageError with the
 * reason alone ("the image has no colours"), for the caller to add the file's name.
 */
EncodedImage encodeImage(vtkImageData* image, FileFormat format, const EncodeOptions& options);

} // namespace mote::imaging

#endif
