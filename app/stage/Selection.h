#pragma once

#include "Arrays.h"
#include "Input.h"
#include "Part.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace mote::app
{

/// Which particles and cells are shown: what --show, --show-range and --show-by ask for.
class Selection
{
public:
  explicit Selection(const Settings& settings);

  /// Has the parts, which show `data`, show what lies in all ranges. `colored` is the array that
  /// colours. Throws
  /// Failure for an array that no part has; where one was there at an earlier time step, a warning
  /// tells once that it is missing, and its range is not in force.
  using Parts = std::vector<std::unique_ptr<Part>>;
  void apply(const Parts& parts, const ArrayChoice& colored, const std::vector<NamedData>& data);

  /// Forgets which arrays there were: other files may follow.
  void startAnew()
  {
    known_.clear();
    mostParts_ = 0;
    knownParts_.clear();
  }

private:
  void followSettings();
  void hideData(const Parts& parts, const std::vector<NamedData>& data);
  std::vector<ArrayChoice> applyExpression(const Parts& parts);
  void limitCells(const Parts& parts, const ArrayChoice& colored) const;
  void applyRanges(const Parts& parts, const Part& first);
  void applyRange(const Parts& parts, const ArrayChoice& colored, const Part& first);
  void require(bool found, std::size_t range, const std::string& name, const Part& part,
    const std::string& option);

  const Settings& settings_;
  SelectionSettings followed_;
  std::size_t mostParts_ = 0;        ///< at any time step
  std::set<std::string> knownParts_; ///< names that a data set had
  bool whereKnown_ = false;          ///< --where was of something at some time step
  std::vector<bool> known_;  ///< whether a range's array was there: --show-range, then each --show
  std::vector<bool> warned_; ///< whether a range was told to be missing
};

} // namespace mote::app
