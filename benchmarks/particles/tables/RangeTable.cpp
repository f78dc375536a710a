// What it costs to show a part of the particles, and to change which.

#include "../StructureMethod.h"
#include "Tables.h"

#include <kernels/particles/ParticleStructure.h>

#include <algorithm>

namespace mote::bench
{

namespace
{

/// A range of one value that keeps a share of the particles.
struct Cull
{
  std::string name; ///< of the value
  int value = 0;    ///< its place in ParticleRanges
  double share = 1.0;
  double lower = -ParticleRanges::infinity, upper = ParticleRanges::infinity;
  std::size_t kept = 0;
  ParticleInput shown{}; ///< the particles that are left, seen by the views of all
};

constexpr int attributeValue = 4; ///< place in ParticleRanges of the first attribute

/// A value that has nothing to do with where a particle is: equally spaced numbers, shuffled by a
/// multiplication with the golden ratio's part of 2^32.
std::vector<float> scatteredValues(std::size_t count)
{
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    auto bits = static_cast<std::uint32_t>(i + 1) * 2654435769u;
    bits ^= bits >> 15;
    bits *= 2246822519u;
    bits ^= bits >> 13;
    values[i] = static_cast<float>(bits >> 8) * 0x1p-24f;
  }
  return values;
}

/// Distances from the middle.
std::vector<float> distances(const ParticleInput& input)
{
  const Vec3d middle = input.statistics.bounds.center();
  std::vector<float> values(input.set.count());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(glm::distance(input.set.position(i), middle));
  return values;
}

/// The particles with values between the limits, with the statistics of all, so that the views
/// stay.
ParticleInput part(
  const ParticleInput& input, const std::vector<float>& values, double lower, double upper)
{
  auto numbers = std::make_shared<std::pair<std::vector<double>, std::vector<double>>>();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const Vec3d p = input.set.position(i);
    const double r = input.set.radiusOf(i);
    if (!isValidParticle(p, r) || !(values[i] >= lower && values[i] <= upper))
      continue;
    numbers->first.insert(numbers->first.end(), {p.x, p.y, p.z});
    numbers->second.push_back(r);
  }
  ParticleInput shown;
  shown.statistics = input.statistics;
  shown.set.positions = ArrayView(numbers->first.data(), numbers->second.size(), 3);
  shown.set.radii = ArrayView(numbers->second.data(), numbers->second.size(), 1);
  shown.owner = std::move(numbers);
  return shown;
}

/// A limit below which lie `count` of the sorted values, between two of them where that can be.
double limitBehind(const std::vector<float>& sorted, std::size_t count)
{
  const std::size_t last = sorted.size() - 1;
  const float below = sorted[std::min(std::max<std::size_t>(count, 1) - 1, last)];
  return below + 0.5f * (sorted[std::min(count, last)] - below);
}

/// Ranges of a value: from the least on, or about the median.
void addCulls(const TableRun& run, const std::string& name, int value,
  const std::vector<float>& values, bool aboutMedian, std::vector<Cull>& culls)
{
  std::vector<float> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  for (const double share : {0.1, 0.01, 0.001})
  {
    Cull cull{name, value, share};
    const auto kept = std::max<std::size_t>(
      1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())));
    const std::size_t first = aboutMedian ? (sorted.size() - kept) / 2 : 0;
    if (aboutMedian)
      cull.lower = limitBehind(sorted, first);
    cull.upper = limitBehind(sorted, first + kept);
    cull.shown = part(run.input, values, cull.lower, cull.upper);
    cull.shown.name = format("%s, %s, %g", run.input.name.c_str(), name.c_str(), share);
    cull.kept = cull.shown.set.count();
    culls.push_back(std::move(cull));
  }
}

/// All particles, and then less and less of them.
std::vector<Cull> cullsOf(
  const TableRun& run, const std::vector<float>& ball, const std::vector<float>& scattered)
{
  std::vector<float> x(run.input.set.count());
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<float>(run.input.set.position(i).x);
  std::vector<Cull> culls = {{"all"}};
  culls.front().kept = run.input.statistics.valid;
  culls.front().shown = run.input;
  addCulls(run, "ball", attributeValue, ball, false, culls);
  addCulls(run, "slab", 0, x, true, culls);
  addCulls(run, "random", attributeValue + 1, scattered, false, culls);
  return culls;
}

/// One of the structures, and what was timed of it.
struct Candidate
{
  std::string name; ///< of the method
  ParticleStructure structure;
  double buildSeconds = 0.0, attachSeconds = 0.0;
  std::vector<std::vector<double>> changes{}; ///< of each cull
};

/// One table in the making.
struct Culling
{
  TableRun& run;
  std::vector<float> ball, scattered;
  std::vector<Cull> culls;
  std::vector<CameraRays> rays{};
  HitImage image;
  std::vector<Candidate> candidates{};
  Race race{};

  explicit Culling(TableRun& of)
    : run(of)
    , ball(distances(of.input))
    , scattered(scatteredValues(of.input.set.count()))
    , culls(cullsOf(of, ball, scattered))
    , image(of.options.width, of.options.height)
  {
    CoherentGridOptions options;
    options.cellsPerParticle = run.options.lambda;
    add("cgt", CoherentGrid(), options);
    add("pkd", PkdTree(), PkdTreeOptions());
    for (const View& view : run.views)
      rays.emplace_back(
        cameraOf(view, run.input.statistics.bounds), run.options.width, run.options.height);
  }

  template <typename Structure, typename BuildOptions>
  void add(const std::string& name, Structure structure, const BuildOptions& options)
  {
    Candidate made;
    made.name = name;
    made.buildSeconds = timed(run.threads, [&] { structure.build(run.input.set, options); });
    made.attachSeconds = timed(run.threads,
      [&]
      {
        structure.setAttributes({{ArrayView(ball.data(), ball.size(), 1)},
          {ArrayView(scattered.data(), scattered.size(), 1)}});
      });
    made.structure = std::move(structure);
    made.changes.resize(culls.size());
    candidates.push_back(std::move(made));
  }

  void show(Candidate& candidate, const Cull& cull) const
  {
    ParticleRanges ranges;
    ranges.lower[static_cast<std::size_t>(cull.value)] = cull.lower;
    ranges.upper[static_cast<std::size_t>(cull.value)] = cull.upper;
    std::visit([&](auto& s) { s.setRanges(ranges); }, candidate.structure);
  }
  void cast(const Candidate& candidate, std::size_t view)
  {
    withStructure(candidate.structure,
      [&](const auto& s) { castBundles(s, run.options.packet, rays[view], image); });
  }

  std::size_t placeOf(std::size_t candidate, std::size_t cull, std::size_t view) const
  {
    return (view * culls.size() + cull) * candidates.size() + candidate;
  }

  /// Everyone sets its range, timed apart, and casts.
  void runRace()
  {
    for (std::size_t v = 0; v < rays.size(); ++v)
      for (std::size_t k = 0; k < culls.size(); ++k)
        for (Candidate& candidate : candidates)
          race.addTimed(
            [this, v, k, &candidate]
            {
              candidate.changes[k].push_back(
                timed(run.threads, [&] { show(candidate, culls[k]); }));
              return timed(run.threads, [&] { cast(candidate, v); });
            });
    race.run(run.options.repeat);
  }

  double timesAsFast(std::size_t c, std::size_t k, std::size_t view) const
  {
    return race.seconds(placeOf(c, 0, view)) / race.seconds(placeOf(c, k, view));
  }

  Measurement measure(std::size_t c, std::size_t k, std::size_t view)
  {
    const Cull& cull = culls[k];
    Candidate& candidate = candidates[c];
    const std::size_t place = placeOf(c, k, view);
    Measurement m = run.measurement(candidate.name, "range of " + cull.name);
    m.view = run.views[view].name;
    m.seconds = race.seconds(place);
    m.least = race.least(place);
    m.most = race.most(place);
    m.buildSeconds = candidate.buildSeconds;
    show(candidate, cull);
    cast(candidate, view);
    const std::size_t bytes =
      withStructure(candidate.structure, [](const auto& s) { return s.bytes(); });
    m.bytesPerParticle =
      static_cast<double>(bytes) / static_cast<double>(run.input.statistics.valid);
    m.errors = compare(image,
      run.references.depths(cull.shown, run.views[view], run.options.width, run.options.height));
    m.more = {{"range", cull.name}, {"share", cull.share},
      {"kept", static_cast<std::int64_t>(cull.kept)}, {"x_all", timesAsFast(c, k, view)},
      {"change_s", median(candidate.changes[k])}, {"set_attributes_s", candidate.attachSeconds}};
    return m;
  }

  std::vector<std::string> row(std::size_t c, std::size_t k)
  {
    std::vector<std::string> row = {
      candidates[c].name, culls[k].name, format("%g %%", 100.0 * culls[k].share)};
    std::size_t wrong = 0;
    double bytes = 0.0;
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      const Measurement m = measure(c, k, v);
      row.push_back(format("%.1f", 1.0 / m.seconds));
      row.push_back(format("%.2f", timesAsFast(c, k, v)));
      wrong += m.errors.wrong;
      bytes = m.bytesPerParticle;
      run.record(m);
    }
    row.push_back(format("%.2f", 1e3 * median(candidates[c].changes[k])));
    row.push_back(format("%.1f", bytes));
    row.push_back(format("%zu", wrong));
    return row;
  }
};

} // namespace

Section rangeTable(TableRun& run)
{
  Culling culling(run);
  culling.runRace();
  Section section;
  std::vector<std::string> titles = {"method", "value", "kept"};
  for (const View& view : run.views)
    for (const char* what : {" fps", " x all"})
      titles.push_back(view.name + what);
  titles.insert(titles.end(), {"change ms", "bytes/particle", "wrong"});
  section.table.add(titles);
  for (std::size_t c = 0; c < culling.candidates.size(); ++c)
    for (std::size_t k = 0; k < culling.culls.size(); ++k)
      section.table.add(culling.row(c, k));
  for (const Candidate& candidate : culling.candidates)
    section.notes.push_back(format("%s: setAttributes() of two took %.1f ms.",
      candidate.name.c_str(), 1e3 * candidate.attachSeconds));
  section.notes.push_back("x all: as fast as with all shown. change: setRanges() from the range of "
                          "the row before to this one.");
  return section;
}

} // namespace mote::bench
