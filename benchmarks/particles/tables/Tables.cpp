#include "Tables.h"

#include "../Comparison.h"

#include <kernels/core/Error.h>

namespace mote::bench
{

const std::vector<TableEntry>& tables()
{
  static const std::vector<TableEntry> all = {
    {"packet", "Size of the bundles of rays", packetTable},
    {"resolution", "Resolution of the image", resolutionTable},
    {"reference-grid", "Sphere-centre method against a grid of references", referenceGridTable},
    {"culling", "What bundles visit, and what culling by the frustum leaves", cullingTable},
    {"culling-speed", "Casting with and without culling by the frustum", cullingSpeedTable},
    {"range", "Culling by a range of a value", rangeTable},
    {"shadows", "Soft shadows of a point light with size", shadowTable},
    {"methods", "Comparison of methods", methodTable},
    {"radii", "Radii over four decades against one radius, same covered area", radiiTable},
    {"build", "Time to build", buildTable}, {"lambda", "Cells a particle", lambdaTable}};
  return all;
}

const ParticleMethodEntry& methodNamed(const std::string& name)
{
  for (const ParticleMethodEntry& entry : particleMethods())
    if (entry.name == name)
      return entry;
  throw Error("There is no method " + name + ".");
}

Measurement TableRun::measurement(const std::string& method, const std::string& mode) const
{
  Measurement m = measurementOf(input, options.width, options.height, threads, options.repeat);
  m.method = method;
  m.mode = mode;
  return m;
}

void TableRun::record(Measurement measurement)
{
  measurement.table = name;
  report.records.push_back(toRecord(measurement));
}

void TableRun::record(Contest& contest)
{
  for (std::size_t v = 0; v < contest.views().size(); ++v)
    for (std::size_t c = 0; c < contest.size(); ++c)
      record(contest.at(c, v));
}

Report makeTables(const Options& options)
{
  const ParticleInput input = inputOf(options);
  TableRun run{options, input, threadCount(options.threads), viewsNamed(options.views), ""};
  for (const TableEntry& entry : tables())
  {
    if (!options.wantsTable(entry.name))
      continue;
    progress("table %s", entry.name.c_str());
    run.name = entry.name;
    Section section = entry.make(run);
    section.title = format("%s: %s, %zu particles, %d thread%s, medians of %d rounds",
      entry.title.c_str(), input.name.c_str(), input.statistics.valid, run.threads,
      run.threads == 1 ? "" : "s", options.repeat);
    run.report.sections.push_back(std::move(section));
  }
  return std::move(run.report);
}

} // namespace mote::bench
