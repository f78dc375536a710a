#pragma once

#include "../core/Film.h"

namespace mote
{

/// Standard error of a picture, in units of its colours: the root mean square, over the pixels that
/// show something and over their premultiplied red, green, blue and alpha, of the standard error of
/// the pixel's mean, which is the root of the samples' variance over their number. In a pixel that
/// is brighter than 1 errors count as shares of its brightness.
///
/// Infinity before there are two samples; 0 where no pixel shows anything. The film must have
/// Film::Variance. Samples here are spread more evenly than random ones: the true error is smaller
/// (docs/ambient-occlusion.md has figures).
double standardError(const Film& film);

/// When a picture that is refined sample by sample is good enough.
struct Refinement
{
  /// The variance is not believed before there are so many samples.
  static constexpr int fewestSamples = 4;

  int samples = 16;   ///< at most
  double noise = 0.0; ///< enough at this standardError(); 0 or less: only the samples count

  /// What the film must have besides colour and depth.
  unsigned channels() const { return noise > 0.0 ? Film::Variance : 0u; }
  bool isDone(const Film& film) const;
  /// The share of the work that is done, most likely: noise falls with the root of the samples.
  double progress(const Film& film) const;
};

} // namespace mote
