#pragma once

#include "../core/Camera.h"
#include "../core/Progress.h"
#include "../scene/Scene.h"

#include <cstdint>
#include <vector>

namespace mote
{

/// Which particles an image shows, of each surface of the scene: bit slot % 64 of word slot / 64.
/// Empty for surfaces without slots that maps count, see SurfaceKind.
using SeenParticles = std::vector<std::vector<std::uint64_t>>;

/// How an image is looked at.
struct SeenView
{
  int width = 0, height = 0;     ///< pixels
  int samples = 1;               ///< of the film, from the first; see RayCaster::sampleOffset()
  const float* limits = nullptr; ///< as RayCaster::setLimits() has them
  int threads = 0;
};

/// Finds the particles that the rays of an image meet first. Clouds hide nothing. `seen` is what
/// was found so far where `progress` stopped it, which makes the answer false.
bool findSeenParticles(const Scene& scene, const Camera& camera, const SeenView& view,
  SeenParticles& seen, const Progress& progress = {});

} // namespace mote
