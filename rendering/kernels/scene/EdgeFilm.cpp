#include "EdgeFilm.h"

#include "RayCaster.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace mote
{

namespace
{

constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U; // spreads small numbers over all bits

/// Group of what a ray met; 0 where that is nothing.
std::uint64_t groupOf(const EdgeGroups& groups, std::int32_t object, std::uint64_t id)
{
  if (object < 0)
    return 0;
  const auto k = static_cast<std::size_t>(object);
  const std::uint64_t own = odd * (k + 1);
  switch (groups.by)
  {
  case EdgeGroups::By::Particle:
    return own ^ (id + 1);
  case EdgeGroups::By::Value:
    // Adding 0 makes one zero of the two that there are.
    return k < groups.values.size() && id < groups.values[k].count()
             ? std::bit_cast<std::uint64_t>(groups.values[k].value(id) + 0.0) | 1U
             : own;
  default:
    return own;
  }
}

} // namespace

DepthImage depthImageOf(const float* depth, int width, int height, const Camera& camera, int sample)
{
  DepthImage image;
  image.width = width;
  image.height = height;
  image.depth = depth;
  const CameraRays rays(camera, width, height);
  if (camera.projection == Camera::Projection::Orthographic)
  {
    image.pixelSize = std::max(glm::length(rays.ox), glm::length(rays.oy));
    return image;
  }
  image.dx = glm::length(rays.dx);
  image.dy = glm::length(rays.dy);
  double jitterX = 0.0, jitterY = 0.0;
  RayCaster::sampleOffset(sample, jitterX, jitterY);
  image.x0 = glm::dot(rays.d0, rays.dx) / image.dx + jitterX * image.dx;
  image.y0 = glm::dot(rays.d0, rays.dy) / image.dy + jitterY * image.dy;
  return image;
}

int silhouetteReach(const SilhouetteOptions& options)
{
  // Lines end half their width and half a pixel from their middle. That is the pixel beside the
  // nearer one, or lies half a pixel towards it: 0.35 along an axis where that is a diagonal.
  const double half = 0.5 * std::max(options.thickness, options.leastThickness) + 0.5;
  return static_cast<int>(std::ceil(half - (options.centered ? 0.35 : 0.0)));
}

float nearSide(const float* depth, int width, int height, int x, int y, int reach)
{
  float nearest = std::numeric_limits<float>::infinity();
  for (int row = std::max(0, y - reach); row <= std::min(height - 1, y + reach); ++row)
  {
    const float* line = depth + static_cast<std::size_t>(row) * width;
    for (int column = std::max(0, x - reach); column <= std::min(width - 1, x + reach); ++column)
      nearest = std::min(nearest, line[column]);
  }
  return nearest;
}

void EdgeFilm::findGroups(const Film& film, const EdgeGroups& groups)
{
  group_.resize(film.pixels());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, film.pixels(), 1 << 14),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        group_[i] = groupOf(groups, film.latestObject()[i], film.latestId()[i]);
    });
}

/// Takes away what lies behind, or hardly in front of, what ends rays, from the edges of some rows.
void EdgeFilm::hideBehind(
  const Film& film, const float* limits, double step, const PixelBox& box, float* edges) const
{
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x, ++edges)
    {
      const float limit = limits[static_cast<std::size_t>(y) * film.width() + x];
      if (*edges <= 0.0f || !std::isfinite(limit))
        continue;
      const float depth = nearSide(film.latestDepth(), film.width(), film.height(), x, y, reach_);
      if (!(depth + step < limit))
        *edges = 0.0f;
    }
}

void EdgeFilm::addRows(const Film& film, const DepthImage& image, const SilhouetteOptions& options,
  const float* limits, const PixelBox& box)
{
  const std::size_t first = static_cast<std::size_t>(box.y0) * image.width;
  const std::size_t count = static_cast<std::size_t>(box.y1 - box.y0) * image.width;
  float* mean = mean_.data() + first;
  std::vector<float> own(samples_ > 0 ? count : 0, 0.0f);
  float* edges = samples_ > 0 ? own.data() : mean;
  if (samples_ == 0)
    std::fill_n(mean, count, 0.0f);
  findSilhouettes(image, options, box, edges, image.width);
  if (limits != nullptr)
    hideBehind(film, limits, options.step, box, edges);
  const float share = 1.0f / static_cast<float>(samples_ + 1);
  for (std::size_t i = 0; samples_ > 0 && i < count; ++i)
    mean[i] += (own[i] - mean[i]) * share;
}

void EdgeFilm::add(const Film& film, const Camera& camera, const SilhouetteOptions& options,
  const EdgeGroups& groups, const float* limits, int threads)
{
  constexpr int bandRows = 128; // which stay in the cache of who works on them
  DepthImage image =
    depthImageOf(film.latestDepth(), film.width(), film.height(), camera, samples_);
  reach_ = silhouetteReach(options);
  mean_.resize(film.pixels());
  const auto work = [&]
  {
    if (groups.by != EdgeGroups::By::Nothing)
    {
      findGroups(film, groups);
      image.group = group_.data();
    }
    tbb::parallel_for(0, (image.height + bandRows - 1) / bandRows,
      [&](int band)
      {
        const int y = band * bandRows;
        addRows(
          film, image, options, limits, {0, y, image.width, std::min(y + bandRows, image.height)});
      });
  };
  if (threads > 0)
    tbb::task_arena(threads).execute(work);
  else
    work();
  ++samples_;
}

} // namespace mote
