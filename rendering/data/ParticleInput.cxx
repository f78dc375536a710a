#include "ParticleInput.h"

#include "Names.h"

#include "kernels/core/Error.h"
#include "kernels/particles/PkdTreeFile.h"

#include "vtkMoteParticleFilePoints.h"
#include "vtkMoteSourcePoints.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtksys/SystemTools.hxx"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace mote
{

namespace
{

vtkDataArray* requireScalar(vtkPointSet* points, const std::string& name, const char* what)
{
  vtkDataArray* array = requirePointArray(points, name, what);
  if (array->GetNumberOfComponents() != 1)
    throw Error("The array \"" + name + "\" has " + std::to_string(array->GetNumberOfComponents()) +
                " components; " + what + " need one.");
  return array;
}

/// In small letters, without units in brackets and what joins words: "Particle Diameter (m)" as
/// particlediameter.
std::string plainName(const std::string& name)
{
  std::string plain;
  for (const char c : name.substr(0, name.find_first_of("([{")))
    if (std::string(" _-.").find(c) == std::string::npos)
      plain += c;
  return vtksys::SystemTools::LowerCase(plain);
}

/// NaN differs from itself: as radii NaN and infinity are unfit alike.
void addRadius(InputKey& key, double radius)
{
  key.push_back(std::isnan(radius) ? std::numeric_limits<double>::infinity() : radius);
}

/// Who tells the points where they are in no array, such as a generator or a file; or null.
std::shared_ptr<const ParticleSource> sourceOf(vtkPointSet* points)
{
  auto* ofSource = vtkMoteSourcePoints::SafeDownCast(points->GetPoints());
  return ofSource ? ofSource->GetSource() : nullptr;
}

/// Array of the points that holds the radii, or null for none; with half = true where it holds
/// diameters.
vtkDataArray* findRadiusArray(vtkPointSet* points, const RadiusChoice& choice, bool& half)
{
  half = false;
  if (points->GetNumberOfPoints() == 0)
    return nullptr; // what is empty lacks no array
  switch (choice.mode)
  {
  case RadiusMode::ByArray:
    return requireScalar(points, choice.radiusArray, "radii");
  case RadiusMode::ByType:
    return requireScalar(points, choice.typeArray, "types");
  case RadiusMode::Automatic:
    if (sourceOf(points))
      return nullptr; // the source's own radii
    {
      vtkDataArray* radii = namedRadii(points->GetPointData());
      half = radii && radiusFactor(radii->GetName()) == 0.5;
      return radii;
    }
  default:
    return nullptr;
  }
}

/// The points, without radii.
void takePositions(vtkPointSet* points, ParticleInput& input)
{
  input.set.source = sourceOf(points);
  if (input.set.source)
    return;
  input.positions = DataArrayView(points->GetPoints()->GetData());
  input.set.positions = input.positions.view;
}

} // namespace

double radiusFactor(const std::string& name)
{
  const std::string plain = plainName(name);
  for (const char* what : {"", "particle", "sphere", "grain", "atom"})
  {
    if (plain == what + std::string("radius") || plain == what + std::string("radii"))
      return 1.0;
    if (plain == what + std::string("diameter"))
      return 0.5;
  }
  return 0.0;
}

vtkDataArray* namedRadii(vtkPointData* data)
{
  vtkDataArray* found = nullptr;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = data->GetArray(i);
        array && array->GetName() && array->GetNumberOfComponents() == 1)
      if (const double factor = radiusFactor(array->GetName());
          factor > 0.0 && (!found || factor > radiusFactor(found->GetName())))
        found = array;
  return found;
}

std::shared_ptr<const PkdTreeFile> fileOf(vtkPointSet* points)
{
  auto* inFile = vtkMoteParticleFilePoints::SafeDownCast(points->GetPoints());
  return inFile ? inFile->GetFile() : nullptr;
}

bool drawsFile(vtkPointSet* points, const RadiusChoice& choice, const StructureChoice& structure)
{
  if (choice.mode != RadiusMode::Automatic || choice.scale != 1.0 ||
      (structure.kind != ParticleStructureKind::Automatic &&
        structure.kind != ParticleStructureKind::PkdTree))
    return false;
  const auto file = fileOf(points);
  return file && (!structure.form || *structure.form == file->tree().form());
}

double spacingOf(vtkPointSet* points, const ParticleParts* parts)
{
  const auto file = fileOf(points);
  if (!parts && file && file->spacing() > 0.0)
    return file->spacing();
  std::vector<double> count = {static_cast<double>(points->GetNumberOfPoints())};
  if (parts)
    parts->sum(count);
  if (count[0] < 2.0)
    return 0.0;
  ParticleInput input;
  if (points->GetNumberOfPoints() > 0)
    takePositions(points, input);
  return estimateSpacing(input.set, parts);
}

void printRadii(const RadiusChoice& choice, std::ostream& os, vtkIndent indent)
{
  static const char* const modes[] = {
    "Automatic", "Constant", "By array", "By type", "From spacing"};
  const auto text = [](const std::string& s) { return s.empty() ? "(none)" : s; };
  os << indent << "RadiusMode: " << modes[static_cast<int>(choice.mode)] << "\n"
     << indent << "Radius: " << choice.radius << "\n"
     << indent << "RadiusScale: " << choice.scale << "\n"
     << indent << "RadiusArrayName: " << text(choice.radiusArray) << "\n"
     << indent << "TypeArrayName: " << text(choice.typeArray) << "\n";
  for (const auto& [type, radius] : choice.typeRadii)
    os << indent << "TypeRadius of " << type << ": " << radius << "\n";
}

vtkDataArray* requirePointArray(vtkPointSet* points, const std::string& name, const char* purpose)
{
  const std::string what = "\"" + name + "\" for " + purpose;
  vtkDataArray* array = points->GetPointData()->GetArray(name.c_str());
  if (!array)
    throw Error("There is no point array " + what +
                "; there are: " + arrayNames(points->GetPointData()) + ".");
  if (array->GetNumberOfTuples() != points->GetNumberOfPoints())
    throw Error("The array " + what + " has not one tuple a point.");
  return array;
}

ParticleInput makeParticleInput(
  vtkPointSet* points, const RadiusChoice& choice, ScratchSpace* space)
{
  ParticleInput input;
  if (!points->GetPoints() || points->GetNumberOfPoints() == 0)
    return input;
  takePositions(points, input);
  input.set.radiusScale = choice.scale;

  bool half = false;
  vtkDataArray* array = findRadiusArray(points, choice, half);
  if (array && choice.mode == RadiusMode::ByType)
  {
    const DataArrayView types(array);
    const std::size_t count = types.view.count();
    input.ownRadii.resize(
      count, space && count > 0 ? space->allocate(count * sizeof(double)) : nullptr);
    double* const own = input.ownRadii.own();
    tbb::parallel_for(std::size_t{0}, count,
      [&](std::size_t i)
      {
        const auto found = choice.typeRadii.find(static_cast<int>(types.view.value(i)));
        own[i] = found == choice.typeRadii.end() ? choice.radius : found->second;
      });
    input.set.radii = ArrayView(input.ownRadii.data(), input.ownRadii.size(), 1);
  }
  else if (array)
  {
    input.radii = DataArrayView(array);
    input.set.radii = input.radii.view;
    input.set.radiusScale *= half ? 0.5 : 1.0;
  }
  else
  {
    if (choice.mode == RadiusMode::Constant)
      input.set.radius = choice.radius;
    else if (input.set.source && choice.mode == RadiusMode::Automatic)
    {
      input.set = ParticleSet::of(input.set.source);
      input.set.radiusScale *= choice.scale;
    }
    else if (const auto file = fileOf(points); file && file->spacing() > 0.0)
      input.set.radius = 0.5 * file->spacing();
    else
      input.set.radius = 0.5 * estimateSpacing(input.set);
    input.commonRadius = input.set.radiiOfSource ? 0.0 : input.set.radius * choice.scale;
  }
  return input;
}

void addArray(InputKey& key, vtkDataArray* array)
{
  key.push_back(array ? static_cast<double>(array->GetMTime()) : -1.0);
}

InputKey keyOf(vtkPointSet* points, const RadiusChoice& choice)
{
  bool half = false;
  vtkDataArray* radii = findRadiusArray(points, choice, half);
  const bool byType = choice.mode == RadiusMode::ByType;
  InputKey key = {double(choice.mode), double(half)};
  addArray(key, points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
  addArray(key, radii);
  addRadius(key, choice.scale);
  if (byType || choice.mode == RadiusMode::Constant)
    addRadius(key, choice.radius);
  if (byType)
    for (const auto& [type, radius] : choice.typeRadii)
    {
      key.push_back(type);
      addRadius(key, radius);
    }
  return key;
}

std::vector<std::string> structureFormNames()
{
  std::vector<std::string> names = pkdTreeFormNames();
  names.insert(names.begin(), "auto");
  return names;
}

StructureChoice structureOf(const std::string& name, const std::string& form)
{
  const std::vector<std::string>& names = particleStructureNames();
  StructureChoice choice;
  choice.kind = static_cast<ParticleStructureKind>(findName(names, name.c_str(), "structure"));
  const std::size_t asked = findName(structureFormNames(), form.c_str(), "form");
  if (asked == 0)
    return choice;
  choice.form = static_cast<PkdTreeOptions::Form>(asked - 1);
  if (choice.kind == ParticleStructureKind::Automatic)
    choice.kind = ParticleStructureKind::PkdTree;
  if (choice.kind != ParticleStructureKind::PkdTree)
    throw Error(
      "The structure \"" + name + "\" has no forms; \"" + form + "\" is one of \"pkd-tree\".");
  return choice;
}

void buildStructure(std::shared_ptr<ParticleStructure>& structure, const ParticleSet& particles,
  const ParticleStructureOptions& options, const Progress& progress)
{
  // One that somebody else still looks at stays as it is.
  std::shared_ptr<ParticleStructure> used = structure.use_count() == 1 ? structure : nullptr;
  structure = nullptr;
  structure = makeParticleStructure(particles, options, progress, std::move(used));
}

} // namespace mote
