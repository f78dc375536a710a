#pragma once

#include "../core/RayBundle.h"
#include "Light.h"
#include "LightSamples.h"

#include <cstdint>

namespace mote
{

/// The hits of a bundle on one object, number after number, so that SIMD shades many at a time.
/// Entries of one hit stand at the same index in every array; arrays beyond `count` hold anything.
struct SurfaceBlock
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
  std::int32_t object = -1; ///< in the scene
  std::uint16_t ray[capacity];
  std::uint64_t slot[capacity];
  std::uint64_t particle[capacity]; ///< input index; filled where somebody asks for it
  std::uint32_t seed[capacity];     ///< of the pixel's random numbers; filled likewise
  alignas(64) float rayX[capacity]; ///< place of the ray in its bundle
  alignas(64) float rayY[capacity];
  alignas(64) double t[capacity];
  Triple<double> center; ///< of the particle, in the object's coordinates
  alignas(64) double radius[capacity];

  Triple<double> position;              ///< in the world, from the tracer's reference point
  Triple<float> normal;                 ///< unit length, in the world, towards the eye
  Triple<float> toEye;                  ///< unit length
  alignas(64) float side[capacity];     ///< 1, or -1 where the eye sees the sphere from within
  alignas(64) float color[capacity][4]; ///< of the surface, with its alpha

  alignas(64) float cosine[capacity]; ///< to one light sample; 0 where it lights nothing
  alignas(64) float shine[capacity];  ///< cosine between the mirrored light and the eye, or 0
  Triple<float> even;                 ///< light received, times the material's share
  Triple<float> highlight;
  alignas(64) float out[capacity][4]; ///< red, green, blue times alpha; alpha
};

/// How positions and normals follow from hits; constant over an object, or over a bundle.
struct SurfacePlacing
{
  const RayBundle* local = nullptr; ///< the bundle in the object's coordinates
  const RayBundle* world = nullptr;
  Vec3d worldOrigin{0.0};                   ///< of the bundle, from the reference point
  const glm::mat3* normalToWorld = nullptr; ///< times any factor; null where it changes nothing
  bool positions = false;                   ///< whether anybody asks for positions
};

/// Fills normal, toEye, side and, where asked for, position; sets what light the block has received
/// to nothing but `ambient`.
void placeSurfaces(SurfaceBlock& block, const SurfacePlacing& placing, float ambient);

/// Fills cosine and, where `specular`, shine. A sample that coincides with a surface lights it not.
void faceLight(SurfaceBlock& block, const LightSample& sample, bool specular);

/// Adds what a light sample of `color` sends by the cosines and shines there are.
void addLight(SurfaceBlock& block, const Vec3f& color, const Material& material);

/// Fills `out` from the light received.
void finishSurfaces(SurfaceBlock& block, const Material& material);

} // namespace mote
