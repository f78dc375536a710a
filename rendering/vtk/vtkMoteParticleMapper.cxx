#include "vtkMoteParticleMapper.h"

#include "ColorBridge.h"
#include "ParticleInput.h"
#include "RendererImage.h"
#include "SceneBridge.h"

#include "kernels/core/Error.h"
#include "kernels/scene/Scene.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkMoteParticleMapper);

class vtkMoteParticleMapper::Internals
{
public:
  /// What the structure was built from, and which particles it was told to show.
  using Key = mote::InputKey;

  mote::RadiusChoice choice;
  std::shared_ptr<mote::ParticleStructure> structure;
  Key structureKey;
  Key visibilityKey;
  vtkTimeStamp builtAt;
  double commonRadius = 0.0;
  double buildTime = 0.0;
  int builds = 0;
  std::string reported; ///< last error, so that it is told once and not every frame

  mote::DataArrayView colorValues;
  vtkSmartPointer<vtkDataArray> directColors;
  Key directKey;
  std::string arrayError;

  std::string reportedFrame;   ///< the same for drawing
  mote::RendererImages images; ///< for renderers that have no vtkMoteRayCastPass

  template <typename Get>
  auto fromStructure(const Get& get, decltype(get(mote::CoherentGrid{})) otherwise) const
  {
    return structure ? mote::withStructure(*structure, get) : otherwise;
  }
};

vtkMoteParticleMapper::vtkMoteParticleMapper()
  : Impl(std::make_unique<Internals>())
{
  this->SetTypeArrayName("type");
  this->SetStructureName(mote::particleStructureNames().front().c_str());
}

vtkMoteParticleMapper::~vtkMoteParticleMapper()
{
  this->SetRadiusArrayName(nullptr);
  this->SetTypeArrayName(nullptr);
  this->SetVisibilityArrayName(nullptr);
  this->SetStructureName(nullptr);
}

int vtkMoteParticleMapper::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

void vtkMoteParticleMapper::SetInputData(vtkPointSet* input)
{
  this->SetInputDataInternal(0, input);
}

vtkPointSet* vtkMoteParticleMapper::GetInput()
{
  if (this->GetNumberOfInputConnections(0) < 1)
    return nullptr;
  return vtkPointSet::SafeDownCast(this->GetExecutive()->GetInputData(0, 0));
}

void vtkMoteParticleMapper::SetTypeRadius(int type, double radius)
{
  auto& table = this->Impl->choice.typeRadii;
  const auto found = table.find(type);
  if (found != table.end() && found->second == radius)
    return;
  table[type] = radius;
  this->Modified();
}

double vtkMoteParticleMapper::GetTypeRadius(int type)
{
  const auto& table = this->Impl->choice.typeRadii;
  const auto found = table.find(type);
  return found == table.end() ? this->Radius : found->second;
}

void vtkMoteParticleMapper::RemoveAllTypeRadii()
{
  this->Impl->choice.typeRadii.clear();
  this->Modified();
}

double* vtkMoteParticleMapper::GetBounds()
{
  if (!this->GetInput() && this->GetNumberOfInputConnections(0) < 1)
  {
    vtkMath::UninitializeBounds(this->Bounds);
    return this->Bounds;
  }
  if (!this->Static)
    this->Update();
  const mote::Box box =
    this->Impl->fromStructure([](const auto& s) { return s.statistics().bounds; }, mote::Box{});
  vtkMath::UninitializeBounds(this->Bounds);
  for (int axis = 0; axis < 3 && !box.empty(); ++axis)
  {
    this->Bounds[2 * axis] = box.lower[axis];
    this->Bounds[2 * axis + 1] = box.upper[axis];
  }
  return this->Bounds;
}

vtkIdType vtkMoteParticleMapper::GetNumberOfParticles()
{
  return this->Impl->fromStructure(
    [](const auto& s) { return static_cast<vtkIdType>(s.size()); }, vtkIdType{0});
}

vtkIdType vtkMoteParticleMapper::GetNumberOfUnfitParticles()
{
  return this->Impl->fromStructure([](const auto& s)
    { return static_cast<vtkIdType>(s.statistics().badPositions + s.statistics().badRadii); },
    vtkIdType{0});
}

vtkTypeInt64 vtkMoteParticleMapper::GetStructureBytes()
{
  return this->Impl->fromStructure(
    [](const auto& s) { return static_cast<vtkTypeInt64>(s.bytes()); }, vtkTypeInt64{0});
}

double vtkMoteParticleMapper::GetBuildTime()
{
  return this->Impl->buildTime;
}

int vtkMoteParticleMapper::GetNumberOfBuilds()
{
  return this->Impl->builds;
}

double vtkMoteParticleMapper::GetRadiusInUse()
{
  return this->Impl->commonRadius;
}

vtkMTimeType vtkMoteParticleMapper::GetPictureMTime()
{
  vtkMTimeType time = std::max(this->GetMTime(), this->Impl->builtAt.GetMTime());
  if (vtkPointSet* input = this->GetInput())
    time = std::max(time, input->GetMTime());
  return time;
}

//------------------------------------------------------------------------------------------------
// Building

namespace
{

/// Tells that a build starts and, however it goes, that it has ended.
struct BuildEvents
{
  vtkMoteParticleMapper* mapper;
  explicit BuildEvents(vtkMoteParticleMapper* m)
    : mapper(m)
  {
    mapper->SetAbortExecute(0);
    mapper->InvokeEvent(vtkCommand::StartEvent, nullptr);
  }
  ~BuildEvents() { mapper->InvokeEvent(vtkCommand::EndEvent, nullptr); }
};

} // namespace

void vtkMoteParticleMapper::Update(int port)
{
  if (!this->Static)
  {
    if (this->GetNumberOfInputConnections(0) < 1)
    {
      this->Impl->structure = nullptr;
      this->Impl->structureKey.clear();
      return;
    }
    this->UpdateInformation();
    this->Superclass::Update(port);
  }
  this->UpdateStructure();
  this->UpdateVisibility();
}

void vtkMoteParticleMapper::UpdateStructure()
{
  Internals& impl = *this->Impl;
  vtkPointSet* input = this->GetInput();
  mote::RadiusChoice& choice = impl.choice;
  choice.mode = this->RadiusMode;
  choice.radius = this->Radius;
  choice.scale = this->RadiusScale;
  choice.radiusArray = this->RadiusArrayName ? this->RadiusArrayName : "";
  choice.typeArray = this->TypeArrayName ? this->TypeArrayName : "";
  try
  {
    if (!input)
      throw mote::Error("The input is not a data set of points.");
    bool half = false;
    vtkDataArray* radii = mote::findRadiusArray(input, choice, half);
    mote::InputKey key = {double(mote::structureOf(this->StructureName))};
    mote::addArray(key, input->GetPoints() ? input->GetPoints()->GetData() : nullptr);
    mote::addChoice(key, choice, radii, half);
    if (impl.structure && key == impl.structureKey)
      return;
    impl.structureKey.clear();
    this->BuildStructure(input);
    if (impl.structure)
      impl.structureKey = key;
    impl.reported.clear();
  }
  catch (const std::exception& error)
  {
    impl.structure = nullptr;
    impl.structureKey.clear();
    if (impl.reported != error.what())
      vtkErrorMacro(<< error.what());
    impl.reported = error.what();
  }
}

void vtkMoteParticleMapper::BuildStructure(vtkPointSet* input)
{
  Internals& impl = *this->Impl;
  const auto start = std::chrono::steady_clock::now();
  mote::ParticleStructureOptions options;
  options.kind = mote::structureOf(this->StructureName);
  const BuildEvents events(this);
  const mote::ParticleInput particles = mote::makeParticleInput(input, impl.choice);
  impl.structure = mote::makeParticleStructure(particles.set, options,
    [this](double done)
    {
      this->UpdateProgress(done);
      return this->GetAbortExecute() == 0;
    });
  impl.buildTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  impl.commonRadius = particles.commonRadius;
  impl.visibilityKey.clear();
  impl.builtAt.Modified();
  ++impl.builds;
  if (!impl.structure)
    return;
  const std::string leftOut = mote::leftOutSentence(
    mote::withStructure(*impl.structure, [](const auto& s) { return s.statistics(); }));
  if (!leftOut.empty())
    vtkWarningMacro(<< "Particles left out: " << leftOut << ".");
}

//------------------------------------------------------------------------------------------------
// Colours and visibility

vtkDataArray* vtkMoteParticleMapper::GetColorArray()
{
  vtkPointSet* input = this->GetInput();
  if (!input || !this->ScalarVisibility)
    return nullptr;
  int cellFlag = 0;
  auto* array = vtkDataArray::SafeDownCast(vtkAbstractMapper::GetAbstractScalars(
    input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag));
  // Cells are not particles: only arrays with a tuple for every point can colour them.
  if (!array || cellFlag == 1 || array->GetNumberOfTuples() != input->GetNumberOfPoints())
    return nullptr;
  return array;
}

int vtkMoteParticleMapper::GetColorComponent(vtkDataArray* array)
{
  vtkScalarsToColors* colors = this->GetLookupTable();
  if (array->GetNumberOfComponents() == 1)
    return 0;
  if (colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
    return mote::ArrayView::magnitude;
  const int component =
    this->ArrayComponent > 0 ? this->ArrayComponent : colors->GetVectorComponent();
  return std::clamp(component, 0, array->GetNumberOfComponents() - 1);
}

double vtkMoteParticleMapper::GetParticleValue(vtkIdType id)
{
  vtkDataArray* array = this->GetColorArray();
  if (!array || id < 0 || id >= array->GetNumberOfTuples())
    return vtkMath::Nan();
  return mote::DataArrayView(array).view.value(
    static_cast<std::size_t>(id), this->GetColorComponent(array));
}

void vtkMoteParticleMapper::GetColorArrayRange(double range[2])
{
  range[0] = 1.0;
  range[1] = 0.0;
  if (vtkDataArray* array = this->GetColorArray())
    array->GetFiniteRange(range, this->GetColorComponent(array));
}

vtkDataArray* vtkMoteParticleMapper::FindVisibilityArray(int& component)
{
  vtkPointSet* input = this->GetInput();
  if (!this->VisibilityArrayName || !*this->VisibilityArrayName)
  {
    vtkDataArray* array = this->GetColorArray();
    if (!array)
      throw mote::Error("There is no array for the visibility range.");
    component = this->GetColorComponent(array);
    return array;
  }
  const std::string name = this->VisibilityArrayName;
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array)
    throw mote::Error("There is no point array \"" + name + "\" for the visibility range.");
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
    throw mote::Error(
      "The array \"" + name + "\" for the visibility range has not one tuple a point.");
  component = this->VisibilityComponent;
  if (component < -1 || component >= array->GetNumberOfComponents())
    throw mote::Error("The array \"" + name + "\" for the visibility range has no component " +
                      std::to_string(component) + ".");
  return array;
}

void vtkMoteParticleMapper::UpdateVisibility()
{
  Internals& impl = *this->Impl;
  if (!impl.structure)
    return;
  vtkDataArray* array = nullptr;
  int component = 0;
  std::string problem;
  try
  {
    if (this->UseVisibilityRange && this->GetInput()->GetNumberOfPoints() > 0)
      array = this->FindVisibilityArray(component);
  }
  catch (const mote::Error& error)
  {
    problem = error.what();
    if (problem != impl.arrayError)
      vtkErrorMacro(<< problem);
  }
  impl.arrayError = problem;
  mote::InputKey key;
  if (array)
  {
    key = {this->VisibilityRange[0], this->VisibilityRange[1], double(component)};
    mote::addArray(key, array);
  }
  if (key == impl.visibilityKey)
    return;
  impl.visibilityKey = key;
  impl.builtAt.Modified();
  const mote::DataArrayView values(array);
  const double low = this->VisibilityRange[0], high = this->VisibilityRange[1];
  std::visit(
    [&](auto& s)
    {
      if (!array)
        s.setVisibility({});
      else
        s.setVisibility(
          [&](std::size_t slot)
          {
            const double v = values.view.value(s.inputIndex(slot), component);
            return v >= low && v <= high;
          });
    },
    *impl.structure);
}

void vtkMoteParticleMapper::DescribeColors(mote::ParticleColoring& coloring)
{
  Internals& impl = *this->Impl;
  vtkDataArray* array = this->GetColorArray();
  if (!array)
    return;
  vtkScalarsToColors* colors = this->GetLookupTable(); // creates the default one
  if (!this->UseLookupTableScalarRange)
    colors->SetRange(this->ScalarRange);
  const bool bytes = vtkUnsignedCharArray::SafeDownCast(array) != nullptr;
  const bool direct = this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS ||
                      (this->ColorMode == VTK_COLOR_MODE_DEFAULT && bytes);
  const bool vectorColors =
    array->GetNumberOfComponents() > 1 && colors->GetVectorMode() == vtkScalarsToColors::RGBCOLORS;
  impl.colorValues = mote::DataArrayView(array);
  if (direct && bytes)
  {
    coloring.direct = impl.colorValues.view;
    return;
  }
  if (!direct && !vectorColors && mote::toColorMap(colors, coloring.map))
  {
    coloring.values = impl.colorValues.view;
    coloring.component = this->GetColorComponent(array);
    return;
  }
  // What only VTK itself can map: annotated values, floating point colours, vectors as colours.
  const int component = vectorColors ? -1 : this->GetColorComponent(array);
  mote::InputKey key = {double(colors->GetMTime()), double(this->ColorMode), double(component)};
  mote::addArray(key, array);
  if (key != impl.directKey)
  {
    impl.directColors.TakeReference(colors->MapScalars(array, this->ColorMode, component));
    impl.directKey = key;
  }
  coloring.direct = mote::DataArrayView(impl.directColors).view;
}

bool vtkMoteParticleMapper::DescribeTo(mote::ParticleObject& object, vtkActor* actor)
{
  this->Update();
  if (!this->Impl->structure || this->GetNumberOfParticles() == 0)
    return false;
  object.structure = this->Impl->structure;
  mote::describeActor(actor, object);
  this->DescribeColors(object.coloring);
  return true;
}

//------------------------------------------------------------------------------------------------

void vtkMoteParticleMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  mote::RendererImage& image = this->Impl->images.of(renderer);
  mote::FrameSettings settings;
  if (image.trace(renderer, {actor}, settings, {}))
    image.draw(renderer, !actor->HasOpaqueGeometry());
  if (!image.problem().empty() && image.problem() != this->Impl->reportedFrame)
    vtkErrorMacro(<< image.problem());
  this->Impl->reportedFrame = image.problem();
  this->TimeToDraw = image.traceTime() + image.displayTime();
}

void vtkMoteParticleMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->images.release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkMoteParticleMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const modes[] = {
    "Automatic", "Constant", "By array", "By type", "From spacing"};
  const auto text = [](const char* s) { return s ? s : "(none)"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RadiusMode: " << modes[this->RadiusMode] << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "RadiusArrayName: " << text(this->RadiusArrayName) << "\n";
  os << indent << "TypeArrayName: " << text(this->TypeArrayName) << "\n";
  for (const auto& [type, radius] : this->Impl->choice.typeRadii)
    os << indent << "TypeRadius of " << type << ": " << radius << "\n";
  os << indent << "UseVisibilityRange: " << (this->UseVisibilityRange ? "On" : "Off") << "\n";
  os << indent << "VisibilityRange: " << this->VisibilityRange[0] << " " << this->VisibilityRange[1]
     << "\n";
  os << indent << "VisibilityArrayName: " << text(this->VisibilityArrayName) << "\n";
  os << indent << "VisibilityComponent: " << this->VisibilityComponent << "\n";
  os << indent << "StructureName: " << text(this->StructureName) << "\n";
  os << indent << "NumberOfParticles: " << this->GetNumberOfParticles() << "\n";
  os << indent << "NumberOfUnfitParticles: " << this->GetNumberOfUnfitParticles() << "\n";
  os << indent << "StructureBytes: " << this->GetStructureBytes() << "\n";
}
