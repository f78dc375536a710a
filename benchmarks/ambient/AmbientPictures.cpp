#include "AmbientPictures.h"

#include "../Report.h"

#include <kernels/core/Error.h>
#include <kernels/tracing/RayCaster.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote::bench
{

namespace
{

constexpr int groups = 4; ///< of rays of a reference

/// The camera whose sample number `sample` goes through the pixels' centres, as the first one of
/// `camera` does.
Camera centered(Camera camera, int sample, const PictureSize& size)
{
  double x = 0.0, y = 0.0;
  RayCaster::sampleOffset(sample, x, y);
  camera.centerX -= 2.0 * x / size.width;
  camera.centerY -= 2.0 * y / size.height;
  return camera;
}

/// The shares that one sample of a film finds; others find them with other rays.
void addShares(const Scene& scene, const Camera& camera, const PictureSize& size, int sample,
  std::vector<double>& sum, std::vector<double>& squares)
{
  Film film;
  film.resize(size.width, size.height);
  film.setSamples(sample);
  RayCaster(scene).addSample(centered(camera, sample, size), film);
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    // The samples that the film takes for granted are black and empty: the quotient is this one's,
    // and no number where nothing is seen.
    const double share = double(film.color()[4 * i]) / film.color()[4 * i + 3];
    sum[i] += share;
    squares[i] += share * share;
  }
}

} // namespace

Scene ambientScene(
  const std::shared_ptr<const ParticleStructure>& structure, int rays, double reach)
{
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].surface = ParticleSurface(structure);
  scene.surfaces[0].material.ambient = 1.0f;
  scene.surfaces[0].material.diffuse = 0.0f;
  scene.lights.clear();
  scene.occlusion.rays = rays;
  scene.occlusion.reach = reach;
  return scene;
}

OpenShares openShares(const Scene& scene, const Camera& camera, const PictureSize& size)
{
  Film film;
  film.resize(size.width, size.height, Film::Id);
  RayCaster(scene).addSample(camera, film);
  OpenShares open;
  open.particle.assign(film.id(), film.id() + film.pixels());
  open.share.resize(film.pixels());
  for (std::size_t i = 0; i < film.pixels(); ++i)
    open.share[i] = film.color()[4 * i + 3] > 0.0f ? film.color()[4 * i]
                                                   : std::numeric_limits<float>::quiet_NaN();
  return open;
}

ReferencePicture makeReference(const std::shared_ptr<const ParticleStructure>& structure,
  const View& view, const Box& bounds, const PictureSize& size, int rays, double reach)
{
  ReferencePicture reference{view, cameraOf(view, bounds), size, {}};
  reference.open = openShares(ambientScene(structure, 0, reach), reference.camera, size);
  std::vector<float>& share = reference.open.share;
  reference.hits = static_cast<std::size_t>(
    std::count_if(share.begin(), share.end(), [](float s) { return !std::isnan(s); }));
  if (reference.hits == 0)
    throw Error("View " + view.name + " shows no particle at this size.");
  const Scene scene = ambientScene(structure, (rays + groups - 1) / groups, reach);
  std::vector<double> sum(size.pixels(), 0.0), squares(size.pixels(), 0.0);
  for (int group = 1; group <= groups; ++group)
  {
    progress("reference of view %s: rays %d of %d", view.name.c_str(), group * scene.occlusion.rays,
      groups * scene.occlusion.rays);
    addShares(scene, reference.camera, size, group, sum, squares);
  }
  double variance = 0.0;
  for (std::size_t i = 0; i < size.pixels(); ++i)
    if (!std::isnan(share[i] *= static_cast<float>(sum[i] / groups)))
    {
      const double mean = sum[i] / groups;
      variance += std::max(0.0, squares[i] / groups - mean * mean) / (groups - 1);
    }
  reference.standardError = std::sqrt(variance / static_cast<double>(reference.hits));
  return reference;
}

ShareErrors compare(const OpenShares& picture, const ReferencePicture& reference)
{
  ShareErrors errors;
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.share.size(); ++i)
  {
    const bool same = picture.particle[i] == reference.open.particle[i];
    if (!same || std::isnan(reference.open.share[i]))
      continue;
    const double error = std::abs(double(picture.share[i]) - double(reference.open.share[i]));
    ++errors.checked;
    sum += error * error;
    errors.greatest = std::max(errors.greatest, error);
  }
  errors.rms = std::sqrt(sum / static_cast<double>(errors.checked));
  return errors;
}

} // namespace mote::bench
