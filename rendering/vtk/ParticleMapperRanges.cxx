// The part of vtkMoteParticleMapper that says which particles are hidden.

#include "ParticleMapperInternals.h"

#include "Names.h"

#include "kernels/core/Error.h"
#include "kernels/particles/PkdTreeFile.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>

namespace
{

constexpr std::size_t mostRanges = 4;

void copyBounds(const mote::Box& box, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  for (int axis = 0; axis < 3 && !box.empty(); ++axis)
  {
    bounds[2 * axis] = box.lower[axis];
    bounds[2 * axis + 1] = box.upper[axis];
  }
}

} // namespace

bool vtkMoteParticleMapper::CheckRange(double low, double high)
{
  if (low <= high)
    return true;
  vtkErrorMacro("A range from " << low << " to " << high
                                << " is none: its first end must not lie above its second.");
  return false;
}

bool vtkMoteParticleMapper::AddRange(const char* array, int component, double low, double high)
{
  if (!array || !*array)
  {
    vtkErrorMacro("A range needs the name of a point array.");
    return false;
  }
  if (!this->CheckRange(low, high))
    return false;
  auto& ranges = this->Impl->ranges;
  const Internals::ArrayRange range = {array, component, low, high};
  const auto found = std::find_if(ranges.begin(), ranges.end(),
    [&](const auto& r) { return r.name == range.name && r.component == component; });
  if (found != ranges.end())
  {
    if (found->low == low && found->high == high)
      return true;
    *found = range;
  }
  else if (ranges.size() == mostRanges)
  {
    vtkErrorMacro("There is no room for a range of \"" << array << "\": " << mostRanges
                                                       << " arrays have one already.");
    return false;
  }
  else
    ranges.push_back(range);
  this->Modified();
  return true;
}

void vtkMoteParticleMapper::RemoveRange(const char* array, int component)
{
  const std::string name = array ? array : "";
  if (std::erase_if(this->Impl->ranges,
        [&](const auto& r) { return r.name == name && r.component == component; }) > 0)
    this->Modified();
}

int vtkMoteParticleMapper::GetNumberOfRanges()
{
  return static_cast<int>(this->Impl->ranges.size());
}

bool vtkMoteParticleMapper::SetCenterRange(int axis, double low, double high)
{
  if (axis < 0 || axis > 2)
  {
    vtkErrorMacro("Axes are 0, 1 and 2 for x, y and z; there is no axis " << axis << ".");
    return false;
  }
  if (!this->CheckRange(low, high))
    return false;
  mote::PlaceRanges& places = this->Impl->places;
  if (places.low[axis] == low && places.high[axis] == high)
    return true;
  places.low[axis] = low;
  places.high[axis] = high;
  this->Modified();
  return true;
}

void vtkMoteParticleMapper::GetCenterRange(int axis, double range[2])
{
  range[0] = this->Impl->places.low[std::clamp(axis, 0, 2)];
  range[1] = this->Impl->places.high[std::clamp(axis, 0, 2)];
}

bool vtkMoteParticleMapper::SetRadiusRange(double low, double high)
{
  if (!this->CheckRange(low, high))
    return false;
  mote::PlaceRanges& places = this->Impl->places;
  if (places.low[3] == low && places.high[3] == high)
    return true;
  places.low[3] = low;
  places.high[3] = high;
  this->Modified();
  return true;
}

void vtkMoteParticleMapper::GetRadiusRange(double range[2])
{
  range[0] = this->Impl->places.low[3];
  range[1] = this->Impl->places.high[3];
}

void vtkMoteParticleMapper::RemoveAllRanges()
{
  if (this->Impl->ranges.empty() && !this->Impl->places.anyLimited())
    return;
  this->Impl->ranges.clear();
  this->Impl->places = {};
  this->Modified();
}

vtkIdType vtkMoteParticleMapper::GetNumberOfVisibleParticles()
{
  const auto& structure = this->Impl->structure;
  return structure ? static_cast<vtkIdType>(this->Impl->selection.shown(*structure).count) : 0;
}

void vtkMoteParticleMapper::GetVisibleBounds(double bounds[6])
{
  const Internals& impl = *this->Impl;
  mote::Box box;
  if (impl.structure)
  {
    const mote::ParticleSelection::Shown& shown = impl.selection.shown(*impl.structure);
    const bool all = impl.preview && shown.count == impl.preview->particles;
    box = all ? impl.preview->whole.bounds : shown.bounds;
  }
  copyBounds(box, bounds);
}

vtkDataArray* vtkMoteParticleMapper::FindRangeArray(
  const std::string& name, int component, const char* purpose)
{
  vtkPointSet* input = this->GetInput();
  const std::string what = "\"" + name + "\" for " + purpose;
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array)
    throw mote::Error("There is no point array " + what +
                      "; there are: " + mote::arrayNames(input->GetPointData()) + ".");
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
    throw mote::Error("The array " + what + " has not one tuple a point.");
  if (component < -1 || component >= array->GetNumberOfComponents())
    throw mote::Error("The array " + what + " has no component " + std::to_string(component) + ".");
  return array;
}

vtkDataArray* vtkMoteParticleMapper::FindVisibilityArray(int& component)
{
  if (!this->VisibilityArrayName || !*this->VisibilityArrayName)
  {
    vtkDataArray* array = this->GetColorArray();
    if (!array)
      throw mote::Error("There is no array for the visibility range.");
    component = this->GetColorComponent(array);
    return array;
  }
  component = this->VisibilityComponent;
  return this->FindRangeArray(this->VisibilityArrayName, component, "the visibility range");
}

/// The particles of the input as the structure was built from them.
mote::ParticleInput vtkMoteParticleMapper::DescribeParticles()
{
  Internals& impl = *this->Impl;
  mote::RadiusChoice choice = impl.choice;
  if (impl.commonRadius > 0.0)
  {
    // As it was built; the spacing need not be estimated again.
    choice.mode = mote::RadiusMode::Constant;
    choice.radius = impl.commonRadius;
    choice.scale = 1.0;
  }
  mote::ParticleInput input = mote::makeParticleInput(this->GetInput(), choice);
  input.enlargement = impl.preview ? impl.preview->enlargement : 1.0;
  return input;
}

void vtkMoteParticleMapper::UpdateRanges()
{
  Internals& impl = *this->Impl;
  if (!impl.structure)
    return;
  std::vector<mote::ValueRange> values;
  std::set<std::string> errors;
  const auto add = [&](const auto& find, double low, double high)
  {
    try
    {
      int component = 0;
      vtkDataArray* array = find(component);
      values.push_back({array, component, low, high});
    }
    catch (const mote::Error& error)
    {
      errors.insert(error.what());
      if (!impl.rangeErrors.count(error.what()))
        vtkErrorMacro(<< error.what());
    }
  };
  if (this->GetInput()->GetNumberOfPoints() > 0)
  {
    for (const auto& range : impl.ranges)
      add(
        [&](int& component)
        {
          component = range.component;
          return this->FindRangeArray(range.name, component, "a range");
        },
        range.low, range.high);
    if (this->UseVisibilityRange)
      add([&](int& component) { return this->FindVisibilityArray(component); },
        this->VisibilityRange[0], this->VisibilityRange[1]);
  }
  impl.rangeErrors = errors;
  if (impl.selection.apply(
        *impl.structure, values, impl.places, [this] { return this->DescribeParticles(); }))
    impl.builtAt.Modified();
}

void vtkMoteParticleMapper::PrintRanges(ostream& os, vtkIndent indent)
{
  static const char* const places[] = {"Center x", "Center y", "Center z", "Radius"};
  for (const auto& range : this->Impl->ranges)
    os << indent << "Range of " << range.name << ", component " << range.component << ": "
       << range.low << " " << range.high << "\n";
  for (int k = 0; k < 4; ++k)
    if (this->Impl->places.isLimited(k))
      os << indent << "Range of " << places[k] << ": " << this->Impl->places.low[k] << " "
         << this->Impl->places.high[k] << "\n";
}
