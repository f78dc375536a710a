#pragma once

#include <commands/VideoFile.h>

#include <memory>
#include <string>

class vtkImageData;

namespace mote::app
{

/// A film of pictures, of the size of the first.
class DataFilm
{
public:
  /// Throws Failure for a name that is no film's and where what would write it is missing.
  DataFilm(const std::string& file, double rate, const std::string& quality);

  /// Throws Failure for a picture of another size.
  void add(vtkImageData* image);
  /// Throws Failure where there is no picture.
  void finish();

private:
  std::string file_;
  FilmSettings settings_;
  std::array<int, 2> size_ = {0, 0};
  std::unique_ptr<VideoFile> video_;
};

} // namespace mote::app
