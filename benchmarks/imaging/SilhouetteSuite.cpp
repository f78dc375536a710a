#include "SilhouetteSuite.h"

#include "../Timing.h"
#include "../particles/Comparison.h"
#include "../particles/Views.h"

#include <kernels/tracing/RayCaster.h>
#include <kernels/tracing/SilhouetteFilm.h>

#include <tbb/parallel_for.h>

#include <algorithm>

namespace mote::bench
{

namespace
{

/// As vtkMoteSilhouettes has it: the least step, and that many radii of a typical particle.
constexpr double radii = 10.0;

struct Method
{
  std::string name;
  std::string summary;
  SilhouetteOptions (*options)(double step); ///< `step` in world units
};

SilhouetteOptions standard(double step)
{
  SilhouetteOptions options;
  options.step = step;
  options.thickness = 1.5;
  return options;
}

SilhouetteOptions published(double step)
{
  SilhouetteOptions options = standard(step);
  options.stepInPixels = 0.0;
  options.thickness = 1.0;
  options.leastOpacity = 1.0;
  options.centered = false;
  return options;
}

SilhouetteOptions graded(double step)
{
  SilhouetteOptions options = standard(step);
  options.thickness = 3.0;
  options.leastThickness = 1.0 / 3.0;
  options.leastOpacity = 0.2;
  return options;
}

const std::vector<Method>& methods()
{
  static const std::vector<Method> all = {
    {"published", "3x3 Laplacian and one threshold, one pixel wide on the far side", published},
    {"default", "what is drawn unless told otherwise", standard},
    {"graded", "grey and 1 to 3 pixels wide by the size of the step", graded}};
  return all;
}

/// One view at one size: frames without silhouettes, and with those of every method.
class Frames
{
public:
  Frames(const Scene& scene, const Camera& camera, int side, double step)
    : scene_(scene)
    , camera_(camera)
    , side_(side)
    , step_(step)
  {
    draw(nullptr);
    silhouettes_.resize(film_.pixels());
  }

  void enter(Race& race, const std::vector<Method>& chosen, int threads)
  {
    plain_ = race.add(threads, [this] { this->draw(nullptr); });
    for (const Method& method : chosen)
    {
      frames_.push_back(race.add(threads, [this, &method] { this->draw(&method); }));
      filters_.push_back(race.add(threads, [this, &method] { this->filter(method); }));
    }
  }

  int side() const { return side_; }
  double plain(const Race& race) const { return race.seconds(plain_); }
  double frame(const Race& race, std::size_t k) const { return race.seconds(frames_[k]); }
  double filterSeconds(const Race& race, std::size_t k) const { return race.seconds(filters_[k]); }
  /// Silhouettes' part of the whole frame: from each round, so that a slow round tells nothing.
  double share(const Race& race, std::size_t k) const
  {
    return 1.0 - race.ratio(plain_, frames_[k]);
  }

  /// Share of the pixels that the lines of a method cover.
  double covered(const Method& method)
  {
    draw(&method);
    double sum = 0.0;
    silhouetteFilm_.forCovered(0, side_, [&](std::size_t, float share) { sum += share; });
    return sum / static_cast<double>(film_.pixels());
  }

private:
  void draw(const Method* method)
  {
    film_.resize(side_, side_, method != nullptr ? SilhouetteGroups().channels() : 0u);
    RayCaster(scene_).addSample(camera_, film_);
    if (method != nullptr)
    {
      silhouetteFilm_.clear();
      silhouetteFilm_.add(film_, camera_, method->options(step_), {});
    }
    bytes_.resize(4 * film_.pixels());
    tbb::parallel_for(0, side_, [&](int row) { this->showRow(row, method != nullptr); });
  }

  /// A row of the picture, in 8 bits as a window takes it, with the silhouettes over it.
  void showRow(int row, bool silhouettes)
  {
    const auto byteOf = [](float value)
    { return static_cast<unsigned char>(std::min(value, 1.0f) * 255.0f + 0.5f); };
    const std::size_t first = 4 * static_cast<std::size_t>(row) * side_;
    for (std::size_t i = first; i < first + 4 * static_cast<std::size_t>(side_); ++i)
      bytes_[i] = byteOf(film_.color()[i]);
    if (!silhouettes)
      return;
    silhouetteFilm_.forCovered(row, row + 1,
      [&](std::size_t pixel, float share)
      {
        for (std::size_t c = 0; c < 4; ++c)
        {
          const float color = film_.color()[4 * pixel + c];
          bytes_[4 * pixel + c] = byteOf(color + share * ((c < 3 ? 0.05f : 1.0f) - color));
        }
      });
  }

  /// The film holds a frame: whoever draws leaves the same depths.
  void filter(const Method& method)
  {
    std::fill(silhouettes_.begin(), silhouettes_.end(), 0.0f);
    findSilhouettes(depthImageOf(film_.depth(), side_, side_, camera_), method.options(step_),
      silhouettes_.data());
  }

  const Scene& scene_;
  Camera camera_;
  int side_;
  double step_;
  Film film_;
  SilhouetteFilm silhouetteFilm_;
  std::vector<float> silhouettes_;
  std::vector<unsigned char> bytes_;
  std::size_t plain_ = 0;
  std::vector<std::size_t> frames_, filters_; ///< places in the race, by method
};

Scene sceneOf(const ParticleInput& input, const Options& options)
{
  progress("building the structure");
  ParticleStructureOptions building;
  building.coherentGrid.cellsPerParticle = options.lambda;
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].surface = ParticleSurface(makeParticleStructure(input.set, building));
  return scene;
}

/// Everything at one size: one view after another.
void measureSize(const Scene& scene, const ParticleInput& input, const Options& options, int side,
  Table& table, std::vector<Record>& records)
{
  const int threads = threadCount(options.threads);
  const double step = radii * typicalRadius(scene);
  std::vector<Method> chosen;
  for (const Method& method : methods())
    if (isWanted(options, method.name))
      chosen.push_back(method);
  for (const View& view : viewsNamed(options.views))
  {
    progress("%d frames of %dx%d, view %s", options.repeat, side, side, view.name.c_str());
    Frames frames(scene, cameraOf(view, input.statistics.bounds), side, step);
    Race race;
    frames.enter(race, chosen, threads);
    race.run(options.repeat);
    for (std::size_t k = 0; k < chosen.size(); ++k)
    {
      const double plain = frames.plain(race), filter = frames.filterSeconds(race, k);
      const double share = frames.share(race, k), covered = frames.covered(chosen[k]);
      table.add({chosen[k].name, view.name, std::to_string(side), format("%.2f", 1e3 * filter),
        format("%.1f", 1e3 * plain), format("%.1f", 1e3 * frames.frame(race, k)),
        format("%.1f %%", 100.0 * share), format("%.1f %%", 100.0 * filter / plain),
        format("%.1f %%", 100.0 * covered)});
      records.push_back({{"suite", "silhouettes"}, {"method", chosen[k].name},
        {"input", input.name}, {"particles", static_cast<std::int64_t>(input.statistics.valid)},
        {"view", view.name}, {"size", std::int64_t{side}}, {"threads", std::int64_t{threads}},
        {"repeat", std::int64_t{options.repeat}}, {"step", step}, {"filter_ms", 1e3 * filter},
        {"frame_ms", 1e3 * plain}, {"frame_with_silhouettes_ms", 1e3 * frames.frame(race, k)},
        {"frame_share", share}, {"covered_share", covered}});
    }
  }
}

Report run(const Options& options)
{
  const ParticleInput input = inputOf(options);
  const Scene scene = sceneOf(input, options);
  Report report;
  Section section{"", Table(2)};
  section.table.add({"method", "view", "size", "filter ms", "frame ms", "with lines ms",
    "share of it", "filter/frame", "covered"});
  for (const int side : options.sizes)
    measureSize(scene, input, options, side, section.table, report.records);
  section.notes = {
    "share of it: the silhouettes' part of the frame with them, the median over rounds in which "
    "frames with and without take turns; with them they are found and drawn. A frame is traced, "
    "shaded and converted to the 8 bits a channel of a window.",
    "filter: finding the silhouettes in the depths of a frame, alone. covered: by lines, of the "
    "picture.",
    format("%zu particles (%s), frames of one ray a pixel with shading, least step of %g radii, "
           "%d threads, medians of %d rounds.",
      input.statistics.valid, options.input.c_str(), radii, threadCount(options.threads),
      options.repeat)};
  report.sections.push_back(std::move(section));
  return report;
}

} // namespace

Suite silhouetteSuite()
{
  Suite suite;
  suite.name = "silhouettes";
  suite.summary = "silhouettes in depth images: the filter alone, and its part of whole frames";
  suite.inputs = particleInputs();
  for (const Method& method : methods())
    suite.methods.emplace_back(method.name, method.summary);
  for (const View& view : views())
    suite.views.emplace_back(view.name, view.summary);
  suite.squares = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
