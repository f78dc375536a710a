#include "ProgressRelay.h"

#include "Failure.h"
#include "Text.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkNew.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <functional>
#include <unistd.h>

namespace mote::app
{

namespace
{

using Clock = std::chrono::steady_clock;
constexpr auto patience = std::chrono::milliseconds(300); // before a bar appears
constexpr auto period = std::chrono::milliseconds(80);    // from one drawing to the next

constexpr double longWork = 5.0; // seconds from which on there is an estimate of what is left

volatile std::sig_atomic_t interrupts = 0;
int works = 0; ///< under way, one within the other

/// Ends the program from within a signal handler, which must not call exit().
[[noreturn]] void endInterrupted(int)
{
  constexpr char sentence[] = "mote: interrupted\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, sentence, sizeof sentence - 1);
  _exit(130);
}

void onInterrupt(int signal)
{
  interrupts = interrupts + 1;
  if (interrupts > 1)
    endInterrupted(signal);
}

/// What SIGINT does. To ask by setting another answer would lose one that comes just then.
void (*onSigint())(int)
{
  struct sigaction action = {};
  ::sigaction(SIGINT, nullptr, &action);
  return action.sa_handler;
}

class ProgressCommand : public vtkCommand
{
public:
  static ProgressCommand* New() { return new ProgressCommand; }
  void Execute(vtkObject*, unsigned long, void* share) override
  {
    this->advance(share ? *static_cast<double*>(share) : 0.0);
  }
  std::function<void(double)> advance;
};

} // namespace

void endOnInterrupt()
{
  // Whoever had it ignored, as nohup and a shell's background commands have, wants no interruption.
  if (std::signal(SIGINT, endInterrupted) == SIG_IGN)
    std::signal(SIGINT, SIG_IGN);
}

void ProgressRelay::add(ProgressDisplay& display)
{
  displays_.push_back(&display);
}

void ProgressRelay::remove(ProgressDisplay& display)
{
  std::erase(displays_, &display);
}

Runner ProgressRelay::runner()
{
  return [this](const std::string& what, vtkObject* object, const std::function<void()>& work)
  {
    Work shown(*this, what, object);
    work();
    shown.finish();
  };
}

Runner quietly(const std::function<bool(double)>& goesOn)
{
  return [goesOn](const std::string&, vtkObject* object, const std::function<void()>& work)
  {
    auto* algorithm = vtkAlgorithm::SafeDownCast(object);
    vtkNew<ProgressCommand> command;
    command->advance = [&](double share)
    {
      if (!goesOn(share) && algorithm)
        algorithm->SetAbortExecute(1);
    };
    const unsigned long tag = object->AddObserver(vtkCommand::ProgressEvent, command);
    if (algorithm)
      algorithm->SetAbortExecute(0);
    work();
    object->RemoveObserver(tag);
    if (!goesOn(1.0))
      throw Interrupted();
  };
}

ProgressRelay::Work::Work(ProgressRelay& progress, const std::string& what, vtkObject* object)
  : progress_(progress)
  , what_(what)
  , object_(object)
  , algorithm_(vtkAlgorithm::SafeDownCast(object))
  , thread_(std::this_thread::get_id())
  , start_(Clock::now())
  , next_(start_ + patience)
{
  if (works++ == 0)
    interrupts = 0; // within another work it may be that one's
  before_ = onSigint();
  if (before_ != SIG_IGN && before_ != onInterrupt)
    std::signal(SIGINT, onInterrupt);
  if (algorithm_)
    algorithm_->SetAbortExecute(0);
  auto* command = ProgressCommand::New();
  command->advance = [this](double share) { this->advance(share); };
  observer_ = object_->AddObserver(vtkCommand::ProgressEvent, command);
  command->Delete();
}

ProgressRelay::Work::~Work()
{
  --works;
  object_->RemoveObserver(observer_);
  if (before_ != SIG_IGN && before_ != onInterrupt)
    std::signal(SIGINT, before_);
  if (algorithm_)
    algorithm_->SetAbortExecute(0);
  if (shown_)
    for (ProgressDisplay* display : progress_.displays_)
      display->hide();
}

void ProgressRelay::Work::finish() const
{
  if (stopped_ || interrupts > 0)
    throw Interrupted();
}

void ProgressRelay::Work::advance(double share)
{
  // Displays draw with OpenGL, which belongs to the thread that began the work.
  if (std::this_thread::get_id() != thread_)
    return;
  stopped_ = stopped_ || interrupts > 0;
  for (ProgressDisplay* display : progress_.displays_)
    stopped_ = stopped_ || display->wantsStop();
  if (stopped_ && algorithm_)
    algorithm_->SetAbortExecute(1);
  const auto now = Clock::now();
  if (now < next_)
    return;
  next_ = now + period;
  shown_ = true;
  share = std::clamp(share, 0.0, 1.0);
  std::string what = what_;
  const double taken = std::chrono::duration<double>(now - start_).count();
  if (taken > longWork && share > 0.02)
    what += ", " + asDuration(taken * (1.0 - share) / share) + " left";
  for (ProgressDisplay* display : progress_.displays_)
    display->show(what, share);
}

TerminalProgress::TerminalProgress()
  : terminal_(isatty(STDERR_FILENO) != 0)
{
}

void TerminalProgress::show(const std::string& what, double share)
{
  if (!terminal_)
    return;
  constexpr int width = 30;
  const int full = static_cast<int>(share * width + 0.5);
  const std::string bar = std::string(full, '=') + std::string(width - full, ' ');
  std::fprintf(stderr, "\r%-40.40s [%s] %3.0f %%", what.c_str(), bar.c_str(), 100.0 * share);
  std::fflush(stderr);
}

void TerminalProgress::hide()
{
  if (terminal_)
    std::fputs("\r\033[K", stderr);
}

} // namespace mote::app
