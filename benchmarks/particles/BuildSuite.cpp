#include "BuildSuite.h"

#include "BuildCosts.h"
#include "Comparison.h"

namespace mote::bench
{

namespace
{

Report run(const Options& options)
{
  const ParticleInput input = inputOf(options);
  std::vector<const ParticleMethodEntry*> methods;
  for (const ParticleMethodEntry& entry : particleMethods())
    if (isWanted(options, entry.name))
      methods.push_back(&entry);
  const std::vector<BuildCost> costs = measureBuilds(methods, {1, options.lambda}, input,
    threadCounts(threadCount(options.threads)), options.repeat);
  Report report;
  for (const BuildCost& cost : costs)
  {
    Measurement m = toMeasurement(cost, input, options.repeat);
    m.suite = "build";
    report.records.push_back(toRecord(m));
  }
  Section section = buildSection(costs);
  section.notes.push_back(format("%zu particles (%s), medians of %d rounds.",
    input.statistics.valid, options.input.c_str(), options.repeat));
  report.sections.push_back(std::move(section));
  return report;
}

} // namespace

Suite buildSuite()
{
  Suite suite;
  suite.name = "build";
  suite.summary = "time and memory to build the structures, on one thread and on all";
  suite.inputs = particleInputs();
  for (const ParticleMethodEntry& entry : particleMethods())
    suite.methods.emplace_back(entry.name, entry.summary);
  suite.run = run;
  return suite;
}

} // namespace mote::bench
