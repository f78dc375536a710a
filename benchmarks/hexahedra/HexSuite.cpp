#include "HexSuite.h"

#include "../Display.h"
#include "HexTables.h"
#include "VolumeContest.h"

#include <algorithm>

namespace mote::bench
{

namespace
{

Section comparison(const std::vector<VolumeMeasurement>& measurements)
{
  Section section{"", Table(2)};
  section.table.add({"method", "integrator", "fps", "(min - max)", "build s", "MB", "references",
    "in a leaf", "cells a ray", "nodes a ray", "fallbacks", "step", "rms error", "max error"});
  const auto number = [](const char* pattern, double value)
  { return std::isnan(value) ? std::string("-") : format(pattern, value); };
  for (const VolumeMeasurement& m : measurements)
    section.table.add({m.method, m.integrator, format("%.3g", 1.0 / m.seconds),
      format("%.3g - %.3g", 1.0 / m.most, 1.0 / m.least), format("%.3f", m.buildSeconds),
      format("%.1f", m.megabytes), number("%.0f", m.references), number("%.0f", m.largestLeaf),
      number("%.1f", m.cellsVisited), number("%.1f", m.nodesVisited), number("%.0f", m.fallbacks),
      number("%.3g", m.step), format("%.1e", m.errors.rms), format("%.1e", m.errors.max)});
  return section;
}

bool isWanted(const Options& options, const std::string& method)
{
  const std::vector<std::string>& wanted = options.methods;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), method) != wanted.end();
}

Report compareMethods(const Options& options)
{
  VolumeTask task = makeVolumeTask(options, options.input);
  integrateReference(task);
  std::vector<HexStructureRequest> requests;
  for (const HexMethodEntry& entry : hexMethods())
    if (isWanted(options, entry.name))
      requests.push_back({&entry, options.lambda2});
  const bool walks = isWanted(options, walkMethod.first);
  const std::size_t asked = requests.size();
  if (walks && requests.empty())
    requests.push_back({&hexMethodNamed(CartesianBvh::name()), options.lambda2});
  VolumeContest contest(task);
  const std::vector<BuiltHexStructure> built = buildStructures(task, requests);
  for (std::size_t i = 0; i < asked; ++i)
    contest.add(built[i], samplingOf(options), options.cloudTolerance);
  if (walks)
    contest.add(
      buildWalk(task, built.back().structure), samplingOf(options), options.cloudTolerance);
  std::vector<std::string> peers;
  for (const auto& [name, summary] : volumePeers())
    if (isWanted(options, name))
      peers.push_back(name);
  const bool draws = !peers.empty() && hasDisplay();
  const Tetrahedra tetrahedra = draws ? makeTetrahedra(task.input) : Tetrahedra();
  if (draws)
    for (const std::string& name : peers)
      contest.addPeer(name, tetrahedra);

  Report report;
  const std::vector<VolumeMeasurement> measurements = contest.race();
  for (const VolumeMeasurement& m : measurements)
    report.records.push_back(toRecord(m));
  Section section = comparison(measurements);
  section.notes = volumeNotes(task);
  if (!peers.empty())
    section.notes.emplace_back(draws ? peerSentence : noDisplaySentence);
  report.sections.push_back(std::move(section));
  return report;
}

Report run(const Options& options)
{
  return options.wantsTables() ? makeHexTables(options) : compareMethods(options);
}

} // namespace

Suite hexahedraSuite()
{
  Suite suite;
  suite.name = "hexahedra";
  suite.summary = "volumes on hexahedral cells";
  suite.inputs = hexInputs();
  for (const HexMethodEntry& entry : hexMethods())
    suite.methods.emplace_back(entry.name, entry.summary);
  suite.methods.push_back(walkMethod);
  suite.methods.insert(suite.methods.end(), volumePeers().begin(), volumePeers().end());
  suite.views = {wholeView};
  suite.tables = hexTables();
  suite.tablesInput = "pump:0.05";
  suite.size = "768x768";
  suite.volumes = true;
  suite.run = run;
  return suite;
}

} // namespace mote::bench
