#pragma once

#include "../../core/HitBlock.h"
#include "../../core/RayBundle.h"
#include "../../shading/Light.h"
#include "../../shading/LightSamples.h"

#include <cstdint>

namespace mote
{

/// The hits of a bundle on one surface, with their colours and the light that they receive.
struct SurfaceBlock : HitBlock
{
  std::uint64_t id[capacity];           ///< of the input; filled where somebody asks for it
  std::uint32_t seed[capacity];         ///< of the pixel's random numbers; filled likewise
  alignas(64) float color[capacity][4]; ///< of the surface, with its alpha

  /// How far neighbouring rays of the camera are apart in the world, at the nearest of the hits,
  /// and how much farther behind each unit of length; 0 where no surface may err.
  double width = 0.0, widthPerLength = 0.0;

  alignas(64) float cosine[capacity]; ///< to one light sample; 0 where it lights nothing
  alignas(64) float shine[capacity];  ///< cosine between the mirrored light and the eye, or 0
  Triple<float> even;                 ///< light received, times the material's share
  Triple<float> highlight;
  alignas(64) float out[capacity][4]; ///< red, green, blue times alpha; alpha
};

/// Sets width and widthPerLength for the hits of `rays`, which run in the world as `world` does.
void measureWidth(SurfaceBlock& block, const RayBundle& rays, const RayBundle& world);

/// Sets what light the block has received to nothing but `ambient`.
void beginLight(SurfaceBlock& block, float ambient);

/// Fills cosine and, where `specular`, shine. A sample that coincides with a surface lights it not.
void faceLight(SurfaceBlock& block, const LightSample& sample, bool specular);

/// Adds what a light sample of `color` sends by the cosines and shines there are.
void addLight(SurfaceBlock& block, const Vec3f& color, const Material& material);

/// Fills `out` from the light received, with the alpha of the colours times `opacity`.
void finishSurfaces(SurfaceBlock& block, const Material& material, float opacity);

} // namespace mote
