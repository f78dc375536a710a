#pragma once

#include "SceneLighting.h"

namespace mote
{

/// The light of a scene on points of a cloud with a normal: the material's even part, Lambert's law
/// and Phong's highlight, the side towards the eye being lit. Where there is no normal the cloud
/// has its own colour, times the even part and Lambert's.
class CloudLight
{
public:
  /// Both must outlive this. No light casts shadows here.
  CloudLight(const std::vector<ShadedLight>& lights, const Material& material)
    : lights_(lights)
    , material_(material)
  {
  }

  /// What a colour becomes; linear in the colour. `position` counts from the point that the lights
  /// count from; `normal` and `toEye` are of unit length, the normal may be 0.
  Vec3d operator()(
    const Vec3d& color, const Vec3d& position, const Vec3d& normal, const Vec3d& toEye) const;

private:
  const std::vector<ShadedLight>& lights_;
  const Material& material_;
};

} // namespace mote
