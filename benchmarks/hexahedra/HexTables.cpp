#include "HexTables.h"

#include "../Display.h"
#include "RayTables.h"

#include <algorithm>

namespace mote::bench
{

const char* const peerSentence =
  "VTK's mappers draw tetrahedra of vtkDataSetTriangleFilter, with linear values; build s and MB "
  "are "
  "the filter's and its output's. Their windows stand off the screen, their colours are read "
  "back in steps of 1/255.";
const char* const noDisplaySentence =
  "VTK's mappers are left out: there is no X server for their windows (xvfb-run brings one).";

const VolumeTask& HexTableRun::task(const std::string& input, bool withReference)
{
  const auto found = tasks.find(input);
  VolumeTask& task = found != tasks.end()
                       ? found->second
                       : tasks.emplace(input, makeVolumeTask(options, input)).first->second;
  if (withReference)
    integrateReference(task);
  return task;
}

void HexTableRun::record(std::vector<VolumeMeasurement>& measurements)
{
  for (VolumeMeasurement& m : measurements)
  {
    m.table = name;
    report.records.push_back(toRecord(m));
  }
}

std::vector<VolumeMeasurement> HexTableRun::race(VolumeContest& contest)
{
  std::vector<VolumeMeasurement> all = contest.race();
  record(all);
  return all;
}

namespace
{

std::string speed(const VolumeMeasurement& m)
{
  return format("%.3g", 1.0 / m.seconds);
}

std::vector<HexStructureRequest> allStructures(double lambda2)
{
  std::vector<HexStructureRequest> requests;
  for (const HexMethodEntry& entry : hexMethods())
    requests.push_back({&entry, lambda2});
  return requests;
}

Section lambda2Table(HexTableRun& run)
{
  Section section{"", Table(1)};
  section.table.add(
    {"structure", "lambda2", "build s", "MB", "references", "in a leaf", "cells a ray", "fps"});
  const VolumeTask& task = run.firstTask();
  for (const double lambda2 : {1.0, 2.0, 4.0, 8.0, 16.0})
  {
    VolumeContest contest(task);
    for (const BuiltHexStructure& built : buildStructures(
           task, {{&hexMethodNamed("cylgrid"), lambda2}, {&hexMethodNamed("cartgrid"), lambda2}}))
      contest.add(built, samplingOf(run.options));
    for (const VolumeMeasurement& m : run.race(contest))
      section.table.add({m.method, format("%g", lambda2), format("%.3f", m.buildSeconds),
        format("%.1f", m.megabytes), format("%.0f", m.references), format("%.0f", m.largestLeaf),
        format("%.1f", m.cellsVisited), speed(m)});
  }
  return section;
}

/// The step that a volume of the task has of itself, or that the options name.
double stepOf(const HexTableRun& run, const VolumeTask& task, const BuiltHexStructure& built)
{
  const VolumeSampling sampling = samplingOf(run.options);
  return sampling.step > 0.0 ? sampling.step : volumeStep(task.volume(built.structure, sampling));
}

Section stepTable(HexTableRun& run)
{
  const VolumeTask& task = run.firstTask();
  const std::vector<BuiltHexStructure> all =
    buildStructures(task, allStructures(run.options.lambda2));
  const std::vector<double> factors = {4.0, 2.0, 1.0, 0.5, 0.25};
  VolumeContest contest(task);
  for (const double factor : factors)
    for (const BuiltHexStructure& built : all)
    {
      VolumeSampling sampling = samplingOf(run.options);
      sampling.step = factor * stepOf(run, task, built);
      contest.add(built, sampling);
    }
  const std::vector<VolumeMeasurement> measured = run.race(contest);
  Section section{"", Table(0)};
  std::vector<std::string> titles = {"step"};
  for (const BuiltHexStructure& built : all)
    titles.push_back(built.method + " fps");
  titles.insert(titles.end(), {"rms error", "max error"});
  section.table.add(titles);
  for (std::size_t i = 0; i < factors.size(); ++i)
  {
    const VolumeMeasurement* row = &measured[i * all.size()];
    std::vector<std::string> texts = {format("%.3g", row->step)};
    for (std::size_t k = 0; k < all.size(); ++k)
      texts.push_back(speed(row[k]));
    texts.push_back(format("%.1e", row->errors.rms));
    texts.push_back(format("%.1e", row->errors.max));
    section.table.add(texts);
  }
  section.notes.push_back(format(
    "By %s. Errors are %s's.", measured.front().integrator.c_str(), all.front().method.c_str()));
  return section;
}

/// Every integrator with its own setting, from coarse to fine.
std::vector<VolumeSampling> sweep(const HexTableRun& run, double step)
{
  std::vector<VolumeSampling> all;
  for (const auto& [name, integrator] : volumeIntegrators())
    for (int k = 0; k < 6; ++k)
    {
      VolumeSampling sampling = samplingOf(run.options);
      sampling.integrator = integrator;
      sampling.step = step * std::exp2(3 - k);
      sampling.tolerance = std::pow(10.0, -k);
      all.push_back(sampling);
    }
  return all;
}

Section integratorTable(HexTableRun& run)
{
  const VolumeTask& task = run.firstTask();
  std::string method = "cylgrid";
  for (const HexMethodEntry& entry : hexMethods())
    if (!run.options.methods.empty() && entry.name == run.options.methods.front())
      method = entry.name;
  const BuiltHexStructure built =
    buildStructures(task, {{&hexMethodNamed(method), run.options.lambda2}}).front();
  VolumeContest contest(task);
  for (const VolumeSampling& sampling : sweep(run, stepOf(run, task, built)))
    contest.add(built, sampling);
  Section section{"", Table(1)};
  section.table.add({"integrator", "step", "tolerance", "s a frame", "rms error", "max error"});
  const auto number = [](double value)
  { return std::isnan(value) ? std::string("-") : format("%.3g", value); };
  for (const VolumeMeasurement& m : run.race(contest))
    section.table.add({m.integrator, number(m.step), number(m.tolerance), format("%.4f", m.seconds),
      format("%.1e", m.errors.rms), format("%.1e", m.errors.max)});
  section.notes.push_back(
    "Through " + method + ". Rays end at an opacity of 0.9999, which allows errors up to 1e-4.");
  return section;
}

/// Mote's fastest structure in this view, among those built.
BuiltHexStructure fastestStructure(
  HexTableRun& run, const VolumeTask& task, const std::vector<BuiltHexStructure>& all)
{
  VolumeContest contest(task);
  for (const BuiltHexStructure& built : all)
    contest.add(built, samplingOf(run.options));
  const std::vector<VolumeMeasurement> measured = run.race(contest);
  const auto best = std::min_element(measured.begin(), measured.end(),
    [](const VolumeMeasurement& a, const VolumeMeasurement& b) { return a.seconds < b.seconds; });
  return all[static_cast<std::size_t>(best - measured.begin())];
}

/// The fastest structure, sampled from coarse to fine, beside VTK's mappers; of one input.
void addPeerRows(HexTableRun& run, const std::string& input, Section& section)
{
  const VolumeTask& task = run.task(input);
  const BuiltHexStructure built =
    fastestStructure(run, task, buildStructures(task, allStructures(run.options.lambda2)));
  const Tetrahedra tetrahedra = makeTetrahedra(task.input);
  VolumeContest contest(task);
  for (const double step : {16.0, 8.0, 4.0, 2.0, 1.0})
  {
    VolumeSampling sampling = samplingOf(run.options);
    sampling.integrator = VolumeIntegrator::Trilinear;
    sampling.step = step * stepOf(run, task, built);
    contest.add(built, sampling);
  }
  VolumeSampling exact = samplingOf(run.options);
  exact.integrator = VolumeIntegrator::CellByCell;
  exact.tolerance = 1.0;
  for (const double between : {0.0, 1.0 / 512.0, 0.01, 0.03, 0.1})
    contest.add(built, exact, between);
  for (const auto& [name, summary] : volumePeers())
    contest.addPeer(name, tetrahedra);
  const std::vector<VolumeMeasurement> measured = run.race(contest);
  const double peer = measured[measured.size() - volumePeers().size()].seconds;
  for (const VolumeMeasurement& m : measured)
    section.table.add({input, m.method, m.integrator,
      std::isnan(m.step) ? std::string("-") : format("%.3g", m.step),
      format("%.3g", m.cloudTolerance), speed(m), format("%.2f", peer / m.seconds),
      format("%.3f", m.buildSeconds), format("%.1f", m.megabytes), format("%.1e", m.errors.rms),
      format("%.1e", m.errors.max)});
  section.notes.push_back(format("%s: %lld tetrahedra.", input.c_str(),
    static_cast<long long>(tetrahedra.grid->GetNumberOfCells())));
}

Section peerTable(HexTableRun& run)
{
  if (!hasDisplay())
    return {"", Table(1), {noDisplaySentence}};
  Section section{"", Table(3)};
  section.table.add({"input", "method", "integrator", "step", "between", "fps", "x vtk-raycast",
    "build s", "MB", "rms error", "max error"});
  for (const std::string& input : run.inputs)
    addPeerRows(run, input, section);
  section.notes.emplace_back(
    "Of Mote the fastest structure, in even samples from coarse to fine and cell by cell with a "
    "tolerance of 1; 'between' is the tolerance up to which pixels are interpolated.");
  section.notes.emplace_back(peerSentence);
  return section;
}

struct HexTableEntry
{
  std::string name;
  std::string title;
  bool ofAllParts;
  Section (*make)(HexTableRun& run);
};

const std::vector<HexTableEntry>& entries()
{
  static const std::vector<HexTableEntry> all = {
    {"grids", "Two-level grids, cylindrical against Cartesian, ray by ray", true, gridTable},
    {"hierarchies", "Hierarchies, cylindrical against Cartesian, ray by ray", true, hierarchyTable},
    {"sizes", "Ray by ray against the size of the mesh", true, sizeTable},
    {"directions", "Ray by ray against the direction of the view", true, directionTable},
    {"lambda2", "Leaves per reference of a grid's macro cell", false, lambda2Table},
    {"step", "Speed against the distance of samples", false, stepTable},
    {"integrators", "Error against time of the integrators", false, integratorTable},
    {"peers", "Mote beside VTK's mappers", true, peerTable}};
  return all;
}

} // namespace

std::vector<Named> hexTables()
{
  std::vector<Named> all;
  for (const HexTableEntry& entry : entries())
    all.emplace_back(entry.name, entry.title);
  return all;
}

std::vector<std::string> volumeNotes(const VolumeTask& task)
{
  return {format("%dx%d rays, %d thread%s, medians of %d rounds; %s.", task.width, task.height,
            task.threads, task.threads == 1 ? "" : "s", task.repeat, wholeView.second.c_str()),
    transferSentence,
    "Errors are of red, green, blue and alpha, premultiplied in 0..1, over every 7th pixel in each "
    "direction, where it is not empty, against a reference in double that is converged to 1e-6."};
}

Report makeHexTables(const Options& options)
{
  HexTableRun run{options, partsOf(options.input), ""};
  for (const HexTableEntry& entry : entries())
  {
    if (!options.wantsTable(entry.name))
      continue;
    progress("table %s", entry.name.c_str());
    run.name = entry.name;
    Section section = entry.make(run);
    section.title = entry.title + ": " + (entry.ofAllParts ? options.input : run.inputs.front());
    run.report.sections.push_back(std::move(section));
  }
  for (const auto& [input, task] : run.tasks)
    if (task.reference.width > 0)
    {
      for (const std::string& note : volumeNotes(task))
        run.report.sections.back().notes.push_back(note);
      break;
    }
  return std::move(run.report);
}

} // namespace mote::bench
