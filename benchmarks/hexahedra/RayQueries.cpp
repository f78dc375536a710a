#include "RayQueries.h"

#include <ctime>

namespace mote::bench
{

namespace
{

/// CPU time of this thread, in seconds: other programs do not count.
double cpuSeconds()
{
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What rays meet, summed.
struct Sums
{
  WalkCounts looked;
  std::uint64_t passed = 0, met = 0;
};

Sums count(const HexStructure& structure, const std::vector<HexRay>& rays)
{
  Sums sums;
  withStructure(structure,
    [&](const auto& s)
    {
      for (const HexRay& ray : rays)
      {
        WalkCounts looked;
        std::uint64_t passed = 0;
        s.forCellsAlong(
          ray, [&](const CellSpan&) { return ++passed > 0; }, KeepAll{}, looked);
        if (passed == 0)
          continue;
        ++sums.met;
        sums.passed += passed;
        sums.looked.cells += looked.cells;
        sums.looked.nodes += looked.nodes;
      }
    });
  return sums;
}

double secondsOf(const HexStructure& structure, const std::vector<HexRay>& rays)
{
  const double begin = cpuSeconds();
  double length = 0.0;
  withStructure(structure,
    [&](const auto& s)
    {
      for (const HexRay& ray : rays)
        s.forCellsAlong(ray,
          [&](const CellSpan& span)
          {
            length += span.tOut - span.tIn;
            return length >= 0.0;
          });
    });
  return cpuSeconds() - begin;
}

} // namespace

RayQueries::RayQueries(const VolumeTask& task, const Camera& camera)
  : task_(task)
{
  const CameraRays rays(camera, task.width, task.height);
  for (int y = 0; y < task.height; ++y)
    for (int x = 0; x < task.width; ++x)
      rays_.push_back({rays.originAt(x + 0.5, y + 0.5), rays.directionAt(x + 0.5, y + 0.5),
        rays.tMin, rays.tMax});
}

void RayQueries::add(std::shared_ptr<const HexStructure> structure, VolumeMeasurement said)
{
  const Sums sums = count(*structure, rays_);
  const auto met = static_cast<double>(sums.met);
  said.cellsVisited = static_cast<double>(sums.looked.cells) / met;
  said.nodesVisited = static_cast<double>(sums.looked.nodes) / met;
  said.cellsPassed = static_cast<double>(sums.passed) / met;
  said.threads = 1;
  said_.push_back(std::move(said));
  met_.push_back(met);
  race_.addTimed([this, structure] { return secondsOf(*structure, rays_); });
}

std::vector<VolumeMeasurement> RayQueries::race()
{
  race_.run(task_.repeat);
  for (std::size_t i = 0; i < said_.size(); ++i)
  {
    said_[i].rayMicroseconds = 1e6 * race_.seconds(i) / met_[i];
    progress("%s: %.1f cells tested for %.1f passed, %.3g us a ray", said_[i].method.c_str(),
      said_[i].cellsVisited, said_[i].cellsPassed, said_[i].rayMicroseconds);
  }
  return said_;
}

} // namespace mote::bench
