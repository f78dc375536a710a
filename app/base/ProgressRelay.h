#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

class vtkAlgorithm;
class vtkObject;

namespace mote::app
{

/// Where progress is shown: the terminal, the window.
class ProgressDisplay
{
public:
  virtual ~ProgressDisplay() = default;

  /// Shows the share done, in [0, 1], of what is under way. Called some ten times a second.
  virtual void show(const std::string& what, double share) = 0;

  /// The work is over; leaves nothing behind.
  virtual void hide() = 0;

  /// Whether the user wants the work to stop.
  virtual bool wantsStop() { return false; }
};

/// Has Ctrl-C end the program with a sentence wherever no ProgressRelay::Work is under way, unless
/// SIGINT is ignored from the start.
void endOnInterrupt();

/// Runs one long work, of which `what` says what it does, on a pipeline object that fires
/// ProgressEvents. Throws Interrupted where it was stopped.
using Runner = std::function<void(
  const std::string& what, vtkObject* object, const std::function<void()>& work)>;

/// One for threads other than the first: shows nothing, and stops the work when `goesOn`, which is
/// told the share done, says no.
Runner quietly(const std::function<bool(double share)>& goesOn);

/// Carries progress from pipeline objects to the displays, and interruption the other way.
class ProgressRelay
{
public:
  /// Displays are not owned.
  void add(ProgressDisplay& display);
  void remove(ProgressDisplay& display);

  /// Runs each work as a Work, below. The relay must live as long.
  Runner runner();

  /// One long work of a pipeline object: shows its ProgressEvents from construction to destruction,
  /// once it takes longer than a moment, with an estimate of what is left where that is long, and
  /// lets Ctrl-C and the displays stop it. An algorithm is stopped by its AbortExecute flag; other
  /// objects find out themselves. A second Ctrl-C ends the program at once, as does the first
  /// outside of any work; unless SIGINT is ignored from the start.
  class Work
  {
  public:
    Work(ProgressRelay& progress, const std::string& what, vtkObject* object);
    ~Work();
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    /// Throws Interrupted if the user asked to stop. Call when the object has returned.
    void finish() const;

  private:
    void advance(double share);

    ProgressRelay& progress_;
    std::string what_;
    vtkObject* object_;
    vtkAlgorithm* algorithm_;
    unsigned long observer_ = 0;
    std::thread::id thread_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point next_;
    void (*before_)(int); ///< what SIGINT did
    bool shown_ = false;
    bool stopped_ = false;
  };

private:
  std::vector<ProgressDisplay*> displays_;
};

/// A bar on standard error, where that is a terminal.
class TerminalProgress : public ProgressDisplay
{
public:
  TerminalProgress();
  void show(const std::string& what, double share) override;
  void hide() override;

private:
  bool terminal_;
};

} // namespace mote::app
