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
};

} // namespace mote
