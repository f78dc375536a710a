/**
 * Files of images other than written PNG, through a library that is loaded with the first of them.
 */

#ifndef MoteImageCodecs_h
#define MoteImageCodecs_h

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;

namespace mote::imaging
{

struct ImageSize
{
  int width = 0, height = 0;
};

enum class FileFormat
{
  Unknown,
  PNG,
  JPEG,
  TIFF,
  EXR
};

/// By the name's ending, in upper or lower case.
FileFormat formatOf(const std::string& fileName);

struct EncodeOptions
{
  int quality = 95; // of JPEG, in [1, 100]
  std::vector<std::pair<std::string, std::string>> attributes;
  /// Called with the share done, in [0, 1]; false stops the work.
  std::function<bool(double)> progress;
};

struct EncodedImage
{
  std::vector<unsigned char> bytes;
  /// Names of arrays for which the file has no place.
  std::vector<std::string> leftOut;
};

/**
 * What OpenImageIO does. It brings 180 libraries (OpenCV, GDAL, FFmpeg ...), which take four times
 * as long to load as all else that the program needs. So the folder codecs is a library of its own.
 * It is loaded when an image is first read, or first written as anything but PNG.
 */
class ImageCodecs
{
public:
  virtual ~ImageCodecs() = default;

  /// Of the first image of a file. Throws ImageError with the reason alone ("there is no such
  /// file"), for the caller to add the file's name.
  virtual ImageSize readSize(const std::string& fileName) const = 0;

  /// Gives `image` the size and the arrays of the file's first image; the rule is in
  /// vtkMoteImageReader.h. Throws as readSize().
  virtual void decode(const std::string& fileName, vtkImageData* image) const = 0;

  /**
   * The whole file, of any format but PNG, in memory: when OpenImageIO 2.4 writes to a full disk
   * itself, small EXR files count as written, and JPEG ends the process. Of encodeImage(), which
   * has seen to the size, and says what is thrown.
   */
  virtual EncodedImage encode(
    vtkImageData* image, FileFormat format, const EncodeOptions& options) const = 0;
};

/// Loads them at the first call, from any thread. Throws ImageError where they cannot be loaded;
/// the next call tries again.
const ImageCodecs& imageCodecs();

} // namespace mote::imaging

#endif
