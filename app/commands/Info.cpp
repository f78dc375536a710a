#include "Info.h"

#include "MeshFacts.h"
#include "base/Text.h"
#include "base/Unit.h"
#include "stage/Arrays.h"
#include "stage/BoxFiles.h"
#include "stage/Calculated.h"
#include "stage/HiddenParts.h"
#include "stage/Input.h"
#include "stage/Part.h"
#include "stage/SimulationBox.h"

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkMoteParticleFilePoints.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteReaderTable.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkTimerLog.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace mote::app
{

namespace
{

/// One array as both forms of output show it.
struct ArrayFacts
{
  std::string name, place, type;
  std::string unit; ///< empty where the data do not say
  std::vector<std::string> components;
  double range[2] = {1.0, 0.0};
  bool ranged = false;
  bool whole = false;
  std::optional<double> mean; ///< by volume
};

ArrayFacts factsOf(vtkAbstractArray* array, const char* place)
{
  ArrayFacts facts;
  facts.name = nameOf(array);
  facts.place = place;
  facts.type = array->GetDataTypeAsString();
  const int components = array->GetNumberOfComponents();
  for (int i = 0; components > 1 && i < components; ++i)
    facts.components.push_back(componentName(array, i));
  facts.whole =
    array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE && components == 1;
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
    facts.ranged = finiteRange(numbers, components > 1 ? ArrayChoice::magnitude : 0, facts.range);
  return facts;
}

std::vector<ArrayFacts> allFacts(vtkDataSet* data, const std::optional<MeshFacts>& mesh)
{
  std::vector<ArrayFacts> all;
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
    all.push_back(factsOf(data->GetPointData()->GetAbstractArray(i), "point"));
  for (int i = 0; i < data->GetCellData()->GetNumberOfArrays(); ++i)
    all.push_back(factsOf(data->GetCellData()->GetAbstractArray(i), "cell"));
  for (ArrayFacts& facts : all)
  {
    facts.unit = unitText(unitOf(data, facts.name));
    if (mesh)
      facts.mean = mesh->meanOf(facts.name, facts.place);
  }
  return all;
}

/// What there is to say about cells that fill space; nothing where there are none.
std::optional<MeshFacts> meshOf(vtkDataSet* data)
{
  if (!Part::isMesh(data))
    return {};
  MeshFacts facts(data);
  return facts.any() ? std::optional(facts) : std::nullopt;
}

/// The points, where they stay in a .mote file; else null.
vtkMoteParticleFilePoints* pointsInFile(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  return points ? vtkMoteParticleFilePoints::SafeDownCast(points->GetPoints()) : nullptr;
}

/// The typical distance between neighbours; 0 where there is none.
double spacingOf(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  if (!points || Part::isMesh(data) || points->GetNumberOfPoints() < 2)
    return 0.0;
  return vtkMoteParticleMapper::EstimateSpacing(points);
}

std::string interval(const double range[2], int digits = 6)
{
  return "[" + asNumber(range[0], digits) + ", " + asNumber(range[1], digits) + "]";
}

std::string vector(const double v[3])
{
  return "(" + asNumber(v[0]) + ", " + asNumber(v[1]) + ", " + asNumber(v[2]) + ")";
}

void printLine(const char* what, const std::string& text)
{
  std::printf("  %-12s%s\n", what, text.c_str());
}

void printTimes(const Input& input, int step)
{
  const std::vector<double>& times = input.times();
  if (times.empty())
    return;
  std::vector<std::string> shown;
  const std::size_t count = times.size();
  for (std::size_t i = 0; i < count; ++i)
    if (count <= 8 || i < 4 || i + 2 > count)
      shown.push_back(asNumber(times[i], 10));
    else if (i == 4)
      shown.emplace_back("...");
  printLine("time steps", std::to_string(count) + ": " + joined(shown, ", "));
  printLine(
    "shown here", "step " + std::to_string(step + 1) + ", t = " + asNumber(times[step], 10));
}

void printArrays(const std::vector<ArrayFacts>& arrays)
{
  const auto shownName = [](const ArrayFacts& facts)
  { return facts.name.empty() ? std::string("(unnamed)") : facts.name; };
  std::size_t width = 8;
  for (const ArrayFacts& facts : arrays)
    width = std::max(width, shownName(facts).size());
  for (const ArrayFacts& facts : arrays)
  {
    std::string text = facts.ranged ? interval(facts.range, facts.whole ? 16 : 6) : "";
    if (!facts.components.empty())
      text =
        "(" + joined(facts.components, " ") + ")" + (text.empty() ? "" : ", magnitude ") + text;
    if (!text.empty() && !facts.unit.empty())
      text += ' ' + facts.unit;
    if (facts.mean)
      text += ", mean by volume " + asNumber(*facts.mean);
    std::printf("  %-5s  %-*s  %-9s  %s\n", facts.place.c_str(), static_cast<int>(width),
      shownName(facts).c_str(), facts.type.c_str(), text.c_str());
  }
}

void printMesh(const MeshFacts& mesh)
{
  printLine("cells", mesh.cells());
  const double range[2] = {mesh.of("min_volume"), mesh.of("max_volume")};
  printLine("volume", asNumber(mesh.of("volume")) + ", of a cell " + interval(range));
  if (std::isfinite(mesh.of("min_scaled_jacobian"))) // polyhedra have none
    printLine("quality", "scaled Jacobian " + asNumber(mesh.of("min_scaled_jacobian"), 3) +
                           " at worst, " + asNumber(mesh.of("mean_scaled_jacobian"), 3) +
                           " on average; aspect ratio up to " +
                           asNumber(mesh.of("max_aspect_ratio"), 3));
  const std::string complaints = mesh.complaints();
  printLine("bad cells", complaints.empty() ? "none" : complaints);
}

/// Whether all cells are triangles of a vtkPolyData.
bool isOfTriangles(vtkDataSet* data)
{
  auto* surface = vtkPolyData::SafeDownCast(data);
  return surface && surface->GetNumberOfPolys() == surface->GetNumberOfCells() &&
         surface->GetPolys()->IsHomogeneous() == 3;
}

const char* kindOf(vtkDataSet* data, const Settings& settings)
{
  Settings any = settings;
  any.volume.cells = "auto";
  switch (Part::kindOf(data, any))
  {
  case Part::Kind::Volume:
    return "volume";
  case Part::Kind::Surface:
    return "surface";
  default:
    return "particles";
  }
}

/// A line for each of the parts of a file, where it has several.
void printParts(
  const std::vector<NamedData>& all, const Settings& settings, const std::string& name)
{
  const std::vector<bool> hidden = hiddenParts(all, settings.selection);
  std::size_t width = 4;
  for (const NamedData& one : all)
    width = std::max(width, partName(one).size());
  std::printf("%s\n", name.c_str());
  printLine("parts", std::to_string(all.size()));
  std::printf("  %3s  %-*s  %-9s  %12s  %12s\n", "", static_cast<int>(width), "name", "kind",
    "cells", "points");
  for (std::size_t i = 0; i < all.size(); ++i)
    std::printf("  %3zu  %-*s  %-9s  %12s  %12s%s\n", i + 1, static_cast<int>(width),
      partName(all[i]).c_str(), kindOf(all[i].data, settings),
      withThousands(all[i].data->GetNumberOfCells()).c_str(),
      withThousands(all[i].data->GetNumberOfPoints()).c_str(),
      !hidden[i]          ? ""
      : all[i].isBoundary ? "  not shown unless --show-part names it"
                          : "  hidden");
}

void printText(const NamedData& one, const Input& input, int step, double seconds)
{
  vtkDataSet* data = one.data;
  std::printf("%s\n", one.name.c_str());
  std::string contents = counted(data->GetNumberOfPoints(), "point");
  if (Part::isMesh(data))
    contents += ", " + counted(data->GetNumberOfCells(), isOfTriangles(data)   ? "triangle"
                                                         : Part::isLines(data) ? "line"
                                                                               : "cell");
  printLine("holds", contents + " (" + data->GetClassName() + ")");
  printTimes(input, step);
  if (data->GetNumberOfPoints() > 0)
  {
    const double* b = data->GetBounds();
    printLine("bounds", interval(b) + " x " + interval(b + 2) + " x " + interval(b + 4));
  }
  if (const auto box = simulationBoxOf(data))
    printLine("box", "origin " + vector(box->origin) + ", vectors " + vector(box->vectors[0]) +
                       " " + vector(box->vectors[1]) + " " + vector(box->vectors[2]));
  if (const double spacing = spacingOf(data); spacing > 0.0)
    printLine("spacing", asNumber(spacing, 4) + " between neighbours");
  if (auto* inFile = pointsInFile(data))
    printLine("form",
      inFile->GetForm() + ", coordinates off by up to " + asNumber(inFile->GetPositionError(), 3));
  printLine("read in", asDuration(seconds));
  const std::optional<MeshFacts> mesh = meshOf(data);
  if (mesh)
    printMesh(*mesh);
  const std::vector<ArrayFacts> arrays = allFacts(data, mesh);
  printLine("arrays", arrays.empty() ? "none" : std::to_string(arrays.size()));
  printArrays(arrays);
}

using Json = nlohmann::ordered_json;

Json asJson(const ArrayFacts& facts)
{
  return {{"name", facts.name}, {"of", facts.place}, {"type", facts.type},
    {"unit", facts.unit.empty() ? Json() : Json(facts.unit)}, {"components", facts.components},
    {"range", facts.ranged ? Json{facts.range[0], facts.range[1]} : Json()},
    {"mean", facts.mean ? Json(*facts.mean) : Json()}};
}

/// Some numbers, or null for none.
Json numbers(const double* values, int count)
{
  return values ? Json(std::vector<double>(values, values + count)) : Json();
}

Json asJson(const NamedData& one, bool isHidden, const Settings& settings, const Input& input,
  int step, double seconds)
{
  vtkDataSet* data = one.data;
  const std::optional<MeshFacts> mesh = meshOf(data);
  const auto box = simulationBoxOf(data);
  const double spacing = spacingOf(data);
  auto* inFile = pointsInFile(data);
  Json json = {{"name", one.name}, {"part", partName(one)}, {"kind", kindOf(data, settings)},
    {"hidden", isHidden}, {"class", data->GetClassName()}, {"points", data->GetNumberOfPoints()},
    {"cells", data->GetNumberOfCells()}, {"times", input.times()}, {"step", step + 1},
    {"bounds", numbers(data->GetNumberOfPoints() > 0 ? data->GetBounds() : nullptr, 6)},
    {"box", numbers(box ? &box->vectors[0][0] : nullptr, 9)},
    {"box_origin", numbers(box ? box->origin : nullptr, 3)},
    {"spacing", spacing > 0.0 ? Json(spacing) : Json()},
    {"form", inFile ? Json(inFile->GetForm()) : Json()},
    {"position_error", inFile ? Json(inFile->GetPositionError()) : Json()},
    {"read_seconds", seconds}, {"mesh", Json()}, {"arrays", Json::array()}};
  if (mesh)
    for (const auto& [name, value] : mesh->all())
      json["mesh"][name] = value;
  for (const ArrayFacts& facts : allFacts(data, mesh))
    json["arrays"].push_back(asJson(facts));
  return json;
}

} // namespace

void printInfo(const Settings& settings)
{
  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  Json objects = Json::array();
  for (const auto& files : vtkMoteReaderTable::GroupSeries(withoutBoxFiles(settings.data.files)))
  {
    Input input(files);
    const double start = vtkTimerLog::GetUniversalTime();
    input.open(progress);
    const int step = input.chosenStep(settings);
    const std::vector<NamedData> all = readAsAsked(input, step, settings, progress);
    const double seconds = vtkTimerLog::GetUniversalTime() - start;
    if (all.size() > 1 && !settings.output.json)
      printParts(all, settings, input.name());
    const std::vector<bool> hidden = hiddenParts(all, settings.selection);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (settings.output.json)
        objects.push_back(asJson(all[i], hidden[i], settings, input, step, seconds));
      else
        printText(all[i], input, step, seconds);
  }
  // Names need not be UTF-8.
  if (settings.output.json)
    std::printf("%s\n", objects.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

} // namespace mote::app
