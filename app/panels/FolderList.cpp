#include "FolderList.h"

#include "base/Text.h"
#include "stage/Input.h"
#include "table/Session.h"

#include <vtkMoteReaderTable.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;

/// Files whose name says nothing, that are opened for their first bytes: more take too long.
constexpr int mostLookedInto = 200;

/// Other programs write .json, too.
bool isSession(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string beginning(64, ' ');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find("\"mote-session\"") != std::string::npos;
}

/// Whether it can be opened. `lookedInto` counts the files that had to be.
bool canOpen(const std::string& path, int& lookedInto)
{
  if (isSessionFile(path))
    return isSession(path);
  return vtkMoteReaderTable::NameTells(path) ||
         (++lookedInto <= mostLookedInto && vtkMoteReaderTable::CheckFile(path).empty());
}

/// "run.9" before "run.10": digits count as numbers.
bool isBefore(const FolderEntry& a, const FolderEntry& b)
{
  if (a.isFolder != b.isFolder)
    return a.isFolder;
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const std::string x = lowerCase(a.name), y = lowerCase(b.name);
  std::size_t i = 0, k = 0;
  while (i < x.size() && k < y.size())
  {
    if (!isDigit(x[i]) || !isDigit(y[k]))
    {
      if (x[i] != y[k])
        return x[i] < y[k];
      ++i, ++k;
      continue;
    }
    const auto numberAt = [&](const std::string& text, std::size_t& at)
    {
      while (at < text.size() && text[at] == '0')
        ++at;
      const std::size_t begin = at;
      while (at < text.size() && isDigit(text[at]))
        ++at;
      return text.substr(begin, at - begin);
    };
    const std::string m = numberAt(x, i), n = numberAt(y, k);
    if (m != n)
      return m.size() != n.size() ? m.size() < n.size() : m < n;
  }
  return x.size() - i != y.size() - k ? x.size() - i < y.size() - k : a.name < b.name;
}

std::uintmax_t sizeOf(const std::vector<std::string>& files)
{
  std::uintmax_t bytes = 0;
  for (const std::string& file : files)
  {
    std::error_code error;
    if (const std::uintmax_t own = fs::file_size(file, error); !error)
      bytes += own;
  }
  return bytes;
}

} // namespace

std::vector<FolderEntry> listFolder(const fs::path& folder, std::string& problem)
{
  problem.clear();
  std::error_code error;
  std::vector<FolderEntry> entries;
  std::vector<std::string> files;
  int lookedInto = 0;
  fs::directory_iterator next(folder, error);
  for (; !error && next != fs::directory_iterator(); next.increment(error))
  {
    std::error_code ignored;
    const std::string name = next->path().filename().string(), path = next->path().string();
    if (name.front() == '.')
      continue;
    if (next->is_directory(ignored))
      entries.push_back({name, {path}, true});
    else if (next->is_regular_file(ignored) && canOpen(path, lookedInto))
      files.push_back(path);
  }
  if (error)
    problem = folder.string() + " cannot be read: " + error.message();
  // What stands for all of an OpenFOAM case, which need not have a file of its own.
  if (const std::string path = folder / "system" / "controlDict"; canOpen(path, lookedInto))
    entries.push_back({"system/controlDict", {path}, false, sizeOf({path})});
  std::sort(files.begin(), files.end());
  for (const auto& group : vtkMoteReaderTable::GroupSeries(files))
    entries.push_back({nameOf(group), group, false, sizeOf(group)});
  std::sort(entries.begin(), entries.end(), isBefore);
  return entries;
}

bool isFound(const std::string& name, const std::string& filter)
{
  const std::string lower = lowerCase(name);
  std::istringstream words(lowerCase(filter));
  for (std::string word; words >> word;)
    if (lower.find(word) == std::string::npos)
      return false;
  return true;
}

} // namespace mote::app
