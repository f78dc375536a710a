#include "ImageCheck.h"

#include "ImageError.h"

#include <vtkErrorCode.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

namespace mote::imaging
{
namespace
{

constexpr std::uint32_t magic = 20000630, severalParts = 0x1000;
constexpr std::size_t longestName = 256;

[[noreturn]] void fail()
{
  throw ImageError(
    vtkErrorCode::FileFormatError, "the file is damaged, or of a kind that cannot be read");
}

/// Lengths of the kinds of attributes that have one. The library reads so much, whatever the
/// attribute says; what follows would be taken for another thing.
const std::map<std::string, std::uint64_t, std::less<>> lengths = {{"box2i", 16}, {"box2f", 16},
  {"chromaticities", 32}, {"compression", 1}, {"double", 8}, {"envmap", 1}, {"float", 4},
  {"int", 4}, {"keycode", 28}, {"lineOrder", 1}, {"m33f", 36}, {"m33d", 72}, {"m44f", 64},
  {"m44d", 128}, {"rational", 8}, {"tiledesc", 9}, {"timecode", 8}, {"v2i", 8}, {"v2f", 8},
  {"v2d", 16}, {"v3i", 12}, {"v3f", 12}, {"v3d", 24}};

/// Goes through the attributes of the headers. Source: OpenEXR file layout, openexr.com.
class Headers
{
public:
  Headers(std::ifstream& file, std::uint64_t bytes)
    : file_(file)
    , bytes_(bytes)
  {
  }

  bool begins()
  {
    const std::uint32_t first = this->number();
    version_ = this->number();
    return file_.good() && first == magic;
  }

  void check()
  {
    std::string name;
    do
    {
      int attributes = 0;
      while (!(name = this->word()).empty())
      {
        this->attribute(name);
        ++attributes;
      }
      if (attributes == 0)
        return; // after the last of several parts
    } while ((version_ & severalParts) != 0);
  }

private:
  std::uint32_t number()
  {
    std::array<char, 4> text{};
    file_.read(text.data(), text.size());
    std::uint32_t value = 0;
    std::memcpy(&value, text.data(), text.size());
    return value;
  }

  std::string word()
  {
    std::string text;
    for (int c = 0; (c = file_.get()) > 0;)
      if (text.push_back(static_cast<char>(c)); text.size() > longestName)
        fail();
    if (!file_)
      fail();
    return text;
  }

  void attribute(const std::string& name)
  {
    const std::string type = this->word();
    const std::uint64_t size = this->number();
    const auto at = static_cast<std::uint64_t>(file_.tellg());
    if (!file_ || size > bytes_ - std::min(at, bytes_))
      fail();
    if (const auto known = lengths.find(type); known != lengths.end() && size != known->second)
      fail();
    if (name == "dataWindow" && type == "box2i")
      this->window();
    if (type == "preview" && (size < 8 || size - 8 != 4 * this->product()))
      fail();
    if (type == "chlist")
      this->channels(at + size);
    file_.seekg(static_cast<std::streamoff>(at + size));
  }

  std::uint64_t product()
  {
    const std::uint64_t width = this->number();
    return width * this->number();
  }

  /// They end with an empty name, where the attribute does.
  void channels(std::uint64_t end)
  {
    while (!this->word().empty())
      for (int i = 0; i < 4; ++i)
        this->number();
    if (!file_ || static_cast<std::uint64_t>(file_.tellg()) != end)
      fail();
  }

  void window()
  {
    std::array<std::int32_t, 4> sides{};
    for (std::int32_t& side : sides)
      side = static_cast<std::int32_t>(this->number());
    const double width = double(sides[2]) - sides[0] + 1.0;
    const double height = double(sides[3]) - sides[1] + 1.0;
    if (width < 1.0 || height < 1.0 || width * height > static_cast<double>(mostOf(bytes_)))
      fail();
  }

  std::ifstream& file_;
  std::uint64_t bytes_;
  std::uint32_t version_ = 0;
};

/// Whether every chunk ends within the file. Source: PNG specification, w3.org/TR/png.
void checkPNG(std::ifstream& file, std::uint64_t bytes)
{
  std::array<unsigned char, 8> head{};
  for (std::uint64_t at = head.size(); at < bytes;)
  {
    file.seekg(static_cast<std::streamoff>(at));
    if (!file.read(reinterpret_cast<char*>(head.data()), head.size()))
      fail();
    const std::uint64_t length =
      std::uint64_t{head[0]} << 24 | head[1] << 16 | head[2] << 8 | head[3];
    at += length + 12;
    if (at > bytes)
      fail();
    if (std::memcmp(&head[4], "IEND", 4) == 0)
      return;
  }
}

} // namespace

std::uint64_t mostOf(std::uint64_t fileBytes)
{
  return std::max<std::uint64_t>(std::uint64_t{128} << 20, 16384 * fileBytes);
}

void checkImage(const std::string& fileName)
{
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(fileName, error);
  std::ifstream file(fileName, std::ios::binary);
  std::array<char, 8> first{};
  if (error || !file.read(first.data(), first.size()))
    return;
  if (std::memcmp(first.data(), "\x89PNG\r\n\x1a\n", first.size()) == 0)
    return checkPNG(file, bytes);
  file.seekg(0);
  Headers headers(file, bytes);
  if (headers.begins())
    headers.check();
}

} // namespace mote::imaging
