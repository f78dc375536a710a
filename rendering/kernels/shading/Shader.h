#pragma once

#include "../scene/Scene.h"

#include <vector>

namespace mote
{

/// The look of one hit.
struct ShadedHit
{
  Vec4f color{0.0f};          ///< premultiplied by alpha
  Vec3f normal{0.0f};         ///< unit length, in world coordinates
  std::uint64_t particle = 0; ///< input index
};

/// Shades hits on the particles of one object by its material, colours and the scene's lights.
/// Spheres are lit on both sides: whoever stands inside one sees it lit from within.
class ParticleShader
{
public:
  ParticleShader(const ParticleObject& object, const std::vector<Light>& lights);

  /// The hit at origin + t * direction (world coordinates) on the particle at `slot`.
  ShadedHit shade(const Vec3d& origin, const Vec3d& direction, double t, std::uint64_t slot) const;

private:
  Vec4f colorOf(std::uint64_t particle) const;
  /// Light that leaves a surface of this colour towards the eye.
  Vec3f lit(
    const Vec3f& color, const Vec3f& normal, const Vec3f& toEye, const Vec3d& position) const;

  const ParticleObject& object_;
  const std::vector<Light>& lights_;
  Mat4d toLocal_;
  Mat3d normalToWorld_;
};

} // namespace mote
