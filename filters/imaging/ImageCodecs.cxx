#include "ImageCodecs.h"

#include "ImageError.h"

#include <vtkErrorCode.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <dlfcn.h>

namespace mote::imaging
{
namespace
{

/// Beside the library that this is in. Where it does not lie there, the system looks for it.
void* openCodecs()
{
  Dl_info own{};
  if (dladdr(reinterpret_cast<void*>(&imageCodecs), &own) != 0 && own.dli_fname)
  {
    const auto beside = std::filesystem::path(own.dli_fname).replace_filename(MOTE_IMAGE_CODECS);
    std::error_code ignored;
    if (std::filesystem::exists(beside, ignored))
      return dlopen(beside.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  return dlopen(MOTE_IMAGE_CODECS, RTLD_NOW | RTLD_LOCAL);
}

/// It stays loaded: its libraries do not all survive being unloaded.
const ImageCodecs& loadCodecs()
{
  void* library = openCodecs();
  void* entry = library ? dlsym(library, "moteImageCodecs") : nullptr;
  if (!entry)
  {
    const char* reason = dlerror();
    throw ImageError(
      vtkErrorCode::UnknownError, std::string("the library of image formats cannot be loaded: ") +
                                    (reason ? reason : "it is not Mote's"));
  }
  return *reinterpret_cast<const ImageCodecs* (*)()>(entry)();
}

} // namespace

FileFormat formatOf(const std::string& fileName)
{
  std::string ending = std::filesystem::path(fileName).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".png")
    return FileFormat::PNG;
  if (ending == ".jpg" || ending == ".jpeg")
    return FileFormat::JPEG;
  if (ending == ".tif" || ending == ".tiff")
    return FileFormat::TIFF;
  return ending == ".exr" ? FileFormat::EXR : FileFormat::Unknown;
}

const ImageCodecs& imageCodecs()
{
  static const ImageCodecs& codecs = loadCodecs();
  return codecs;
}

} // namespace mote::imaging
