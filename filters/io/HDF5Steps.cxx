#include "HDF5Steps.h"

#include "FileError.h"
#include "GadgetFile.h"
#include "ParseNumber.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mote
{
namespace
{

/// More components than this are no vector or tensor of a particle.
constexpr std::uint64_t mostComponents = 100;

[[noreturn]] void fail(const HDF5File& file, const std::string& sentence,
  FileError::Kind kind = FileError::Kind::Malformed)
{
  throw FileError(kind, file.path(), sentence);
}

double numberOf(
  const HDF5File& file, const std::string& of, const std::string& attribute, double usual)
{
  const std::vector<double> values = file.numbers(of, attribute);
  return values.empty() || !std::isfinite(values[0]) ? usual : values[0];
}

/// An array of so many particles as a part of a field; none where it is another.
std::optional<HDF5Part> partOf(
  const HDF5File& file, const std::string& name, std::uint64_t particles, bool& isWhole)
{
  const auto array = file.array(name);
  if (!array || !array->isNumber || array->rows() != particles || array->columns() == 0 ||
      array->columns() > mostComponents)
    return {};
  isWhole = isWhole && array->isWhole;
  return HDF5Part{name, static_cast<std::size_t>(array->columns()), {}, 1.0};
}

/// Steps in the order of the numbers behind a prefix: "Step#10" after "Step#9".
std::map<std::int64_t, std::string> numbered(
  const std::vector<std::string>& names, const std::string& prefix)
{
  std::map<std::int64_t, std::string> found;
  for (const std::string& name : names)
  {
    std::int64_t number = 0;
    if (name.starts_with(prefix) && parseInteger(name.c_str() + prefix.size(), number))
      found[number] = name;
  }
  return found;
}

/// Times that do not ascend are none: the numbers of the steps take their place.
void setTimes(HDF5Steps& steps, const std::vector<std::int64_t>& numbers)
{
  const auto isBefore = [](const HDF5Step& a, const HDF5Step& b) { return !(a.time < b.time); };
  const bool ascend =
    std::adjacent_find(steps.steps.begin(), steps.steps.end(), isBefore) == steps.steps.end();
  for (std::size_t i = 0; !ascend && i < numbers.size(); ++i)
    steps.steps[i].time = static_cast<double>(numbers[i]);
}

std::string nameOfGadget(const std::string& name)
{
  static const std::map<std::string, std::string> names = {
    {"Velocities", "v"}, {"Masses", "mass"}, {"ParticleIDs", "id"}};
  const auto found = names.find(name);
  return found == names.end() ? name : found->second;
}

HDF5Kind gadgetKind(const HDF5File& file, int type, double usualMass)
{
  const std::string group = "/PartType" + std::to_string(type);
  HDF5Kind kind;
  kind.type = type;
  kind.name = gadgetTypeNames().contains(type) ? gadgetTypeNames().at(type) : std::to_string(type);
  const auto places = file.array(group + "/Coordinates");
  if (!places || !places->isNumber || places->columns() != 3)
    fail(file, "'" + group + "' has no Coordinates of three numbers each");
  kind.particles = places->rows();
  kind.positions = {"", {{group + "/Coordinates", 3, {}, 1.0}}, false};
  for (const std::string& name : file.namesIn(group))
  {
    bool isWhole = true;
    const auto part = partOf(file, group + "/" + name, kind.particles, isWhole);
    if (part && name != "Coordinates")
      kind.fields.push_back({nameOfGadget(name), {*part}, isWhole});
  }
  if (!kind.field("mass") && usualMass > 0)
    kind.fields.push_back({"mass", {{"", 1, usualMass, 1.0}}, false});
  return kind;
}

HDF5Steps gadgetSteps(const HDF5File& file)
{
  HDF5Steps found;
  found.hasKinds = true;
  HDF5Step step;
  step.time = numberOf(file, "/Header", "Time", 0.0);
  const std::vector<double> masses = file.numbers("/Header", "MassTable");
  for (int type = 0; type < 10; ++type)
  {
    const auto place = static_cast<std::size_t>(type);
    if (file.isGroup("/PartType" + std::to_string(type)))
      step.kinds.push_back(gadgetKind(file, type, place < masses.size() ? masses[place] : 0.0));
  }
  const std::vector<double> size = file.numbers("/Header", "BoxSize");
  if (!size.empty() && size[0] > 0)
    step.box = {size[0], 0, 0, 0, size.size() == 3 ? size[1] : size[0], 0, 0, 0,
      size.size() == 3 ? size[2] : size[0]};
  found.files = static_cast<std::uint64_t>(
    std::clamp(numberOf(file, "/Header", "NumFilesPerSnapshot", 1.0), 1.0, 1e9));
  found.steps.push_back(std::move(step));
  return found;
}

/// Fields of arrays of one number a particle; what differs in a last x, y and z is one field.
std::vector<HDF5Field> fieldsOf(
  const HDF5File& file, const std::string& group, std::uint64_t particles)
{
  const std::vector<std::string> names = file.namesIn(group);
  std::vector<HDF5Field> fields;
  for (const std::string& name : names)
  {
    const std::string stem = name.substr(0, name.size() - 1);
    const auto isThere = [&](char axis)
    { return std::binary_search(names.begin(), names.end(), stem + axis); };
    const bool isVector = !name.empty() && isThere('x') && isThere('y') && isThere('z');
    if (isVector && name.back() != 'x' && (name.back() == 'y' || name.back() == 'z'))
      continue; // of the field of its x
    const bool isFirst = isVector && name.back() == 'x';
    if (isFirst && stem.empty())
      continue; // the positions
    HDF5Field field = {isFirst ? stem : name, {}, true};
    for (const std::string& one : isFirst
                                    ? std::vector<std::string>{stem + 'x', stem + 'y', stem + 'z'}
                                    : std::vector<std::string>{name})
      if (const auto part = partOf(file, group + "/" + one, particles, field.isWhole))
        field.parts.push_back(*part);
    if (field.parts.size() == (isFirst ? 3 : 1))
      fields.push_back(std::move(field));
  }
  return fields;
}

HDF5Step partStep(const HDF5File& file, const std::string& group, double number)
{
  HDF5Kind kind;
  kind.positions.isWhole = true;
  const auto places = file.array(group + "/x");
  kind.particles = places ? places->rows() : 0;
  for (const char* axis : {"/x", "/y", "/z"})
    if (const auto part = partOf(file, group + axis, kind.particles, kind.positions.isWhole);
        part && part->columns == 1)
      kind.positions.parts.push_back(*part);
  if (kind.positions.parts.size() != 3)
    fail(file, "'" + group + "' has no x, y and z of one number a particle");
  kind.fields = fieldsOf(file, group, kind.particles);
  HDF5Step step;
  step.time = numberOf(file, group, "TimeValue", numberOf(file, group, "Time", number));
  step.kinds.push_back(std::move(kind));
  return step;
}

HDF5Steps partSteps(const HDF5File& file, const std::map<std::int64_t, std::string>& groups)
{
  HDF5Steps found;
  std::vector<std::int64_t> numbers;
  for (const auto& [number, name] : groups)
  {
    found.steps.push_back(partStep(file, "/" + name, static_cast<double>(number)));
    numbers.push_back(number);
  }
  setTimes(found, numbers);
  return found;
}

/// A component of a record of openPMD: an array, or a group that says one value for all.
std::optional<HDF5Part> componentOf(const HDF5File& file, const std::string& name,
  std::optional<std::uint64_t> particles, std::uint64_t& count, bool& isWhole)
{
  if (const auto array = file.array(name))
  {
    count = particles.value_or(array->rows());
    auto part = partOf(file, name, count, isWhole);
    return part && part->columns == 1 ? part : std::nullopt;
  }
  const std::vector<double> value = file.numbers(name, "value");
  const std::vector<double> shape = file.numbers(name, "shape");
  if (value.size() != 1 || shape.size() != 1 || !(shape[0] >= 0 && shape[0] < 1e15))
    return {};
  count = static_cast<std::uint64_t>(shape[0]);
  isWhole = false;
  if (particles && count != *particles)
    return {};
  return HDF5Part{"", 1, value[0], 1.0};
}

/// A record with the components that it has; axes that positions lack are 0.
HDF5Field recordOf(const HDF5File& file, const std::string& name,
  std::optional<std::uint64_t> particles, std::uint64_t& count, bool isPlace)
{
  HDF5Field field = {name.substr(name.rfind('/') + 1), {}, true};
  if (const auto scalar = componentOf(file, name, particles, count, field.isWhole))
  {
    field.parts.push_back(*scalar);
    return field;
  }
  for (const char* axis : {"/x", "/y", "/z"})
  {
    const std::string component = name + axis;
    if (auto part = componentOf(file, component, particles, count, field.isWhole))
    {
      part->scale = isPlace ? numberOf(file, component, "unitSI", 1.0) : 1.0;
      field.parts.push_back(*part);
      particles = count;
    }
    else if (isPlace)
      field.parts.push_back({"", 1, 0.0, 1.0});
  }
  return field;
}

HDF5Kind openPMDKind(const HDF5File& file, const std::string& group, int type)
{
  HDF5Kind kind;
  kind.type = type;
  kind.name = group.substr(group.rfind('/') + 1);
  kind.positions = recordOf(file, group + "/position", {}, kind.particles, true);
  if (kind.positions.parts.size() != 3 ||
      std::all_of(kind.positions.parts.begin(), kind.positions.parts.end(),
        [](const HDF5Part& part) { return part.constant.has_value(); }))
    fail(file, "'" + group + "' has no positions");
  std::uint64_t count = 0;
  kind.offsets = recordOf(file, group + "/positionOffset", kind.particles, count, true);
  const auto isNothing = [](const HDF5Part& part) { return part.constant == 0.0; };
  if (kind.offsets.parts.size() != 3 ||
      std::all_of(kind.offsets.parts.begin(), kind.offsets.parts.end(), isNothing))
    kind.offsets.parts.clear();
  bool areAlike = true;
  for (std::size_t axis = 0; axis < kind.offsets.parts.size(); ++axis)
    areAlike = areAlike && kind.offsets.parts[axis].scale == kind.positions.parts[axis].scale;
  if (areAlike)
    for (HDF5Field* field : {&kind.positions, &kind.offsets})
      for (HDF5Part& part : field->parts)
        part.scale = 1.0; // the file's own units
  for (const std::string& name : file.namesIn(group))
  {
    if (name == "position" || name == "positionOffset" || name == "particlePatches")
      continue;
    HDF5Field field = recordOf(file, group + "/" + name, kind.particles, count, false);
    if (!field.parts.empty())
      kind.fields.push_back(std::move(field));
  }
  return kind;
}

HDF5Steps openPMDSteps(const HDF5File& file)
{
  HDF5Steps found;
  found.hasKinds = true;
  std::vector<std::int64_t> numbers;
  std::map<std::string, int> types; // of the kinds of all steps
  for (const auto& [number, name] : numbered(file.namesIn("/data"), ""))
  {
    const std::string group = "/data/" + name;
    HDF5Step step;
    step.time = numberOf(file, group, "time", static_cast<double>(number));
    for (const std::string& kind : file.namesIn(group + "/particles"))
    {
      const int type = types.emplace(kind, static_cast<int>(types.size()) + 1).first->second;
      step.kinds.push_back(openPMDKind(file, group + "/particles/" + kind, type));
    }
    if (step.kinds.empty())
      continue;
    found.steps.push_back(std::move(step));
    numbers.push_back(number);
  }
  if (found.steps.empty())
    fail(file, "no iteration of this openPMD file has particles");
  setTimes(found, numbers);
  return found;
}

} // namespace

std::size_t HDF5Field::components() const
{
  std::size_t components = 0;
  for (const HDF5Part& part : parts)
    components += part.columns;
  return components;
}

const HDF5Field* HDF5Kind::field(const std::string& wanted) const
{
  const auto found = std::find_if(
    fields.begin(), fields.end(), [&](const HDF5Field& one) { return one.name == wanted; });
  return found == fields.end() ? nullptr : &*found;
}

HDF5Steps findHDF5Steps(const HDF5File& file)
{
  if (file.hasAttribute("/", "openPMD"))
    return openPMDSteps(file);
  const std::vector<std::string> names = file.namesIn("/");
  const auto isKind = [](const std::string& name) { return name.starts_with("PartType"); };
  if (std::any_of(names.begin(), names.end(), isKind))
    return gadgetSteps(file);
  if (const auto steps = numbered(names, "Step#"); !steps.empty())
    return partSteps(file, steps);
  fail(file, "this HDF5 file has no particles of Gadget, H5Part or openPMD",
    FileError::Kind::OtherFormat);
}

} // namespace mote
