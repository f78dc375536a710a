// Films that the window makes.

#include "Window.h"

#include "base/Failure.h"
#include "commands/Animate.h"
#include "commands/Film.h"

#include <vtkRenderer.h>

namespace mote::app
{

/// Of pictures and films that are saved.
std::array<int, 2> Window::savedSize() const
{
  const std::array<int, 2>& size = this->settings().output.size;
  return size[0] > 0 ? size : this->viewSize();
}

void Window::saveFilm()
{
  playing_ = false;
  this->recordCamera();
  const Settings before = this->settings();
  const std::string& asked = before.output.file;
  const std::string file = asked.empty() ? this->unusedName(".ogv") : asked;
  const std::vector<double> camera = cameraOf(stage_.renderer()->GetActiveCamera());
  std::string told;
  const bool done = this->perform(
    [&]
    {
      stage_.finishBuild(progress_); // a preview is for looking
      this->keepStep();
      loadedStep_ = -1;
      const StepCache::Pause pause(cache_.get());
      const auto restore = [&]
      {
        bar_.reset();
        stage_.apply(before);
        setCamera(stage_.renderer()->GetActiveCamera(), camera);
        this->load(step_);
      };
      try
      {
        told = this->makeFilm(file);
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
  if (done)
    this->say(told);
}

/// Leaves the stage at the film's last frame. Returns what is to be told of it.
std::string Window::makeFilm(const std::string& file)
{
  const Settings now = this->settingsInForce();
  checkFilmName(file, now.data.files);
  stage_.setPreview(false);
  const std::vector<Settings>& keys = panel_.keyFrames();
  const std::vector<Settings> frames =
    framesOf(stage_, input_, keys.empty() ? std::vector<Settings>{now} : keys);
  int step = includeColorsOf(frames, stage_, input_, step_, progress_);
  const std::array<int, 2> size = this->savedSize();
  const FilmResult result = mote::app::makeFilm(stage_, input_, step, frames, file, size, bar_);
  const std::string text =
    filmText(file, size, result.frames, frames.size(), frames.front().film.rate);
  return result.isStopped ? "Stopped: " + (result.frames > 0 ? text : "there is no film")
                          : "Saved " + text;
}

} // namespace mote::app
