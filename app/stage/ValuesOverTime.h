#pragma once

#include "CellValues.h"
#include "StepReader.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mote::app
{

/// A place in a cell, which goes with the cell where that moves.
struct PlaceInCell
{
  std::size_t set = 0; ///< number of the data set
  vtkIdType cell = 0;
  CellWeights weights; ///< of the cell's points there
};

/// What is followed through time: particles, by ids of --hide-ids, and places in cells.
struct Followed
{
  IdRanges ids;
  std::vector<PlaceInCell> places;
};

/// The values that some particles and places in cells have at each time step, found on a thread
/// with readers of its own. All member functions are for one thread, that of the window.
class ValuesOverTime
{
public:
  /// What the settings calculate has values, too. The cache may have steps that need not be read
  /// again.
  ValuesOverTime(std::unique_ptr<Input> input, Followed followed, const Settings& settings,
    const std::weak_ptr<StepCache>& cache = {});

  const Followed& followed() const { return followed_; }
  /// Of this one and no other that the program has made.
  std::uint64_t number() const { return number_; }
  /// How many steps were read, of how many.
  int stepsRead() const;
  int steps() const { return reader_.steps(); }

  /// x, y, z and the arrays that were found, their components one by one.
  std::vector<std::string> names() const;

  bool isRead(int step) const;

  /// The values of a particle, or in a cell: one a step, not a number where that has none or was
  /// not read yet.
  struct Curve
  {
    std::size_t set; ///< number of the data set
    std::int64_t id; ///< or the number of the cell
    std::vector<double> values;
  };
  /// In the order of data sets and ids.
  std::vector<Curve> curves(const std::string& name) const;

  /// Writes all of it as comma-separated values, a line for each step and particle. Throws Failure.
  void write(const std::string& file, const std::vector<double>& times) const;

private:
  using Particle = std::pair<std::size_t, std::int64_t>; ///< data set, and id
  /// By name.
  using Step = std::map<std::string, std::map<Particle, double>>;
  Step look(const std::vector<NamedData>& data) const;
  void lookAtParticles(std::size_t set, vtkDataSet* particles, Step& step) const;
  void lookAtCells(std::size_t set, vtkDataSet* mesh, Step& step) const;

  const Followed followed_;
  const std::uint64_t number_;
  mutable std::mutex mutex_;              ///< of the next three
  std::vector<std::optional<Step>> read_; ///< all steps
  int stepsRead_ = 0;
  std::map<std::string, int> firstOf_; ///< by name the first step that has it
  StepReader reader_;                  ///< the last: its thread uses the others
};

} // namespace mote::app
