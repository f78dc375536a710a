#include "RayTables.h"

#include "RayQueries.h"

#include <kernels/core/Error.h>

#include <glm/trigonometric.hpp>

#include <array>
#include <cstdlib>

namespace mote::bench
{

namespace
{

std::string number(const char* pattern, double value)
{
  return std::isnan(value) ? std::string("-") : format(pattern, value);
}

/// Pumps are not made smaller.
constexpr double leastScale = 0.0005;

/// How rays were cast.
std::string castSentence(const Options& options, const std::string& view)
{
  return format("%dx%d rays %s, one at a time through all structures and to their ends, with "
                "nothing integrated; CPU time of one thread, medians of %d rounds. Of rays that "
                "pass a cell; ratios are cylindrical to Cartesian.",
    options.width, options.height, view.c_str(), options.repeat);
}

/// One number of a table of twins.
struct Column
{
  const char* title;
  const char* pattern;
  double VolumeMeasurement::*value;
};

const std::vector<Column>& twinColumns()
{
  using M = VolumeMeasurement;
  static const std::vector<Column> all = {{"build s", "%.3f", &M::buildSeconds},
    {"MB", "%.1f", &M::megabytes}, {"references", "%.0f", &M::references},
    {"in a leaf", "%.0f", &M::largestLeaf}, {"levels", "%.0f", &M::levels},
    {"nodes", "%.0f", &M::nodes}, {"area", "%.1f", &M::area}, {"leaf area", "%.1f", &M::leafArea},
    {"cells a ray", "%.1f", &M::cellsVisited}, {"nodes a ray", "%.1f", &M::nodesVisited},
    {"us a ray", "%.2f", &M::rayMicroseconds}};
  return all;
}

/// Rows of a cylindrical structure, its Cartesian twin and their ratio, in pairs.
void addTwins(HexTableRun& run, const std::string& input,
  const std::vector<HexStructureRequest>& requests, Section& section)
{
  const VolumeTask& task = run.task(input, false);
  RayQueries queries(task, task.camera);
  for (const BuiltHexStructure& built : buildStructures(task, requests))
    queries.add(built.structure, measurementOf(task, built));
  std::vector<VolumeMeasurement> measured = queries.race();
  run.record(measured);
  for (std::size_t i = 0; i < measured.size(); ++i)
  {
    std::vector<std::string> row = {input, measured[i].method}, ratios = {"", "ratio"};
    for (const Column& column : twinColumns())
    {
      const double value = measured[i].*column.value;
      row.push_back(number(column.pattern, value));
      ratios.push_back(number("%.2f", measured[i - i % 2].*column.value / value));
    }
    section.table.add(row);
    ratios.back() = format("%.2f", queries.ratio(i - i % 2, i));
    if (i % 2 == 1)
      section.table.add(ratios);
  }
  section.notes.push_back(format("%s: %zu cells, of which a ray passes %.1f.", input.c_str(),
    task.input.mesh->cellCount(), measured.front().cellsPassed));
}

Section twinTable(HexTableRun& run, const std::vector<HexStructureRequest>& requests)
{
  Section section{"", Table(2)};
  std::vector<std::string> titles = {"input", "structure"};
  for (const Column& column : twinColumns())
    titles.emplace_back(column.title);
  section.table.add(titles);
  for (const std::string& input : run.inputs)
    addTwins(run, input, requests, section);
  section.notes.push_back(castSentence(run.options, wholeView.second));
  section.notes.emplace_back("Nodes of a grid: macro cells and leaves. Areas: sums over all nodes "
                             "and over the leaves, in that of the mesh's box.");
  return section;
}

/// Every structure's rays from one camera, as texts of a row: cells tested, then time in that of
/// the Cartesian twin.
std::vector<std::string> addView(HexTableRun& run, const VolumeTask& task, const Camera& camera,
  const std::vector<BuiltHexStructure>& structures, double degrees)
{
  RayQueries queries(task, camera);
  for (const BuiltHexStructure& built : structures)
  {
    VolumeMeasurement m = measurementOf(task, built);
    m.degrees = degrees;
    queries.add(built.structure, m);
  }
  std::vector<VolumeMeasurement> measured = queries.race();
  run.record(measured);
  std::vector<std::string> texts = {format("%.1f", measured.front().cellsPassed)};
  for (const VolumeMeasurement& m : measured)
    texts.push_back(format("%.1f", m.cellsVisited));
  for (const VolumeMeasurement& m : measured)
    texts.push_back(format("%.2f", m.rayMicroseconds));
  for (std::size_t i = 0; i + 1 < measured.size(); i += 2)
    texts.push_back(format("%.2f", queries.ratio(i, i + 1)));
  return texts;
}

/// All structures, made once.
std::vector<BuiltHexStructure> makeAll(const VolumeTask& task, double lambda2)
{
  std::vector<BuiltHexStructure> all;
  for (const HexMethodEntry& entry : hexMethods())
  {
    BuiltHexStructure built;
    built.method = entry.name;
    built.lambda2 = lambda2;
    built.structure = makeStructure(task.input, {&entry, lambda2});
    describe(built);
    all.push_back(std::move(built));
  }
  return all;
}

Section curveSection(const char* variable)
{
  Section section{"", Table(1)};
  std::vector<std::string> titles = {"input", variable, "passed"};
  for (const char* what : {"cells", "us"})
    for (const HexMethodEntry& entry : hexMethods())
      titles.push_back(entry.name + " " + what);
  titles.insert(titles.end(), {"grids, us", "bvhs, us"});
  section.table.add(titles);
  return section;
}

/// A camera that looks at the whole mesh, `degrees` away from along the axis. About the axis it
/// stands aslant, so that it does not look along x or y.
Camera cameraFromAxis(const Box& bounds, const CylinderAxis& axis, double degrees)
{
  const Vec3d h = glm::normalize(axis.direction);
  const Vec3d other = std::abs(h.x) < 0.9 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d u = glm::normalize(glm::cross(h, other)), v = glm::cross(h, u);
  const double around = glm::radians(35.0), from = glm::radians(degrees);
  const Vec3d across = std::cos(around) * u + std::sin(around) * v;
  return wholeCamera(bounds, std::cos(from) * h + std::sin(from) * across, glm::cross(h, across));
}

} // namespace

Section gridTable(HexTableRun& run)
{
  const HexMethodEntry *cylindrical = &hexMethodNamed(CylindricalGrid::name()),
                       *cartesian = &hexMethodNamed(CartesianGrid::name());
  const double lambda2 = run.options.lambda2;
  return twinTable(run, {{cylindrical, lambda2}, {cartesian, lambda2}, {cylindrical, lambda2, true},
                          {cartesian, lambda2, true}});
}

Section hierarchyTable(HexTableRun& run)
{
  return twinTable(
    run, {{&hexMethodNamed(CylindricalBvh::name())}, {&hexMethodNamed(CartesianBvh::name())}});
}

Section sizeTable(HexTableRun& run)
{
  Section section = curveSection("cells");
  for (const std::string& input : run.inputs)
  {
    const std::size_t from = input.find(':') + 1, to = input.find(':', from);
    if (input.rfind("pump:", 0) != 0 || to == std::string::npos)
    {
      section.notes.push_back(input + " has one size only.");
      continue;
    }
    const double scale = std::strtod(input.c_str() + from, nullptr);
    for (const double part : {1.0 / 64.0, 1.0 / 16.0, 1.0 / 4.0, 1.0})
    {
      if (part * scale < leastScale)
        continue;
      const std::string sized = format("pump:%g", part * scale) + input.substr(to);
      const VolumeTask& task = run.task(sized, false);
      std::vector<std::string> row = {
        input.substr(to + 1), format("%zu", task.input.mesh->cellCount())};
      for (std::string& text :
        addView(run, task, task.camera, makeAll(task, run.options.lambda2), NAN))
        row.push_back(std::move(text));
      section.table.add(row);
    }
  }
  section.notes.push_back(castSentence(run.options, wholeView.second));
  return section;
}

Section directionTable(HexTableRun& run)
{
  Section section = curveSection("degrees");
  for (const std::string& input : run.inputs)
  {
    const VolumeTask& task = run.task(input, false);
    const HexMesh& mesh = *task.input.mesh;
    const CylinderAxis axis = task.input.axis ? *task.input.axis : findAxis(mesh);
    const std::vector<BuiltHexStructure> structures = makeAll(task, run.options.lambda2);
    for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0})
    {
      std::vector<std::string> row = {input, format("%g", degrees)};
      for (std::string& text :
        addView(run, task, cameraFromAxis(mesh.bounds(), axis, degrees), structures, degrees))
        row.push_back(std::move(text));
      section.table.add(row);
    }
    section.notes.push_back(format("%s: the axis, %s, goes through (%.4g, %.4g, %.4g) along "
                                   "(%.4g, %.4g, %.4g).",
      input.c_str(), task.input.axis ? "the input's" : "found", axis.origin.x, axis.origin.y,
      axis.origin.z, axis.direction.x, axis.direction.y, axis.direction.z));
  }
  section.notes.push_back(
    castSentence(run.options, "from so many degrees away from the axis, towards the middle"));
  return section;
}

} // namespace mote::bench
