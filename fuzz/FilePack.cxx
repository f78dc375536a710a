#include "FilePack.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

namespace
{

bool isUsual(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("._-/").find(c) != std::string_view::npos;
}

/// Whether a name stays within the folder and names a file.
bool isFine(const std::filesystem::path& name)
{
  const std::string text = name.string();
  return !text.empty() && text.size() <= 60 && name.is_relative() && name.has_filename() &&
         std::all_of(text.begin(), text.end(), isUsual) &&
         std::none_of(name.begin(), name.end(), [](const auto& part) { return part == ".."; });
}

} // namespace

std::string packed(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string pack;
  for (const auto& file : files)
  {
    pack += packMark;
    pack += file.lexically_relative(folder).string() + "\n";
    std::ifstream stream(file, std::ios::binary);
    pack.append(std::istreambuf_iterator<char>(stream), {});
  }
  return pack;
}

void unpack(std::string_view pack, const std::filesystem::path& folder)
{
  constexpr int most = 40;
  std::size_t at = pack.find(packMark);
  for (int count = 0; at != pack.npos && count < most; ++count)
  {
    at += packMark.size();
    const std::size_t next = pack.find(packMark, at);
    const std::string_view whole = pack.substr(at, next == pack.npos ? next : next - at);
    at = next;
    const std::size_t lineEnd = whole.find('\n');
    const std::filesystem::path name(whole.substr(0, lineEnd));
    if (lineEnd == whole.npos || !isFine(name))
      continue;
    const std::string_view content = whole.substr(lineEnd + 1);
    // A folder may be in a file's place, and the other way round: then there is no such file.
    std::error_code error;
    std::filesystem::create_directories((folder / name).parent_path(), error);
    std::ofstream stream(folder / name, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  }
}
