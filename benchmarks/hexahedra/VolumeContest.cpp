#include "VolumeContest.h"

#include <kernels/tracing/detail/CloudTracer.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace mote::bench
{

namespace
{

/// A whole number as such, null for none.
Value counted(double number)
{
  if (std::isnan(number))
    return number;
  return static_cast<std::int64_t>(number);
}

/// What draws a structure, frame after frame.
struct Caster
{
  Scene scene;
  Camera camera;
  Film film;
  bool singleRays = false;

  void draw()
  {
    if (singleRays)
      return drawRayByRay();
    film.setSamples(0);
    RayCaster(scene).addSample(camera, film);
  }

private:
  void drawRayByRay()
  {
    const int width = film.width();
    const CameraRays rays(camera, width, film.height());
    const std::vector<ShadedLight> noLights;
    const CloudTracer tracer(scene.clouds.front(), noLights, rays.o0, 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, film.pixels(), 64),
      [&](const tbb::blocked_range<std::size_t>& pixels)
      {
        for (std::size_t i = pixels.begin(); i != pixels.end(); ++i)
        {
          const double x = static_cast<double>(i % static_cast<std::size_t>(width)) + 0.5,
                       y = static_cast<double>(i / static_cast<std::size_t>(width)) + 0.5;
          RayGatherer gatherer(nullptr);
          tracer.gather(
            tracer.ray(rays.originAt(x, y), rays.directionAt(x, y), rays.tMin, rays.tMax),
            gatherer);
          const RayColor& seen = gatherer.total();
          const Vec4f color(Vec3f(seen.color), static_cast<float>(1.0 - seen.transmittance));
          std::copy_n(&color.x, 4, film.color() + 4 * i);
        }
      });
  }
};

std::string nameOf(VolumeIntegrator integrator)
{
  for (const auto& [name, value] : volumeIntegrators())
    if (value == integrator)
      return name;
  return "";
}

/// What rays looked at, summed over those that meet the volume.
struct Visits
{
  std::uint64_t rays = 0, cells = 0, nodes = 0;

  Visits operator+(const Visits& other) const
  {
    return {rays + other.rays, cells + other.cells, nodes + other.nodes};
  }
};

Visits rowVisits(const CloudTracer& tracer, const CameraRays& rays, int width, int y)
{
  Visits visits;
  for (int x = 0; x < width; ++x)
  {
    RayGatherer gatherer(nullptr);
    WalkCounts counts;
    tracer.gather(tracer.ray(rays.originAt(x + 0.5, y + 0.5), rays.directionAt(x + 0.5, y + 0.5),
                    rays.tMin, rays.tMax),
      gatherer, counts);
    if (gatherer.transmittance() < 1.0)
      visits = visits + Visits{1, counts.cells, counts.nodes};
  }
  return visits;
}

/// Walks the task's rays once more, counting.
void countSteps(const VolumeTask& task, const CloudTracer& tracer, VolumeMeasurement& m)
{
  const CameraRays rays = task.rays();
  std::uint64_t met = 0;
  for (int y = 0; y < task.height; ++y)
    for (int x0 = 0; x0 < task.width; x0 += CellWalk::mostRays)
    {
      const int count = std::min(task.width - x0, CellWalk::mostRays);
      CellWalk::Part parts[CellWalk::mostRays];
      for (int i = 0; i < count; ++i)
        parts[i] = {{x0 + i + 0.5, y + 0.5}, rays.tMin, rays.tMax};
      RayColor colors[CellWalk::mostRays];
      tracer.walk()->gather(parts, count, colors, nullptr);
      met += static_cast<std::uint64_t>(std::count_if(
        colors, colors + count, [](const RayColor& c) { return c.transmittance < 1.0; }));
    }
  const WalkSteps counts = tracer.walk()->counts();
  m.cellsVisited = static_cast<double>(counts.steps) / static_cast<double>(met);
  m.fallbacks = static_cast<double>(counts.fallbacks);
  progress("walk: %llu steps, %llu fallbacks, %llu integrated one at a time",
    static_cast<unsigned long long>(counts.steps),
    static_cast<unsigned long long>(counts.fallbacks),
    static_cast<unsigned long long>(counts.seldom));
}

/// Casts the task's rays once more, counting.
void countVisits(const VolumeTask& task, const CloudObject& volume, VolumeMeasurement& m)
{
  const CameraRays rays = task.rays();
  const std::vector<ShadedLight> noLights;
  CloudTracer tracer(volume, noLights, rays.o0, 0);
  if (tracer.lookFrom(rays, task.width, task.height))
    return countSteps(task, tracer, m);
  const Visits visits = tbb::parallel_reduce(
    tbb::blocked_range<int>(0, task.height), Visits(),
    [&](const tbb::blocked_range<int>& rows, Visits part)
    {
      for (int y = rows.begin(); y != rows.end(); ++y)
        part = part + rowVisits(tracer, rays, task.width, y);
      return part;
    },
    std::plus<>());
  m.cellsVisited = static_cast<double>(visits.cells) / static_cast<double>(visits.rays);
  m.nodesVisited = static_cast<double>(visits.nodes) / static_cast<double>(visits.rays);
}

} // namespace

Record toRecord(const VolumeMeasurement& m)
{
  Record record = {{"suite", std::string("hexahedra")}};
  if (!m.table.empty())
    record.emplace_back("table", m.table);
  const Record more = {{"method", m.method}, {"integrator", m.integrator}, {"input", m.input},
    {"view", wholeView.first}, {"cells", static_cast<std::int64_t>(m.cells)},
    {"width", std::int64_t{m.width}}, {"height", std::int64_t{m.height}},
    {"threads", std::int64_t{m.threads}}, {"repeat", std::int64_t{m.repeat}},
    {"fps", 1.0 / m.seconds}, {"fps_min", 1.0 / m.most}, {"fps_max", 1.0 / m.least},
    {"build_s", m.buildSeconds}, {"frame_change_s", m.frameChangeSeconds},
    {"memory_mb", m.megabytes}, {"references", counted(m.references)},
    {"max_cells_per_leaf", counted(m.largestLeaf)}, {"lambda2", m.lambda2},
    {"cells_visited", m.cellsVisited}, {"nodes_visited", m.nodesVisited},
    {"cells_passed", m.cellsPassed}, {"us_per_ray", m.rayMicroseconds}, {"degrees", m.degrees},
    {"nodes", counted(m.nodes)}, {"levels", counted(m.levels)}, {"area", m.area},
    {"leaf_area", m.leafArea}, {"fallbacks", counted(m.fallbacks)}, {"step", m.step},
    {"tolerance", m.tolerance}, {"cloud_tolerance", m.cloudTolerance},
    {"checked_pixels", static_cast<std::int64_t>(m.errors.checked)}, {"rms_error", m.errors.rms},
    {"max_error", m.errors.max}};
  record.insert(record.end(), more.begin(), more.end());
  return record;
}

const std::vector<std::pair<std::string, VolumeIntegrator>>& volumeIntegrators()
{
  static const std::vector<std::pair<std::string, VolumeIntegrator>> all = {
    {"inverse-distance", VolumeIntegrator::InverseDistance},
    {"trilinear", VolumeIntegrator::Trilinear}, {"cell-by-cell", VolumeIntegrator::CellByCell}};
  return all;
}

VolumeSampling samplingOf(const Options& options)
{
  VolumeSampling sampling;
  sampling.step = options.step;
  sampling.tolerance = options.tolerance;
  sampling.saturation = 0.9999;
  for (const auto& [name, value] : volumeIntegrators())
    if (name == options.integrator)
      sampling.integrator = value;
  return sampling;
}

namespace
{

VolumeMeasurement measurement(const VolumeTask& task, const std::string& method)
{
  VolumeMeasurement m;
  m.method = method;
  m.input = task.input.name;
  m.cells = task.input.mesh->cellCount();
  m.width = task.width;
  m.height = task.height;
  m.threads = task.threads;
  m.repeat = task.repeat;
  return m;
}

} // namespace

VolumeMeasurement measurementOf(const VolumeTask& task, const BuiltHexStructure& built)
{
  VolumeMeasurement m = measurement(task, built.method);
  m.buildSeconds = built.buildSeconds;
  m.frameChangeSeconds = built.frameChangeSeconds;
  m.megabytes = built.megabytes;
  if (!built.walk)
  {
    m.references = static_cast<double>(built.references);
    m.largestLeaf = static_cast<double>(built.largestLeaf);
    m.nodes = static_cast<double>(built.shape.nodes);
    m.levels = static_cast<double>(built.shape.levels);
    if (built.shape.area > 0.0)
    {
      const Vec3d d = task.input.mesh->bounds().size();
      const double box = 2.0 * (d.x * d.y + d.y * d.z + d.z * d.x);
      m.area = built.shape.area / box;
      m.leafArea = built.shape.leafArea / box;
    }
  }
  if (built.method.find("grid") != std::string::npos)
    m.lambda2 = built.lambda2;
  return m;
}

void VolumeContest::add(
  const BuiltHexStructure& built, const VolumeSampling& wanted, double cloudTolerance)
{
  VolumeMeasurement m = measurementOf(task_, built);
  VolumeSampling sampling = wanted;
  if (built.walk)
    sampling.integrator = VolumeIntegrator::CellByCell;
  m.integrator = nameOf(sampling.integrator);
  const auto caster = std::make_shared<Caster>();
  caster->scene.clouds = {task_.volume(built.structure, sampling)};
  caster->scene.clouds[0].walk = built.walk;
  caster->scene.cloudTolerance = m.cloudTolerance = cloudTolerance;
  caster->camera = task_.camera;
  caster->film.resize(task_.width, task_.height);
  caster->singleRays = task_.singleRays && !built.walk;
  if (sampling.integrator == VolumeIntegrator::CellByCell)
    m.tolerance = sampling.tolerance;
  else
    m.step = sampling.step > 0.0 ? sampling.step : volumeStep(caster->scene.clouds.front());
  countVisits(task_, caster->scene.clouds.front(), m);
  contestants_.push_back(
    {m, [this, caster] { return timed(task_.threads, [&] { caster->draw(); }); },
      [this, caster] { return compare(task_.reference, caster->film.color()); }});
}

void VolumeContest::addPeer(const std::string& name, const Tetrahedra& tetrahedra)
{
  VolumeMeasurement m = measurement(task_, name);
  m.integrator = name == "vtk-raycast" ? "partial-pre-integration" : "projection";
  m.buildSeconds = tetrahedra.seconds;
  m.megabytes = tetrahedra.megabytes;
  const auto peer = std::make_shared<VolumePeer>(name, task_, tetrahedra);
  contestants_.push_back({m, [peer] { return peer->draw(); },
    [this, peer] { return compare(task_.reference, peer->colors().data()); }});
}

std::vector<VolumeMeasurement> VolumeContest::race()
{
  Race race;
  for (const Contestant& contestant : contestants_)
    race.addTimed(contestant.draw);
  progress("drawing %d rounds of %zu", task_.repeat, contestants_.size());
  race.run(task_.repeat);
  std::vector<VolumeMeasurement> all;
  for (std::size_t i = 0; i < contestants_.size(); ++i)
  {
    VolumeMeasurement m = contestants_[i].said;
    m.seconds = race.seconds(i);
    m.least = race.least(i);
    m.most = race.most(i);
    m.errors = contestants_[i].check();
    progress("%s, %s: %.3g s, rms error %.2e", m.method.c_str(), m.integrator.c_str(), m.seconds,
      m.errors.rms);
    all.push_back(std::move(m));
  }
  return all;
}

} // namespace mote::bench
