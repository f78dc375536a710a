#pragma once

#include "Input.h"

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace mote::app
{

class StepCache;

/// Looks at all time steps on a thread with readers of its own. What a cache has read is not read
/// again, and the other way round: it is given what is read here.
class StepReader
{
public:
  /// Gets each step's data once, with what the settings calculate and move, on the other thread;
  /// none of a step that cannot be read. Steps come in any order.
  using Look = std::function<void(int step, const std::vector<NamedData>&)>;

  /// The cache may end before this does, and there may be none.
  StepReader(std::unique_ptr<Input> input, const Settings& settings, std::weak_ptr<StepCache> cache,
    Look look);
  /// Stops what is under way, and waits until it has stopped.
  ~StepReader();
  StepReader(const StepReader&) = delete;
  StepReader& operator=(const StepReader&) = delete;

  int steps() const { return steps_; }

private:
  void run();
  int next(const std::vector<bool>& isDone) const;
  double timeOf(int step) const;
  std::vector<NamedData> read(int step);

  std::unique_ptr<Input> input_;
  const Settings settings_;
  const std::weak_ptr<StepCache> cache_;
  const Look look_;
  const int steps_;
  std::atomic<bool> stop_{false};
  std::thread thread_; ///< the last: it uses the others
};

} // namespace mote::app
