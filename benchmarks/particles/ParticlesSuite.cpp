#include "ParticlesSuite.h"

#include "Comparison.h"
#include "tables/Tables.h"

namespace mote::bench
{

namespace
{

/// All methods in all views.
Report compareMethods(const Options& options)
{
  const int threads = threadCount(options.threads);
  const ParticleInput input = inputOf(options);
  Contest contest(viewsNamed(options.views), options.width, options.height, options.repeat);
  for (const ParticleMethodEntry& entry : particleMethods())
    if (isWanted(options, entry.name))
      for (Contestant& contestant : contestantsOf(
             entry, {threads, options.lambda, options.packet}, input, threads, options.poe))
        contest.add(std::move(contestant));
  contest.race();
  ReferenceImages references;
  contest.check(references);

  Report report;
  std::vector<Measurement> measurements;
  for (std::size_t v = 0; v < contest.views().size(); ++v)
    for (std::size_t c = 0; c < contest.size(); ++c)
    {
      measurements.push_back(contest.at(c, v));
      report.records.push_back(toRecord(contest.at(c, v)));
    }
  Section section = comparison(measurements);
  section.notes.push_back(format("%zu particles (%s), %dx%d rays a view, %d threads, medians of %d "
                                 "rounds. Depth errors are relative, the largest.",
    input.statistics.valid, options.input.c_str(), options.width, options.height, threads,
    options.repeat));
  report.sections.push_back(std::move(section));
  if (options.poe != std::vector<double>{0.0})
    report.sections.push_back(lodErrors(measurements));
  return report;
}

Report run(const Options& options)
{
  return options.wantsTables() ? makeTables(options) : compareMethods(options);
}

} // namespace

Suite particlesSuite()
{
  Suite suite;
  suite.name = "particles";
  suite.summary = "primary rays through particles as spheres";
  suite.inputs = particleInputs();
  for (const ParticleMethodEntry& entry : particleMethods())
    suite.methods.emplace_back(entry.name, entry.summary);
  for (const View& view : views())
    suite.views.emplace_back(view.name, view.summary);
  for (const TableEntry& table : tables())
    suite.tables.emplace_back(table.name, table.title);
  suite.bundles = true;
  suite.lods = true;
  suite.tablesInput = "lattice:1000000";
  suite.run = run;
  return suite;
}

} // namespace mote::bench
