#include "SilhouetteFilm.h"

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
std::uint64_t groupOf(const SilhouetteGroups& groups, std::int32_t object, std::uint64_t id)
{
  if (object < 0)
    return 0;
  const auto k = static_cast<std::size_t>(object);
  const std::uint64_t own = odd * (k + 1);
  switch (groups.by)
  {
  case SilhouetteGroups::By::Particle:
    return own ^ (id + 1);
  case SilhouetteGroups::By::Value:
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
  const double half = 0.5 * options.thickness + 0.5;
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

void SilhouetteFilm::findGroups(const Film& film, const SilhouetteGroups& groups)
{
  group_.resize(film.pixels());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, film.pixels(), 1 << 14),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        group_[i] = groupOf(groups, film.latestObject()[i], film.latestId()[i]);
    });
}

/// Takes from the silhouettes of some rows what lies behind, or hardly in front of, what ends rays.
void SilhouetteFilm::hideBehind(const DepthImage& image, const float* limits, double step,
  const PixelBox& box, float* coverage, const std::uint8_t* covered) const
{
  for (int y = box.y0; y < box.y1; ++y, covered += blocks_)
    for (int x = box.x0; x < box.x1; ++x, ++coverage)
    {
      const float limit = limits[static_cast<std::size_t>(y) * width_ + x];
      if (covered[x / coveredColumns] == 0 || *coverage <= 0.0f || !std::isfinite(limit))
        continue;
      const float depth = nearSide(image.depth, image.width, image.height, x, y, reach_);
      if (!(depth + step < limit))
        *coverage = 0.0f;
    }
}

void SilhouetteFilm::addRows(const DepthImage& image, const SilhouetteFinder& finder, double step,
  const float* limits, const PixelBox& box)
{
  const std::size_t first = static_cast<std::size_t>(box.y0) * width_;
  const std::size_t firstBlock = static_cast<std::size_t>(box.y0) * blocks_;
  const int rows = box.y1 - box.y0;
  std::vector<float> ownCoverage;
  std::vector<std::uint8_t> ownCovered;
  float* coverage = mean_.data() + first;
  std::uint8_t* covered = covered_.data() + firstBlock;
  if (samples_ > 0)
  {
    ownCoverage.resize(static_cast<std::size_t>(rows) * width_);
    ownCovered.resize(static_cast<std::size_t>(rows) * blocks_);
    coverage = ownCoverage.data();
    covered = ownCovered.data();
  }
  finder.find(box, coverage, width_, covered);
  if (limits != nullptr)
    hideBehind(image, limits, step, box, coverage, covered);
  const float share = 1.0f / static_cast<float>(samples_ + 1);
  for (int block = 0; samples_ > 0 && block < rows * blocks_; ++block)
  {
    std::uint8_t& any = covered_[firstBlock + static_cast<std::size_t>(block)];
    if (any == 0 && covered[block] == 0)
      continue;
    const int x = block % blocks_ * coveredColumns;
    const std::size_t at = static_cast<std::size_t>(block / blocks_) * width_ + x;
    for (std::size_t i = at; i < at + std::min(coveredColumns, width_ - x); ++i)
    {
      const float before = any != 0 ? mean_[first + i] : 0.0f;
      const float own = covered[block] != 0 ? coverage[i] : 0.0f;
      mean_[first + i] = before + (own - before) * share;
    }
    any = 1;
  }
}

void SilhouetteFilm::add(
  const DepthImage& image, const SilhouetteOptions& options, const float* limits, int threads)
{
  constexpr int bandRows = 128; // which stay in the cache of who works on them
  reach_ = silhouetteReach(options);
  width_ = image.width;
  blocks_ = (width_ + coveredColumns - 1) / coveredColumns;
  mean_.resize(static_cast<std::size_t>(image.height) * width_);
  covered_.resize(static_cast<std::size_t>(image.height) * blocks_);
  const SilhouetteFinder finder(image, options);
  const auto work = [&]
  {
    tbb::parallel_for(0, (image.height + bandRows - 1) / bandRows,
      [&](int band)
      {
        const int y = band * bandRows;
        addRows(image, finder, options.step, limits,
          {0, y, width_, std::min(y + bandRows, image.height)});
      });
  };
  if (threads > 0)
    tbb::task_arena(threads).execute(work);
  else
    work();
  ++samples_;
}

void SilhouetteFilm::add(const Film& film, const Camera& camera, const SilhouetteOptions& options,
  const SilhouetteGroups& groups, const float* limits, int threads)
{
  DepthImage image =
    depthImageOf(film.latestDepth(), film.width(), film.height(), camera, samples_);
  if (groups.by != SilhouetteGroups::By::Nothing)
  {
    findGroups(film, groups);
    image.group = group_.data();
  }
  add(image, options, limits, threads);
}

} // namespace mote
