#include "DataFilm.h"

#include <base/Failure.h>

#include <vtkImageData.h>

#include <cmath>

namespace mote::app
{

DataFilm::DataFilm(const std::string& file, double rate, const std::string& quality)
  : file_(file)
{
  if (!isVideoName(file))
    throw Failure(file +
                  " is no name of a film; they end in .ogv, .mp4, .mkv, .webm, .mov, .avi or "
                  ".gif");
  if (!(rate >= 1.0 && rate <= 240.0))
    throw Failure("a film has from 1 to 240 frames a second");
  if (quality != "low" && quality != "medium" && quality != "high")
    throw Failure("the quality of a film is low, medium or high, not " + quality);
  settings_.rate = static_cast<int>(std::lround(rate));
  settings_.quality = quality;
}

void DataFilm::add(vtkImageData* image)
{
  const std::array<int, 2> size = {image->GetDimensions()[0], image->GetDimensions()[1]};
  if (!video_)
  {
    video_ = makeVideoFile(file_, size, settings_);
    size_ = size;
  }
  if (size != size_)
    throw Failure("all pictures of a film have one size");
  video_->add(image);
}

void DataFilm::finish()
{
  if (!video_)
    throw Failure("a film has one picture at least");
  video_->finish();
}

} // namespace mote::app
