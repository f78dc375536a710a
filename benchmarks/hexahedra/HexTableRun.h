#pragma once

#include "../Report.h"
#include "VolumeContest.h"

#include <map>
#include <string>
#include <vector>

namespace mote::bench
{

/// One run of the tables.
struct HexTableRun
{
  const Options& options;
  std::vector<std::string> inputs; ///< the parts of a pump, or one
  std::string name;                ///< of the table in the making
  Report report{};
  std::map<std::string, VolumeTask> tasks{};

  /// The task of an input, with the reference where pictures are compared.
  const VolumeTask& task(const std::string& input, bool withReference = true);
  /// What tables are of that look at one input only.
  const VolumeTask& firstTask() { return this->task(inputs.front()); }

  /// Keeps a record of each.
  void record(std::vector<VolumeMeasurement>& measurements);
  std::vector<VolumeMeasurement> race(VolumeContest& contest);
};

} // namespace mote::bench
