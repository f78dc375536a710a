#pragma once

#include "../Report.h"
#include "../Timing.h"
#include "HexStructures.h"
#include "VolumePeers.h"

#include <kernels/core/Film.h>
#include <kernels/tracing/RayCaster.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// What one record says. What has no value, such as the cells visited by a peer, is NaN and null in
/// the record.
struct VolumeMeasurement
{
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::string table{}; ///< empty outside --tables
  std::string method{}, integrator{}, input{};
  std::size_t cells = 0;
  int width = 0, height = 0, threads = 1, repeat = 1;
  double seconds = unknown; ///< a frame, median; then the least and the most
  double least = unknown, most = unknown;
  double buildSeconds = unknown, frameChangeSeconds = unknown, megabytes = unknown;
  double references = unknown, largestLeaf = unknown, lambda2 = unknown;
  double nodes = unknown, levels = unknown;
  double area = unknown, leafArea = unknown; ///< of a hierarchy, in that of the mesh's box
  /// For a ray that meets the volume, the mean.
  double cellsVisited = unknown, nodesVisited = unknown;
  double cellsPassed = unknown, rayMicroseconds = unknown; ///< where nothing is integrated
  double degrees = unknown;                                ///< of the view from the axis
  double fallbacks = unknown; ///< of a walk: cells whose exit signs of edges did not tell
  double step = unknown, tolerance = unknown;
  double cloudTolerance = 0.0; ///< between pixels, see Scene::cloudTolerance
  ColorErrors errors{};
};

Record toRecord(const VolumeMeasurement& measurement);

/// The measurement with what is to be told of the input, and of the structure on its own.
VolumeMeasurement measurementOf(const VolumeTask& task, const BuiltHexStructure& built);

/// The integrators by their names.
const std::vector<std::pair<std::string, VolumeIntegrator>>& volumeIntegrators();

/// How a command line wants rays to be sampled: by trilinear values unless it says otherwise. Rays
/// end at an opacity of 0.9999, in all that is measured.
VolumeSampling samplingOf(const Options& options);

/// Mote's and VTK's casters of one task in one race.
class VolumeContest
{
public:
  /// The task must outlive this.
  explicit VolumeContest(const VolumeTask& task)
    : task_(task)
  {
  }

  /// A way of drawing the structure; `cloudTolerance` is the scene's.
  void add(
    const BuiltHexStructure& built, const VolumeSampling& sampling, double cloudTolerance = 0.0);
  /// VTK's mapper of this name. The tetrahedra must outlive this.
  void addPeer(const std::string& name, const Tetrahedra& tetrahedra);

  /// Draws everyone's frames and compares the last with the reference; in the order of adding.
  std::vector<VolumeMeasurement> race();

private:
  struct Contestant
  {
    VolumeMeasurement said;
    std::function<double()> draw; ///< seconds
    std::function<ColorErrors()> check;
  };

  const VolumeTask& task_;
  std::vector<Contestant> contestants_;
};

} // namespace mote::bench
