#include "ParticlesSuite.h"

#include "Contest.h"
#include "tables/Tables.h"

#include <algorithm>

namespace mote::bench
{

namespace
{

bool isWanted(const Options& options, const std::string& method)
{
  const std::vector<std::string>& wanted = options.methods;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), method) != wanted.end();
}

/// Speed of the peer in a view, or 0 where it took no part.
double peerSpeed(Contest& contest, std::size_t view)
{
  for (std::size_t c = 0; c < contest.size(); ++c)
    if (contest.at(c, view).method == "embree")
      return contest.at(c, view).mrays();
  return 0.0;
}

std::vector<std::string> rowOf(const Measurement& m, double peer)
{
  const ImageErrors& errors = m.errors;
  return {m.method, m.mode, m.view, format("%.2f", m.mrays()),
    format("%.2f - %.2f", m.mrays(m.most), m.mrays(m.least)),
    peer > 0.0 ? format("%.2f", m.mrays() / peer) : "-", format("%.3f", m.buildSeconds),
    format("%.1f", m.bytesPerParticle), format("%zu/%zu", errors.wrong, errors.checked),
    format("%.1e", errors.maxDepthError), format("%.1e", errors.maxRightDepthError)};
}

/// All methods in all views.
Report compareMethods(const Options& options)
{
  const int threads = threadCount(options.threads);
  progress("making or reading %s", options.input.c_str());
  const ParticleInput input = makeParticleInput(options.input);
  const ParticleStatistics& statistics = input.statistics;
  progress("%zu particles, radius %g to %g", statistics.valid, statistics.smallestRadius,
    statistics.largestRadius);

  Contest contest(viewsNamed(options.views), options.width, options.height, options.repeat);
  for (const ParticleMethodEntry& entry : particleMethods())
    if (isWanted(options, entry.name))
      contest.add(contestantOf(entry, {threads, options.lambda, options.packet}, input, threads));
  contest.race();
  ReferenceImages references;
  contest.check(references);

  Report report;
  Section section{"", Table(3)};
  section.table.add({"method", "mode", "view", "Mrays/s", "(min - max)", "x embree", "build s",
    "bytes/particle", "wrong/checked", "depth error", "of right pixels"});
  for (std::size_t v = 0; v < contest.views().size(); ++v)
    for (std::size_t c = 0; c < contest.size(); ++c)
    {
      section.table.add(rowOf(contest.at(c, v), peerSpeed(contest, v)));
      report.records.push_back(toRecord(contest.at(c, v)));
    }
  section.notes.push_back(format("%zu particles (%s), %dx%d rays a view, %d threads, medians of %d "
                                 "rounds. Depth errors are relative, the largest.",
    statistics.valid, options.input.c_str(), options.width, options.height, threads,
    options.repeat));
  report.sections.push_back(std::move(section));
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
  suite.tablesInput = "lattice:1000000";
  suite.run = run;
  return suite;
}

} // namespace mote::bench
