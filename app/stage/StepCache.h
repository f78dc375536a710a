#pragma once

#include "Input.h"
#include "ReadyStep.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace mote::app
{

/// Reads and builds time steps ahead, on a thread with readers and mappers of its own, and keeps
/// them within a budget of memory: first the next steps in the direction of the last change, then
/// the others. What is handed out the thread does not use any more. Member functions are for one
/// thread, that of the window, but for those that say otherwise.
class StepCache
{
public:
  /// `complete` is called on the other thread with what was read, to add what lies beside files.
  explicit StepCache(
    std::uint64_t budget, std::function<void(const std::vector<NamedData>&)> complete = {});
  /// Stops what is under way, and waits until it has stopped.
  ~StepCache();
  StepCache(const StepCache&) = delete;
  StepCache& operator=(const StepCache&) = delete;

  /// Reads from here on; what was read stays where `sameSteps` says that the steps that there were
  /// are still the same. What could not be read before is tried again.
  void setInput(std::unique_ptr<Input> input, bool sameSteps);
  /// How steps are built from here on; those that do not fit are built anew.
  void setPlan(const ReadyPlan& plan);
  /// The step that is shown, and where it goes from there: 1 or -1; with `wraps` from the last step
  /// to the first.
  void setPlace(int step, int direction, bool wraps);
  /// Reads this step before all others; -1: none.
  void want(int step);

  /// The step with data objects of the caller's own; none where it is not there.
  std::optional<ReadyStep> take(int step);
  /// Keeps what the caller has read, and does not use while another step is shown.
  void keep(int step, const ReadyStep& ready);

  // For any thread.
  bool has(int step) const;
  bool isReading(int step) const;
  /// All steps, in the order in which they are read as far as there is room.
  std::vector<int> placesInOrder() const;
  /// What was read of the step, which must be of this time, as data objects of the caller's own;
  /// none where it is not there. Their arrays are to be read and not changed.
  std::optional<std::vector<NamedData>> original(int step, double time) const;
  /// Keeps what somebody else has read of a step of this time, where it is not there and fits.
  void give(int step, double time, const std::vector<NamedData>& original);

  /// Whether nothing is left to be read or built.
  bool isAtRest() const;
  /// The share done of what is read or built now.
  double share() const { return share_; }
  /// Waits until the step is not being read, but no longer than so many seconds; whether it is not.
  bool wait(int step, double seconds) const;
  /// The step nearest to this one that is there; -1 where there is none.
  int nearest(int step) const;

  enum class Mark
  {
    Away,
    Reading,
    Here
  };
  struct Facts
  {
    std::vector<Mark> marks; ///< one a step
    std::uint64_t bytes = 0; ///< of what is kept
    std::uint64_t budget = 0;
    bool operator==(const Facts&) const = default;
  };
  Facts facts() const;

  /// Has the other thread wait while it lives, as the cores are needed.
  class Pause
  {
  public:
    explicit Pause(StepCache* cache); ///< may be null
    ~Pause();
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

  private:
    StepCache* cache_;
  };

private:
  using Clock = std::chrono::steady_clock;
  using Entry = std::shared_ptr<const ReadyStep>;

  void run();
  void readInto(ReadyStep& read, Input& input, int step, const Runner& runner) const;
  void work(std::unique_lock<std::mutex>& lock, int step);
  bool isOf(int step, double time) const;
  bool goesOn(double share);
  std::vector<int> order() const;
  int next() const;
  std::uint64_t usualBytes() const;
  std::vector<Entry> evict(int reserved);

  const std::uint64_t budget_;
  const std::function<void(const std::vector<NamedData>&)> complete_;

  mutable std::mutex mutex_; ///< of all that follows
  mutable std::condition_variable changed_;
  std::shared_ptr<Input> input_;
  std::optional<ReadyPlan> plan_;
  std::map<int, Entry> entries_;
  std::set<int> failed_;
  std::vector<BuiltPart> last_; ///< volumes and meshes that the thread built last
  FlowFinder finder_;           ///< of the thread
  Clock::time_point notBefore_; ///< settings that go on to change wait
  int steps_ = 0;
  int place_ = 0, direction_ = 1;
  bool wraps_ = false;
  int wanted_ = -1;
  int working_ = -1; ///< the step that is read or built
  int pauses_ = 0;
  bool stop_ = false;
  std::atomic<bool> cancel_{false}; ///< what is under way
  std::atomic<double> share_{0.0};  ///< of it that is done

  std::thread thread_; ///< the last: it uses the others
};

} // namespace mote::app
