#include "StepCache.h"

#include "base/Background.h"
#include "base/Failure.h"
#include "base/Text.h"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

namespace mote::app
{

namespace
{

constexpr auto settingsRest = std::chrono::milliseconds(300);

/// Has the system read a file that is mapped, not read, when it is opened.
void readMapped(const std::string& file)
{
  if (!lowerCase(file).ends_with(".mote"))
    return;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return;
  ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_WILLNEED);
  ::close(descriptor);
}

} // namespace

StepCache::StepCache(
  std::uint64_t budget, std::function<void(const std::vector<NamedData>&)> complete)
  : budget_(budget)
  , complete_(std::move(complete))
  , thread_([this] { inBackground([this] { this->run(); }); })
{
}

StepCache::~StepCache()
{
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    cancel_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

//------------------------------------------------------------------------------------------------
// Of the window's thread

void StepCache::setInput(std::unique_ptr<Input> input, bool sameSteps)
{
  std::map<int, Entry> gone;
  const std::lock_guard lock(mutex_);
  input_ = std::move(input);
  steps_ = input_ ? input_->numberOfSteps() : 0;
  failed_.clear();
  if (!sameSteps)
    gone.swap(entries_);
  cancel_ = true;
  changed_.notify_all();
}

void StepCache::setPlan(const ReadyPlan& plan)
{
  const std::lock_guard lock(mutex_);
  if (plan_ && plan_->fits(plan))
    return;
  if (plan_)
    notBefore_ = Clock::now() + settingsRest;
  plan_ = plan;
  cancel_ = true;
  changed_.notify_all();
}

void StepCache::setPlace(int step, int direction, bool wraps)
{
  const std::lock_guard lock(mutex_);
  place_ = step;
  direction_ = direction < 0 ? -1 : 1;
  wraps_ = wraps;
  if (wanted_ == step)
    wanted_ = -1;
  changed_.notify_all();
}

void StepCache::want(int step)
{
  const std::lock_guard lock(mutex_);
  wanted_ = step;
  if (step >= 0 && working_ != step)
    cancel_ = true;
  changed_.notify_all();
}

std::optional<ReadyStep> StepCache::take(int step)
{
  Entry entry;
  {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(step);
    if (found == entries_.end() || working_ == step)
      return std::nullopt;
    entry = found->second;
    place_ = step; // from here on the thread leaves it alone
  }
  return withOwnData(*entry);
}

void StepCache::keep(int step, const ReadyStep& ready)
{
  // The stage has its data sets until it shows others, and mappers in two threads would enter
  // themselves into them.
  auto entry = std::make_shared<const ReadyStep>(withOwnData(ready));
  std::vector<Entry> gone;
  const std::lock_guard lock(mutex_);
  if (working_ == step)
    return;
  entries_[step].swap(entry);
  gone = this->evict(-1);
  changed_.notify_all();
}

bool StepCache::has(int step) const
{
  const std::lock_guard lock(mutex_);
  return entries_.count(step) > 0 && working_ != step;
}

bool StepCache::isReading(int step) const
{
  const std::lock_guard lock(mutex_);
  return working_ == step;
}

std::vector<int> StepCache::placesInOrder() const
{
  const std::lock_guard lock(mutex_);
  return this->order();
}

std::optional<std::vector<NamedData>> StepCache::original(int step, double time) const
{
  Entry entry;
  {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(step);
    if (found == entries_.end() || working_ == step || !this->isOf(step, time))
      return std::nullopt;
    entry = found->second;
  }
  ReadyStep read;
  read.original = entry->original;
  return withOwnData(read).original;
}

void StepCache::give(int step, double time, const std::vector<NamedData>& original)
{
  ReadyStep given;
  given.original = original;
  auto entry = std::make_shared<ReadyStep>(withOwnData(given));
  if (complete_)
    complete_(entry->original);
  entry->count();
  std::vector<Entry> gone;
  const std::lock_guard lock(mutex_);
  if (working_ == step || step == place_ || entries_.count(step) > 0 || !this->isOf(step, time))
    return;
  entries_[step] = std::move(entry);
  gone = this->evict(-1);
  changed_.notify_all();
}

bool StepCache::isAtRest() const
{
  const std::lock_guard lock(mutex_);
  return working_ < 0 && this->next() < 0;
}

bool StepCache::wait(int step, double seconds) const
{
  std::unique_lock lock(mutex_);
  return changed_.wait_for(
    lock, std::chrono::duration<double>(seconds), [&] { return working_ != step; });
}

int StepCache::nearest(int step) const
{
  const std::lock_guard lock(mutex_);
  int best = -1;
  for (const auto& [own, entry] : entries_)
    if (own != working_ && (best < 0 || std::abs(own - step) < std::abs(best - step)))
      best = own;
  return best;
}

StepCache::Facts StepCache::facts() const
{
  const std::lock_guard lock(mutex_);
  Facts facts;
  MemorySum sum;
  facts.budget = budget_;
  facts.marks.assign(static_cast<std::size_t>(steps_), Mark::Away);
  for (const auto& [step, entry] : entries_)
  {
    sum.add(entry->memory);
    if (step < steps_)
      facts.marks[static_cast<std::size_t>(step)] = Mark::Here;
  }
  facts.bytes = sum.bytes();
  if (place_ < steps_)
    facts.marks[static_cast<std::size_t>(place_)] = Mark::Here; // the window has it
  if (working_ >= 0 && working_ < steps_ && entries_.count(working_) == 0)
    facts.marks[static_cast<std::size_t>(working_)] = Mark::Reading;
  return facts;
}

StepCache::Pause::Pause(StepCache* cache)
  : cache_(cache)
{
  if (!cache_)
    return;
  const std::lock_guard lock(cache_->mutex_);
  ++cache_->pauses_;
}

StepCache::Pause::~Pause()
{
  if (!cache_)
    return;
  const std::lock_guard lock(cache_->mutex_);
  --cache_->pauses_;
  cache_->changed_.notify_all();
}

//------------------------------------------------------------------------------------------------
// Of both; the mutex is held

/// Whether the step's time is this one, and not that of other data.
bool StepCache::isOf(int step, double time) const
{
  const auto at = static_cast<std::size_t>(step);
  return input_ && step < steps_ && at < input_->times().size() && input_->times()[at] == time;
}

/// All steps, those that are to be kept first first.
std::vector<int> StepCache::order() const
{
  std::vector<int> order;
  std::vector<bool> isIn(static_cast<std::size_t>(steps_), false);
  const auto add = [&](int step)
  {
    if (step < 0 || step >= steps_ || isIn[static_cast<std::size_t>(step)])
      return;
    isIn[static_cast<std::size_t>(step)] = true;
    order.push_back(step);
  };
  add(wanted_);
  add(place_);
  add(place_ + direction_);
  if (wraps_)
    add((place_ + direction_ + steps_) % std::max(1, steps_));
  add(place_ - direction_); // whoever turns round sees what was there
  for (int i = 1; i < steps_; ++i)
  {
    const int step = place_ + i * direction_;
    add(wraps_ ? ((step % steps_) + steps_) % steps_ : step);
  }
  for (int i = 1; i < steps_; ++i)
    add(place_ - i * direction_);
  return order;
}

/// What a step takes that is not there yet: no more than another one does that shares what it can.
std::uint64_t StepCache::usualBytes() const
{
  MemorySum before;
  std::uint64_t most = 0;
  for (const auto& [step, entry] : entries_)
  {
    // The first one has what the others share.
    const std::uint64_t more = before.more(entry->memory);
    most = before.bytes() == 0 && entries_.size() > 1 ? 0 : std::max(most, more);
    before.add(entry->memory);
  }
  return most;
}

/// The step to read or build next; -1: none.
int StepCache::next() const
{
  if (!input_ || !plan_ || pauses_ > 0)
    return -1;
  const std::uint64_t usual = this->usualBytes();
  std::uint64_t expected = 0;
  MemorySum used;
  for (const int step : this->order())
  {
    const auto found = entries_.find(step);
    if (found != entries_.end())
      used.add(found->second->memory);
    else if (step != place_)
      expected += usual;
    if (used.bytes() + expected > budget_)
      return -1;
    if (step != place_ && failed_.count(step) == 0 &&
        (found == entries_.end() || !found->second->plan.fits(*plan_)))
      return step;
  }
  return -1;
}

/// Takes out what does not fit the budget beside a step that comes; -1: none does.
std::vector<StepCache::Entry> StepCache::evict(int reserved)
{
  std::vector<Entry> gone;
  std::uint64_t expected = 0;
  MemorySum used;
  for (const int step : this->order())
  {
    const auto found = entries_.find(step);
    if (found == entries_.end())
    {
      expected += step == reserved ? this->usualBytes() : 0;
      continue;
    }
    if (expected + used.bytes() + used.more(found->second->memory) <= budget_)
    {
      used.add(found->second->memory);
      continue;
    }
    gone.push_back(std::move(found->second));
    entries_.erase(found);
  }
  return gone;
}

//------------------------------------------------------------------------------------------------
// Of the other thread

/// Whether what is under way is to go on, perhaps after a while.
bool StepCache::goesOn(double share)
{
  share_ = share;
  if (cancel_ || std::this_thread::get_id() != thread_.get_id())
    return !cancel_;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return pauses_ == 0 || cancel_; });
  return !cancel_;
}

void StepCache::run()
{
  std::unique_lock lock(mutex_);
  while (!stop_)
  {
    if (Clock::now() < notBefore_)
    {
      changed_.wait_until(lock, notBefore_);
      continue;
    }
    const int step = this->next();
    if (step < 0)
      changed_.wait(lock);
    else
      this->work(lock, step);
  }
}

void StepCache::readInto(ReadyStep& read, Input& input, int step, const Runner& runner) const
{
  for (const auto& [file, time] : input.filesAt(step))
    readMapped(file);
  read.original = input.read(step, runner);
  if (complete_)
    complete_(read.original);
  read.count();
}

void StepCache::work(std::unique_lock<std::mutex>& lock, int step)
{
  working_ = step;
  cancel_ = stop_;
  std::vector<Entry> gone = this->evict(step);
  const std::shared_ptr<Input> input = input_;
  const ReadyPlan plan = *plan_;
  const auto found = entries_.find(step);
  const Entry before = found == entries_.end() ? nullptr : found->second;
  changed_.notify_all();
  lock.unlock();

  gone.clear();
  bool failed = false;
  std::shared_ptr<ReadyStep> made;
  try
  {
    const Runner runner = quietly([this](double share) { return this->goesOn(share); });
    ReadyStep read;
    if (before)
      read.original = before->original;
    else
      this->readInto(read, *input, step, runner);
    made = std::make_shared<ReadyStep>(read); // which stays where the building is stopped
    *made = makeReady(read.original, plan, runner, last_, finder_);
  }
  catch (const Interrupted&)
  {
  }
  catch (const std::exception&)
  {
    failed = true; // whoever shows the step finds the same, and tells it
  }

  lock.lock();
  working_ = -1;
  if (input == input_)
  {
    if (made && !made->parts.empty())
    {
      last_ = made->parts;
      for (BuiltPart& part : last_)
      {
        part.particles = nullptr; // no two steps have the same
        part.drawn = nullptr;     // has the step's arrays
      }
    }
    if (made)
      entries_[step] = std::move(made);
    if (failed)
      failed_.insert(step);
  }
  gone = this->evict(-1);
  changed_.notify_all();
  lock.unlock();
  gone.clear();
  lock.lock();
}

} // namespace mote::app
