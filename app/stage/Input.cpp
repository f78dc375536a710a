#include "Input.h"

#include "Blocks.h"
#include "BoxFiles.h"
#include "KeptData.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkMoteLAMMPSDumpReader.h>
#include <vtkMotePolyDataReader.h>
#include <vtkMoteReaderTable.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace mote::app
{

std::string nameOf(const std::vector<std::string>& files)
{
  std::string first = baseName(files.front());
  for (const std::string& file : files)
  {
    const std::string other = baseName(file);
    if (other == first)
      continue;
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t begin =
      std::mismatch(first.begin(), first.end(), other.begin(), other.end()).first - first.begin();
    while (begin > 0 && isDigit(first[begin - 1]))
      --begin;
    std::size_t end = begin;
    while (end < first.size() && isDigit(first[end]))
      ++end;
    return first.replace(begin, end - begin, 1, '*');
  }
  return first;
}

namespace
{

/// Throws Failure for what no reader is for.
vtkSmartPointer<vtkAlgorithm> makeReader(const std::vector<std::string>& files)
{
  if (isKeptData(files.front()))
    return producerOfKept(files.front());
  std::string error;
  auto reader = vtkMoteReaderTable::MakeReader(files, error);
  if (!reader)
    throw Failure(error);
  return reader;
}

} // namespace

Input::Input(const std::vector<std::string>& files)
  : files_(files)
{
  std::vector<std::string> ofDisk;
  const auto add = [this](const std::vector<std::string>& group, const std::string& name)
  {
    Source source;
    source.files = group;
    source.name = name;
    source.reader = makeReader(group);
    sources_.push_back(source);
  };
  const auto addDisk = [&]
  {
    for (const auto& group : vtkMoteReaderTable::GroupSeries(ofDisk))
      add(group, nameOf(group));
    ofDisk.clear();
  };
  for (const std::string& file : withoutBoxFiles(files))
  {
    if (!isKeptData(file))
    {
      ofDisk.push_back(file);
      continue;
    }
    addDisk();
    add({file}, nameOfKept(file));
  }
  addDisk();
  tellApart(sources_);
}

/// Files of one name in several folders have of their folders what tells them apart.
void Input::tellApart(std::vector<Source>& sources)
{
  std::map<std::vector<std::string>, std::vector<Source*>> sameFiles; // a file may be there twice
  for (Source& source : sources)
  {
    std::vector<std::string> path;
    if (!isKeptData(source.files.front()))
      for (const auto& word : std::filesystem::absolute(source.files.front()).lexically_normal())
        path.push_back(word.string());
    if (path.empty())
      path.emplace_back();
    path.back() = source.name;
    sameFiles[path].push_back(&source);
  }
  std::vector<std::vector<std::string>> paths;
  for (const auto& [path, same] : sameFiles)
    paths.push_back(path);
  const std::vector<std::string> names = shortestEnds(paths);
  auto name = names.begin();
  for (const auto& [path, same] : sameFiles)
  {
    for (Source* source : same)
      source->name = *name;
    ++name;
  }
}

std::size_t Input::Source::stepAt(double time) const
{
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - times.begin() - 1));
}

const std::string& Input::Source::fileAt(double time) const
{
  const bool fileAStep = !times.empty() && files.size() == times.size();
  return files[fileAStep ? this->stepAt(time) : 0];
}

void Input::setSpace(const std::shared_ptr<ScratchSpace>& space)
{
  for (const Source& source : sources_)
    if (auto* reader = vtkMotePolyDataReader::SafeDownCast(source.reader))
      reader->SetScratchSpace(space);
}

namespace
{

/// Leaves the last step of a dump out where it is damaged and others are not, as where a run was
/// killed while it wrote; and says so.
void leaveOutDamagedEnd(const std::string& name, vtkAlgorithm* reader, std::vector<double>& times)
{
  auto* dump = vtkMoteLAMMPSDumpReader::SafeDownCast(reader);
  if (!dump || dump->GetLeaveOutDamagedEnd() || times.size() < 2)
    return;
  std::string error;
  dump->LeaveOutDamagedEndOn();
  std::vector<double> others = vtkMoteReaderTable::GetTimeSteps(reader, error);
  if (error.empty() && others.size() < times.size() && !others.empty())
  {
    Messages::warn(name + ": the last time step is damaged, as of a run that was stopped while it "
                          "wrote, and is left out");
    times = std::move(others);
    return;
  }
  dump->LeaveOutDamagedEndOff();
  vtkMoteReaderTable::GetTimeSteps(reader, error);
}

} // namespace

void Input::open(ProgressRelay& progress)
{
  times_.clear();
  for (Source& source : sources_)
  {
    std::string error;
    {
      ProgressRelay::Work work(progress, "Scanning " + source.name, source.reader);
      source.times = vtkMoteReaderTable::GetTimeSteps(source.reader, error);
      if (error.empty())
        leaveOutDamagedEnd(source.name, source.reader, source.times);
      work.finish();
    }
    if (!error.empty())
      throw Failure(error);
    times_.insert(times_.end(), source.times.begin(), source.times.end());
  }
  std::sort(times_.begin(), times_.end());
  times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
}

int Input::chosenStep(const Settings& settings) const
{
  const int last = this->numberOfSteps() - 1;
  if (settings.data.time)
  {
    if (times_.empty())
      throw Failure(this->name() + " has no time, so --time means nothing for it");
    if (*settings.data.time < times_.front())
      throw Failure(this->name() + " begins at time " + asNumber(times_.front(), 10) +
                    ", after --time " + asNumber(*settings.data.time, 10));
    const auto after = std::upper_bound(times_.begin(), times_.end(), *settings.data.time);
    return std::max(0, static_cast<int>(after - times_.begin()) - 1);
  }
  if (settings.data.step == "first")
    return 0;
  if (settings.data.step == "last")
    return last;
  double number = 1.0;
  parseNumber(settings.data.step, number);
  if (number > last + 1)
    throw Failure(this->name() + " has " + counted(last + 1, "time step") +
                  ", so there is no --step " + settings.data.step);
  return static_cast<int>(number) - 1;
}

void Input::leaveOutDamagedEnds()
{
  for (const Source& source : sources_)
    if (auto* dump = vtkMoteLAMMPSDumpReader::SafeDownCast(source.reader))
      dump->LeaveOutDamagedEndOn();
}

Input Input::goneOn(const std::vector<std::string>& files, ProgressRelay& progress) const
{
  Input next(files);
  for (std::size_t i = 0; i < next.sources_.size() && i < sources_.size(); ++i)
    if (auto* dump = vtkMoteLAMMPSDumpReader::SafeDownCast(next.sources_[i].reader))
      dump->TakeIndexOf(vtkMoteLAMMPSDumpReader::SafeDownCast(sources_[i].reader));
  next.leaveOutDamagedEnds();
  next.open(progress);
  return next;
}

std::unique_ptr<Input> Input::again() const
{
  std::unique_ptr<Input> other(new Input);
  other->times_ = times_;
  for (const Source& source : sources_)
  {
    other->sources_.push_back(source);
    Source& own = other->sources_.back();
    own.reader = makeReader(source.files);
    if (auto* dump = vtkMoteLAMMPSDumpReader::SafeDownCast(own.reader))
      dump->TakeIndexOf(vtkMoteLAMMPSDumpReader::SafeDownCast(source.reader));
  }
  return other;
}

std::vector<NamedData> Input::read(int step, ProgressRelay& progress)
{
  return this->read(step, progress.runner());
}

std::vector<NamedData> Input::read(int step, const Runner& runner)
{
  if (kept_)
    if (auto kept = kept_(step))
      return *std::move(kept);
  std::vector<NamedData> all;
  for (Source& source : sources_)
  {
    std::string error;
    vtkSmartPointer<vtkDataObject> data;
    runner("Reading " + source.name, source.reader,
      [&]
      {
        data = times_.empty() ? vtkMoteReaderTable::Read(source.reader, error)
                              : vtkMoteReaderTable::Read(source.reader, times_[step], error);
      });
    if (!data)
    {
      source.reader->Modified(); // or it would fail without a look, once the file is there again
      throw Failure(error.empty() ? source.name + " could not be read" : error);
    }
    // The reader writes its next step into the same objects.
    const auto copy = sharingCopy(data);
    const std::size_t first = all.size();
    for (NamedData& one : dataSetsOf(copy, source.name))
      all.push_back(std::move(one));
    const std::string file = source.fileAt(times_.empty() ? 0.0 : times_[step]);
    for (std::size_t i = first; i < all.size(); ++i)
    {
      addBoxOfFile(all[i].data, file);
      all[i].file = source.files.front();
      all[i].fileName = source.name;
      if (!times_.empty())
        all[i].time = times_[step];
      if (source.times.empty())
        continue;
      all[i].step = static_cast<int>(source.stepAt(times_[step]));
      all[i].steps = static_cast<int>(source.times.size());
      all[i].isOwnStep = source.times != times_;
    }
  }
  return all;
}

std::vector<std::pair<std::string, std::optional<double>>> Input::filesAt(int step) const
{
  std::vector<std::pair<std::string, std::optional<double>>> all;
  for (const Source& source : sources_)
  {
    if (source.times.empty())
      all.emplace_back(source.files.front(), std::nullopt);
    else
      all.emplace_back(source.fileAt(times_[step]), source.times[source.stepAt(times_[step])]);
  }
  return all;
}

std::string Input::name() const
{
  const std::string first = sources_.empty() ? "" : sources_.front().name;
  return sources_.size() > 1 ? first + " and " + std::to_string(sources_.size() - 1) + " more"
                             : first;
}

std::string captionOf(const Input& input, int step, const std::string& contents)
{
  std::string caption = input.name() + "   " + contents;
  if (!input.times().empty())
    caption += "   t = " + asNumber(input.times()[step], 10);
  return caption;
}

} // namespace mote::app
