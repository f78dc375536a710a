#include "detail/BundleClouds.h"

#include <algorithm>

namespace mote
{

BundleClouds::BundleClouds(const Scene& scene, const CameraRays& rays,
  const std::vector<ShadedLight>& lights, const Film& film)
  : rays_(rays)
{
  for (const CloudObject& cloud : scene.clouds)
  {
    CloudTracer& tracer = tracers_.emplace_back(cloud, lights, rays.o0, film.samples());
    tracer.lookFrom(rays, film.width(), film.height());
    sides_.push_back(tracer.sidesOf(rays));
  }
}

void BundleClouds::gather(const Part* parts, int count, RayColor* colors) const
{
  const bool isMixed = tracers_.size() > 1;
  std::vector<Runs> runs(isMixed ? static_cast<std::size_t>(count) : 0);
  for (std::size_t k = 0; k < tracers_.size(); ++k)
  {
    const int most = tracers_[k].walk() ? mostParts : static_cast<int>(BundleSpans::rays);
    for (int first = 0; first < count; first += most)
      this->gather(k, parts + first, std::min(most, count - first), colors + first,
        isMixed ? runs.data() + first : nullptr);
  }
  for (int i = 0; isMixed && i < count; ++i)
  {
    Runs& met = runs[static_cast<std::size_t>(i)];
    std::stable_sort(
      met.begin(), met.end(), [](const RayRun& a, const RayRun& b) { return a.tIn < b.tIn; });
    colors[i] = {};
    for (const RayRun& run : met)
      colors[i].add(run.color);
  }
}

/// Gathers one cloud, where it is shown.
void BundleClouds::gather(
  std::size_t cloud, const Part* parts, int count, RayColor* colors, Runs* runs) const
{
  if (!tracers_[cloud].clip().isAll())
    return this->gatherClipped(cloud, parts, count, colors, runs);
  this->gatherWhole(cloud, parts, count, colors, runs);
}

/// Gathers those parts of one cloud that are shown, one behind another.
void BundleClouds::gatherClipped(
  std::size_t cloud, const Part* parts, int count, RayColor* colors, Runs* runs) const
{
  std::array<std::array<RaySpan, ClipRegion::mostSpans>, mostParts> spans;
  std::array<int, mostParts> counts;
  for (int i = 0; i < count; ++i)
  {
    const auto& [place, from, to] = parts[i];
    const auto r = static_cast<std::size_t>(i);
    counts[r] = tracers_[cloud].clip().spansOf(rays_.originAt(place.x, place.y),
      rays_.directionAt(place.x, place.y), from, to, spans[r].data());
    colors[i] = {};
  }
  std::array<Part, mostParts> some;
  std::array<RayColor, mostParts> theirs;
  std::array<Runs, mostParts> ofSome;
  std::array<int, mostParts> ray;
  for (int s = 0; s < ClipRegion::mostSpans; ++s)
  {
    int found = 0;
    for (int i = 0; i < count; ++i)
    {
      const auto r = static_cast<std::size_t>(i), k = static_cast<std::size_t>(found);
      if (s >= counts[r])
        continue;
      const RaySpan& span = spans[r][static_cast<std::size_t>(s)];
      some[k] = {parts[i].place, span.tIn, span.tOut};
      ofSome[k].clear();
      ray[k] = i;
      ++found;
    }
    if (found > 0)
      this->gatherWhole(cloud, some.data(), found, theirs.data(), runs ? ofSome.data() : nullptr);
    for (int k = 0; k < found; ++k)
    {
      const auto r = static_cast<std::size_t>(k);
      colors[ray[r]].add(theirs[r]);
      if (runs)
        runs[ray[r]].insert(runs[ray[r]].end(), ofSome[r].begin(), ofSome[r].end());
    }
  }
}

void BundleClouds::gatherWhole(
  std::size_t cloud, const Part* parts, int count, RayColor* colors, Runs* runs) const
{
  const CloudTracer& tracer = tracers_[cloud];
  if (tracer.walk())
    return tracer.walk()->gather(parts, count, colors, runs);
  std::array<CloudRay, BundleSpans::rays> rays;
  std::vector<RayGatherer> gatherers;
  std::array<RayGatherer*, BundleSpans::rays> pointers;
  gatherers.reserve(pointers.size());
  for (int i = 0; i < count; ++i)
  {
    const auto r = static_cast<std::size_t>(i);
    const auto& [place, from, to] = parts[i];
    rays[r] =
      tracer.ray(rays_.originAt(place.x, place.y), rays_.directionAt(place.x, place.y), from, to);
    pointers[r] = &gatherers.emplace_back(runs ? runs + i : nullptr);
  }
  tracer.gather(rays.data(), count, sides_[cloud], pointers.data());
  for (int i = 0; i < count; ++i)
    colors[i] = gatherers[static_cast<std::size_t>(i)].total();
}

} // namespace mote
