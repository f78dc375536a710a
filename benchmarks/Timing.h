#pragma once

#include <functional>
#include <vector>

namespace mote::bench
{

/// The middle value, or the mean of the two in the middle; `values` must not be empty.
double median(std::vector<double> values);

/// Threads that a measurement may use where --threads says `asked`: as many as the machine has for
/// 0.
int threadCount(int asked);

/// Seconds that the work takes on so many threads; everything else may use them all.
double timed(int threads, const std::function<void()>& work);

/// Pieces of work that are compared. All are done once in every round, so that whatever else the
/// machine does meanwhile falls on all of them; medians over the rounds are what counts.
class Race
{
public:
  /// Adds work that times itself and answers in seconds. Returns its place.
  std::size_t addTimed(std::function<double()> work);
  /// Adds work that is timed on so many threads. Returns its place.
  std::size_t add(int threads, std::function<void()> work);

  /// Runs `rounds` rounds, after one that does not count.
  void run(int rounds);

  /// Median of the seconds that the work at this place took.
  double seconds(std::size_t place) const { return median(seconds_[place]); }
  /// Which of `count` places from `first` on has the least median, counted from `first`.
  std::size_t fastest(std::size_t first, std::size_t count) const;
  /// Median over the rounds of the seconds here over those at `base` in the same round: what else
  /// the machine does falls on both.
  double ratio(std::size_t place, std::size_t base) const;
  double least(std::size_t place) const;
  double most(std::size_t place) const;

private:
  std::vector<std::function<double()>> work_;
  std::vector<std::vector<double>> seconds_;
};

} // namespace mote::bench
