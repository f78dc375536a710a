#pragma once

#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;

namespace mote
{
class ScratchSpace;
} // namespace mote

namespace mote::app
{

/// One data set of a file, with the name to show for it.
struct NamedData
{
  std::string name;
  vtkSmartPointer<vtkDataSet> data;
  std::string file = {}; ///< that it is from, the first one of a series
  int step = 0;          ///< among those of the file
  int steps = 1;
  bool isOwnStep = false; ///< as files with other times are beside this one
  std::string block = {}; ///< what it is called in its file; empty where it is the file's only one
  std::string fileName = {};       ///< what the file, or the series, is called
  bool isBoundary = false;         ///< a surface beside a volume in the same file
  std::optional<double> time = {}; ///< of the step that is shown; none where there is no time
};

/// The files of one command line: their readers, and the time steps of all of them together. Every
/// member function throws Failure with a sentence if something cannot be read, and Interrupted.
class Input
{
public:
  /// Recognises the files; reads nothing.
  explicit Input(const std::vector<std::string>& files);

  /// Has the readers of text put what they read there rather than on the heap (see
  /// vtkMotePolyDataReader), before any reading.
  void setSpace(const std::shared_ptr<ScratchSpace>& space);

  /// Finds the time steps, which may mean to read through the files.
  void open(ProgressRelay& progress);

  /// Ascending; empty where no file has time.
  const std::vector<double>& times() const { return times_; }
  int numberOfSteps() const { return times_.empty() ? 1 : static_cast<int>(times_.size()); }

  /// The index of the step that --step and --time ask for.
  int chosenStep(const Settings& settings) const;

  /// All data sets at a step; of composite data every leaf.
  std::vector<NamedData> read(int step, ProgressRelay& progress);
  std::vector<NamedData> read(int step, const Runner& runner);

  /// What has been read of a step and is still kept, as data objects of the caller's own; none
  /// where it is not.
  using Kept = std::function<std::optional<std::vector<NamedData>>(int step)>;
  /// Has read() ask there first.
  void setKept(Kept kept) { kept_ = std::move(kept); }

  /// The same and new files, of a simulation that goes on: opened, with what is known of those that
  /// have only grown. A last step that is half written is left out. Throws Failure and Interrupted.
  Input goneOn(const std::vector<std::string>& files, ProgressRelay& progress) const;
  /// Has open() leave out steps that are half written, at the ends of files.
  void leaveOutDamagedEnds();

  /// The same files with readers of their own, for another thread; to be called where this is open
  /// and not at work.
  std::unique_ptr<Input> again() const;

  /// For each reader the file with a step, and the time to ask for where files have times.
  std::vector<std::pair<std::string, std::optional<double>>> filesAt(int step) const;

  /// The first file's name without folders, a series' with a "*"; "and 2 more" where there are.
  std::string name() const;

  /// The files as they were given.
  const std::vector<std::string>& files() const { return files_; }

private:
  Input() = default;

  struct Source
  {
    std::vector<std::string> files;
    std::string name;
    vtkSmartPointer<vtkAlgorithm> reader;
    std::vector<double> times;

    std::size_t stepAt(double time) const; ///< the last one that is not later, or the first
    const std::string& fileAt(double time) const;
  };
  static void tellApart(std::vector<Source>& sources);

  std::vector<std::string> files_;
  std::vector<Source> sources_;
  std::vector<double> times_;
  Kept kept_;
};

/// What a file is called, without folders; a series as "peri.*.dump".
std::string nameOf(const std::vector<std::string>& files);

/// The line below a picture of a step, where none is given: the input, what is shown, the time.
std::string captionOf(const Input& input, int step, const std::string& contents);

} // namespace mote::app
