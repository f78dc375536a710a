#include "CaseFolder.h"

#include <filesystem>

namespace mote
{

std::string fileOfFolder(const std::string& path)
{
  std::error_code none;
  const std::filesystem::path folder = path;
  for (const char* name : {"index.xml", "system/controlDict"})
    if (std::filesystem::is_regular_file(folder / name, none))
      return (folder / name).string();
  return path;
}

} // namespace mote
