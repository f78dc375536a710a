#pragma once

#include "../core/Vec.h"

namespace mote
{

/// A light in world coordinates.
///
/// A light that casts shadows does so from `samples` x `samples` points spread over its `size`; one
/// sample, or no size, gives hard shadows from the middle. A headlight stands in the eye and casts
/// none. See lightSamples() for what numbers out of range mean, and docs/shadows.md.
struct Light
{
  enum class Kind
  {
    Headlight,   ///< shines along each ray from the eye
    Directional, ///< shines along `vector`
    Point        ///< shines from the point `vector`, without falling off
  };
  Kind kind = Kind::Headlight;
  Vec3d vector{0.0, 0.0, -1.0};
  Vec3f color{1.0f}; ///< times intensity
  bool shadows = false;
  int samples = 1; ///< a side of the square of samples, in [1, 64]
  /// Point: edge of the square that the samples fill, in world units; it faces the middle
  /// of the scene's bounds.
  /// Directional: its edge as seen from the scene, in degrees (the sun has 0.53); [0, 170].
  double size = 0.0;

  bool operator==(const Light&) const = default;
};

/// The light that comes from all around, behind all that there is: even, or changing with the
/// cosine to `up` from one colour to another.
struct Sky
{
  Vec3f top{1.0f};
  Vec3f bottom{1.0f};
  Vec3d up{0.0, 0.0, 1.0}; ///< unit length

  /// From a direction of unit length.
  Vec3f operator()(const Vec3d& direction) const
  {
    const auto share = static_cast<float>(0.5 + 0.5 * glm::dot(direction, up));
    return bottom + share * (top - bottom);
  }
  bool operator==(const Sky&) const = default;
};

/// How a surface answers light: Lambert's cosine law, an even part, and Phong's highlight.
struct Material
{
  float ambient = 0.0f;
  float diffuse = 1.0f;
  float specular = 0.0f;
  Vec3f specularColor{1.0f}; ///< of the highlight, whatever colour the surface has
  float specularPower = 1.0f;
  float opacity = 1.0f;
  /// Shown in its colours times the ambient part, in whatever light: no light and no shadow, nor
  /// the sky's, changes them.
  bool isUnlit = false;
  /// For paths alone, which know no ambient part and no Phong: the share of a metal in [0, 1], and
  /// how rough it is, from 0 (a mirror, nearly) to 1.
  float metallic = 0.0f;
  float roughness = 0.5f;

  bool operator==(const Material&) const = default;
};

} // namespace mote
