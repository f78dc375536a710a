#pragma once

#include "CellSampler.h"
#include "HexRay.h"
#include "LineBundle.h"
#include "RayColor.h"

namespace mote
{

/// Gathers a ray's colour at even samples: the intervals [k step, (k + 1) step) of the ray, each
/// looking all the way as in its middle. Intervals are cut where the mesh begins and ends, so that
/// of an even field nothing is counted that is not there.
class EvenSamples
{
public:
  enum class Interpolation
  {
    InverseDistance,
    Trilinear
  };

  /// Everything must outlive this; `lighting` may be null. `speed` is the length in the world of
  /// the ray's direction.
  EvenSamples(const HexMesh& mesh, const HexField& field, const CloudSettings& settings,
    const CloudLighting* lighting, Interpolation interpolation, const HexRay& ray, double speed,
    RayGatherer& gatherer);

  /// Takes the ray's next span. False where nothing behind it can be seen.
  bool operator()(const CellSpan& span);
  bool operator()(const ValuedSpan& span) { return (*this)(span.span); }
  /// To be called behind the last span.
  void finish();

private:
  void begin(double t);
  void sample(double t);
  void flush(double until);

  const CloudSettings& settings_;
  const CloudLighting* lighting_; ///< none: colours are seen as they are
  Interpolation interpolation_;
  const HexRay& ray_;
  double speed_, step_; ///< of the ray's t
  RayGatherer& gatherer_;
  CellSampler cell_;
  CellSpan last_;
  double end_;                   ///< of the spans so far
  double from_ = 0.0, to_ = 0.0; ///< the interval that waits for its sample
  double pendingFrom_ = 0.0;     ///< of the interval that waits for its end
  bool isPending_ = false;
  TransferTable::Sample pending_;
};

} // namespace mote
