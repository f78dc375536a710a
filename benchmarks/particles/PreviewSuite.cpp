#include "PreviewSuite.h"

#include "../Timing.h"
#include "Comparison.h"
#include "Views.h"

#include <kernels/particles/ParticleSample.h>
#include <kernels/tracing/RayCaster.h>

#include <cmath>

namespace mote::bench
{

namespace
{

struct Method
{
  std::string name;
  std::string summary;
  std::size_t particles; ///< of the preview; 0: the exact structure `kind`
  ParticleStructureKind kind = ParticleStructureKind::CoherentGrid;
};

const std::vector<Method>& methods()
{
  static const std::vector<Method> all = {
    {"preview-250k", "a preview of 250,000 particles", 250'000},
    {"preview-500k", "one of 500,000", 500'000}, {"preview-1m", "one of 1,000,000", 1'000'000},
    {"preview-2m", "one of 2,000,000", 2'000'000},
    {"cgt", "the exact picture, from a coherent grid", 0, ParticleStructureKind::CoherentGrid},
    {"pkd", "the exact picture, from a P-k-d tree", 0, ParticleStructureKind::PkdTree}};
  return all;
}

/// One who makes a picture from nothing but the particles.
class Painter
{
public:
  Painter(const Method& method, const Options& options, const ParticleInput& input)
    : method_(method)
    , options_(options)
    , input_(input)
  {
  }

  void enter(Race& race)
  {
    const int threads = threadCount(options_.threads);
    build_ = race.add(threads, [this] { this->build(); });
    frame_ = race.add(threads, [this] { this->cast(); });
  }

  const std::string& name() const { return method_.name; }
  const Film& film() const { return film_; }
  double build(const Race& race) const { return race.seconds(build_); }
  double frame(const Race& race) const { return race.seconds(frame_); }

private:
  void build()
  {
    scene_.surfaces.resize(1);
    auto structure = std::make_shared<ParticleStructure>();
    if (method_.particles > 0)
    {
      const ParticleSample sample(input_.set, method_.particles);
      structure->emplace<CoherentGrid>().build(sample.set(), sample.gridOptions());
    }
    else
    {
      ParticleStructureOptions options;
      options.kind = method_.kind;
      structure = makeParticleStructure(input_.set, options);
    }
    scene_.surfaces[0].surface = ParticleSurface(structure);
  }

  void cast()
  {
    film_.resize(options_.width, options_.height);
    RayCaster(scene_).addSample(cameraOf(views().front(), input_.statistics.bounds), film_);
    scene_.surfaces.clear(); // what follows needs the memory
  }

  const Method& method_;
  const Options& options_;
  const ParticleInput& input_;
  Scene scene_;
  Film film_;
  std::size_t build_ = 0, frame_ = 0; ///< places in the race
};

/// Share of the pixels that `truth` covers and the other does not, and the other way.
double uncovered(const Film& truth, const Film& other)
{
  std::size_t hits = 0, wrong = 0;
  for (std::size_t i = 0; i < truth.pixels(); ++i)
  {
    const bool hit = std::isfinite(truth.depth()[i]);
    hits += hit;
    wrong += hit != std::isfinite(other.depth()[i]);
  }
  return hits > 0 ? static_cast<double>(wrong) / static_cast<double>(hits) : 0.0;
}

Record recordOf(const Painter& painter, const Race& race, const ParticleInput& input,
  const Options& options, double before, double wrong)
{
  return {{"suite", "preview"}, {"method", painter.name()}, {"input", input.name},
    {"particles", static_cast<std::int64_t>(input.statistics.valid)},
    {"width", std::int64_t{options.width}}, {"height", std::int64_t{options.height}},
    {"threads", std::int64_t{threadCount(options.threads)}},
    {"repeat", std::int64_t{options.repeat}}, {"before_s", before},
    {"build_s", painter.build(race)}, {"frame_s", painter.frame(race)},
    {"wrongly_covered_share", wrong}};
}

Report run(const Options& options)
{
  const ParticleInput input = inputOf(options);
  std::vector<Painter> painters;
  painters.reserve(methods().size());
  for (const Method& method : methods())
    if (isWanted(options, method.name))
      painters.emplace_back(method, options, input);
  Painter truth(methods()[4], options, input);
  Race race;
  const std::size_t looking = race.add(threadCount(options.threads),
    [&]
    {
      estimateSpacing(input.set);
      examine(input.set);
    });
  for (Painter& painter : painters)
    painter.enter(race);
  progress("making %zu pictures in %d rounds", painters.size(), options.repeat);
  race.run(options.repeat);
  Race once;
  truth.enter(once);
  once.run(1);

  Report report;
  Section section;
  section.table.add({"method", "radius and bounds ms", "structure ms", "frame ms",
    "picture after s", "wrongly covered"});
  const double before = race.seconds(looking);
  for (const Painter& painter : painters)
  {
    const double wrong = uncovered(truth.film(), painter.film());
    const double build = painter.build(race), frame = painter.frame(race);
    section.table.add({painter.name(), format("%.0f", 1e3 * before), format("%.0f", 1e3 * build),
      format("%.0f", 1e3 * frame), format("%.2f", before + build + frame),
      format("%.1f %%", 100.0 * wrong)});
    report.records.push_back(recordOf(painter, race, input, options, before, wrong));
  }
  section.notes = {
    "wrongly covered: pixels that show particles and should not, or the other way, as a share of "
    "those that should.",
    format("%zu particles (%s), one ray a pixel of %d x %d, medians of %d rounds.",
      input.statistics.valid, options.input.c_str(), options.width, options.height,
      options.repeat)};
  report.sections.push_back(std::move(section));
  return report;
}

} // namespace

Suite previewSuite()
{
  Suite suite;
  suite.name = "preview";
  suite.summary = "time from particles in memory to a first picture and to the exact one";
  suite.inputs = particleInputs();
  for (const Method& method : methods())
    suite.methods.emplace_back(method.name, method.summary);
  suite.run = run;
  return suite;
}

} // namespace mote::bench
