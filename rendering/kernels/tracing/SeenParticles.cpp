#include "SeenParticles.h"

#include "RayCaster.h"
#include "Tiles.h"
#include "detail/CameraCasts.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace mote
{

namespace
{

/// Sets a bit that other threads may set, too.
void setBit(std::vector<std::uint64_t>& bits, std::uint64_t k)
{
  const std::atomic_ref<std::uint64_t> word(bits[k / 64]);
  const std::uint64_t bit = std::uint64_t{1} << (k % 64);
  if ((word.load(std::memory_order_relaxed) & bit) == 0)
    word.fetch_or(bit, std::memory_order_relaxed);
}

/// The scene without levels of detail of particles: a box that stands for many of them does not
/// tell which are seen.
Scene ofSingleParticles(Scene scene)
{
  for (SurfaceObject& object : scene.surfaces)
    if (auto* particles = std::get_if<ParticleSurface>(&object.surface))
      *particles = ParticleSurface(particles->structure());
  return scene;
}

/// One film sample's rays.
class Look
{
public:
  Look(const Scene& scene, const Camera& camera, const SeenView& view, int sample)
    : view_(view)
    , rays_(camera, view.width, view.height)
    , casts_(scene, rays_)
  {
    RayCaster::sampleOffset(sample, jitterX_, jitterY_);
  }

  void add(int x0, int y0, SeenParticles& seen) const
  {
    constexpr int side = 8;
    RayBundle bundle;
    for (int y = y0; y < std::min(y0 + tileSize, view_.height); y += side)
      for (int x = x0; x < std::min(x0 + tileSize, view_.width); x += side)
      {
        rays_.fillBundle(bundle, side, x, y, jitterX_, jitterY_);
        limit(bundle, side, x, y);
        casts_.cast(bundle, side, x, y, jitterX_, jitterY_);
        for (int i = 0; i < bundle.count; ++i)
          if (bundle.object[i] >= 0)
            if (auto& bits = seen[static_cast<std::size_t>(bundle.object[i])]; !bits.empty())
              setBit(bits, bundle.slot[i]);
      }
  }

private:
  /// Ends rays at the limits, and at once where they are of no pixel.
  void limit(RayBundle& bundle, int side, int x0, int y0) const
  {
    for (int i = 0; i < bundle.count; ++i)
    {
      int x = 0, y = 0;
      bundleOffset(side, i, x, y);
      x += x0;
      y += y0;
      if (x >= view_.width || y >= view_.height)
        bundle.t[i] = -std::numeric_limits<double>::infinity();
      else if (view_.limits)
        bundle.t[i] = std::min(
          bundle.t[i], double(view_.limits[static_cast<std::size_t>(y) * view_.width + x]));
    }
  }

  const SeenView& view_;
  CameraRays rays_;
  CameraCasts casts_;
  double jitterX_ = 0.0, jitterY_ = 0.0;
};

} // namespace

bool findSeenParticles(const Scene& scene, const Camera& camera, const SeenView& view,
  SeenParticles& seen, const Progress& progress)
{
  seen.clear();
  const Scene looked = ofSingleParticles(scene);
  for (const SurfaceObject& object : looked.surfaces)
    seen.emplace_back(
      (withSurface(object.surface, [](const auto& s) { return s.slots(); }) + 63) / 64);
  for (int sample = 0; sample < view.samples; ++sample)
  {
    const Look look(looked, camera, view, sample);
    const auto part = [&](double done)
    { return !progress || progress((sample + done) / view.samples); };
    if (!forTiles(view.width, view.height, view.threads, part,
          [&](int x0, int y0) { look.add(x0, y0, seen); }))
      return false;
  }
  return true;
}

} // namespace mote
