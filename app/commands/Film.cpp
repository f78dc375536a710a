#include "Film.h"

#include "Bake.h"
#include "VideoFile.h"
#include "base/Failure.h"
#include "base/OutputFile.h"
#include "base/Text.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <optional>
#include <set>

namespace mote::app
{

namespace
{

using Clock = std::chrono::steady_clock;

/// Tells of frames, and not of what is done for each.
class FilmDisplay : public ProgressDisplay
{
public:
  FilmDisplay(ProgressDisplay& display, std::size_t frames)
    : display_(display)
    , frames_(frames)
  {
  }

  /// The next frame is under way.
  void begin(std::size_t frame)
  {
    frame_ = frame;
    constexpr auto period = std::chrono::milliseconds(80);
    if (Clock::now() - shown_ > period)
      this->show({}, 0.0);
  }

  void show(const std::string&, double share) override
  {
    shown_ = Clock::now();
    const double done = (static_cast<double>(frame_) + share) /
                        static_cast<double>(std::max<std::size_t>(1, frames_));
    std::string what = "Frame " + std::to_string(frame_ + 1) + " of " + std::to_string(frames_);
    const double taken = std::chrono::duration<double>(shown_ - start_).count();
    if (taken > 3.0 && done > 0.0)
      what += ", " + asDuration(taken * (1.0 - done) / done) + " left";
    display_.show(what, done);
  }
  void hide() override {}
  bool wantsStop() override { return display_.wantsStop(); }

private:
  ProgressDisplay& display_;
  std::size_t frames_, frame_ = 0;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point shown_;
};

/// Where the number goes: [first, second) of the name; and its digits.
struct NumberPlace
{
  std::size_t begin = 0, end = 0, digits = 0;
};

std::optional<NumberPlace> numberPlace(const std::string& pattern)
{
  NumberPlace place;
  place.begin = pattern.find('%');
  if (place.begin == pattern.npos || pattern.find('%', place.begin + 1) != pattern.npos)
    return {};
  place.end = place.begin + 1;
  for (; place.end < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[place.end]));
       ++place.end)
    place.digits = std::min<std::size_t>(20, 10 * place.digits + (pattern[place.end] - '0'));
  if (place.end == pattern.size() || pattern[place.end] != 'd')
    return {};
  ++place.end;
  return place;
}

/// Shows a frame's settings and time step.
void showFrame(
  Stage& stage, Input& input, int& step, const Settings& frame, ProgressRelay& progress)
{
  bool isOther = stage.apply(frame);
  if (const int next = input.chosenStep(frame); next != step)
  {
    readStep(stage, input, next, progress);
    step = next;
    isOther = true;
  }
  if (!isOther)
    return;
  stage.build(progress);
  stage.applyColors();
}

} // namespace

void checkFilmName(const std::string& file, const std::vector<std::string>& inputs)
{
  if (!isVideoName(file) && !numberPlace(file))
    throw Failure(file + " is no name of a film, which ends in .ogv, .mp4, .mkv, .webm, .mov, .avi "
                         "or .gif, nor of pictures with a place for their numbers, such as "
                         "frames-%04d.png");
  if (isVideoName(file))
    makeVideoFile(file, {16, 16}, {}); // which says what is missing, and leaves nothing behind
  checkOutput(isVideoName(file) ? file : frameName(file, 1), inputs);
}

std::string frameName(const std::string& pattern, int frame)
{
  const auto place = numberPlace(pattern);
  if (!place)
    return pattern;
  std::string number = std::to_string(frame);
  number.insert(0, place->digits - std::min(place->digits, number.size()), '0');
  return pattern.substr(0, place->begin) + number + pattern.substr(place->end);
}

FilmResult makeFilm(Stage& stage, Input& input, int& step, const std::vector<Settings>& frames,
  const std::string& file, const std::array<int, 2>& size, ProgressDisplay& display)
{
  FilmResult result;
  FilmDisplay shown(display, frames.size());
  ProgressRelay progress;
  progress.add(shown);
  Picture picture(stage, size);
  std::unique_ptr<ParticlePaths> paths;
  const bool isVideo = isVideoName(file);
  std::unique_ptr<VideoFile> video;
  vtkSmartPointer<vtkImageData> last; // of the video
  if (isVideo)
    video = makeVideoFile(file, size, frames.front().film);
  vtkNew<vtkObject> whole;
  ProgressRelay::Work work(progress, "Film", whole); // so that Ctrl-C comes between frames, too
  try
  {
    paths = ParticlePaths::whole(frames.front(), input, progress);
    picture.setPaths(paths.get());
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      shown.begin(i);
      if (shown.wantsStop())
        throw Interrupted();
      work.finish();
      // The frames of one time step are often alike.
      if (last && frames[i] == frames[i - 1])
      {
        video->add(last);
        ++result.frames;
        continue;
      }
      showFrame(stage, input, step, frames[i], progress);
      if (!isVideo)
        picture.aim(frameName(file, result.frames + 1));
      stage.look(picture.aspect(), picture.margins());
      const std::string caption = captionOf(input, step, stage.contents());
      if (isVideo)
        video->add(last = inBytes(picture.draw(caption, progress)));
      else
        picture.write(caption, progress);
      ++result.frames;
    }
  }
  catch (const Interrupted&)
  {
    result.isStopped = true;
  }
  if (video && result.frames > 0)
    video->finish();
  display.hide();
  return result;
}

void includeColors(
  Stage& stage, Input& input, const std::vector<int>& steps, ProgressRelay& progress)
{
  for (const int step : steps)
  {
    stage.setData(input.read(step, progress));
    stage.coloring().include(stage.parts());
  }
}

int includeColorsOf(const std::vector<Settings>& frames, Stage& stage, Input& input, int step,
  ProgressRelay& progress)
{
  const ColorSettings& color = frames.front().color;
  std::set<int> steps;
  for (const Settings& frame : frames)
    steps.insert(input.chosenStep(frame));
  if (steps.size() < 2 || !color.range.empty() || color.array == "none")
    return step;
  stage.apply(frames.front()); // which names the array
  includeColors(stage, input, {steps.begin(), steps.end()}, progress);
  return -1;
}

} // namespace mote::app
