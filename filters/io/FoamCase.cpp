#include "FoamCase.h"

#include "FileError.h"
#include "FoamMesh.h"
#include "TextFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

namespace fs = std::filesystem;

/// The folders in a folder, by name.
std::vector<fs::path> foldersIn(const fs::path& folder)
{
  std::vector<fs::path> all;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory(error))
      all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

/// The time that a folder is of; none for others.
std::optional<double> timeOf(const fs::path& folder)
{
  const std::string name = folder.filename().string();
  double time = 0.0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, time);
  return error == std::errc() && stop == end ? std::optional(time) : std::nullopt;
}

/// The regions of a case that have a mesh: names of folders, which is empty for the whole case.
std::vector<std::string> regionsIn(const fs::path& folder)
{
  std::vector<std::string> regions = {""};
  for (const fs::path& region : foldersIn(folder / "constant"))
    regions.push_back(region.filename().string());
  std::erase_if(regions,
    [&](const std::string& region)
    {
      std::error_code error;
      return !fs::is_directory(folder / "constant" / region / "polyMesh", error);
    });
  return regions;
}

/// The case's own folder, or those of its processors.
std::vector<fs::path> casesIn(const FoamCase& which)
{
  if (!which.isDecomposed)
    return {which.folder};
  std::vector<fs::path> cases = foldersIn(which.folder);
  std::erase_if(
    cases, [](const fs::path& one) { return !one.filename().string().starts_with("processor"); });
  return cases;
}

std::size_t timesIn(const fs::path& folder)
{
  const auto folders = foldersIn(folder);
  return static_cast<std::size_t>(std::count_if(
    folders.begin(), folders.end(), [](const fs::path& one) { return timeOf(one).has_value(); }));
}

/// Throws FileError where a case has a pipe or a device in place of a file, which VTK's reader
/// would wait for.
void requireNoStreams(const fs::path& folder)
{
  std::vector<fs::path> folders = {folder / "constant", folder / "system"};
  for (const fs::path& one : foldersIn(folder))
    if (timeOf(one))
      folders.push_back(one);
  for (const fs::path& one : folders)
  {
    // A simulation that runs may take folders away meanwhile: that ends the look at this one.
    std::error_code error, none;
    fs::recursive_directory_iterator entry(
      one, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
      if (!entry->is_regular_file(none) && !entry->is_directory(none))
        requireNoStream(entry->path().string());
  }
}

} // namespace

FoamCase foamCaseOf(const std::string& fileName)
{
  fs::path folder = fs::path(fileName).parent_path();
  if (folder.empty())
    folder = ".";
  std::error_code error;
  if (!fs::is_directory(folder / "constant", error) && folder.filename() == "system")
    folder = folder / "..";
  const fs::path first = folder / "processor0";
  const bool hasMesh = !regionsIn(folder).empty();
  const bool hasParts = !regionsIn(first).empty();
  if (!hasMesh && !hasParts)
  {
    const auto folders = foldersIn(folder);
    const bool isCollated = std::any_of(folders.begin(), folders.end(),
      [](const fs::path& one) { return one.filename().string().starts_with("processors"); });
    throw FileError(FileError::Kind::NotFound, fileName,
      isCollated ? "the case is decomposed in the collated form, which is not read; reconstructPar "
                   "puts it together"
                 : "there is no mesh beside this file: an OpenFOAM case has it in "
                   "constant/polyMesh");
  }
  requireNoStreams(folder);
  if (hasParts)
    requireNoStreams(first); // others are as that one
  const bool isDecomposed = hasParts && (!hasMesh || timesIn(first) > timesIn(folder));
  return {folder.string(), isDecomposed};
}

namespace
{

/// The folders of times, from the first one to that which is nearest to this time, or else of the
/// first alone.
std::vector<fs::path> foldersUntil(const fs::path& folder, std::optional<double> time)
{
  std::vector<std::pair<double, fs::path>> all;
  for (const fs::path& one : foldersIn(folder))
    if (const auto own = timeOf(one))
      all.emplace_back(*own, one);
  std::sort(all.begin(), all.end());
  const auto away = [&](const auto& one) { return time ? std::abs(one.first - *time) : one.first; };
  const auto nearest = std::min_element(all.begin(), all.end(),
    [&](const auto& one, const auto& other) { return away(one) < away(other); });
  std::vector<fs::path> found;
  for (auto one = all.begin(); one != all.end() && one <= nearest; ++one)
    found.push_back(one->second);
  return found;
}

/// The folders of the time that is nearest to this one, or else of the first: one a case.
std::vector<fs::path> foldersOfTime(const FoamCase& which, std::optional<double> time)
{
  std::vector<fs::path> found;
  for (const fs::path& one : casesIn(which))
    if (const auto folders = foldersUntil(one, time); !folders.empty())
      found.push_back(folders.back());
  return found;
}

} // namespace

std::vector<FoamMesh> foamMeshesOf(const FoamCase& which, std::optional<double> time)
{
  std::vector<FoamMesh> meshes;
  for (const fs::path& one : casesIn(which))
  {
    std::vector<fs::path> folders = foldersUntil(one, time);
    folders.insert(folders.begin(), one / "constant");
    for (const std::string& region : regionsIn(one))
    {
      FoamMesh mesh;
      for (const fs::path& folder : folders)
      {
        const std::string polyMesh = (folder / region / "polyMesh").string();
        const bool isFirst = &folder == &folders.front();
        if (isFirst || findFoamFile(polyMesh, "points"))
          mesh.points = polyMesh;
        if (isFirst || findFoamFile(polyMesh, "faces"))
          mesh.faces = polyMesh;
      }
      meshes.push_back(mesh);
    }
  }
  return meshes;
}

std::vector<std::string> foamFilesOf(const FoamCase& which, std::optional<double> time)
{
  std::vector<std::string> files;
  for (const fs::path& folder : foldersOfTime(which, time))
  {
    // A simulation that runs may take folders away meanwhile: that ends the look at this one.
    std::error_code error, none;
    fs::recursive_directory_iterator entry(
      folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
      if (entry->is_regular_file(none))
        files.push_back(entry->path().string());
  }
  return files;
}

std::vector<std::string> foamFieldsOf(const FoamCase& which, double time)
{
  std::vector<std::string> fields;
  for (const fs::path& nearest : foldersOfTime(which, time))
  {
    std::vector<fs::path> folders = foldersIn(nearest); // of regions
    folders.push_back(nearest);
    std::error_code error;
    for (const fs::path& folder : folders)
      for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.is_regular_file(error))
          fields.push_back(entry.path().string());
  }
  return fields;
}

} // namespace mote
