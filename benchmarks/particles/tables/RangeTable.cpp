// What it costs to show a part of the particles, and to change which.

#include "../StructureMethod.h"
#include "Tables.h"

#include <kernels/particles/CoherentGrid.h>

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
  double upper = ParticleRanges::infinity;
  std::size_t kept = 0;
  ParticleInput shown{}; ///< the particles that are left, seen by the views of all
  std::vector<double> changes{};
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

/// The particles with values up to the limit, with the statistics of all, so that the views stay.
ParticleInput part(const ParticleInput& input, const std::vector<float>& values, float limit)
{
  auto numbers = std::make_shared<std::pair<std::vector<double>, std::vector<double>>>();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const Vec3d p = input.set.position(i);
    const double r = input.set.radiusOf(i);
    if (!isValidParticle(p, r) || !(values[i] <= limit))
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

/// The limit up to which a share of the values lies, between two of them where that can be.
float limitOf(std::vector<float> values, double share)
{
  std::sort(values.begin(), values.end());
  const auto kept =
    std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
  const float below = values[kept - 1], above = values[std::min(kept, values.size() - 1)];
  return below + 0.5f * (above - below);
}

void addCulls(const TableRun& run, const std::string& name, int value,
  const std::vector<float>& values, std::vector<Cull>& culls)
{
  for (const double share : {0.5, 0.25, 0.1, 0.01})
  {
    Cull cull{name, value, share};
    const float limit = limitOf(values, share);
    cull.upper = limit;
    cull.shown = part(run.input, values, limit);
    cull.shown.name = format("%s, %s, %g", run.input.name.c_str(), name.c_str(), share);
    cull.kept = cull.shown.set.count();
    culls.push_back(std::move(cull));
  }
}

/// All particles, and then less and less of them.
std::vector<Cull> cullsOf(const TableRun& run, const std::vector<float>& attribute)
{
  std::vector<float> x(run.input.set.count());
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<float>(run.input.set.position(i).x);
  std::vector<Cull> culls = {{"all"}};
  culls.front().kept = run.input.statistics.valid;
  culls.front().shown = run.input;
  addCulls(run, "x", 0, x, culls);
  addCulls(run, "random", attributeValue, attribute, culls);
  return culls;
}

/// One table in the making.
struct Culling
{
  TableRun& run;
  std::vector<float> attribute;
  std::vector<Cull> culls;
  std::vector<CameraRays> rays{};
  HitImage image;
  CoherentGrid grid{};
  Race race{};
  double buildSeconds = 0.0, attachSeconds = 0.0;

  explicit Culling(TableRun& of)
    : run(of)
    , attribute(scatteredValues(of.input.set.count()))
    , culls(cullsOf(of, attribute))
    , image(of.options.width, of.options.height)
  {
    CoherentGridOptions options;
    options.cellsPerParticle = run.options.lambda;
    buildSeconds = timed(run.threads, [&] { grid.build(run.input.set, options); });
    attachSeconds = timed(run.threads,
      [&] { grid.setAttributes({{ArrayView(attribute.data(), attribute.size(), 1)}}); });
    for (const View& view : run.views)
      rays.emplace_back(
        cameraOf(view, run.input.statistics.bounds), run.options.width, run.options.height);
  }

  void show(const Cull& cull)
  {
    ParticleRanges ranges;
    ranges.upper[static_cast<std::size_t>(cull.value)] = cull.upper;
    grid.setRanges(ranges);
  }
  void cast(std::size_t view) { castBundles(grid, run.options.packet, rays[view], image); }

  /// Everyone sets its range, timed apart, and casts.
  void runRace()
  {
    for (std::size_t v = 0; v < rays.size(); ++v)
      for (Cull& cull : culls)
        race.addTimed(
          [this, v, &cull]
          {
            cull.changes.push_back(timed(run.threads, [&] { show(cull); }));
            return timed(run.threads, [&] { cast(v); });
          });
    race.run(run.options.repeat);
  }

  double seconds(std::size_t k, std::size_t view) const
  {
    return race.seconds(view * culls.size() + k);
  }

  Measurement measure(std::size_t k, std::size_t view)
  {
    const Cull& cull = culls[k];
    const std::size_t place = view * culls.size() + k;
    Measurement m = run.measurement("cgt", "range of " + cull.name);
    m.view = run.views[view].name;
    m.seconds = race.seconds(place);
    m.least = race.least(place);
    m.most = race.most(place);
    m.buildSeconds = buildSeconds;
    m.bytesPerParticle =
      static_cast<double>(grid.bytes()) / static_cast<double>(run.input.statistics.valid);
    show(cull);
    cast(view);
    m.errors = compare(image,
      run.references.depths(cull.shown, run.views[view], run.options.width, run.options.height));
    m.more = {{"range", cull.name}, {"share", cull.share},
      {"kept", static_cast<std::int64_t>(cull.kept)},
      {"share_of_time", m.seconds / seconds(0, view)}, {"change_s", median(cull.changes)},
      {"set_attributes_s", attachSeconds}};
    return m;
  }
};

} // namespace

Section rangeTable(TableRun& run)
{
  Culling culling(run);
  culling.runRace();
  Section section;
  std::vector<std::string> titles = {"value", "kept"};
  for (const View& view : run.views)
    for (const char* what : {" ms", " of all"})
      titles.push_back(view.name + what);
  titles.insert(titles.end(), {"change ms", "wrong"});
  section.table.add(titles);
  for (std::size_t k = 0; k < culling.culls.size(); ++k)
  {
    const Cull& cull = culling.culls[k];
    std::vector<std::string> row = {cull.name, format("%g %%", 100.0 * cull.share)};
    std::size_t wrong = 0;
    for (std::size_t v = 0; v < run.views.size(); ++v)
    {
      const Measurement m = culling.measure(k, v);
      row.push_back(format("%.1f", 1e3 * m.seconds));
      row.push_back(format("%.2f", m.seconds / culling.seconds(0, v)));
      wrong += m.errors.wrong;
      run.record(m);
    }
    row.push_back(format("%.2f", 1e3 * median(cull.changes)));
    row.push_back(format("%zu", wrong));
    section.table.add(row);
  }
  section.notes.push_back(format("setAttributes() once: %.1f ms. change: setRanges() from the "
                                 "range of the row before to this one.",
    1e3 * culling.attachSeconds));
  return section;
}

} // namespace mote::bench
