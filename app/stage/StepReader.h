#pragma once

#include "Input.h"

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace mote::app
{

/// Reads all time steps, one after the other, on a thread with readers of its own.
class StepReader
{
public:
  /// Gets each step's data, with what the settings calculate and move, on the other thread; none of
  /// a step that cannot be read.
  using Look = std::function<void(const std::vector<NamedData>&)>;

  StepReader(std::unique_ptr<Input> input, const Settings& settings, Look look);
  /// Stops what is under way, and waits until it has stopped.
  ~StepReader();
  StepReader(const StepReader&) = delete;
  StepReader& operator=(const StepReader&) = delete;

  int steps() const { return steps_; }

private:
  void run();

  std::unique_ptr<Input> input_;
  const Settings settings_;
  const Look look_;
  const int steps_;
  std::atomic<bool> stop_{false};
  std::thread thread_; ///< the last: it uses the others
};

} // namespace mote::app
