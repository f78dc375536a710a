#include "Window.h"

#include "InteractorStyle.h"
#include "Observe.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"
#include "settings/Colors.h"
#include "settings/ErrorBudget.h"
#include "settings/UserState.h"
#include "stage/Advice.h"
#include "stage/KeptData.h"
#include "table/Session.h"

#include <kernels/core/CutFiles.h>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkMoteShading.h>
#include <vtkMoteSilhouettes.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

namespace mote::app
{

namespace
{

constexpr unsigned long restAfter = 250;  // ms from a turn of the wheel to sharpening
constexpr unsigned long buildPause = 200; // ms between looks at what other threads build
constexpr const char* stopped = "Stopped";
constexpr int previewSamples = 4; // samples per pixel: more would slow down the build behind it

/// Leaves the object alone when the window goes: what is still fired finds no one.
void forget(vtkObject* object)
{
  object->RemoveAllObservers();
}

} // namespace

void showWindow(const Settings& settings)
{
  Input input(settings.data.files);
  if (!displayAvailable())
    throw Failure("there is no display to open a window on; make a picture instead: "
                  "mote render FILE -o picture.png");
  Window window(settings, input);
  window.run();
}

Window::Window(const Settings& settings, Input& input)
  : asked_(settings)
  , input_(input)
  , stage_(settings)
  , views_(stage_, window_)
  , overlay_(window_, stage_.renderer())
  , props_(stage_)
  , bar_(window_, stage_.renderer(), overlay_.renderer())
  , panel_(stage_)
  , panelOn_(settings.output.panel)
{
  progress_.add(terminal_);
  progress_.add(bar_);
  this->setUpWindow();
  this->setUpEvents();
}

Window::~Window()
{
  forget(window_);
  views_.setUpPasses([](vtkMoteRayCastPass* pass) { forget(pass); });
  forget(style_);
  forget(interactor_);
  forget(stage_.renderer());
  forget(overlay_.renderer());
}

void Window::setUpWindow()
{
  window_->SetMultiSamples(0); // the rays are the antialiasing
  window_->SetWindowName(this->isEmpty() ? "Mote" : ("Mote: opening " + input_.name()).c_str());
  window_->AddRenderer(stage_.renderer());
  this->updateScale(); // which the panel's width goes by
  const std::array<int, 2> size = asked_.picture.size;
  const int* screen = window_->GetScreenSize();
  // The view that a session was saved from had the panel at its side.
  const int beside =
    asked_.output.fitsView && panelOn_ ? std::min(this->widthOfPanel(), size[0]) : 0;
  const int width = std::max(size[0], std::min(size[0] + beside, screen[0]));
  window_->SetSize(size[0] > 0 ? width : std::min(1280, screen[0] * 9 / 10),
    size[0] > 0 ? size[1] : std::min(860, screen[1] * 8 / 10));
  views_.setUpPasses(
    [this](vtkMoteRayCastPass* pass)
    {
      pass->ProgressiveOn();
      pass->SetNumberOfThreads(asked_.data.threads);
      pass->SetShading(stage_.lighting().shading());
      pass->SetSilhouettes(stage_.silhouettes());
    });
  views_.takePasses();
  overlay_.followBackground();
  interactor_->SetRenderWindow(window_);
  interactor_->SetInteractorStyle(style_);
}

void Window::setUpEvents()
{
  style_->onKey = [this](const std::string& key)
  {
    try
    {
      const Binding& binding = bindingOf(key);
      if (!this->takePlayersKey(binding.action))
        this->act(binding);
    }
    catch (const Failure& failure)
    {
      this->say(failure.what());
      this->render();
    }
  };
  style_->onZoom = [this](double factor) { this->turnWheel(factor); };
  observe(window_, vtkCommand::StartEvent, [this](void*) { this->onRenderStart(); });
  observe(window_, vtkCommand::EndEvent, [this](void*) { this->onRenderEnd(); });
  // Input stops what sharpens a picture and nothing else: VTK shows no frame that was stopped, and
  // whoever holds a key would see none.
  views_.setUpPasses(
    [this](vtkMoteRayCastPass* pass)
    {
      observe(pass, vtkCommand::ProgressEvent,
        [this](void*)
        {
          if (!busy_ && inputWaits(window_))
            window_->SetAbortRender(1);
        });
    });
  observe(style_, vtkCommand::EndInteractionEvent, [this](void*) { this->recordCamera(); });
  observe(interactor_, vtkCommand::ExitEvent, [this](void*) { this->leave(); });
  observe(
    interactor_, vtkCommand::TimerEvent,
    [this](void* timer) { this->onTimer(*static_cast<int*>(timer)); }, 0.0f, true);
}

void Window::run()
{
  interactor_->Initialize();
  this->takePlayer(asked_.output.play, asked_.data.files);
  this->startRecording(asked_.output.record);
  busy_ = true;
  try
  {
    if (!this->isEmpty())
      bar_.show("Opening " + input_.name(), 0.0);
    if (asked_.output.follow)
      input_.leaveOutDamagedEnds();
    input_.open(progress_);
    step_ = input_.chosenStep(asked_);
    this->load(step_);
    picked_.addNamed(stage_.parts(), asked_.marks.picked);
    bar_.hide();
  }
  catch (const Interrupted&)
  {
    if (bar_.wantsQuit())
      return;
    throw;
  }
  busy_ = false;
  arrayAsked_ = stage_.settingsInForce().color.array;
  previewed_ = !stage_.preview().empty();
  this->nameWindow();
  this->look();
  this->followProps();
  if (asked_.output.isSession)
    kept_.keep(this->settings());
  if (this->isEmpty())
    this->say("Mote shows what simulations write: start it as mote FILE, or press Ctrl+O");
  else
    this->say("Press h for the keys");
  if (std::none_of(input_.files().begin(), input_.files().end(), isKeptData))
    noteRecent(input_.files());
  props_.attach(interactor_); // which draws the window
  this->setUpPanel();
  this->updatePanel(); // how wide messages may be
  for (const std::string& sentence : adviceOnData(stage_))
    this->tell(sentence);
  if (const std::string nothing = whatLeavesNothing(stage_); !nothing.empty())
    this->tell(nothing);
  this->setUpPicking();
  this->setUpOpening();
  this->startCache();
  this->startFollowing();
  this->followPaths();
  this->startPlaying();
  this->render();
  if (!quit_)
    interactor_->Start();
  recorder_.stop();
  cache_.reset();
  paths_.clear();
  overTime_ = nullptr;
  if (!asked_.output.session.empty() && !this->isEmpty())
    writeSession(this->settingsInForce(), asked_.output.session);
}

void Window::quit()
{
  quit_ = true;
  // Not TerminateApp(): that of VTK 9.1 closes the display under the event loop's feet.
  interactor_->SetDone(true);
}

bool Window::perform(const std::function<void()>& work)
{
  busy_ = true;
  bar_.reset();
  bool done = false;
  std::string message;
  try
  {
    work();
    done = true;
  }
  catch (const Interrupted&)
  {
    message = stopped;
  }
  catch (const Failure& failure)
  {
    failure_ = message = failure.what();
  }
  catch (const std::bad_alloc&)
  {
    failure_ = message = "There is not enough memory for this";
  }
  busy_ = false;
  if (bar_.wantsQuit())
    this->quit();
  else if (!done)
  {
    playing_ = false;
    if (message == stopped)
      this->say(message);
    else
      this->tell(message);
  }
  return done;
}

//------------------------------------------------------------------------------------------------
// Drawing

/// What stands beside the data follows them.
void Window::followProps()
{
  props_.update();
  views_.follow(paths_.paths());
}

void Window::look()
{
  const std::array<int, 2> size = views_.size();
  Margins margins;
  // Both sides alike, so that what turns about its middle stays in the window's middle. Views
  // beside one another leave the legend a strip of its own.
  props_.update();
  const int legend = views_.shown().size() == 1 ? props_.legend().widthAtSide() : 0;
  const double width = std::max(1, size[0]);
  margins.left = margins.right =
    legend > 0 ? std::max(0.03 + 0.13 * size[1] / width, 0.01 + legend / width) : 0.04;
  margins.bottom = margins.top = 0.06;
  stage_.look(double(size[0]) / std::max(1, size[1]), margins);
  this->rememberView();
  viewedSize_ = size;
}

void Window::rememberView()
{
  view_ = this->viewNow();
  lookedAt_ = this->settings();
  camera_ = cameraOf(stage_.renderer()->GetActiveCamera());
}

std::array<double, 10> Window::viewNow()
{
  vtkCamera* camera = stage_.renderer()->GetActiveCamera();
  std::array<double, 10> view{};
  camera->GetPosition(&view[0]);
  camera->GetFocalPoint(&view[3]);
  camera->GetViewUp(&view[6]);
  view[9] = camera->GetParallelScale() + camera->GetParallelProjection();
  return view;
}

void Window::render()
{
  // While time goes on the next step matters more than a sharp picture of this one.
  window_->SetDesiredUpdateRate(
    playing_ ? interactor_->GetDesiredUpdateRate() : interactor_->GetStillUpdateRate());
  window_->Render();
}

void Window::renderMoving()
{
  wheeling_ = true;
  window_->SetDesiredUpdateRate(interactor_->GetDesiredUpdateRate());
  window_->Render();
  this->startTimer(restTimer_, restAfter);
}

/// Leaves the rays what the panel and OpenGL leave of a frame that moves.
void Window::shareFrameTime()
{
  constexpr double usual = 12.0; // frames a second
  const std::optional<double> asked = this->settings().picture.fps;
  double wanted = 1.0 / asked.value_or(usual); // s
  // A time step that is seen for long may be traced for long, unless somebody turns it.
  if (!asked && playing_ && !wheeling_ && style_->GetState() == VTKIS_NONE)
    wanted =
      std::clamp(0.25 * std::max(stepTime_, 1.0 / this->settings().output.speed), wanted, 1.0);
  // Rays get something, however long the rest takes: so much that the data can be told.
  const double least = asked ? std::min(0.5 * wanted, 0.3 / usual) : 0.3 * wanted;
  const auto count = static_cast<double>(views_.shown().size());
  const double share = frameTime_.forRays(wanted, least, asked.has_value()) / count;
  views_.setUpPasses([&](vtkMoteRayCastPass* pass) { pass->SetInteractiveFrameTime(share); });
}

void Window::nameWindow()
{
  window_->SetWindowName(("Mote - " + (this->isEmpty() ? "nothing open" : input_.name()) +
                          (previewed_ ? " (preview)" : "") + (player_ ? " (playing)" : ""))
                           .c_str());
}

void Window::updatePreview()
{
  // Before the frame: what is built meanwhile may be in it, but no preview that nothing tells of.
  if (const std::string error = stage_.update(); !error.empty())
    this->say(error);
  const std::string preview = stage_.preview();
  if (previewed_ != !preview.empty())
  {
    previewed_ = !preview.empty();
    views_.forgetMarks(); // their sizes were those of the particles as they were drawn
    this->nameWindow();
  }
  overlay_.setPreview(preview);
  const Settings& wanted = this->settings();
  const int samples = wanted.picture.mostSamples(wanted.light.pathTrace);
  const ErrorShares shares = errorShares(wanted);
  const std::array<int, 2> size = this->viewSize();
  const double distance = mostDistance(
    wanted.picture, double(size[0]) * size[1] / double(views_.shown().size()), stage_.lodError());
  views_.setUpPasses(
    [&](vtkMoteRayCastPass* pass)
    {
      pass->SetNoiseLevel(shares.noise.value_or(0.0));
      pass->SetMostDistance(distance);
      pass->SetRoughDrafts(!isColorError(wanted.picture));
      pass->SetSamplesPerPixel(previewed_ ? std::min(previewSamples, samples) : samples);
    });
}

void Window::onRenderStart()
{
  frameStart_ = vtkTimerLog::GetUniversalTime();
  panelTime_ = 0.0;
  if (busy_)
    return;
  this->shareFrameTime();
  // A view that the user has not touched goes on to fit when the window's shape changes.
  this->updatePanel();
  if (viewedSize_ != views_.size() && view_ == this->viewNow())
    this->look();
  this->letGoWithoutPanel();
  recorder_.note(this->state());
  if (picked_.empty() && picked_.numberAway() == 0)
    overTime_ = nullptr; // whose values it has
  this->updatePreview();
  this->takeMessages();
  views_.update(picked_);
  overlay_.setTop(views_.heightOfNames());
  overlay_.setStatus(this->statusText());
  props_.legend().update();
}

void Window::onRenderEnd()
{
  const double presenting = vtkTimerLog::GetUniversalTime();
  // Nobody has seen what was drawn of it, or a bar's frame lies over it.
  if ((!presenter_.present() || busy_) && panelHost_)
    panelHost_->lose();
  if (busy_)
    return;
  if (Messages::takeError() == std::bad_alloc().what()) // and is not drawn
  {
    this->endCache();
    this->tell("There is not enough memory to draw this; what was read ahead is given up");
  }
  if (takeFileCut())
    Messages::warn("A file was cut short while it was in use: what is shown of it may be wrong");
  const double traceTime = views_.traceTime();
  if (traceTime > 0.0)
  {
    const double now = vtkTimerLog::GetUniversalTime();
    const double silhouettes = views_.silhouetteTime();
    costs_ = {
      now - frameStart_, traceTime - silhouettes, silhouettes, panelTime_, now - presenting};
    frameTime_.traced(costs_.frame, traceTime);
  }
  if (this->isResting())
    this->noteRest();
  if (!this->isResting())
    return;
  // Sharpen until all samples are there; then once more, for the texts to say so.
  const bool preview = views_.isPreview();
  const bool sharp = preview ? traceTime == 0.0 : views_.isConverged();
  if (!sharp || previewed_ != preview || overlay_.status() != this->statusText())
    this->startTimer(sharpenTimer_, 1);
  else if (stage_.isBuilding())
    this->startTimer(sharpenTimer_, buildPause);
}

void Window::startTimer(int& timer, unsigned long milliseconds)
{
  if (timer > 0)
    interactor_->DestroyTimer(timer);
  timer = interactor_->CreateOneShotTimer(milliseconds);
}

void Window::onTimer(int timer)
{
  const auto due = [timer](int& own)
  {
    if (own != timer)
      return false;
    own = 0;
    return true;
  };
  if (busy_ || quit_)
    return;
  if (due(panelTimer_))
    this->takeWish();
  else if (due(playTimer_))
    this->advance();
  else if (due(hoverTimer_))
    this->hover();
  else if (due(cacheTimer_))
    this->watchCache();
  else if (due(followTimer_))
    this->watchFiles();
  else if (due(pathTimer_))
    this->watchPaths();
  else if (due(overTimeTimer_))
    this->watchOverTime();
  else if (due(recordTimer_))
    this->playNext();
  else if (due(messageTimer_))
  {
    askedToLeave_.reset();
    overlay_.setMessage("");
    this->render();
  }
  else if (due(restTimer_))
  {
    wheeling_ = false;
    if (style_->GetState() != VTKIS_NONE)
      return; // the end of the drag does so
    this->recordCamera();
    this->render();
  }
  else if (due(sharpenTimer_) && this->isResting())
    this->render();
}

/// Whether nothing moves, and nothing is about to.
bool Window::isResting() const
{
  constexpr unsigned long soon = 100; // ms
  return !wheeling_ && !playing_ && style_->GetState() == VTKIS_NONE &&
         !(player_ && player_->wait() < soon);
}

} // namespace mote::app
