#pragma once

#include <stage/Picture.h>
#include <stage/Stage.h>

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

// What the functions of the package `mote` are made of: the program's stage, files, window and
// settings, for data that a Python program holds. Settings are the JSON text of an object of names,
// as the command line has them, and values. All throws WrongSetting, Failure and Interrupted.

namespace mote::app
{

/// A setting that there is not, or a value that it cannot take.
struct WrongSetting
{
  std::string sentence;
  bool isUnknown = false;
};

/// Data with the name to show for them.
struct GivenData
{
  std::string name;
  vtkSmartPointer<vtkDataObject> data;
};

struct DrawnImage
{
  vtkSmartPointer<vtkImageData> image;
  std::string contents;   ///< "84,270 particles"
  double traceTime = 0.0; ///< s
  std::vector<std::string> warnings;
};

/// Draws data, and keeps what was built of them for the next picture.
class DataView
{
public:
  DataView();
  ~DataView();

  /// The picture that `mote render` makes of such data; written to a file, too, where one is named.
  DrawnImage draw(
    const std::vector<GivenData>& data, const std::string& settings, const std::string& output);

private:
  void show(const std::vector<GivenData>& data, const Settings& settings);

  std::mutex mutex_; ///< of both, should threads draw one scene
  std::unique_ptr<Stage> stage_;
  std::vector<std::pair<vtkSmartPointer<vtkDataObject>, vtkMTimeType>> shown_;
};

/// The files of a scene, opened.
class DataFiles
{
public:
  DataFiles(const std::vector<std::string>& names, std::vector<std::string>& warnings);

  /// Of the steps; empty where no file has time.
  const std::vector<double>& times() const { return input_->times(); }

  /// What is there at a step, from 0.
  std::vector<GivenData> read(int step, std::vector<std::string>& warnings);

private:
  std::unique_ptr<Input> input_;
};

/// Opens a window on files and on data, and returns when the user closes it.
void showData(const std::vector<GivenData>& data, const std::vector<std::string>& files,
  const std::string& settings);

/// Every setting of pictures and of the window, as the JSON text of a list of objects: group, name,
/// command, help, values, usual, shape.
std::string settingsAsJson();

} // namespace mote::app
