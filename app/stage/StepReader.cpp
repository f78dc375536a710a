#include "StepReader.h"

#include "Calculated.h"
#include "StepCache.h"
#include "base/Background.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace mote::app
{

StepReader::StepReader(
  std::unique_ptr<Input> input, const Settings& settings, std::weak_ptr<StepCache> cache, Look look)
  : input_(std::move(input))
  , settings_(settings)
  , cache_(std::move(cache))
  , look_(std::move(look))
  , steps_(input_->numberOfSteps())
  , thread_([this] { inBackground([this] { this->run(); }); })
{
}

StepReader::~StepReader()
{
  stop_ = true;
  thread_.join();
}

double StepReader::timeOf(int step) const
{
  return input_->times().empty() ? 0.0 : input_->times()[static_cast<std::size_t>(step)];
}

/// The step to look at: one that the cache has, or else that which it would come to last; -1 while
/// it reads what is left.
int StepReader::next(const std::vector<bool>& isDone) const
{
  const std::shared_ptr<StepCache> cache = cache_.lock();
  const auto isLeft = [&](int step)
  { return step < steps_ && !isDone[static_cast<std::size_t>(step)]; };
  std::vector<int> left;
  for (int step = 0; !cache && step < steps_; ++step)
    if (isLeft(step))
      return step;
  for (const int step : cache ? cache->placesInOrder() : std::vector<int>())
    if (isLeft(step))
    {
      if (cache->has(step))
        return step;
      left.push_back(step);
    }
  std::reverse(left.begin(), left.end());
  for (const int step : left)
    if (!cache->isReading(step))
      return step;
  return -1;
}

std::vector<NamedData> StepReader::read(int step)
{
  if (const auto cache = cache_.lock())
    if (auto known = cache->original(step, this->timeOf(step)))
      return *std::move(known);
  std::vector<NamedData> data = input_->read(step, quietly([this](double) { return !stop_; }));
  if (const auto cache = cache_.lock())
    cache->give(step, this->timeOf(step), data);
  return data;
}

void StepReader::run()
{
  constexpr auto pause = std::chrono::milliseconds(5);
  std::vector<bool> isDone(static_cast<std::size_t>(steps_), false);
  for (int done = 0; done < steps_ && !stop_;)
  {
    const int step = this->next(isDone);
    if (step < 0)
    {
      std::this_thread::sleep_for(pause);
      continue;
    }
    std::vector<NamedData> data;
    try
    {
      KnownExpressions known;
      data = withCalculated(this->read(step), settings_, known);
    }
    catch (const std::exception&)
    {
      // A step that cannot be read is a gap; who shows it is told why.
    }
    look_(step, data);
    isDone[static_cast<std::size_t>(step)] = true;
    ++done;
  }
}

} // namespace mote::app
