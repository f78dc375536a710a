#include "EvenSamples.h"

#include <algorithm>

namespace mote
{

EvenSamples::EvenSamples(const HexMesh& mesh, const HexField& field, const CloudSettings& settings,
  const CloudLighting* lighting, Interpolation interpolation, const HexRay& ray, double speed,
  RayGatherer& gatherer)
  : settings_(settings)
  , lighting_(lighting)
  , interpolation_(interpolation)
  , ray_(ray)
  , speed_(speed)
  , step_(settings.step / speed)
  , gatherer_(gatherer)
  , cell_(mesh, field)
  , end_(-std::numeric_limits<double>::infinity())
{
}

/// Spans begin at t, behind a gap.
void EvenSamples::begin(double t)
{
  gatherer_.begin(t);
  from_ = t;
  to_ = (std::floor(t / step_ - settings_.phase) + 1.0 + settings_.phase) * step_;
  if (!(to_ > from_)) // steps below rounding
    to_ = from_ + step_;
}

/// Looks at the volume at t, in the present cell.
void EvenSamples::sample(double t)
{
  if (cell_.isNaN())
  {
    pending_ = settings_.transfer.ofNaN();
    return;
  }
  const Vec3d p = ray_.origin + t * ray_.direction;
  const double value =
    interpolation_ == Interpolation::Trilinear ? cell_.trilinear(p) : cell_.byDistance(p);
  pending_ = settings_.transfer(value);
  if (lighting_ != nullptr && pending_.extinction > 0.0)
    pending_.color = (*lighting_)(pending_.color, p, cell_.gradient(p), ray_.direction);
}

/// Adds the interval that waits for its end.
void EvenSamples::flush(double until)
{
  if (isPending_)
    gatherer_.color().add(pending_, (until - pendingFrom_) * speed_);
  isPending_ = false;
}

bool EvenSamples::operator()(const CellSpan& span)
{
  if (span.tIn > end_)
  {
    finish();
    begin(span.tIn);
  }
  end_ = std::max(end_, span.tOut);
  last_ = span;
  for (double middle = 0.5 * (from_ + to_); middle < span.tOut; middle = 0.5 * (from_ + to_))
  {
    cell_.enter(span.cell);
    flush(from_);
    sample(std::max(middle, span.tIn));
    isPending_ = true;
    pendingFrom_ = from_;
    from_ = to_;
    to_ += step_;
  }
  return gatherer_.transmittance() > settings_.leastTransmittance;
}

void EvenSamples::finish()
{
  if (end_ == -std::numeric_limits<double>::infinity())
    return;
  if (!isPending_ && from_ < end_) // the spans were too short for a sample
  {
    cell_.enter(last_.cell);
    sample(std::clamp(0.5 * (from_ + end_), last_.tIn, last_.tOut));
    isPending_ = true;
    pendingFrom_ = from_;
  }
  flush(end_);
  gatherer_.end();
}

} // namespace mote
