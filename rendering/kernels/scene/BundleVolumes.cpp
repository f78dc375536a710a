#include "BundleVolumes.h"

#include "Scene.h"

#include <algorithm>

namespace mote
{

BundleVolumes::BundleVolumes(
  const Scene& scene, const CameraRays& rays, const SceneLighting& lighting, int filmSample)
  : rays_(rays)
  , lighting_(lighting)
  , particles_(scene.particles.size())
{
  for (const VolumeObject& volume : scene.volumes)
  {
    const VolumeTracer& tracer =
      tracers_.emplace_back(volume, lighting.lights, rays.o0, filmSample);
    hasSurfaces_ = hasSurfaces_ || tracer.hasSurfaces();
    clouds_ += tracer.hasCloud();
    sides_.push_back(tracer.sidesOf(rays));
  }
}

void BundleVolumes::castRay(RayBundle& rays, int i, const Place& place, Surfaces& surfaces) const
{
  const Vec3d origin = rays_.originAt(place.x, place.y);
  const Vec3d direction = rays_.directionAt(place.x, place.y);
  bool found = false;
  for (std::size_t k = 0; k < tracers_.size(); ++k)
  {
    const VolumeTracer& tracer = tracers_[k];
    if (!tracer.hasSurfaces() || !(rays.t[i] > rays.tMin))
      continue;
    const auto hit = tracer.surface(tracer.ray(origin, direction, rays.tMin, rays.t[i]));
    if (!hit)
      continue;
    rays.t[i] = hit->t;
    rays.slot[i] = hit->cell;
    rays.object[i] = static_cast<std::int32_t>(particles_ + k);
    surfaces.ray[surfaces.count] = static_cast<std::uint16_t>(i);
    surfaces.volume[surfaces.count] = static_cast<std::int32_t>(k);
    surfaces.hit[surfaces.count] = *hit;
    found = true;
  }
  surfaces.count += found;
}

void BundleVolumes::gather(std::int32_t volume, const RayBundle& rays, const Surfaces& surfaces,
  SurfaceBlock& block, const Place* places) const
{
  const VolumeTracer& tracer = tracers_[static_cast<std::size_t>(volume)];
  block.count = 0;
  block.object = static_cast<std::int32_t>(particles_) + volume;
  const float ambient = tracer.volume().material.ambient;
  for (int s = 0; s < surfaces.count; ++s)
  {
    if (surfaces.volume[s] != volume)
      continue;
    const int k = block.count++, i = surfaces.ray[s];
    const IsoHit& hit = surfaces.hit[s];
    const Vec3d direction = rays_.directionAt(places[i].x, places[i].y);
    const Vec3d position = rays_.originAt(places[i].x, places[i].y) - rays_.o0 + hit.t * direction;
    const Vec3d toEye = -glm::normalize(direction);
    Vec3d normal = tracer.normalOf(hit);
    normal = normal == Vec3d(0.0) ? toEye : glm::dot(normal, toEye) < 0.0 ? -normal : normal;
    const auto set = [k](auto& triple, const auto& v)
    {
      using T = std::remove_reference_t<decltype(triple.x[0])>;
      triple.x[k] = static_cast<T>(v.x);
      triple.y[k] = static_cast<T>(v.y);
      triple.z[k] = static_cast<T>(v.z);
    };
    block.ray[k] = static_cast<std::uint16_t>(i);
    block.slot[k] = RayBundle::noHit;
    block.particle[k] = tracer.inputCell(hit);
    block.rayX[k] = rays.x[i];
    block.rayY[k] = rays.y[i];
    block.t[k] = hit.t;
    block.side[k] = 1.0f;
    set(block.position, position);
    set(block.normal, normal);
    set(block.toEye, toEye);
    set(block.even, Vec3f(ambient));
    set(block.highlight, Vec3f(0.0f));
    const Vec4f color = tracer.colorOf(hit);
    std::copy_n(&color.x, 4, block.color[k]);
  }
}

void BundleVolumes::clouds(const Place* places, const double* t, int count, RayColor* colors) const
{
  constexpr std::size_t most = BundleSpans::rays;
  std::array<VolumeRay, most> rays;
  std::array<std::vector<RayRun>, most> runs;
  for (std::size_t k = 0; k < tracers_.size(); ++k)
  {
    const VolumeTracer& tracer = tracers_[k];
    if (!tracer.hasCloud())
      continue;
    std::vector<RayGatherer> gatherers;
    std::array<RayGatherer*, most> pointers;
    gatherers.reserve(most);
    for (int i = 0; i < count; ++i)
    {
      const auto r = static_cast<std::size_t>(i);
      rays[r] = tracer.ray(rays_.originAt(places[i].x, places[i].y),
        rays_.directionAt(places[i].x, places[i].y), rays_.tMin, t[i]);
      pointers[r] = &gatherers.emplace_back(clouds_ > 1 ? &runs[r] : nullptr);
    }
    tracer.gather(rays.data(), count, sides_[k], pointers.data());
    for (int i = 0; i < count; ++i)
      colors[i] = gatherers[static_cast<std::size_t>(i)].total();
  }
  for (int i = 0; clouds_ > 1 && i < count; ++i)
  {
    std::vector<RayRun>& parts = runs[static_cast<std::size_t>(i)];
    std::stable_sort(
      parts.begin(), parts.end(), [](const RayRun& a, const RayRun& b) { return a.tIn < b.tIn; });
    colors[i] = {};
    for (const RayRun& part : parts)
      colors[i].add(part.color);
  }
}

} // namespace mote
