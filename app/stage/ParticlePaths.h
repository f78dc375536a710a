#pragma once

#include "Input.h"
#include "SimulationBox.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

class vtkPolyData;

namespace mote::app
{

/// Where some particles are at each time step, found on a thread with readers of its own. All
/// member functions are for one thread, that of the window.
class ParticlePaths
{
public:
  /// Ids are those of --hide-ids. Positions are as --positions of the settings asks.
  ParticlePaths(std::unique_ptr<Input> input, const IdRanges& ids, const Settings& settings);
  /// Stops what is under way, and waits until it has stopped.
  ~ParticlePaths();
  ParticlePaths(const ParticlePaths&) = delete;
  ParticlePaths& operator=(const ParticlePaths&) = delete;

  /// The paths that the settings ask for, read to their end; null where they ask for none.
  static std::unique_ptr<ParticlePaths> whole(
    const Settings& settings, const Input& input, ProgressRelay& progress);

  /// How many steps were read, of how many.
  int stepsRead() const;
  int steps() const { return steps_; }
  /// The paths of these data sets through the steps that were read, as lines with a colour for each
  /// id. There is none
  /// from one side of a periodic box to the other, nor over a step that lacks the particle.
  void fill(vtkPolyData* lines, const std::vector<std::size_t>& sets) const;

private:
  using Place = std::array<double, 3>;
  using Id = std::pair<std::size_t, std::int64_t>; ///< data set, and id of its particle
  struct Step
  {
    std::map<Id, Place> places;
    std::optional<SimulationBox> box;
    std::array<bool, 3> isPeriodic{};
  };
  void run();
  Step look(const std::vector<NamedData>& data) const;
  static bool isJump(const Step& step, const Place& from, const Place& to);

  std::unique_ptr<Input> input_;
  const IdRanges ids_;
  const Settings settings_;
  const int steps_;
  mutable std::mutex mutex_; ///< of `read_`
  std::vector<Step> read_;
  std::atomic<bool> stop_{false};
  std::thread thread_; ///< the last: it uses the others
};

} // namespace mote::app
