// Time in the window: steps are shown, played, scrubbed and read ahead.

#include "Window.h"

#include "base/Failure.h"
#include "base/Text.h"
#include "commands/Bake.h"
#include "table/Row.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>
#include <utility>

namespace mote::app
{

namespace
{

constexpr unsigned long leastPause = 15;  // ms between time steps, for what the user does
constexpr unsigned long scrubPause = 40;  // ms between looks for the step that is wanted
constexpr unsigned long pathPause = 150;  // ms between looks at the paths that are read
constexpr unsigned long cachePause = 250; // ms between looks at what is read ahead

} // namespace

void Window::load(int step)
{
  const double start = vtkTimerLog::GetUniversalTime();
  this->keepStep();
  stage_.stopBuild();
  loadedStep_ = -1;
  const PickedSet::Names names = picked_.names(stage_.parts());
  if (cache_ && cache_->isReading(step))
    this->awaitStep(step);
  if (const auto ready = cache_ ? cache_->take(step) : std::nullopt)
    stage_.setData(ready->original, &*ready);
  else
  {
    const StepCache::Pause pause(cache_.get());
    const auto data = input_.read(step, progress_);
    addOcclusionMaps(data);
    stage_.setData(data);
  }
  picked_.findAgain(stage_.parts(), names);
  this->tellPickedAgain();
  // What plays would go on to the next step before it is built.
  stage_.setPreview(asked_.output.preview && !playing_);
  if (step != step_)
    direction_ = step > step_ ? 1 : -1;
  step_ = step;
  {
    const StepCache::Pause pause(cache_.get());
    stage_.build(progress_);
  }
  stage_.applyColors();
  loadedStep_ = step;
  frameTime_.loaded(vtkTimerLog::GetUniversalTime() - start);
  if (cache_)
    cache_->setPlace(step_, playing_ ? 1 : direction_, playing_ && this->settings().output.loop);
}

/// What is shown is there again when the user comes back.
void Window::keepStep()
{
  if (cache_ && loadedStep_ >= 0)
    cache_->keep(loadedStep_, stage_.ready());
}

/// Waits for a step that is being read ahead. Throws Interrupted.
void Window::awaitStep(int step)
{
  vtkNew<vtkObject> waiting;
  const ProgressRelay::Work work(progress_, "Reading " + input_.name(), waiting);
  cache_->want(step);
  while (!cache_->wait(step, 0.02))
  {
    double share = cache_->share();
    waiting->InvokeEvent(vtkCommand::ProgressEvent, &share);
    work.finish();
  }
  cache_->want(-1);
}

void Window::startCache()
{
  cacheSize_ = this->settings().output.cache;
  const std::uint64_t budget = memoryOf(cacheSize_).value_or(0);
  if (budget == 0 || input_.numberOfSteps() < 2)
    return;
  cache_ = std::make_shared<StepCache>(budget, addOcclusionMaps);
  cache_->setPlace(step_, direction_, false);
  cache_->setInput(input_.again(), true);
  this->planCache();
  this->startTimer(cacheTimer_, cachePause);
}

void Window::endCache()
{
  cache_.reset();
  cacheShown_ = {};
  loadedStep_ = -1;
  wantedStep_ = -1;
}

/// Tells how steps are to be built that are read ahead.
void Window::planCache()
{
  if (cacheSize_ != this->settings().output.cache)
  {
    wantedStep_ = -1;
    cache_.reset();
    cacheShown_ = {};
    return this->startCache();
  }
  if (cache_ && loadedStep_ >= 0)
    cache_->setPlan(stage_.readyPlan());
}

void Window::goTo(int step)
{
  playing_ = false;
  if (step < 0 || step >= input_.numberOfSteps())
    this->say(input_.numberOfSteps() == 1 ? "There is one time step only"
              : step < 0                  ? "This is the first time step"
                                          : "This is the last time step");
  else
    this->change(this->withStep(step));
}

void Window::play()
{
  playing_ = !playing_ && input_.numberOfSteps() > 1;
  if (!playing_)
    return this->render();
  history_.add(this->settingsAsSeen());
  // Who begins at the end means to see all.
  if (step_ + 1 == input_.numberOfSteps() && !this->settings().output.loop)
    this->follow(this->withStep(0));
  stepTime_ = 0.0;
  stepStart_ = vtkTimerLog::GetUniversalTime();
  if (!player_) // which has the steps
    this->advance();
}

void Window::advance()
{
  const OutputSettings& wanted = this->settings().output;
  const int steps = input_.numberOfSteps();
  playing_ = playing_ && (wanted.loop || step_ + 1 < steps);
  const int next = (step_ + 1) % steps;
  if (playing_ && cache_ && cache_->isReading(next))
  {
    // The last step stays in sight, and the window answers.
    cache_->want(next);
    return this->startTimer(playTimer_, leastPause);
  }
  const double start = vtkTimerLog::GetUniversalTime();
  const bool goesOn = playing_ && this->follow(this->withStep(next));
  if (cache_)
    cache_->want(-1);
  stepTime_ = 0.5 * (stepTime_ + start - std::exchange(stepStart_, start));
  this->render();
  const double taken = vtkTimerLog::GetUniversalTime() - start;
  const double rest = std::round(1000.0 * (1.0 / wanted.speed - taken));
  if (goesOn)
    this->startTimer(
      playTimer_, std::max(leastPause, static_cast<unsigned long>(std::max(0.0, rest))));
}

/// While the slider is dragged: shows the nearest step that is there, until the one that is wanted
/// is read.
void Window::scrub(Settings next, int step)
{
  wantedStep_ = step;
  cache_->want(step);
  const int nearest = cache_->nearest(step);
  const bool isNearer = nearest >= 0 && std::abs(nearest - step) < std::abs(step_ - step);
  next.data.step = std::to_string((isNearer ? nearest : step_) + 1);
  if (next != this->settings())
    this->follow(next);
  this->startTimer(cacheTimer_, scrubPause);
  this->renderMoving();
}

/// The slider was let go of: what it asked for is shown.
void Window::endScrub()
{
  if (const int step = std::exchange(wantedStep_, -1); step >= 0)
  {
    this->follow(this->withStep(step));
    cache_->want(-1);
    this->render();
  }
}

/// Shows the paths of what is picked; none where those are shown, or nothing is picked.
void Window::changePaths()
{
  const IdRanges present = this->settings().marks.trajectories;
  const IdRanges picked = picked_.particleIds(stage_.parts());
  if (picked.empty() && present.empty())
    return this->say("Pick particles first: their paths through time are shown then");
  const IdRanges next = picked == present ? IdRanges() : picked;
  this->change(this->settingsOf([&](Settings& s) { s.marks.trajectories = next; }),
    [&]
    {
      return next.empty() ? "No paths are shown"
                          : "The paths of " + counted(next.count(), "particle");
    });
}

/// Reads the paths that the settings ask for.
void Window::followPaths()
{
  paths_.follow(this->settings(), input_, cache_);
  if (paths_.isReading())
    this->startTimer(pathTimer_, pathPause);
  else
    paths_.update();
  views_.follow(paths_.paths());
}

void Window::watchPaths()
{
  if (paths_.update())
  {
    views_.follow(paths_.paths());
    this->render();
  }
  if (paths_.isReading())
    this->startTimer(pathTimer_, pathPause);
}

/// Reads the values that what is picked has at all steps, for the panel to plot.
void Window::plotOverTime()
{
  constexpr std::int64_t most = 1000;
  const auto count = static_cast<std::int64_t>(picked_.items().size());
  if (count == 0)
    return this->say("Pick particles or cells first: their values over time are plotted then");
  if (count > most)
    return this->say("Values over time are plotted of up to " + withThousands(most) + ", and " +
                     withThousands(count) + " are picked");
  Followed followed{picked_.particleIds(stage_.parts()), {}};
  for (const Picked& one : picked_.items())
    if (one.kind == Picked::Kind::Cell)
      followed.places.push_back(
        {static_cast<std::size_t>(one.part), one.id, picked_.weightsOf(stage_.parts(), one)});
  this->readOverTime(std::move(followed));
}

void Window::readOverTime(Followed followed)
{
  overTime_ = nullptr;
  overTime_ =
    std::make_unique<ValuesOverTime>(input_.again(), std::move(followed), this->settings(), cache_);
  this->startTimer(overTimeTimer_, pathPause);
}

void Window::watchOverTime()
{
  if (!overTime_)
    return;
  if (panelHost_ && panelOn_)
    this->renderPanel();
  if (overTime_->stepsRead() < overTime_->steps())
    this->startTimer(overTimeTimer_, pathPause);
}

void Window::saveOverTime()
{
  if (!overTime_)
    return;
  while (player_ && overTime_->stepsRead() < overTime_->steps()) // who was recorded had waited
    std::this_thread::sleep_for(std::chrono::milliseconds(pathPause));
  const std::string file = this->unusedName("-over-time.csv");
  overTime_->write(file, input_.times());
  this->say("Saved " + file);
}

/// Looks at what was read ahead by now.
void Window::watchCache()
{
  if (!cache_)
    return;
  if (wantedStep_ >= 0 && cache_->has(wantedStep_))
  {
    this->follow(this->withStep(std::exchange(wantedStep_, -1)));
    this->renderMoving();
  }
  else if (StepCache::Facts facts = cache_->facts(); facts != cacheShown_)
  {
    cacheShown_ = std::move(facts);
    if (panelHost_ && panelOn_)
      this->renderOverlays();
  }
  this->startTimer(cacheTimer_, wantedStep_ >= 0 ? scrubPause : cachePause);
}

} // namespace mote::app
