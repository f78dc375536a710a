#pragma once

#include <kernels/core/Camera.h>
#include <kernels/particles/ParticleStructure.h>

#include <cstdint>
#include <limits>
#include <memory>

namespace mote::bench
{

/// What levels of detail of particles make wrong in a picture. Displacements are in pixels where
/// the hit is: how far a hit on a box lies from the nearest sphere that it stands for; 0 within
/// one.
struct ParticleLodErrors
{
  double rms = unknown;        ///< root mean square of the displacements
  double mostOfMany = unknown; ///< 99.9 % of the hits are displaced by less
  double most = unknown;
  double lods = unknown;  ///< share of the hits that are on boxes
  std::int64_t holes = 0; ///< pixels that miss where the exact picture hits
  std::int64_t extra = 0; ///< pixels that hit where the exact picture misses

  /// Of white particles lit from the eye, 36 rays a pixel against 36 exact ones: how much is
  /// covered, and how bright it is.
  double coverage = unknown, brightness = unknown;
  /// Root mean square errors of their pixels, in [0, 1], against those exact ones, with one ray a
  /// pixel: of the exact picture, and with levels of detail.
  double exactColor = unknown, color = unknown;
  /// Root mean square change of pixels when the camera moves by a quarter of a pixel.
  double exactFlicker = unknown, flicker = unknown;

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
};

/// Casts pictures exactly and with `poe` pixels of error; displacements are those of every hit, or
/// of every n-th where there are more than 60,000. Unknown where there are no levels of detail.
ParticleLodErrors measureParticleLods(const std::shared_ptr<const ParticleStructure>& structure,
  const Camera& camera, int width, int height, double poe);

} // namespace mote::bench
