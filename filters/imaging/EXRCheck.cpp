#include "EXRCheck.h"

#include "ImageError.h"

#include <vtkErrorCode.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace mote::imaging
{
namespace
{

constexpr std::uint32_t magic = 20000630, severalParts = 0x1000;
constexpr std::size_t longestName = 256;

[[noreturn]] void fail()
{
  throw ImageError(vtkErrorCode::FileFormatError, "the file is damaged: its header does not fit");
}

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
    if (name == "dataWindow" && type == "box2i" && size == 16)
      this->window();
    file_.seekg(static_cast<std::streamoff>(at + size));
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

} // namespace

std::uint64_t mostOf(std::uint64_t fileBytes)
{
  return std::max<std::uint64_t>(std::uint64_t{16} << 20, 4096 * fileBytes);
}

void checkEXR(const std::string& fileName)
{
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(fileName, error);
  std::ifstream file(fileName, std::ios::binary);
  if (error || !file)
    return;
  Headers headers(file, bytes);
  if (headers.begins())
    headers.check();
}

} // namespace mote::imaging
