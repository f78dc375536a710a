#include "Timing.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

namespace mote::bench
{

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

int threadCount(int asked)
{
  return asked > 0 ? asked : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

double timed(int threads, const std::function<void()>& work)
{
  static std::map<int, tbb::task_arena> arenas; // kept, so that their threads are there already
  return arenas.try_emplace(threads, threads)
    .first->second.execute(
      [&]
      {
        const auto begin = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      });
}

std::size_t Race::addTimed(std::function<double()> work)
{
  work_.push_back(std::move(work));
  seconds_.emplace_back();
  return work_.size() - 1;
}

std::size_t Race::add(int threads, std::function<void()> work)
{
  return addTimed([threads, work = std::move(work)] { return timed(threads, work); });
}

void Race::run(int rounds)
{
  for (const auto& work : work_) // pages, the processor's clock, the threads
    work();
  for (int k = 0; k < rounds; ++k)
    for (std::size_t i = 0; i < work_.size(); ++i)
      seconds_[i].push_back(work_[i]());
}

std::size_t Race::fastest(std::size_t first, std::size_t count) const
{
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i)
    if (seconds(first + i) < seconds(first + best))
      best = i;
  return best;
}

double Race::ratio(std::size_t place, std::size_t base) const
{
  std::vector<double> ratios;
  for (std::size_t k = 0; k < seconds_[place].size(); ++k)
    ratios.push_back(seconds_[place][k] / seconds_[base][k]);
  return median(std::move(ratios));
}

double Race::least(std::size_t place) const
{
  return *std::min_element(seconds_[place].begin(), seconds_[place].end());
}

double Race::most(std::size_t place) const
{
  return *std::max_element(seconds_[place].begin(), seconds_[place].end());
}

} // namespace mote::bench
