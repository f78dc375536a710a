#pragma once

#include "settings/Settings.h"

#include <array>
#include <memory>
#include <string>

class vtkImageData;

namespace mote::app
{

/// A film that grows by a frame at a time. It lies under another name beside its own until it is
/// finished, and is gone where it never is.
class VideoFile
{
public:
  virtual ~VideoFile() = default;

  /// Appends an image of three bytes a pixel, of the film's size. Throws Failure.
  virtual void add(vtkImageData* image) = 0;

  /// Closes the file, with the frames that there are, and gives it its name. Throws Failure.
  virtual void finish() = 0;
};

/// Begins a film. Its ending decides how: .ogv by VTK, others by ffmpeg. Throws Failure for
/// endings that are none of a film, and where ffmpeg is missing.
std::unique_ptr<VideoFile> makeVideoFile(
  const std::string& file, const std::array<int, 2>& size, const FilmSettings& film);

/// Whether the name is a film's, by its ending.
bool isVideoName(const std::string& file);

/// Whether the program ffmpeg is there.
bool hasFfmpeg();

} // namespace mote::app
