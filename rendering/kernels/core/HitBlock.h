#pragma once

#include "RayBundle.h"

#include <cstdint>

namespace mote
{

/// The hits of a bundle on one surface of a scene, number after number, so that SIMD handles many
/// at a time. Entries of one hit stand at the same index in every array; arrays beyond `count` hold
/// anything.
struct HitBlock
{
  static constexpr int capacity = RayBundle::capacity;

  /// Three numbers a hit.
  template <typename T>
  struct Triple
  {
    alignas(64) T x[capacity];
    alignas(64) T y[capacity];
    alignas(64) T z[capacity];
  };

  int count = 0;
  std::int32_t surface = -1; ///< index in the scene
  std::uint16_t ray[capacity];
  std::uint64_t slot[capacity];
  alignas(64) float rayX[capacity]; ///< place of the ray in its bundle
  alignas(64) float rayY[capacity];
  alignas(64) double t[capacity];
  /// What the kind of surface keeps from its fetch() to its place(), as it likes.
  alignas(64) double own[4][capacity];

  Triple<double> position;          ///< in the world, from the tracer's reference point
  Triple<float> normal;             ///< unit length, in the world, towards the eye
  Triple<float> toEye;              ///< unit length
  alignas(64) float side[capacity]; ///< 1, or -1 where the eye looks at the inner side of a solid
};

/// How positions and normals follow from hits; constant over a surface, or over a bundle.
struct HitPlacing
{
  const RayBundle& local;                   ///< the bundle in the surface's coordinates
  const RayBundle& world;                   ///< the same rays in the world
  Vec3d worldOrigin{0.0};                   ///< of `world`, from the tracer's reference point
  const glm::mat3* normalToWorld = nullptr; ///< times any factor; null where it changes nothing
  bool positions = false;                   ///< whether anybody asks for positions
};

} // namespace mote
