// A simulation that runs: steps are read as they are written.

#include "Window.h"

#include "base/Failure.h"

#include <algorithm>

namespace mote::app
{

namespace
{

constexpr unsigned long followPause = 500; // ms between looks at the files

} // namespace

/// Begins to follow the files, or ends it, as the settings say.
void Window::startFollowing()
{
  if (!this->settings().output.follow || this->isEmpty())
    return followed_.reset();
  if (followed_)
    return;
  followed_.emplace(input_.files());
  input_.leaveOutDamagedEnds();
  this->startTimer(followTimer_, followPause);
}

void Window::watchFiles()
{
  if (!followed_)
    return;
  // Who drags the slider, or anything else, is not disturbed.
  if (!beforeHold_ && wantedStep_ < 0 && followed_->lookAgain())
  {
    std::string problem;
    busy_ = true;
    bar_.reset();
    try
    {
      this->takeNewSteps();
    }
    catch (const Interrupted&)
    {
    }
    catch (const Failure& failure)
    {
      // What was read stays; the files may come back.
      problem = failure.what();
    }
    busy_ = false;
    if (bar_.wantsQuit())
      return this->quit();
    if (!problem.empty() && problem != followProblem_)
      this->say(problem + "; what was read stays");
    followProblem_ = problem;
    this->render();
  }
  this->startTimer(followTimer_, followPause);
}

/// Takes the steps that there are by now; throws, and leaves all as it is, where they cannot be
/// found.
void Window::takeNewSteps()
{
  Input next = input_.goneOn(followed_->files(), progress_);
  const std::vector<double> before = input_.times(), now = next.times();
  const bool same =
    before.size() <= now.size() && std::equal(before.begin(), before.end(), now.begin());
  const bool wasLast = step_ + 1 == input_.numberOfSteps();
  input_ = std::move(next);
  Settings present = this->settings();
  present.data.files = input_.files();
  stage_.apply(present);
  this->note(RecordedEvent::Kind::Pass, present);
  const int last = input_.numberOfSteps() - 1;
  if (!cache_)
    this->startCache();
  else
    cache_->setInput(input_.again(), same);
  this->followPaths();
  if (overTime_)
    this->readOverTime(overTime_->followed());
  if (!same)
  {
    loadedStep_ = -1; // there are others by these numbers
    this->say("The files have other time steps now");
    this->follow(this->withStep(std::min(step_, last)));
    if (loadedStep_ < 0)
      this->load(std::min(step_, last));
  }
  else if (wasLast && now.size() > before.size() && !playing_)
    this->follow(this->withStep(last));
}

} // namespace mote::app
