#pragma once

#include "SimulationBox.h"
#include "StepReader.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

namespace mote::app
{

/// Red, green, blue of a particle's path, or of its values over time: those of so many go round and
/// round.
std::array<unsigned char, 3> pathColor(std::size_t number);

/// Where some particles are at each time step, found on a thread with readers of its own. All
/// member functions are for one thread, that of the window.
class ParticlePaths
{
public:
  /// Ids are those of --hide-ids. Positions are as --positions of the settings asks. The cache may
  /// have steps that need not be read again.
  ParticlePaths(std::unique_ptr<Input> input, const IdRanges& ids, const Settings& settings,
    const std::weak_ptr<StepCache>& cache = {});

  /// The paths that the settings ask for, read to their end; null where they ask for none.
  static std::unique_ptr<ParticlePaths> whole(
    const Settings& settings, const Input& input, ProgressRelay& progress);

  /// Waits until all steps are read. Throws Interrupted.
  void finish(ProgressRelay& progress) const;

  /// How many steps were read, of how many.
  int stepsRead() const;
  int steps() const { return reader_.steps(); }
  /// The paths of these data sets through the steps that were read, as lines with a colour for each
  /// id. There is none
  /// from one side of a periodic box to the other, nor over a step that lacks the particle.
  void fill(vtkPolyData* lines, const std::vector<std::size_t>& sets) const;

private:
  using Place = std::array<double, 3>;
  using Id = std::pair<std::size_t, std::int64_t>; ///< data set, and id of its particle
  using Places = std::map<Id, Place>;
  struct Step
  {
    Places places;
    std::optional<SimulationBox> box;
    std::array<bool, 3> isPeriodic{};
  };
  Step look(const std::vector<NamedData>& data) const;
  static bool isJump(const Step& step, const Place& from, const Place& to);

  const IdRanges ids_;
  const Settings settings_;
  mutable std::mutex mutex_;              ///< of the next two
  std::vector<std::optional<Step>> read_; ///< all steps
  int stepsRead_ = 0;
  StepReader reader_; ///< the last: its thread uses the others
};

} // namespace mote::app
