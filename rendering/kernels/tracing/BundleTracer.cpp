#include "detail/BundleTracer.h"

#include "../shading/SampleSequence.h"
#include "RayCaster.h"
#include "detail/BundlePixels.h"
#include "detail/CloudSquare.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

static_assert(BundleClouds::mostParts >= RayBundle::capacity);
static_assert(BundleClouds::mostParts >= CloudSquare::mostPixels);

/// A bundle on its way: rays, what they hit, and what that looks like.
struct BundleTracer::Bundle
{
  RayBundle rays;  ///< in the coordinates of whichever object they last met
  RayBundle world; ///< where the rays run in the world, nothing else
  SurfaceBlock block;
  std::uint8_t outside[RayBundle::capacity]; ///< 1: no pixel of the film
  bool isInside = true;                      ///< none is outside
  std::size_t pixel[RayBundle::capacity];    ///< of each ray, from that of the first
  alignas(64) float color[RayBundle::capacity][4];
  float normal[RayBundle::capacity][3];
  std::uint64_t id[RayBundle::capacity]; ///< of the input, filled where the film asks for it
  const BundlePixels* pixels = nullptr;
  std::optional<CloudSquare> square; ///< that the bundle lies in, where not every ray is traced

  /// Whether ray i has met anything that is not wholly transparent.
  bool isSeen(int i) const { return color[i][3] > 0.0f; }
  float depthOf(int i) const
  {
    return rays.object[i] >= 0 ? static_cast<float>(rays.t[i])
                               : std::numeric_limits<float>::infinity();
  }
};

BundleTracer::BundleTracer(
  const Scene& scene, const Camera& camera, Film& film, int side, const float* limits)
  : scene_(scene)
  , film_(film)
  , side_(side)
  , limits_(limits)
  , rays_(camera, film.width(), film.height())
  , casts_(scene, rays_)
{
  RayCaster::sampleOffset(film.samples(), jitterX_, jitterY_);
  for (const SurfaceObject& object : scene.surfaces)
  {
    shaders_.emplace_back(object);
    isTransparent_ = isTransparent_ || object.mayBeTransparent();
    mayErr_ = mayErr_ || pixelsOfError(object) > 0.0;
  }
  // Positions count from where the rays start: they are small numbers wherever the scene lies.
  const bool hasPaths = scene.paths.bounces > 0;
  if (hasPaths || isTransparent_)
    sceneRays_.emplace(scene, rays_.o0);
  if (hasPaths)
    paths_.emplace(*sceneRays_, shaders_, rays_, film.samples());
  if (!hasPaths || !scene.clouds.empty())
    lighting_.emplace(scene, rays_.o0, film.samples());
  if (!scene.clouds.empty())
    clouds_.emplace(scene, rays_, lighting_->lights, film);
}

void BundleTracer::traceTile(int x0, int y0, int size) const
{
  int side = side_;
  if (side == 0)
  {
    side = 16;
    for (std::size_t k = 0; k < scene_.surfaces.size(); ++k)
      side = std::min(side, withSurface(scene_.surfaces[k].surface, [&](const auto& s)
                              { return s.bundleSide(casts_.local(k), x0, y0, size); }));
  }
  Bundle bundle;
  bundle.pixels = &pixelsOf(side);
  for (int i = 0; i < side * side; ++i)
    bundle.pixel[i] =
      static_cast<std::size_t>(bundle.pixels->row[i]) * film_.width() + bundle.pixels->column[i];
  const int right = std::min(film_.width(), x0 + size), top = std::min(film_.height(), y0 + size);
  for (int y = y0; y < top; y += side)
    for (int x = x0; x < right; x += side)
    {
      traceBundle(bundle, side, x, y);
      shadeBundle(bundle, side, x, y);
      if (film_.samples() == 0)
        keepFirst(bundle, x, y);
      else
        keep(bundle, x, y);
      if (film_.has(Film::LatestId))
        keepIds(bundle, x, y, film_.latestId(), film_.latestObject());
    }
}

void BundleTracer::traceBundle(Bundle& bundle, int side, int x0, int y0) const
{
  RayBundle& rays = bundle.rays;
  rays_.fillBundle(rays, side, x0, y0, jitterX_, jitterY_);
  bundle.isInside = x0 + side <= film_.width() && y0 + side <= film_.height();
  std::fill_n(bundle.outside, rays.count, std::uint8_t{0});
  for (int i = 0; !bundle.isInside && i < rays.count; ++i)
  {
    bundle.outside[i] = x0 + bundle.pixels->column[i] >= film_.width() ||
                        y0 + bundle.pixels->row[i] >= film_.height();
    if (bundle.outside[i])
      rays.t[i] = -std::numeric_limits<double>::infinity();
  }
  if (limits_ != nullptr)
    limitRays(bundle, x0, y0);
  casts_.cast(rays, side, x0, y0, jitterX_, jitterY_);
}

void BundleTracer::limitRays(Bundle& bundle, int x0, int y0) const
{
  forPixels(bundle, x0, y0,
    [&](int i, std::size_t pixel)
    { bundle.rays.t[i] = std::min(bundle.rays.t[i], double(limits_[pixel])); });
}

/// Width in the world of the bundle at its hits.
double BundleTracer::footprint(const RayBundle& rays, int side) const
{
  double sum = 0.0;
  int hits = 0;
  for (int i = 0; i < rays.count; ++i)
    if (rays.object[i] >= 0)
    {
      sum += rays.t[i];
      ++hits;
    }
  const bool fan = rays.kind == RayBundle::Kind::CommonOrigin;
  const double pixel = fan && hits > 0 ? glm::length(rays_.dx) * sum / hits : glm::length(rays_.ox);
  return side * pixel;
}

/// Gives each hit of the block the seed of its pixel: the same whatever the bundles.
void BundleTracer::seed(Bundle& bundle, int x0, int y0) const
{
  SurfaceBlock& block = bundle.block;
  for (int k = 0; k < block.count; ++k)
  {
    const int ray = block.ray[k];
    block.seed[k] = mixedBits(static_cast<std::uint32_t>(x0 + bundle.pixels->column[ray]),
      static_cast<std::uint32_t>(y0 + bundle.pixels->row[ray]));
  }
}

void BundleTracer::shadeBundle(Bundle& bundle, int side, int x0, int y0) const
{
  const RayBundle& rays = bundle.rays;
  if (std::any_of(rays.object, rays.object + rays.count, [](std::int32_t k) { return k < 0; }))
    std::fill_n(&bundle.color[0][0], 4 * rays.count, 0.0f);
  if (this->wantsNormals())
    std::fill_n(&bundle.normal[0][0], 3 * rays.count, 0.0f);
  rays_.placeBundle(bundle.world, side, x0, y0, jitterX_, jitterY_);
  this->shadeHits(bundle, bundle.rays, side, x0, y0, [&] { this->takeFirst(bundle); });
  if (isTransparent_)
    this->addBehind(bundle, side, x0, y0);
  if (clouds_)
    this->addClouds(bundle, side, x0, y0);
}

/// Shades the hits of `rays`, which are the bundle's, surface by surface; calls take() after each.
template <typename Take>
void BundleTracer::shadeHits(
  Bundle& bundle, RayBundle& rays, int side, int x0, int y0, const Take& take) const
{
  BundlePlacing placing{rays, bundle.world, bundle.world.origin - rays_.o0};
  placing.footprint = lighting_ && lighting_->shadows ? footprint(rays, side) : 0.0;
  const bool ids = wantsIds();
  SurfaceBlock& block = bundle.block;
  block.width = block.widthPerLength = 0.0;
  if (mayErr_)
    measureWidth(block, rays, bundle.world);
  for (std::size_t k = 0; k < shaders_.size(); ++k)
  {
    casts_.local(k).placeBundle(rays, side, x0, y0, jitterX_, jitterY_);
    const SurfaceShader& shader = shaders_[k];
    shader.gather(rays, static_cast<std::int32_t>(k), bundle.outside, block);
    if (block.count == 0)
      continue;
    if (paths_ || lighting_->occlusion)
      seed(bundle, x0, y0);
    if (paths_)
    {
      shader.place(block, placing, true, ids);
      paths_->shade(block);
    }
    else
      shader.shade(block, placing, *lighting_, ids);
    take();
  }
}

namespace
{

/// What comes through less than this is not followed: half a step of 8 bits.
constexpr float leastThrough = 1.0f / 512.0f;

void putBehind(const RayColor& cloud, float* color)
{
  const float through = 1.0f - color[3];
  for (int c = 0; c < 3; ++c)
    color[c] += through * static_cast<float>(cloud.color[c]);
  color[3] += through * static_cast<float>(1.0 - cloud.transmittance);
}

} // namespace

/// The rays of the bundle that do not end at what they have met.
std::vector<PassingRay> BundleTracer::passingRays(const Bundle& bundle, int x0, int y0) const
{
  std::vector<PassingRay> passing;
  forPixels(bundle, x0, y0,
    [&](int i, std::size_t pixel)
    {
      const RayBundle& rays = bundle.rays;
      if (rays.object[i] < 0 || !(bundle.color[i][3] < 1.0f - leastThrough))
        return;
      PassingRay& ray = passing.emplace_back();
      const BundleClouds::Place place = this->placeOf(bundle, i, x0, y0);
      ray.ray = i;
      ray.object = rays.object[i];
      ray.origin = rays_.originAt(place.x, place.y) - rays_.o0;
      ray.direction = rays_.directionAt(place.x, place.y);
      ray.t = rays.t[i];
      ray.limit = limits_ ? std::min(rays_.tMax, double(limits_[pixel])) : rays_.tMax;
      ray.passed = {{rays.object[i], rays.slot[i]}};
    });
  return passing;
}

/// Puts what lies behind surfaces that are not opaque behind them, layer by layer. What is wholly
/// transparent is as if it were not there.
void BundleTracer::addBehind(Bundle& bundle, int side, int x0, int y0) const
{
  std::vector<PassingRay> passing = this->passingRays(bundle, x0, y0);
  if (passing.empty())
    return;
  RayBundle behind = bundle.rays;
  while (!passing.empty())
  {
    std::vector<double> from;
    for (const PassingRay& ray : passing)
      from.push_back(ray.t);
    findNextHits(*sceneRays_, passing, bundle.world.footprint, bundle.world.footprintPerT);
    std::fill_n(behind.object, behind.count, -1);
    for (const PassingRay& ray : passing)
    {
      behind.object[ray.ray] = ray.object;
      behind.slot[ray.ray] = ray.slot;
      behind.t[ray.ray] = ray.object < 0 ? ray.limit : ray.t;
      if (bundle.isSeen(ray.ray))
        continue;
      bundle.rays.object[ray.ray] = ray.object;
      bundle.rays.t[ray.ray] = behind.t[ray.ray];
      std::fill_n(bundle.normal[ray.ray], 3, 0.0f);
    }
    if (clouds_)
      this->addCloudsBehind(bundle, passing, from, x0, y0);
    this->shadeHits(bundle, behind, side, x0, y0, [&] { this->takeBehind(bundle); });
    std::erase_if(passing, [&](const PassingRay& ray)
      { return ray.object < 0 || !(bundle.color[ray.ray][3] < 1.0f - leastThrough); });
  }
}

namespace
{

void takeNormal(const SurfaceBlock& block, int k, float* normal)
{
  normal[0] = block.side[k] * block.normal.x[k];
  normal[1] = block.side[k] * block.normal.y[k];
  normal[2] = block.side[k] * block.normal.z[k];
}

void putBefore(const RayColor& cloud, float* color)
{
  for (int c = 0; c < 3; ++c)
    color[c] = static_cast<float>(cloud.color[c] + cloud.transmittance * color[c]);
  color[3] = static_cast<float>(1.0 - cloud.transmittance * (1.0 - double(color[3])));
}

} // namespace

/// Where a ray of the bundle at (x0, y0) runs.
BundleClouds::Place BundleTracer::placeOf(const Bundle& bundle, int i, int x0, int y0) const
{
  return {
    x0 + bundle.pixels->column[i] + 0.5 + jitterX_, y0 + bundle.pixels->row[i] + 0.5 + jitterY_};
}

/// Puts clouds in front of what the bundle's rays have met.
void BundleTracer::addClouds(Bundle& bundle, int side, int x0, int y0) const
{
  const RayBundle& rays = bundle.rays;
  // Where surfaces end some of the rays neighbours have nothing to do with one another.
  const bool isEven = side >= 8 && std::all_of(rays.t, rays.t + rays.count,
                                     [&](double t) { return t == rays_.tMax; });
  if (scene_.cloudTolerance > 0.0 && isEven && bundle.isInside)
    return this->addCloudsBetween(bundle, side, x0, y0);
  BundleClouds::Part parts[RayBundle::capacity];
  RayColor colors[RayBundle::capacity];
  int ray[RayBundle::capacity], count = 0;
  for (int i = 0; i < rays.count; ++i)
    if (!bundle.outside[i])
    {
      parts[count] = {this->placeOf(bundle, i, x0, y0), rays_.tMin, rays.t[i]};
      ray[count++] = i;
    }
  if (count > 0)
    clouds_->gather(parts, count, colors);
  for (int k = 0; k < count; ++k)
    putBefore(colors[k], bundle.color[ray[k]]);
}

/// The same where not every ray needs to be traced.
void BundleTracer::addCloudsBetween(Bundle& bundle, int side, int x0, int y0) const
{
  // Bundles that nothing is before or behind share what is traced for them.
  const auto fits = [](int at, int size)
  { return at - at % CloudSquare::largest + CloudSquare::largest <= size; };
  const bool isShared = scene_.surfaces.empty() && limits_ == nullptr && fits(x0, film_.width()) &&
                        fits(y0, film_.height());
  const int across = isShared ? CloudSquare::largest : side;
  const int column = x0 % across, row = y0 % across;
  if (column == 0 && row == 0)
  {
    const BundleClouds::Place first = this->placeOf(bundle, 0, x0, y0);
    bundle.square.emplace(across, scene_.cloudTolerance,
      [&](const CloudSquare::Pixel* pixels, int count, RayColor* colors)
      {
        BundleClouds::Part parts[CloudSquare::mostPixels];
        for (int i = 0; i < count; ++i)
          parts[i] = {{first.x + pixels[i].x, first.y + pixels[i].y}, rays_.tMin, rays_.tMax};
        clouds_->gather(parts, count, colors);
      });
  }
  for (int i = 0; i < bundle.rays.count; ++i)
    putBefore((*bundle.square)(column + bundle.pixels->column[i], row + bundle.pixels->row[i]),
      bundle.color[i]);
}

/// Puts what clouds lie between the last hits, at `from`, and the present ones behind what is seen
/// already. Where nothing is, addClouds() does it.
void BundleTracer::addCloudsBehind(Bundle& bundle, const std::vector<PassingRay>& rays,
  const std::vector<double>& from, int x0, int y0) const
{
  BundleClouds::Part parts[RayBundle::capacity];
  RayColor colors[RayBundle::capacity];
  int ray[RayBundle::capacity], count = 0;
  for (std::size_t k = 0; k < rays.size(); ++k)
    if (const int i = rays[k].ray; bundle.isSeen(i))
    {
      const double to = rays[k].object < 0 ? rays[k].limit : rays[k].t;
      parts[count] = {this->placeOf(bundle, i, x0, y0), from[k], to};
      ray[count++] = i;
    }
  if (count > 0)
    clouds_->gather(parts, count, colors);
  for (int k = 0; k < count; ++k)
    putBehind(colors[k], bundle.color[ray[k]]);
}

/// Takes what a shaded block tells of what its rays have met first.
void BundleTracer::takeFirst(Bundle& bundle) const
{
  const SurfaceBlock& block = bundle.block;
  for (int k = 0; k < block.count; ++k)
    std::copy_n(block.out[k], 4, bundle.color[block.ray[k]]);
  for (int k = 0; wantsIds() && k < block.count; ++k)
    bundle.id[block.ray[k]] = block.id[k];
  for (int k = 0; this->wantsNormals() && k < block.count; ++k)
    takeNormal(block, k, bundle.normal[block.ray[k]]);
}

/// Takes what a shaded block tells of what lies behind.
void BundleTracer::takeBehind(Bundle& bundle) const
{
  const SurfaceBlock& block = bundle.block;
  for (int k = 0; k < block.count; ++k)
  {
    const int i = block.ray[k];
    if (!bundle.isSeen(i))
    {
      if (wantsIds())
        bundle.id[i] = block.id[k];
      if (this->wantsNormals())
        takeNormal(block, k, bundle.normal[i]);
    }
    const float through = 1.0f - bundle.color[i][3];
    for (int c = 0; c < 4; ++c)
      bundle.color[i][c] += through * block.out[k][c];
  }
}

/// Calls visit(ray, pixel of the film) for the bundle's rays within the film.
template <typename Visit>
void BundleTracer::forPixels(const Bundle& bundle, int x0, int y0, const Visit& visit) const
{
  const std::size_t corner = static_cast<std::size_t>(y0) * film_.width() + x0;
  const int count = bundle.rays.count;
  if (bundle.isInside)
    for (int i = 0; i < count; ++i)
      visit(i, corner + bundle.pixel[i]);
  else
    for (int i = 0; i < count; ++i)
      if (!bundle.outside[i])
        visit(i, corner + bundle.pixel[i]);
}

/// Adds the bundle to the film. Channel by channel: one stream of memory at a time.
void BundleTracer::keep(const Bundle& bundle, int x0, int y0) const
{
  const float share = 1.0f / static_cast<float>(film_.samples() + 1);
  if (film_.has(Film::Variance))
    // Before the mean moves: by Welford's update the sum grows by difference^2 (1 - share).
    forPixels(bundle, x0, y0,
      [&](int i, std::size_t pixel)
      {
        float sum = 0.0f;
        for (int c = 0; c < 4; ++c)
          sum += std::pow(bundle.color[i][c] - film_.color()[4 * pixel + c], 2.0f);
        film_.squares()[pixel] += 0.25f * sum * (1.0f - share);
      });
  forPixels(bundle, x0, y0,
    [&](int i, std::size_t pixel)
    {
      float* mean = film_.color() + 4 * pixel;
      for (int c = 0; c < 4; ++c)
        mean[c] += (bundle.color[i][c] - mean[c]) * share;
    });
  float* nearest = film_.nearestDepth();
  forPixels(bundle, x0, y0,
    [&](int i, std::size_t pixel)
    { nearest[pixel] = std::min(nearest[pixel], bundle.depthOf(i)); });
  if (film_.has(Film::LatestDepth))
    forPixels(bundle, x0, y0,
      [&](int i, std::size_t pixel) { film_.latestDepth()[pixel] = bundle.depthOf(i); });
}

bool BundleTracer::wantsIds() const
{
  return film_.has(Film::LatestId) || (film_.samples() == 0 && film_.has(Film::Id));
}

bool BundleTracer::wantsNormals() const
{
  return film_.samples() == 0 && film_.has(Film::Normal);
}

/// Writes what the bundle's rays met into two channels.
void BundleTracer::keepIds(
  const Bundle& bundle, int x0, int y0, std::uint64_t* id, std::int32_t* object) const
{
  forPixels(bundle, x0, y0,
    [&](int i, std::size_t pixel)
    {
      const std::int32_t met = bundle.rays.object[i];
      id[pixel] = met >= 0 ? bundle.id[i] : Film::noId;
      object[pixel] = met >= 0 ? scene_.surfaces[static_cast<std::size_t>(met)].id : -1;
    });
}

/// Writes the bundle into the film as its first sample.
void BundleTracer::keepFirst(const Bundle& bundle, int x0, int y0) const
{
  float* color = film_.color();
  forPixels(bundle, x0, y0,
    [&](int i, std::size_t pixel) { std::copy_n(bundle.color[i], 4, color + 4 * pixel); });
  float* depth = film_.depth();
  forPixels(bundle, x0, y0, [&](int i, std::size_t pixel) { depth[pixel] = bundle.depthOf(i); });
  if (film_.has(Film::Variance))
    forPixels(bundle, x0, y0, [&](int, std::size_t pixel) { film_.squares()[pixel] = 0.0f; });
  if (film_.has(Film::Id))
    keepIds(bundle, x0, y0, film_.id(), film_.object());
  if (film_.has(Film::Normal))
    forPixels(bundle, x0, y0,
      [&](int i, std::size_t pixel)
      { std::copy_n(bundle.normal[i], 3, film_.normal() + 3 * pixel); });
}

} // namespace mote
