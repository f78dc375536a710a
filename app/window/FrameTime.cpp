#include "FrameTime.h"

#include <algorithm>
#include <utility>

namespace mote::app
{

double FrameTime::forRays(double wanted, double least, bool steady)
{
  const double loading = std::exchange(loading_, 0.0);
  ofStep_ = ofStep_ || loading > 0.0;
  const double before = steady ? 0.0 : std::min(loading, 0.5 * wanted);
  // The first step of all has no other to go by.
  const double beside = ofStep_ ? std::max(beside_, besideOfStep_) : beside_;
  return std::max(wanted - beside - before, least);
}

void FrameTime::traced(double frame, double rays)
{
  (std::exchange(ofStep_, false) ? besideOfStep_ : beside_) = frame - rays;
}

} // namespace mote::app
