#pragma once

#include "VolumeContest.h"

namespace mote::bench
{

/// Rays of a camera that go through structures one at a time, and ask for the cells that they pass
/// from end to end: nothing is integrated, and no structure has bundles. All structures answer the
/// same rays in one race, in CPU time of one thread.
class RayQueries
{
public:
  /// The task must outlive this.
  RayQueries(const VolumeTask& task, const Camera& camera);
  RayQueries(const RayQueries&) = delete;
  RayQueries& operator=(const RayQueries&) = delete;

  /// Adds a structure, and counts what rays look at in it. `said` goes into the answer.
  void add(std::shared_ptr<const HexStructure> structure, VolumeMeasurement said);

  /// Times them; in the order of adding.
  std::vector<VolumeMeasurement> race();
  /// After the race: how much longer rays take in one structure than in another, by their places;
  /// the median over the rounds.
  double ratio(std::size_t place, std::size_t base) const { return race_.ratio(place, base); }

private:
  const VolumeTask& task_;
  std::vector<HexRay> rays_;
  std::vector<VolumeMeasurement> said_;
  std::vector<double> met_; ///< rays that pass a cell, for each structure
  Race race_;
};

} // namespace mote::bench
