#include "detail/BundleClouds.h"

#include <algorithm>

namespace mote
{

BundleClouds::BundleClouds(const Scene& scene, const CameraRays& rays,
  const std::vector<ShadedLight>& lights, int filmSample)
  : rays_(rays)
{
  for (const CloudObject& cloud : scene.clouds)
    sides_.push_back(tracers_.emplace_back(cloud, lights, rays.o0, filmSample).sidesOf(rays));
}

void BundleClouds::gather(const Part* parts, int count, RayColor* colors) const
{
  constexpr std::size_t most = BundleSpans::rays;
  const bool isMixed = tracers_.size() > 1;
  std::array<CloudRay, most> rays;
  std::array<std::vector<RayRun>, most> runs;
  for (std::size_t k = 0; k < tracers_.size(); ++k)
  {
    const CloudTracer& tracer = tracers_[k];
    std::vector<RayGatherer> gatherers;
    std::array<RayGatherer*, most> pointers;
    gatherers.reserve(most);
    for (int i = 0; i < count; ++i)
    {
      const auto r = static_cast<std::size_t>(i);
      const auto& [place, from, to] = parts[i];
      rays[r] =
        tracer.ray(rays_.originAt(place.x, place.y), rays_.directionAt(place.x, place.y), from, to);
      pointers[r] = &gatherers.emplace_back(isMixed ? &runs[r] : nullptr);
    }
    tracer.gather(rays.data(), count, sides_[k], pointers.data());
    for (int i = 0; i < count; ++i)
      colors[i] = gatherers[static_cast<std::size_t>(i)].total();
  }
  for (int i = 0; isMixed && i < count; ++i)
  {
    std::vector<RayRun>& met = runs[static_cast<std::size_t>(i)];
    std::stable_sort(
      met.begin(), met.end(), [](const RayRun& a, const RayRun& b) { return a.tIn < b.tIn; });
    colors[i] = {};
    for (const RayRun& run : met)
      colors[i].add(run.color);
  }
}

} // namespace mote
