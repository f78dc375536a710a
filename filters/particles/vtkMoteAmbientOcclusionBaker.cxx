#include "vtkMoteAmbientOcclusionBaker.h"

#include "OcclusionArrays.h"
#include "ParticleInput.h"
#include "ParticleSelection.h"

#include "kernels/core/Error.h"
#include "kernels/particles/ParticleHash.h"
#include "kernels/particles/PkdTreeFile.h"
#include "kernels/shading/ParticleOcclusion.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <optional>
#include <thread>

vtkStandardNewMacro(vtkMoteAmbientOcclusionBaker);

namespace
{

/// Shares of the progress.
constexpr double building = 0.05, baking = 0.9;

vtkDataArray* requirePointArray(vtkPolyData* data, const char* name, const char* what)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  if (!array)
    throw mote::Error(
      std::string("There is no point array \"") + name + "\" for the " + what + ".");
  return array;
}

bool isGiven(const char* name)
{
  return name && *name;
}

bool isFile(const char* name)
{
  return isGiven(name) && vtksys::SystemTools::FileExists(name, true);
}

/// The maps in a file; none where there is no such file, or it holds those of other particles or
/// settings. Throws Error where it cannot be read.
std::optional<mote::StoredOcclusion> readMaps(const char* name, const mote::ContentHash& content,
  std::size_t particles, const mote::OcclusionBakeOptions& options)
{
  if (!isFile(name))
    return std::nullopt;
  mote::StoredOcclusion stored = mote::readOcclusionFile(name);
  const bool fits = stored.content == content && stored.maps.size() == particles &&
                    mote::wereBakedWith(stored, options);
  return fits ? std::optional(std::move(stored)) : std::nullopt;
}

} // namespace

/// What is kept between runs.
class vtkMoteAmbientOcclusionBaker::Internals
{
public:
  mote::RadiusChoice choice;
  mote::ParticleInput particles;
  mote::InputKey structureKey; ///< of the structure
  std::shared_ptr<mote::ParticleStructure> structure;
  mote::ParticleSelection selection;
  std::optional<mote::ContentHash> content; ///< of the particles of the structure

  mote::InputKey mapsKey; ///< of what the maps belong to, and their settings
  mote::ParticleOcclusion maps;

  std::chrono::steady_clock::time_point start; ///< of the baking
  std::atomic<double> share{0.0};              ///< of it that is done
  std::thread::id thread;                      ///< of the run
  bool isBaking = false;
};

vtkMoteAmbientOcclusionBaker::vtkMoteAmbientOcclusionBaker()
  : Tolerance(mote::OcclusionBakeOptions().tolerance)
  , Impl(std::make_unique<Internals>())
{
  this->SetTypeArrayName("type");
  this->SetStructureName(mote::particleStructureNames().front().c_str());
}

vtkMoteAmbientOcclusionBaker::~vtkMoteAmbientOcclusionBaker()
{
  this->SetRadiusArrayName(nullptr);
  this->SetTypeArrayName(nullptr);
  this->SetStructureName(nullptr);
  this->SetSelectionArrayName(nullptr);
  this->SetMaskArrayName(nullptr);
  this->SetFileName(nullptr);
}

int vtkMoteAmbientOcclusionBaker::FillInputPortInformation(
  int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkMoteAmbientOcclusionBaker::SetTypeRadius(int type, double radius)
{
  this->Impl->choice.typeRadii[type] = radius;
  this->Modified();
}

void vtkMoteAmbientOcclusionBaker::RemoveAllTypeRadii()
{
  this->Impl->choice.typeRadii.clear();
  this->Modified();
}

void vtkMoteAmbientOcclusionBaker::SetVisibleIds(vtkIdTypeArray* ids)
{
  if (this->VisibleIds == ids)
    return;
  this->VisibleIds = ids;
  this->Modified();
}

vtkIdTypeArray* vtkMoteAmbientOcclusionBaker::GetVisibleIds()
{
  return this->VisibleIds;
}

double vtkMoteAmbientOcclusionBaker::GetRemainingTime()
{
  const Internals& impl = *this->Impl;
  if (!impl.isBaking)
    return 0.0;
  if (impl.share <= 0.0)
    return std::numeric_limits<double>::infinity();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - impl.start;
  return taken.count() * (1.0 - impl.share) / impl.share;
}

std::string vtkMoteAmbientOcclusionBaker::ReadMaps(const std::string& fileName, vtkDataSet* data)
{
  if (!data)
    return "There are no data to read the maps of " + fileName + " for.";
  try
  {
    mote::addOcclusionArrays(data->GetFieldData(), mote::readOcclusionFile(fileName));
    return {};
  }
  catch (const mote::Error& error)
  {
    return error.what();
  }
}

int vtkMoteAmbientOcclusionBaker::RequestData(
  vtkInformation* vtkNotUsed(request), vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  this->NumberOfNewlyBaked = this->NumberOfBaked = 0;
  this->NumberOfRays = 0;
  this->BakeTime = this->BytesPerParticle = 0.0;
  this->ReadFromFile = false;
  std::string problem;
  try
  {
    this->Run(output);
  }
  catch (const std::bad_alloc&)
  {
    problem = "There is not enough memory to bake ambient occlusion.";
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  this->Impl->isBaking = false;
  if (problem.empty())
    return 1;
  vtkErrorMacro(<< problem);
  return 0;
}

void vtkMoteAmbientOcclusionBaker::Run(vtkPolyData* data)
{
  Internals& impl = *this->Impl;
  impl.thread = std::this_thread::get_id();
  this->BuildStructure(data);
  if (!impl.structure)
    return; // aborted
  this->BeginMaps(data);
  const bool finished = this->Bake(data);
  const auto inputs = static_cast<std::size_t>(data->GetNumberOfPoints());
  const mote::StoredOcclusion stored = impl.maps.stored(*impl.structure, inputs, *impl.content);
  mote::addOcclusionArrays(data->GetFieldData(), stored);
  for (std::size_t i = 0; i < inputs; ++i)
    this->NumberOfBaked += stored.maps.isBaked(i);
  if (inputs > 0)
    this->BytesPerParticle = double(stored.maps.bytes()) / double(inputs);
  if (isGiven(this->FileName) && this->NumberOfNewlyBaked > 0)
  {
    // A part of these maps does not replace all of others.
    if (finished || !isFile(this->FileName) ||
        readMaps(this->FileName, *impl.content, inputs, impl.maps.options()))
      mote::writeOcclusionFile(this->FileName, stored);
    else
      vtkWarningMacro(<< this->FileName
                      << " holds other maps, and stays as it is: baking was "
                         "stopped before new ones were complete.");
  }
  if (finished)
    this->UpdateProgress(1.0);
}

/// Builds where points or radii have changed, and shows what the selection says.
void vtkMoteAmbientOcclusionBaker::BuildStructure(vtkPolyData* data)
{
  Internals& impl = *this->Impl;
  mote::RadiusChoice& choice = impl.choice;
  choice.mode = static_cast<mote::RadiusMode>(this->RadiusMode);
  choice.radius = this->Radius;
  choice.scale = this->RadiusScale;
  choice.radiusArray = this->RadiusArrayName ? this->RadiusArrayName : "";
  choice.typeArray = this->TypeArrayName ? this->TypeArrayName : "";
  bool half = false;
  vtkDataArray* radii = mote::findRadiusArray(data, choice, half);
  const mote::StructureChoice asked = mote::structureOf(this->StructureName, nullptr);
  mote::InputKey key = {double(asked.kind)};
  mote::addArray(key, data->GetPoints() ? data->GetPoints()->GetData() : nullptr);
  mote::addChoice(key, choice, radii, half);
  if (!impl.structure || key != impl.structureKey)
  {
    impl.structureKey.clear();
    impl.selection.forget();
    impl.particles = mote::makeParticleInput(data, choice);
    impl.content = mote::hashOf(impl.particles.set);
    if (mote::drawsFile(data, choice, asked))
      impl.structure = std::make_shared<mote::ParticleStructure>(mote::fileOf(data)->tree());
    else
      mote::buildStructure(impl.structure, impl.particles.set, asked.options(),
        [this](double done) { return this->Report(building * done); });
    if (!impl.structure)
      return;
    impl.structureKey = key;
  }
  std::vector<mote::ValueRange> ranges;
  if (isGiven(this->SelectionArrayName))
  {
    vtkDataArray* array = requirePointArray(data, this->SelectionArrayName, "selection");
    if (this->SelectionComponent < -1 || this->SelectionComponent >= array->GetNumberOfComponents())
      throw mote::Error(std::string("The array \"") + this->SelectionArrayName +
                        "\" of the selection has no component " +
                        std::to_string(this->SelectionComponent) + ".");
    ranges.push_back(
      {array, this->SelectionComponent, this->SelectionRange[0], this->SelectionRange[1]});
  }
  impl.selection.apply(*impl.structure, ranges, {}, [&] { return impl.particles; });
}

/// Takes what is known already: from the last run, or from the file.
void vtkMoteAmbientOcclusionBaker::BeginMaps(vtkPolyData* data)
{
  Internals& impl = *this->Impl;
  mote::OcclusionBakeOptions options;
  options.side = this->Side;
  options.samples = this->Samples;
  options.reach =
    this->Reach >= VTK_DOUBLE_MAX ? std::numeric_limits<double>::infinity() : this->Reach;
  options.reach = mote::occlusionReach(*impl.structure, options);
  options.adaptive = this->Adaptive != 0;
  options.tolerance = this->Tolerance;
  options.dilate = this->Dilate != 0;
  options.threads = this->NumberOfThreads;
  const mote::Vec3d up(this->SkyUp[0], this->SkyUp[1], this->SkyUp[2]);
  options.sky.top = static_cast<float>(this->SkyTop);
  options.sky.bottom = static_cast<float>(this->SkyBottom);
  if (glm::length(up) > 0.0)
    options.sky.up = mote::Vec3f(glm::normalize(up));
  mote::InputKey key = impl.structureKey;
  key.insert(key.end(),
    {double(options.side), double(options.samples), options.reach, double(options.adaptive),
      options.tolerance, double(options.dilate), options.sky.top, options.sky.bottom,
      options.sky.up.x, options.sky.up.y, options.sky.up.z});
  if (impl.maps.maps() && key == impl.mapsKey)
    return impl.maps.update(*impl.structure);
  impl.mapsKey = key;
  try
  {
    if (const auto stored = readMaps(this->FileName, *impl.content,
          static_cast<std::size_t>(data->GetNumberOfPoints()), options))
    {
      impl.maps.begin(*impl.structure, options, *stored);
      this->ReadFromFile = true;
      return;
    }
  }
  catch (const mote::Error& error)
  {
    vtkWarningMacro(<< error.what());
  }
  impl.maps.begin(*impl.structure, options);
}

/// Tells how far the run is, from the thread that it began on; false where it was aborted.
bool vtkMoteAmbientOcclusionBaker::Report(double done)
{
  if (std::this_thread::get_id() == this->Impl->thread)
    this->UpdateProgress(done);
  return this->GetAbortExecute() == 0;
}

/// False where it was aborted.
bool vtkMoteAmbientOcclusionBaker::Bake(vtkPolyData* data)
{
  Internals& impl = *this->Impl;
  const auto inputs = static_cast<std::size_t>(data->GetNumberOfPoints());
  const bool masked = isGiven(this->MaskArrayName), chosen = this->VisibleIds != nullptr;
  std::vector<std::uint8_t> wanted(masked || chosen ? inputs : 0, !chosen);
  for (vtkIdType k = 0; chosen && k < this->VisibleIds->GetNumberOfValues(); ++k)
    if (const vtkIdType id = this->VisibleIds->GetValue(k);
        id >= 0 && id < data->GetNumberOfPoints())
      wanted[static_cast<std::size_t>(id)] = 1;
  if (masked)
  {
    const mote::DataArrayView mask(requirePointArray(data, this->MaskArrayName, "mask"));
    for (std::size_t i = 0; i < inputs; ++i)
      wanted[i] = wanted[i] && mask.view.value(i) != 0.0;
  }
  mote::ParticleBits bits;
  if (!wanted.empty())
    mote::withStructure(*impl.structure,
      [&](const auto& s)
      {
        bits.resize((s.size() + 63) / 64);
        for (std::size_t slot = 0; slot < s.size(); ++slot)
          bits[slot / 64] |= std::uint64_t{wanted[s.inputIndex(slot)]} << (slot % 64);
      });
  const mote::OcclusionBakeStatistics before = impl.maps.statistics();
  impl.start = std::chrono::steady_clock::now();
  impl.share = 0.0;
  impl.isBaking = true;
  const bool finished = impl.maps.bake(*impl.structure, bits,
    [this](double done)
    {
      this->Impl->share = done;
      return this->Report(building + baking * done);
    });
  const mote::OcclusionBakeStatistics& after = impl.maps.statistics();
  this->NumberOfNewlyBaked = static_cast<vtkIdType>(after.particles - before.particles);
  this->NumberOfRays = static_cast<vtkTypeInt64>(after.rays - before.rays);
  this->BakeTime = after.seconds - before.seconds;
  return finished;
}

void vtkMoteAmbientOcclusionBaker::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto text = [](const char* s) { return s ? s : "(none)"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RadiusMode: " << this->RadiusMode << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "RadiusArrayName: " << text(this->RadiusArrayName) << "\n";
  os << indent << "TypeArrayName: " << text(this->TypeArrayName) << "\n";
  os << indent << "StructureName: " << text(this->StructureName) << "\n";
  os << indent << "Side: " << this->Side << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "On" : "Off") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Dilate: " << (this->Dilate ? "On" : "Off") << "\n";
  os << indent << "SkyTop: " << this->SkyTop << "\n";
  os << indent << "SkyBottom: " << this->SkyBottom << "\n";
  os << indent << "SkyUp: " << this->SkyUp[0] << " " << this->SkyUp[1] << " " << this->SkyUp[2]
     << "\n";
  os << indent << "SelectionArrayName: " << text(this->SelectionArrayName) << "\n";
  os << indent << "SelectionComponent: " << this->SelectionComponent << "\n";
  os << indent << "SelectionRange: " << this->SelectionRange[0] << " " << this->SelectionRange[1]
     << "\n";
  os << indent << "MaskArrayName: " << text(this->MaskArrayName) << "\n";
  os << indent << "VisibleIds: " << this->VisibleIds.Get() << "\n";
  os << indent << "FileName: " << text(this->FileName) << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
