#include "ParticleLodErrors.h"

#include <kernels/scene/Scene.h>
#include <kernels/tracing/RayCaster.h>

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mote::bench
{

namespace
{

struct Hit
{
  std::uint64_t slot;
  Vec3d origin, way;
  double pixel;
};

double displacement(const PkdTree& tree, const Hit& hit)
{
  if (!PkdTree::isLod(hit.slot))
    return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  const SlotRun below = tree.slotsBelow(hit.slot);
  const Vec3d way = glm::normalize(hit.way);
  for (std::size_t slot = below.first; slot < below.last; ++slot)
    nearest = std::min(
      nearest, glm::length(glm::cross(tree.center(slot) - hit.origin, way)) - tree.radius(slot));
  return std::max(0.0, nearest) / hit.pixel;
}

/// Casts both pictures: counts pixels that differ and keeps hits.
std::vector<Hit> hitsOf(const PkdTree& tree, const CameraRays& rays, int width, int height,
  double poe, ParticleLodErrors& errors)
{
  std::vector<Hit> hits;
  for (int y0 = 0; y0 < height; y0 += 16)
    for (int x0 = 0; x0 < width; x0 += 16)
    {
      RayBundle exact;
      rays.fillBundle(exact, 16, x0, y0, 0.0, 0.0);
      RayBundle rough = exact;
      tree.cast(exact, 0);
      tree.cast(rough, 0, poe);
      for (int i = 0; i < exact.count; ++i)
      {
        int x = 0, y = 0;
        bundleOffset(16, i, x, y);
        if (x0 + x >= width || y0 + y >= height)
          continue;
        errors.holes += exact.object[i] == 0 && rough.object[i] != 0;
        errors.extra += exact.object[i] != 0 && rough.object[i] == 0;
        if (rough.object[i] == 0)
          hits.push_back({rough.slot[i], rough.originOf(i), rough.directionOf(i),
            rough.footprint + rough.t[i] * rough.footprintPerT});
      }
    }
  return hits;
}

void measureHits(const PkdTree& tree, const CameraRays& rays, int width, int height, double poe,
  ParticleLodErrors& errors)
{
  const std::vector<Hit> hits = hitsOf(tree, rays, width, height, poe, errors);
  const std::size_t every = 1 + hits.size() / 60000;
  std::vector<double> displacements((hits.size() + every - 1) / every);
  if (displacements.empty())
    return;
  tbb::parallel_for(std::size_t{0}, displacements.size(),
    [&](std::size_t k) { displacements[k] = displacement(tree, hits[k * every]); });
  std::sort(displacements.begin(), displacements.end());
  double squares = 0.0;
  for (const double d : displacements)
    squares += d * d;
  const auto count = static_cast<double>(displacements.size());
  errors.rms = std::sqrt(squares / count);
  errors.most = displacements.back();
  errors.mostOfMany = displacements[static_cast<std::size_t>(0.999 * (count - 1.0))];
  errors.lods = static_cast<double>(std::count_if(hits.begin(), hits.end(),
                  [](const Hit& hit) { return PkdTree::isLod(hit.slot); })) /
                static_cast<double>(hits.size());
}

Film pictureOf(const std::shared_ptr<const ParticleStructure>& structure, const Camera& camera,
  int width, int height, double poe, int samples)
{
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].surface = ParticleSurface(structure, poe);
  Film film;
  film.resize(width, height);
  for (int k = 0; k < samples; ++k)
    RayCaster(scene).addSample(camera, film);
  return film;
}

/// Root mean square difference of the pixels, of those that either picture covers in part.
double difference(const Film& a, const Film& b)
{
  double squares = 0.0, pixels = 0.0;
  for (std::size_t k = 0; k < a.pixels(); ++k)
  {
    const float* const one = a.color() + 4 * k;
    const float* const other = b.color() + 4 * k;
    squares += std::pow(double(one[0]) - double(other[0]), 2);
    pixels += one[3] > 0.0f || other[3] > 0.0f;
  }
  return std::sqrt(squares / std::max(1.0, pixels));
}

double sumOf(const Film& film, int channel)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < film.pixels(); ++k)
    sum += film.color()[4 * k + static_cast<std::size_t>(channel)];
  return sum;
}

} // namespace

ParticleLodErrors measureParticleLods(const std::shared_ptr<const ParticleStructure>& structure,
  const Camera& camera, int width, int height, double poe)
{
  ParticleLodErrors errors;
  const auto* tree = std::get_if<PkdTree>(structure.get());
  if (tree == nullptr || !tree->hasLods())
    return errors;
  const CameraRays rays(camera, width, height);
  measureHits(*tree, rays, width, height, poe, errors);
  constexpr int many = 36;
  Camera moved = camera;
  moved.position += 0.25 * glm::length(camera.forward) * (rays.dx + 0.5 * rays.dy);
  const auto picture = [&](const Camera& from, double error, int samples)
  { return pictureOf(structure, from, width, height, error, samples); };
  const Film fine = picture(camera, 0.0, many), exact = picture(camera, 0.0, 1);
  const Film rough = picture(camera, poe, 1), smooth = picture(camera, poe, many);
  errors.coverage = sumOf(smooth, 3) / sumOf(fine, 3);
  errors.brightness = sumOf(smooth, 0) / sumOf(fine, 0) / errors.coverage;
  errors.exactColor = difference(exact, fine);
  errors.color = difference(rough, fine);
  errors.exactFlicker = difference(exact, picture(moved, 0.0, 1));
  errors.flicker = difference(rough, picture(moved, poe, 1));
  return errors;
}

} // namespace mote::bench
