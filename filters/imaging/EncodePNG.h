/**
 * PNG files, through libpng alone: it is loaded with the program, and most pictures are of this
 * kind.
 */

#ifndef MoteEncodePNG_h
#define MoteEncodePNG_h

#include "ImageCodecs.h"

#include <vector>

namespace mote::imaging
{

/// As encodeImage(), which has seen to the size.
std::vector<unsigned char> encodePNG(vtkImageData* image, const EncodeOptions& options);

} // namespace mote::imaging

#endif
