#pragma once

// What the tests of levels of detail of the P-k-d tree share.

#include "ShadowParts.h"

#include <kernels/particles/PkdTree.h>

#include <support/CastOracle.h>

#include <memory>
#include <vector>

namespace mote::testing
{

/// Particles in a box of side 2 about the origin that touch their neighbours, but for chance.
inline Particles denseParticles(int side, std::uint64_t seed)
{
  Particles particles;
  Random random(seed);
  const double spacing = 2.0 / side;
  for (int i = 0; i < side * side * side; ++i)
  {
    const Vec3d cell(i % side, i / side % side, i / (side * side));
    particles.add(spacing * (cell + random.inBox(Vec3d(0.3), Vec3d(0.7))) - 1.0, 0.5 * spacing);
  }
  return particles;
}

inline std::shared_ptr<ParticleStructure> treeOver(
  const Particles& particles, bool lods, PkdTreeOptions options = {})
{
  auto made = std::make_shared<ParticleStructure>(std::in_place_type<PkdTree>);
  auto& tree = std::get<PkdTree>(*made);
  tree.build(particles.set(), options);
  if (lods)
    tree.makeLods();
  return made;
}

inline const PkdTree& treeOf(const std::shared_ptr<ParticleStructure>& structure)
{
  return std::get<PkdTree>(*structure);
}

/// Bundles of cameras around, from which particles are about as large as pixels or smaller.
inline std::vector<RayBundle> farBundles(int count, std::uint64_t seed)
{
  std::vector<RayBundle> bundles;
  Random random(seed);
  for (int k = 0; k < count; ++k)
  {
    Camera camera = lookAt(random(6.0, 9.0) * random.direction(), Vec3d(0.0), 25.0);
    if (k % 4 == 3)
    {
      camera.projection = Camera::Projection::Orthographic;
      camera.parallelScale = 1.6;
    }
    const CameraRays rays(camera, 64, 64);
    const int side = 4 << (k % 3);
    bundles.emplace_back();
    rays.fillBundle(bundles.back(), side, 16 * (k % 3), 16 * (k / 3 % 3), 0.1, -0.2);
  }
  return bundles;
}

inline Film pictureOf(
  const std::shared_ptr<ParticleStructure>& structure, double poe, const Tracing& tracing = {})
{
  Scene scene;
  SurfaceObject object;
  object.surface = ParticleSurface(structure, poe);
  addTo(scene, object);
  return tracedFilm(scene, lookAt({4.0, 3.0, 6.0}, Vec3d(0.0), 25.0), 96, 96, tracing);
}

inline double meanOf(const Film& film, int channel)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < film.pixels(); ++k)
    sum += film.color()[4 * k + static_cast<std::size_t>(channel)];
  return sum / static_cast<double>(film.pixels());
}

} // namespace mote::testing
