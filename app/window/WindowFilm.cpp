// Films that the window makes.

#include "Window.h"

#include "base/Text.h"
#include "commands/Animate.h"
#include "commands/Film.h"
#include "stage/Silhouettes.h"

#include <vtkRenderer.h>

namespace mote::app
{

/// Of pictures and films that are saved.
std::array<int, 2> Window::savedSize() const
{
  const std::array<int, 2>& size = this->settings().output.size;
  return size[0] > 0 ? size : this->viewSize();
}

/// Factor on widths in pixels: what is saved looks like the view.
double Window::savedScale() const
{
  return double(this->savedSize()[1]) / std::max(1, this->viewSize()[1]);
}

/// Does work that leaves the stage at other settings and data, and then shows again what is shown
/// now. False where the work failed.
bool Window::doElsewhere(const std::function<void()>& work)
{
  playing_ = false;
  this->recordCamera();
  const Settings before = this->settings();
  const std::vector<double> camera = cameraOf(stage_.renderer()->GetActiveCamera());
  const bool done = this->perform(
    [&]
    {
      stage_.finishBuild(progress_); // a preview is for looking
      this->keepStep();
      loadedStep_ = -1;
      const StepCache::Pause pause(cache_.get());
      const auto restore = [&]
      {
        input_.setKept({});
        bar_.reset();
        stage_.apply(before);
        setCamera(stage_.renderer()->GetActiveCamera(), camera);
        this->load(step_);
      };
      input_.setKept(
        [this](int step) -> std::optional<std::vector<NamedData>>
        {
          const std::vector<double>& times = input_.times();
          return cache_ && !times.empty() ? cache_->original(step, times[step]) : std::nullopt;
        });
      try
      {
        work();
      }
      catch (...)
      {
        restore();
        throw;
      }
      restore();
    });
  this->followProps();
  this->rememberView();
  return done;
}

void Window::saveFilm()
{
  const std::string& asked = this->settings().output.file;
  const std::string file = asked.empty() ? this->unusedName(".ogv") : asked;
  std::string told;
  if (this->doElsewhere([&] { told = this->makeFilm(file); }))
    this->say(told);
}

/// Adds the view that is shown to those that a film goes through, or forgets some; false for what
/// other actions do.
bool Window::changeKeyFrames(Action action)
{
  Settings next = this->settings();
  if (action == Action::AddKeyFrame)
  {
    Settings key = this->settingsInForce();
    key.keyFrames.clear();
    next.keyFrames.push_back(std::move(key));
  }
  else if (action == Action::ForgetKeyFrame && !next.keyFrames.empty())
    next.keyFrames.pop_back();
  else if (action == Action::ForgetKeyFrames)
    next.keyFrames.clear();
  else
    return false;
  this->change(next);
  return true;
}

/// Leaves the stage at the film's last frame. Returns what is to be told of it.
std::string Window::makeFilm(const std::string& file)
{
  const Settings now = this->settingsInForce();
  checkFilmName(file, now.data.files);
  stage_.setPreview(false);
  std::vector<Settings> keys = now.keyFrames;
  if (keys.empty())
    keys = {now};
  for (Settings& key : keys) // of a view that may have had another size
    key.silhouettes =
      scaled(key.silhouettes, double(this->savedSize()[1]) / std::max(1, key.picture.size[1]));
  const std::vector<Settings> frames = framesOf(stage_, input_, keys);
  int step = includeColorsOf(frames, stage_, input_, step_, progress_);
  const std::array<int, 2> size = this->savedSize();
  const FilmResult result = mote::app::makeFilm(stage_, input_, step, frames, file, size, bar_);
  const std::string text =
    filmText(file, size, result.frames, frames.size(), frames.front().film.rate);
  return result.isStopped ? "Stopped: " + (result.frames > 0 ? text : "there is no film")
                          : "Saved " + text;
}

} // namespace mote::app
