#pragma once

#include "../core/Vec.h"

#include <glm/vec2.hpp>

namespace mote
{

/// How a surface sends light on in a path: Lambert's law, a rough metal, or a mixture. It never
/// sends on more than it receives.
///
/// The metal is a surface of mirrors whose slopes follow the GGX distribution, with Smith's
/// height-correlated masking and Schlick's Fresnel factor of the colour (Walter et al., "Microfacet
/// Models for Refraction through Rough Surfaces", 2007; Heitz, "Understanding the Masking-Shadowing
/// Function", JCGT 2014). Light that would be mirrored twice within the surface is lost.
struct Reflectance
{
  /// A metal's slopes are at least so rough: smoother ones mirror lights that have no size as
  /// single bright pixels.
  static constexpr float smoothest = 0.03f;

  Vec3f color{1.0f};     ///< share that is sent on, in [0, 1]
  float metallic = 0.0f; ///< share of the metal, in [0, 1]
  float slope = 0.25f;   ///< of the mirrors, GGX's alpha: roughness squared

  /// pi times the light sent towards `out` per light from `in`, times the cosine to `in`: what a
  /// light of colour 1 from `in` makes the surface look like. Unit vectors away from the surface,
  /// `out` on the side of the normal; 0 for `in` on the other.
  Vec3f shine(const Vec3f& normal, const Vec3f& out, const Vec3f& in) const;

  /// What a sampled direction is worth.
  struct Scattering
  {
    Vec3f direction{0.0f}; ///< where the light comes from; unit length
    Vec3f weight{0.0f};    ///< times its light; at most 1; 0 where there is none
    bool isDiffuse = true;
  };
  /// Chooses where light towards `out` comes from, in proportion to what comes from there: the
  /// mean of weight * light over points `at` of the unit square, and `lobe` of [0, 1), is what is
  /// sent on. Source of the metal's choice: Heitz, "Sampling the GGX Distribution of Visible
  /// Normals", JCGT 7(4), 2018.
  Scattering scatter(
    const Vec3f& normal, const Vec3f& out, const glm::dvec2& at, double lobe) const;
};

/// Unit vector about `normal`, in proportion to its cosine, that stands for a point of the square.
Vec3d cosineDirection(const Vec3d& normal, const glm::dvec2& at);

} // namespace mote
