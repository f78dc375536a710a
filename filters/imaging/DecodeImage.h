/**
 * Files of images as point arrays, through OpenImageIO.
 */

#ifndef MoteDecodeImage_h
#define MoteDecodeImage_h

#include <string>

class vtkImageData;

namespace mote::imaging
{

struct ImageSize
{
  int width = 0, height = 0;
};

/// Of the first image of a file. Throws ImageError with the reason alone ("there is no such file"),
/// for the caller to add the file's name.
ImageSize readSize(const std::string& fileName);

/// Gives `image` the size and the arrays of the file's first image; the rule is in
/// vtkMoteImageReader.h. Throws as readSize().
void decodeImage(const std::string& fileName, vtkImageData* image);

} // namespace mote::imaging

#endif
