#pragma once

namespace mote
{

/// How long films of a picture take: a beginning, and each ray. Learned from the films there were.
///
/// What a beginning takes depends on what nobody knows before: memory that a new time step or
/// structure has not touched yet, threads that wait, other work of the machine. So a film of few
/// rays tells little about rays, for its beginning may have taken most of its time; one of many
/// rays tells much. Both are estimated together, by a Kalman filter: what a film took otherwise
/// than expected is shared out by how unsure each of the two is.
class FilmCost
{
public:
  /// Most likely seconds for so many rays.
  double seconds(double rays) const { return start_ + perRay_ * rays; }
  double secondsPerRay() const { return perRay_; }

  /// So many rays that a film most likely takes no longer; half of the time is left to rays
  /// whatever the beginning takes.
  double raysFor(double seconds) const;

  /// A film of so many rays took so long. `complete` tells whether it came to its end, else it was
  /// given up because it took much too long: then rays are what takes time.
  void learn(double seconds, double rays, bool complete);

private:
  double start_ = 0.0;
  /// To begin with, about what clouds take: where rays are faster a finer film follows in the same
  /// frame.
  double perRay_ = 5e-6;
  // Variances of the two, and their covariance.
  double startVariance_ = 0.0, perRayVariance_ = 0.0, covariance_ = 0.0;
};

} // namespace mote
