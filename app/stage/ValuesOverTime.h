#pragma once

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

/// The values that some particles have at each time step, found on a thread with readers of its
/// own. All member functions are for one thread, that of the window.
class ValuesOverTime
{
public:
  /// Ids are those of --hide-ids. What the settings calculate has values, too. The cache may have
  /// steps that need not be read again.
  ValuesOverTime(std::unique_ptr<Input> input, const IdRanges& ids, const Settings& settings,
    const std::weak_ptr<StepCache>& cache = {});

  const IdRanges& ids() const { return ids_; }
  /// Of this one and no other that the program has made.
  std::uint64_t number() const { return number_; }
  /// How many steps were read, of how many.
  int stepsRead() const;
  int steps() const { return reader_.steps(); }

  /// x, y, z and the arrays that were found, their components one by one.
  std::vector<std::string> names() const;

  bool isRead(int step) const;

  /// One particle's values: one a step, not a number where that has none or was not read yet.
  struct Curve
  {
    std::size_t set; ///< number of the data set
    std::int64_t id;
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

  const IdRanges ids_;
  const std::uint64_t number_;
  mutable std::mutex mutex_;              ///< of the next three
  std::vector<std::optional<Step>> read_; ///< all steps
  int stepsRead_ = 0;
  std::map<std::string, int> firstOf_; ///< by name the first step that has it
  StepReader reader_;                  ///< the last: its thread uses the others
};

} // namespace mote::app
