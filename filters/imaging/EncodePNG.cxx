#include "EncodePNG.h"

#include "ImageError.h"
#include "PixelColors.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include <png.h>

namespace mote::imaging
{
namespace
{

/// Rows between two reports of progress.
constexpr int BatchRows = 64;

/**
 * What one file is made from and of. libpng leaves its functions by longjmp() where something
 * fails, past destructors: what has one lies here, outside of the function that calls them.
 */
struct Work
{
  const PixelColors* pixels = nullptr;
  const EncodeOptions* options = nullptr;
  png_uint_32 width = 0, height = 0;
  int channels = 0;
  std::vector<std::uint8_t> row;
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<png_text> entries; ///< point into `texts`
  std::vector<unsigned char> bytes;
  std::array<char, 128> reason{}; ///< no string, which may throw where libpng calls
  bool isStopped = false;
};

/// No exception crosses libpng.
void appendBytes(png_structp png, png_bytep from, std::size_t size)
{
  auto& bytes = static_cast<Work*>(png_get_io_ptr(png))->bytes;
  try
  {
    bytes.insert(bytes.end(), from, from + size);
    return;
  }
  catch (const std::exception&)
  {
  }
  png_error(png, "the image does not fit in memory");
}

void keepReason(png_structp png, png_const_charp reason)
{
  auto& kept = static_cast<Work*>(png_get_error_ptr(png))->reason;
  std::strncpy(kept.data(), reason, kept.size() - 1);
  png_longjmp(png, 1);
}

/// The keyword of PNG for what has one.
std::string keyword(const std::string& name)
{
  if (name == "description" || name == "ImageDescription")
    return "Description";
  return name == "Artist" ? "Author" : name == "DocumentName" ? "Title" : name;
}

void addTexts(Work& work)
{
  work.texts.emplace_back("Software", "Mote " MOTE_VERSION);
  for (const auto& [name, value] : work.options->attributes)
    if (name == "Software")
      work.texts.front().second = value;
    else
      work.texts.emplace_back(keyword(name), value);
  for (auto& [name, value] : work.texts)
  {
    const bool isPlain =
      std::all_of(value.begin(), value.end(), [](unsigned char c) { return c < 128; });
    png_text entry{};
    entry.compression = isPlain ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE; // UTF-8
    entry.key = name.data();
    entry.text = value.data();
    (isPlain ? entry.text_length : entry.itxt_length) = value.size();
    work.entries.push_back(entry);
  }
}

/// All rows; false where it was stopped.
bool writeRows(png_structp png, Work& work)
{
  for (int y = 0, height = static_cast<int>(work.height); y < height; ++y)
  {
    work.pixels->encode(y, AlphaKind::Straight, work.row.data());
    png_write_row(png, work.row.data());
    const bool isBatch = (y + 1) % BatchRows == 0 || y + 1 == height;
    const auto& progress = work.options->progress;
    if (isBatch && progress && !progress(static_cast<double>(y + 1) / height))
      return false;
  }
  return true;
}

/// False where libpng left through keepReason(). Nothing in here has a destructor.
bool writeFile(png_structp png, png_infop info, Work& work)
{
  if (setjmp(png_jmpbuf(png)))
    return false;
  constexpr int types[] = {0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
    PNG_COLOR_TYPE_RGB_ALPHA};
  png_set_write_fn(png, &work, appendBytes, nullptr);
  png_set_IHDR(png, info, work.width, work.height, 8, types[work.channels], PNG_INTERLACE_NONE,
    PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_text(png, info, work.entries.data(), static_cast<int>(work.entries.size()));
  png_write_info(png, info);
  work.isStopped = !writeRows(png, work);
  if (!work.isStopped)
    png_write_end(png, info);
  return true;
}

/// libpng's structures, freed on every way out.
struct Structures
{
  explicit Structures(Work& work)
    : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &work, keepReason,
        [](png_structp, png_const_charp) {})) // warnings are of no use to anybody here
    , info(png ? png_create_info_struct(png) : nullptr)
  {
  }
  Structures(const Structures&) = delete;
  Structures& operator=(const Structures&) = delete;
  ~Structures() { png_destroy_write_struct(&png, &info); }

  png_structp png;
  png_infop info;
};

} // namespace

std::vector<unsigned char> encodePNG(vtkImageData* image, const EncodeOptions& options)
{
  int size[3];
  image->GetDimensions(size);
  const PixelColors pixels(findColors(image), size[0], size[1]);
  Work work;
  work.pixels = &pixels;
  work.options = &options;
  work.width = static_cast<png_uint_32>(size[0]);
  work.height = static_cast<png_uint_32>(size[1]);
  work.channels = pixels.channels(AlphaKind::Straight);
  work.row.resize(static_cast<std::size_t>(size[0]) * work.channels);
  addTexts(work);
  Structures structures(work);
  if (!structures.info || !writeFile(structures.png, structures.info, work))
  {
    throw ImageError(vtkErrorCode::UnknownError,
      work.reason[0] ? work.reason.data() : "the image does not fit in memory");
  }
  if (work.isStopped)
    throw ImageError(vtkErrorCode::UserError, "it was stopped");
  return std::move(work.bytes);
}

} // namespace mote::imaging
