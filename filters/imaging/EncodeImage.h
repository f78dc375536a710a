/**
 * Images as the bytes of a file, through OpenImageIO.
 */

#ifndef MoteEncodeImage_h
#define MoteEncodeImage_h

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;

namespace mote::imaging
{

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
 * The whole file, in memory: when OpenImageIO 2.4 writes to a full disk itself, PNG and small EXR
 * files count as written, and JPEG ends the process. `image` has one slice in z. Throws ImageError
 * with the reason alone ("the image has no colours"), for the caller to add the file's name.
 */
EncodedImage encodeImage(vtkImageData* image, FileFormat format, const EncodeOptions& options);

} // namespace mote::imaging

#endif
