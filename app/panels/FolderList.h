#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mote::app
{

/// A line of a folder's list: a folder, a file, or the files of a series of time steps.
struct FolderEntry
{
  std::string name;               ///< "run.*.dump" for a series
  std::vector<std::string> files; ///< with their full names; of a folder itself
  bool isFolder = false;
  std::uintmax_t bytes = 0;
};

/// The folders and files in a folder that mote can open, sessions among them, in the order of their
/// names, folders first; without those whose name begins with a dot. `problem` says in a sentence
/// why the folder cannot be read.
std::vector<FolderEntry> listFolder(const std::filesystem::path& folder, std::string& problem);

/// Whether all words of `filter` are in the name, in whatever case.
bool isFound(const std::string& name, const std::string& filter);

} // namespace mote::app
