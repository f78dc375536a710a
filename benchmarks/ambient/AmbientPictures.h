#pragma once

#include "../particles/ParticleInput.h"
#include "../particles/Views.h"

#include <kernels/core/Film.h>
#include <kernels/scene/Scene.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// White particles under an even sky and no light: the picture of a pixel's centre is the open
/// share of what it shows. `rays` a hit find it, each `reach` long (world units, above 0); 0 rays:
/// everything is 1, or what the object's maps say.
Scene ambientScene(
  const std::shared_ptr<const ParticleStructure>& structure, int rays, double reach);

/// Pixels of an image.
struct PictureSize
{
  int width = 0, height = 0;
  std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
};

/// The open share in a view, at the pixels' centres.
struct OpenShares
{
  std::vector<float> share;            ///< NaN where nothing is seen
  std::vector<std::uint64_t> particle; ///< by input index; Film::noId where nothing is seen
};

OpenShares openShares(const Scene& scene, const Camera& camera, const PictureSize& size);

/// What pictures are compared with.
struct ReferencePicture
{
  View view;
  Camera camera;
  PictureSize size;
  OpenShares open;
  std::size_t hits = 0;       ///< pixels that show something
  double standardError = 0.0; ///< of the shares: root of the mean square over these pixels
};

/// Casts `rays` rays a hit, rounded up to a multiple of 4, in four groups that tell from one
/// another how exact their mean is. The rays are others than those of openShares(). Throws Error
/// where the view shows nothing.
ReferencePicture makeReference(const std::shared_ptr<const ParticleStructure>& structure,
  const View& view, const Box& bounds, const PictureSize& size, int rays, double reach);

/// How far a picture is from the reference, over the pixels that show the same particle in both.
struct ShareErrors
{
  std::size_t checked = 0;
  double rms = 0.0; ///< of shares, in [0, 1]
  double greatest = 0.0;
};

ShareErrors compare(const OpenShares& picture, const ReferencePicture& reference);

} // namespace mote::bench
