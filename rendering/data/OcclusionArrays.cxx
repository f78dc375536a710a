#include "OcclusionArrays.h"

#include "kernels/core/Error.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <span>
#include <string>

namespace mote
{

namespace
{

constexpr const char* settingsName = "MoteOcclusion";
constexpr const char* contentName = "MoteOcclusionContent";
constexpr const char* levelsName = "MoteOcclusionLevels";
constexpr const char* texelsName = "MoteOcclusionTexels";
constexpr const char* shownName = "MoteOcclusionShown";

/// The components of the array of settings.
enum Setting
{
  Version,
  Side,
  Samples,
  Reach,
  Tolerance,
  Adaptive,
  Dilate,
  Maximum,
  Gamma,
  SkyTop,
  SkyBottom,
  SkyUp,
  numberOfSettings = SkyUp + 3
};
constexpr const char* settingNames[] = {"version", "side", "samples", "reach", "tolerance",
  "adaptive", "dilate", "maximum", "gamma", "sky top", "sky bottom", "sky up x", "sky up y",
  "sky up z"};
constexpr double theVersion = 1.0, theGamma = 2.0;

template <typename Array>
auto* addArray(vtkFieldData* field, const char* name, std::size_t count)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  field->AddArray(array); // in place of one of that name
  return array->GetPointer(0);
}

/// The array of that name and type, with one component, which must be there.
template <typename T>
std::span<const T> required(vtkFieldData* field, const char* name, int type)
{
  vtkDataArray* array = field->GetArray(name);
  if (!array || array->GetDataType() != type || !array->HasStandardMemoryLayout())
    throw Error(std::string("The occlusion maps of the input lack the array \"") + name +
                "\", or it is of another type.");
  return {static_cast<const T*>(array->GetVoidPointer(0)),
    static_cast<std::size_t>(array->GetNumberOfValues())};
}

} // namespace

void addOcclusionArrays(vtkFieldData* field, const StoredOcclusion& stored)
{
  const OcclusionMaps& maps = stored.maps;
  vtkNew<vtkDoubleArray> settings;
  settings->SetName(settingsName);
  settings->SetNumberOfComponents(numberOfSettings);
  settings->SetNumberOfTuples(1);
  for (int i = 0; i < numberOfSettings; ++i)
    settings->SetComponentName(i, settingNames[i]);
  const OcclusionSky& sky = maps.sky();
  const double values[numberOfSettings] = {theVersion, double(stored.side), double(stored.samples),
    stored.reach, stored.tolerance, double(stored.adaptive), double(stored.dilate), maps.maximum(),
    theGamma, sky.top, sky.bottom, sky.up.x, sky.up.y, sky.up.z};
  settings->SetTypedTuple(0, values);
  field->AddArray(settings);

  vtkTypeUInt64* content = addArray<vtkTypeUInt64Array>(field, contentName, 2);
  content[0] = stored.content.low;
  content[1] = stored.content.high;
  unsigned char* levels = addArray<vtkUnsignedCharArray>(field, levelsName, maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i)
    levels[i] = maps.level(i);
  std::copy(maps.texels().begin(), maps.texels().end(),
    addArray<vtkUnsignedCharArray>(field, texelsName, maps.texels().size()));
  if (stored.shown.empty())
    field->RemoveArray(shownName);
  else
    std::copy(stored.shown.begin(), stored.shown.end(),
      addArray<vtkTypeUInt64Array>(field, shownName, stored.shown.size()));
}

std::optional<StoredOcclusion> findOcclusionArrays(vtkFieldData* field)
{
  if (!field->GetAbstractArray(settingsName))
    return std::nullopt;
  const auto settings = required<double>(field, settingsName, VTK_DOUBLE);
  const auto content = required<vtkTypeUInt64>(field, contentName, VTK_TYPE_UINT64);
  const auto levels = required<unsigned char>(field, levelsName, VTK_UNSIGNED_CHAR);
  const auto texels = required<unsigned char>(field, texelsName, VTK_UNSIGNED_CHAR);
  if (settings.size() != numberOfSettings || content.size() != 2 ||
      settings[Version] != theVersion || settings[Gamma] != theGamma)
    throw Error("The occlusion maps of the input are of another version.");
  const auto small = [&](int i) { return static_cast<float>(settings[i]); };

  StoredOcclusion stored;
  OcclusionMaps::Piece piece;
  piece.levels.assign(levels.begin(), levels.end());
  piece.texels.resize(texels.size());
  std::copy(texels.begin(), texels.end(), piece.texels.begin());
  const OcclusionSky sky{
    small(SkyTop), small(SkyBottom), {small(SkyUp), small(SkyUp + 1), small(SkyUp + 2)}};
  stored.maps = OcclusionMaps({&piece, 1}, sky);
  if (field->GetAbstractArray(shownName))
  {
    const auto shown = required<vtkTypeUInt64>(field, shownName, VTK_TYPE_UINT64);
    stored.shown.assign(shown.begin(), shown.end());
    if (shown.size() != (levels.size() + 63) / 64)
      throw Error("The occlusion maps of the input contradict one another.");
  }
  stored.content = {content[0], content[1]};
  stored.side = static_cast<int>(settings[Side]);
  stored.samples = static_cast<int>(settings[Samples]);
  stored.reach = settings[Reach];
  stored.tolerance = settings[Tolerance];
  stored.adaptive = settings[Adaptive] != 0.0;
  stored.dilate = settings[Dilate] != 0.0;
  return stored;
}

unsigned long long occlusionArraysTime(vtkFieldData* field)
{
  unsigned long long time = 0;
  for (const char* name : {settingsName, contentName, levelsName, texelsName, shownName})
    if (vtkAbstractArray* array = field->GetAbstractArray(name))
      time = std::max<unsigned long long>(time, array->GetMTime());
  return time;
}

} // namespace mote
