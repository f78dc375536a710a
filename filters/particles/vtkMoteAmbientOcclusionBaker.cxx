#include "vtkMoteAmbientOcclusionBaker.h"

#include "OcclusionArrays.h"
#include "ParticleModel.h"

#include "kernels/core/Error.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtksys/SystemTools.hxx"

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
  mote::ParticleModel model;

  std::chrono::steady_clock::time_point start; ///< of the baking
  std::atomic<double> share{0.0};              ///< of it that is done
  std::thread::id thread;                      ///< of the run
  bool isBaking = false;

  explicit Internals(vtkMoteAmbientOcclusionBaker* self)
    : model(self, false) // whose pipeline has events of its own
  {
  }
};

vtkMoteAmbientOcclusionBaker::vtkMoteAmbientOcclusionBaker()
  : Tolerance(mote::OcclusionBakeOptions().tolerance)
  , Impl(std::make_unique<Internals>(this))
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
  this->Impl->model.radii.typeRadii[type] = radius;
  this->Modified();
}

void vtkMoteAmbientOcclusionBaker::RemoveAllTypeRadii()
{
  this->Impl->model.radii.typeRadii.clear();
  this->Modified();
}

vtkCxxSetSmartPointerMacro(vtkMoteAmbientOcclusionBaker, VisibleIds, vtkIdTypeArray);

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
  this->SetProgressShiftScale(0.0, 1.0); // also after an error
  if (problem.empty())
    return 1;
  vtkErrorMacro(<< problem);
  return 0;
}

void vtkMoteAmbientOcclusionBaker::Run(vtkPolyData* data)
{
  Internals& impl = *this->Impl;
  impl.thread = std::this_thread::get_id();
  mote::ParticleModel& model = impl.model;
  mote::takeRadiusProperties(this, model.radii);
  model.structureName = isGiven(this->StructureName) ? this->StructureName : "";
  model.meetsGhosts = true; // they keep light off what this rank has
  this->SetProgressShiftScale(0.0, building);
  model.update(data);
  this->SetProgressShiftScale(building, baking);
  if (!model.structure())
    return; // aborted
  std::vector<mote::ArrayRange> ranges;
  if (isGiven(this->SelectionArrayName))
    ranges.push_back({this->SelectionArrayName, this->SelectionComponent, this->SelectionRange[0],
      this->SelectionRange[1], "the selection"});
  model.updateRanges(ranges);
  if (!model.rangeProblems().empty())
    throw mote::Error(*model.rangeProblems().begin());
  this->BeginMaps(data);
  const bool finished = this->Bake(data);
  const auto inputs = static_cast<std::size_t>(data->GetNumberOfPoints());
  const mote::StoredOcclusion stored =
    model.maps().known().stored(*model.structure(), inputs, model.content());
  mote::addOcclusionArrays(data->GetFieldData(), stored);
  for (std::size_t i = 0; i < inputs; ++i)
    this->NumberOfBaked += stored.maps.isBaked(i);
  if (inputs > 0)
    this->BytesPerParticle = double(stored.maps.bytes()) / double(inputs);
  if (isGiven(this->FileName) && this->NumberOfNewlyBaked > 0)
  {
    // A part of these maps does not replace all of others.
    if (finished || !isFile(this->FileName) ||
        readMaps(this->FileName, model.content(), inputs, model.maps().known().options()))
      mote::writeOcclusionFile(this->FileName, stored);
    else
      vtkWarningMacro(<< this->FileName
                      << " holds other maps, and stays as it is: baking was "
                         "stopped before new ones were complete.");
  }
  this->SetProgressShiftScale(0.0, 1.0);
  if (finished)
    this->UpdateProgress(1.0);
}

/// Takes what is known already: from the last run, or from the file.
void vtkMoteAmbientOcclusionBaker::BeginMaps(vtkPolyData* data)
{
  mote::ParticleModel& model = this->Impl->model;
  mote::OcclusionBakeOptions options;
  options.side = this->Side;
  options.samples = this->Samples;
  options.reach =
    this->Reach >= VTK_DOUBLE_MAX ? std::numeric_limits<double>::infinity() : this->Reach;
  options.reach = mote::occlusionReach(*model.structure(), options);
  options.adaptive = this->Adaptive != 0;
  options.tolerance = this->Tolerance;
  options.dilate = this->Dilate != 0;
  options.threads = this->NumberOfThreads;
  const mote::Vec3d up(this->SkyUp[0], this->SkyUp[1], this->SkyUp[2]);
  options.sky.top = static_cast<float>(this->SkyTop);
  options.sky.bottom = static_cast<float>(this->SkyBottom);
  if (glm::length(up) > 0.0)
    options.sky.up = mote::Vec3f(glm::normalize(up));
  model.updateOcclusion(options, {},
    [&]
    {
      auto stored = readMaps(this->FileName, model.content(),
        static_cast<std::size_t>(data->GetNumberOfPoints()), options);
      this->ReadFromFile = stored.has_value();
      return stored;
    });
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
    const mote::DataArrayView mask(mote::requirePointArray(data, this->MaskArrayName, "the mask"));
    for (std::size_t i = 0; i < inputs; ++i)
      wanted[i] = wanted[i] && mask.view.value(i) != 0.0;
  }
  const mote::ParticleStructure& structure = *impl.model.structure();
  mote::MapperOcclusion& maps = impl.model.maps();
  mote::ParticleBits bits;
  if (!wanted.empty())
    mote::withStructure(structure,
      [&](const auto& s)
      {
        bits.resize((s.size() + 63) / 64);
        for (std::size_t slot = 0; slot < s.size(); ++slot)
          bits[slot / 64] |= std::uint64_t{wanted[s.inputIndex(slot)]} << (slot % 64);
      });
  const mote::OcclusionBakeStatistics before = maps.known().statistics();
  impl.start = std::chrono::steady_clock::now();
  impl.share = 0.0;
  impl.isBaking = true;
  const bool finished = maps.bake(structure, bits,
    [this](double done)
    {
      this->Impl->share = done;
      if (std::this_thread::get_id() == this->Impl->thread)
        this->UpdateProgress(done);
      return this->GetAbortExecute() == 0;
    });
  const mote::OcclusionBakeStatistics& after = maps.known().statistics();
  this->NumberOfNewlyBaked = static_cast<vtkIdType>(after.particles - before.particles);
  this->NumberOfRays = static_cast<vtkTypeInt64>(after.rays - before.rays);
  this->BakeTime = after.seconds - before.seconds;
  return finished;
}

void vtkMoteAmbientOcclusionBaker::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto print = [&](const char* name, const auto& value)
  { os << indent << name << ": " << value << "\n"; };
  const auto text = [](const char* s) { return s ? s : "(none)"; };
  const auto onOff = [](bool is) { return is ? "On" : "Off"; };
  mote::RadiusChoice radii = this->Impl->model.radii;
  mote::takeRadiusProperties(this, radii);
  this->Superclass::PrintSelf(os, indent);
  mote::printRadii(radii, os, indent);
  print("StructureName", text(this->StructureName));
  print("Side", this->Side);
  print("Samples", this->Samples);
  print("Reach", this->Reach);
  print("Adaptive", onOff(this->Adaptive));
  print("Tolerance", this->Tolerance);
  print("Dilate", onOff(this->Dilate));
  print("SkyTop", this->SkyTop);
  print("SkyBottom", this->SkyBottom);
  os << indent << "SkyUp: " << this->SkyUp[0] << " " << this->SkyUp[1] << " " << this->SkyUp[2]
     << "\n";
  print("SelectionArrayName", text(this->SelectionArrayName));
  print("SelectionComponent", this->SelectionComponent);
  os << indent << "SelectionRange: " << this->SelectionRange[0] << " " << this->SelectionRange[1]
     << "\n";
  print("MaskArrayName", text(this->MaskArrayName));
  print("VisibleIds", this->VisibleIds.Get());
  print("FileName", text(this->FileName));
  print("NumberOfThreads", this->NumberOfThreads);
}
