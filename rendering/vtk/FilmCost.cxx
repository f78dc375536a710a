#include "FilmCost.h"

#include <algorithm>

namespace mote
{

namespace
{

constexpr double leastForRays = 0.5; ///< of a film's time

// From film to film.
constexpr double startChange = 0.02;  ///< seconds that a beginning changes by
constexpr double perRayChange = 0.25; ///< of what a ray takes

/// Of what a film takes: how far off it may be for no reason.
constexpr double scatter = 0.15;

/// Seconds that the beginning of a film that was given up may have had.
constexpr double longestStart = 0.05;

constexpr double square(double x)
{
  return x * x;
}

} // namespace

double FilmCost::raysFor(double seconds) const
{
  return std::max(seconds - start_, leastForRays * seconds) / perRay_;
}

void FilmCost::learn(double seconds, double rays, bool complete)
{
  if (!(seconds > 0.0 && rays >= 1.0))
    return;
  startVariance_ += square(startChange);
  perRayVariance_ += square(perRayChange * perRay_);

  const double off = seconds - this->seconds(rays);
  const double ofStart = startVariance_ + rays * covariance_;
  const double ofRay = covariance_ + rays * perRayVariance_;
  const double variance = ofStart + rays * ofRay + square(scatter * seconds);
  start_ = std::clamp(start_ + off * ofStart / variance, 0.0, seconds);
  perRay_ += off * ofRay / variance;
  perRayVariance_ -= ofRay * ofRay / variance;
  covariance_ -= ofStart * ofRay / variance;
  startVariance_ -= ofStart * ofStart / variance;

  // No ray took longer than all of the film, nor less than nothing.
  const double longest = seconds / rays;
  const double least = complete ? 0.0 : seconds - longestStart;
  perRay_ = std::clamp(perRay_, std::max(least / rays, 1e-3 * longest), longest);
}

} // namespace mote
