// Soft shadows: time and noise against the number of samples of the light.

#include "Tables.h"

#include <kernels/tracing/RayCaster.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mote::bench
{

namespace
{

constexpr int finestSamples = 32; ///< a side; what the noise is measured against
constexpr int largestSide = 512;  ///< pixels: the finest picture takes a thousand rays for each

/// A light above and beside the data, as large as a quarter of its longest side.
Light lightOver(const Box& bounds)
{
  const Vec3d size = bounds.size();
  const double side = std::max({size.x, size.y, size.z});
  Light light;
  light.kind = Light::Kind::Point;
  light.vector = bounds.center() + Vec3d(0.4, 1.5, 0.9) * side;
  light.size = 0.25 * side;
  return light;
}

/// Scenes that differ in the light alone.
Scene sceneOf(const std::shared_ptr<const ParticleStructure>& structure, Light light, int samples)
{
  light.shadows = samples > 0;
  light.samples = std::max(1, samples);
  if (samples == 1)
    light.size = 0.0; // hard
  Scene scene;
  SurfaceObject object;
  object.surface = ParticleSurface(structure);
  object.material.ambient = 0.1f;
  scene.surfaces.push_back(std::move(object));
  scene.lights = {light};
  return scene;
}

void draw(const Scene& scene, const Camera& camera, const Options& options, Film& film)
{
  film.resize(std::min(largestSide, options.width), std::min(largestSide, options.height));
  RayCaster(scene).addSample(camera, film);
}

/// Root of the mean square of the difference in colour over the pixels that show something.
double noise(const Film& film, const Film& finest)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    const float *a = film.color() + 4 * i, *b = finest.color() + 4 * i;
    if (!(b[3] > 0.0f))
      continue;
    for (int c = 0; c < 3; ++c, ++count)
      sum += std::pow(double(a[c]) - b[c], 2);
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

std::string sampleText(int samples)
{
  return samples == 0 ? "no shadows" : format("%dx%d", samples, samples);
}

/// One table in the making.
struct Shadows
{
  static constexpr int samples[] = {0, 1, 2, 4, 8};
  static constexpr std::size_t count = std::size(samples);

  TableRun& run;
  Light light;
  std::shared_ptr<const ParticleStructure> structure{};
  std::vector<Scene> scenes{};
  std::vector<Camera> cameras{};
  std::vector<Film> finest{}; ///< by view
  Film film{};
  Race race{};
  double buildSeconds = 0.0;

  explicit Shadows(TableRun& of)
    : run(of)
    , light(lightOver(of.input.statistics.bounds))
  {
    ParticleStructureOptions options;
    options.coherentGrid.cellsPerParticle = run.options.lambda;
    buildSeconds =
      timed(run.threads, [&] { structure = makeParticleStructure(run.input.set, options); });
    for (const int n : samples)
      scenes.push_back(sceneOf(structure, light, n));
    for (const View& view : run.views)
      cameras.push_back(cameraOf(view, run.input.statistics.bounds));
  }

  void runRace()
  {
    for (const Camera& camera : cameras)
      for (const Scene& scene : scenes)
        race.add(run.threads, [&] { draw(scene, camera, run.options, film); });
    race.run(run.options.repeat);
    for (const Camera& camera : cameras)
    {
      progress("a picture with %s samples", sampleText(finestSamples).c_str());
      finest.emplace_back();
      draw(sceneOf(structure, light, finestSamples), camera, run.options, finest.back());
    }
  }

  double timesNoShadows(std::size_t k, std::size_t view) const
  {
    return race.seconds(view * count + k) / race.seconds(view * count);
  }

  Measurement measure(std::size_t k, std::size_t view, double& error)
  {
    const std::size_t place = view * count + k;
    Measurement m = run.measurement("cgt", sampleText(samples[k]));
    m.view = run.views[view].name;
    m.width = film.width();
    m.height = film.height();
    m.setTimes(race, place);
    m.buildSeconds = buildSeconds;
    const std::size_t bytes = withStructure(*structure, [](const auto& s) { return s.bytes(); });
    m.bytesPerParticle =
      static_cast<double>(bytes) / static_cast<double>(run.input.statistics.valid);
    draw(scenes[k], cameras[view], run.options, film);
    error = noise(film, finest[view]);
    m.more = {{"shadow_samples", std::int64_t{samples[k]} * samples[k]},
      {"times_no_shadows", timesNoShadows(k, view)}, {"rms_error", error}};
    return m;
  }
};

} // namespace

Section shadowTable(TableRun& run)
{
  Shadows shadows(run);
  shadows.runRace();
  Section section;
  std::vector<std::string> titles = {"samples"};
  for (const View& view : run.views)
    for (const char* what : {" ms", " x no shadows", " RMS error"})
      titles.push_back(view.name + what);
  section.table.add(titles);
  for (std::size_t k = 0; k < Shadows::count; ++k)
  {
    std::vector<std::string> row = {sampleText(Shadows::samples[k])};
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      double error = 0.0;
      const Measurement m = shadows.measure(k, v, error);
      row.push_back(format("%.1f", 1e3 * m.seconds));
      row.push_back(format("%.2f", shadows.timesNoShadows(k, v)));
      row.push_back(format("%.4f", error));
      run.record(m);
    }
    section.table.add(row);
  }
  section.notes.push_back(format("Whole frames of %dx%d pixels with shading. RMS error: of colours "
                                 "in [0, 1] against %s samples. 1x1: a point without size.",
    shadows.film.width(), shadows.film.height(), sampleText(finestSamples).c_str()));
  return section;
}

} // namespace mote::bench
