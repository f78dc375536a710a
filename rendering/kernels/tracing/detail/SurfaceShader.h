#pragma once

#include "SceneLighting.h"

#include <optional>

namespace mote
{

/// Where the rays of a bundle run.
struct BundlePlacing
{
  const RayBundle& local; ///< in the coordinates of the surface that is shaded
  const RayBundle& world; ///< in the world
  Vec3d worldOrigin{0.0}; ///< of `world`, from the reference point
  double footprint = 0.0; ///< as in ShadowCaster::remove()
};

/// The unit normal of the flat face that a hit lies on, so far along its ray, where the clip of an
/// object has cut a solid open.
std::optional<Vec3d> cutFaceAt(const SurfaceObject& object, const Vec3d& point, double distance);

/// Shades hits on one surface by its material, colours and the scene's lights.
class SurfaceShader
{
public:
  /// `object` must stay where it is while the shader lives.
  explicit SurfaceShader(const SurfaceObject& object);

  /// Takes the hits on surface `index` of the bundle into the block. `local` tells where the rays
  /// run in the surface's coordinates; rays whose `skipped` is not 0 are left out.
  void gather(const RayBundle& local, std::int32_t index, const std::uint8_t* skipped,
    SurfaceBlock& block) const;

  /// Shades what gather() took: fills everything that the block holds. Ids are filled where `ids`;
  /// seeds must be filled where the lighting has occlusion.
  void shade(SurfaceBlock& block, const BundlePlacing& placing, const SceneLighting& lighting,
    bool ids) const;

  /// What shade() does before any light: fills colours, normals, sides and, where asked for,
  /// positions and ids.
  void place(SurfaceBlock& block, const BundlePlacing& placing, bool positions, bool ids) const;

  /// Colour of what is hit at a slot, at a point in the surface's coordinates.
  Vec4f colorOf(std::uint64_t slot, const Vec3d& local) const;

  /// Opacity that the side has which is hit at a point by a ray that goes `way`, both in the
  /// surface's coordinates.
  float sideOpacity(std::uint64_t slot, const Vec3d& local, const Vec3d& way) const;

  /// Unit normal in the world, outwards, at a point in the surface's coordinates; 0 where there is
  /// none. Where a hit stands for many, it is what a ray sees of them that goes `way`, which is in
  /// the surface's coordinates too.
  Vec3f normalAt(std::uint64_t slot, const Vec3d& local, const Vec3d& way) const;

private:
  template <typename PointOf>
  void fillColors(
    const std::uint64_t* slots, int count, const PointOf& pointOf, float (*colors)[4]) const;
  template <typename PointOf>
  bool takeValues(
    const std::uint64_t* slots, int count, const PointOf& pointOf, float (*colors)[4]) const;
  void drawEdges(SurfaceBlock& block, const BundlePlacing& placing) const;
  template <typename Take>
  void forCuts(const SurfaceBlock& block, const BundlePlacing& placing, const Take& take) const;
  void lookUpShares(const SurfaceBlock& block, const OcclusionLookUp& found, float* shares) const;
  bool usesMaps() const { return object_.occlusion && object_.material.ambient > 0.0f; }

  const SurfaceObject& object_;
  glm::mat3 normalToWorld_{1.0f};
  glm::mat3 normalToLocal_{1.0f}; ///< times any factor
  double lengthToLocal_ = 1.0;    ///< lengths of the surface's coordinates for one in the world
  bool isIdentity_ = false;
  bool isCut_ = false; ///< solids, by the object's clip
};

} // namespace mote
