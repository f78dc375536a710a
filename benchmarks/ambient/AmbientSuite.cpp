#include "AmbientSuite.h"

#include "../particles/Comparison.h"
#include "AmbientContest.h"

namespace mote::bench
{

namespace
{

Report run(const Options& options)
{
  const ParticleInput input = inputOf(options);
  AmbientContest contest(options, input);
  Report report;
  for (const AmbientTable& table : ambientTables())
    if (options.wantsTable(table.name))
      contest.compareErrors(table, report);
  if (options.wantsTables())
    return report;
  contest.compareErrors(report);
  contest.raceEmbree(report);
  contest.timeLookUps(report);
  return report;
}

} // namespace

Suite ambientSuite()
{
  Suite suite;
  suite.name = "ambient";
  suite.summary = "ambient occlusion by live rays and by baked maps: error against time";
  suite.inputs = particleInputs();
  for (const AmbientMethod& method : ambientMethods())
    suite.methods.emplace_back(method.name, method.summary);
  for (const View& view : views())
    suite.views.emplace_back(view.name, view.summary);
  for (const AmbientTable& table : ambientTables())
    suite.tables.emplace_back(table.name, table.title);
  suite.tablesInput = "lattice:1000000";
  suite.maps = true;
  suite.size = "256x256";
  suite.run = run;
  return suite;
}

} // namespace mote::bench
