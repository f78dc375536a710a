#include "FollowedFiles.h"

#include <vtkMoteReaderTable.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace mote::app
{

namespace fs = std::filesystem;

FollowedFiles::FollowedFiles(const std::vector<std::string>& files)
  : files_(files)
{
  for (const std::string& file : files_)
    stamps_[file] = stampOf(file);
}

FollowedFiles::Stamp FollowedFiles::stampOf(const std::string& file)
{
  std::error_code gone;
  const auto bytes = fs::file_size(file, gone);
  if (gone)
    return {-1, 0};
  const auto time = fs::last_write_time(file, gone);
  return {static_cast<std::int64_t>(bytes), gone ? 0 : time.time_since_epoch().count()};
}

bool FollowedFiles::lookAgain()
{
  const auto before = stamps_;
  this->addNew();
  for (const std::string& file : files_)
    stamps_[file] = stampOf(file);
  return stamps_ != before;
}

/// Whether a new file is written to its end: VTK's XML says so itself, others have not changed
/// since the last look.
bool FollowedFiles::isWhole(const std::string& file)
{
  const Stamp now = stampOf(file);
  const auto [seen, isNew] = growing_.insert({file, now});
  const bool rests = !isNew && seen->second == now;
  seen->second = now;
  const std::string extension = fs::path(file).extension().string();
  if (extension != ".vtu" && extension != ".vtp" && extension != ".vti")
    return rests && now.first > 0;
  if (std::error_code error; !fs::is_regular_file(file, error))
    return false;
  constexpr std::int64_t tail = 64;
  std::ifstream in(file, std::ios::binary);
  in.seekg(std::max<std::int64_t>(0, now.first - tail));
  const std::string end((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  return end.find("</VTKFile>") != end.npos;
}

void FollowedFiles::addNew()
{
  if (files_.empty())
    return;
  const fs::path folder = fs::path(files_.back()).parent_path();
  const std::string extension = fs::path(files_.back()).extension().string();
  std::vector<std::string> all = files_;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end;
       !error && entry != end; entry.increment(error))
    if (entry->path().extension() == extension)
      if (std::string file = (folder / entry->path().filename()).string();
          std::find(files_.begin(), files_.end(), file) == files_.end())
        all.push_back(std::move(file));
  for (const auto& group : vtkMoteReaderTable::GroupSeries(all))
  {
    const auto last = std::find_if(group.rbegin(), group.rend(),
      [&](const std::string& file)
      { return std::find(files_.begin(), files_.end(), file) != files_.end(); });
    if (last == group.rend())
      continue;
    for (auto file = last.base(); file != group.end() && this->isWhole(*file); ++file)
    {
      files_.push_back(*file);
      growing_.erase(*file);
    }
  }
}

} // namespace mote::app
