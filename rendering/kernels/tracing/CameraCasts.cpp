#include "detail/CameraCasts.h"

#include "detail/ClippedRays.h"

namespace mote
{

CameraCasts::CameraCasts(const Scene& scene, const CameraRays& rays)
  : scene_(scene)
  , rays_(rays)
{
  for (const SurfaceObject& object : scene.surfaces)
    local_.push_back(rays.transformed(glm::inverse(object.toWorld)));
}

void CameraCasts::cast(
  RayBundle& rays, int side, int x0, int y0, double jitterX, double jitterY) const
{
  for (std::size_t k = 0; k < local_.size(); ++k)
  {
    const SurfaceObject& object = scene_.surfaces[k];
    const auto index = static_cast<std::int32_t>(k);
    local_[k].placeBundle(rays, side, x0, y0, jitterX, jitterY);
    if (object.clip.isAll())
    {
      withSurface(object.surface, [&](const auto& s) { s.cast(rays, index); });
      continue;
    }
    RayBundle world;
    rays_.placeBundle(world, side, x0, y0, jitterX, jitterY);
    withSurface(object.surface,
      [&](const auto& s)
      {
        castClipped(
          object.clip, world, OnSurface::Neither, rays, [&](RayBundle& all) { s.cast(all, index); },
          [&](ClippedPacket& clipped, RayPacket& packet)
          { clipped.castNearest(packet, s, index); });
      });
  }
}

} // namespace mote
