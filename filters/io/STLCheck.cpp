#include "STLCheck.h"

#include "FileError.h"
#include "TextFile.h"

#include <algorithm>
#include <cstdint>

namespace mote
{
namespace
{

constexpr std::size_t headBytes = 84;     ///< 80 of any text, and the number of triangles
constexpr std::size_t triangleBytes = 50; ///< a normal, three corners, two bytes more

/// As vtkSTLReader tells text from bytes: fewer than a twentieth of the first 256 are no text.
bool isText(std::string_view bytes)
{
  const std::string_view first = bytes.substr(0, 256);
  const auto isOther = [](char c)
  { return (c < ' ' && c != '\n' && c != '\r' && c != '\t') || static_cast<signed char>(c) < 0; };
  const auto others = std::count_if(first.begin(), first.end(), isOther);
  return 20 * static_cast<std::size_t>(others) < first.size();
}

} // namespace

void checkSTL(const std::string& path)
{
  const TextFile file(path);
  const std::string_view bytes = file.text();
  if (isText(bytes) || bytes.size() < headBytes)
    return; // of which the reader says what is wrong
  std::uint64_t triangles = 0;
  for (std::size_t i = 0; i < 4; ++i)
    triangles |= std::uint64_t{static_cast<unsigned char>(bytes[80 + i])} << (8 * i);
  const std::uint64_t most = (bytes.size() - headBytes) / triangleBytes;
  if (triangles > most)
  {
    throw FileError(FileError::Kind::Truncated, path,
      "the file announces " + std::to_string(triangles) + " triangles and has room for " +
        std::to_string(most) + ": it is truncated");
  }
}

} // namespace mote
