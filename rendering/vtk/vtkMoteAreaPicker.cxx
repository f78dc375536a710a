#include "vtkMoteAreaPicker.h"

#include "ParticleModel.h"
#include "PeriodicImages.h"
#include "PixelPicker.h"
#include "SceneBridge.h"
#include "vtkMoteParticleMapper.h"

#include "kernels/tracing/SeenParticles.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <tbb/blocked_range.h>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

vtkStandardNewMacro(vtkMoteAreaPicker);

/// In pixels of the viewport, both ends included.
struct vtkMoteAreaPicker::Rectangle
{
  double x0, y0, x1, y1;
  int width, height; ///< of the viewport

  bool Holds(double x, double y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
};

namespace
{

/// The input's numbers of the particles whose bits are set.
std::vector<vtkIdType> idsOf(
  const mote::ParticleSurface& surface, const std::vector<std::uint64_t>& bits)
{
  std::vector<std::uint64_t> slots;
  for (std::size_t word = 0; word < bits.size(); ++word)
    for (std::uint64_t left = bits[word]; left != 0; left &= left - 1)
      slots.push_back(64 * word + static_cast<std::size_t>(std::countr_zero(left)));
  std::vector<std::uint64_t> ids(slots.size());
  constexpr std::size_t atOnce = 1 << 20;
  for (std::size_t i = 0; i < slots.size(); i += atOnce)
    surface.inputIds(&slots[i], static_cast<int>(std::min(atOnce, slots.size() - i)), &ids[i]);
  std::sort(ids.begin(), ids.end());
  return {ids.begin(), ids.end()};
}

/// A structure for a cloud that has none: it takes less time than many rays without one.
std::shared_ptr<const mote::HexStructure> structureOf(const mote::CloudObject& cloud)
{
  // The mesh is the cloud's, which outlives it.
  const std::shared_ptr<const mote::HexMesh> mesh(std::shared_ptr<void>(), &meshOf(cloud));
  mote::HexStructureOptions options;
  options.kind = mote::HexStructureKind::CartesianBvh;
  const auto structure = mote::makeHexStructure(mesh, options);
  mote::setRanges(*structure, *cloud.field);
  return structure;
}

} // namespace

vtkMoteAreaPicker::vtkMoteAreaPicker()
{
  std::fill_n(this->ValueRange, 2, vtkMath::Nan());
}

vtkMoteAreaPicker::~vtkMoteAreaPicker() = default;

vtkIdType vtkMoteAreaPicker::Pick(double x0, double y0, double x1, double y1, vtkRenderer* renderer)
{
  this->All.clear();
  std::fill_n(this->ValueRange, 2, vtkMath::Nan());
  if (!renderer || !renderer->GetActiveCamera())
  {
    vtkErrorMacro("Picking needs a renderer with a camera.");
    return 0;
  }
  const int* size = renderer->GetSize();
  const int* corner = renderer->GetOrigin();
  const Rectangle rectangle = {std::min(x0, x1) - corner[0], std::min(y0, y1) - corner[1],
    std::max(x0, x1) - corner[0], std::max(y0, y1) - corner[1], size[0], size[1]};
  if (size[0] < 1 || size[1] < 1)
    return 0;
  try
  {
    if (this->Through)
      this->FindAll(rectangle, renderer);
    else
      this->FindSeen(rectangle, renderer);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  vtkIdType count = 0;
  for (const Found& found : this->All)
    count += found.Ids->GetNumberOfValues();
  return count;
}

void vtkMoteAreaPicker::FindSeen(const Rectangle& rectangle, vtkRenderer* renderer)
{
  mote::MoteProps props = mote::pickableProps(renderer->GetViewProps());
  const mote::Scene scene = mote::sceneOf(renderer, props);
  // Rays of other pixels end before they begin.
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const int width = rectangle.width, height = rectangle.height;
  std::vector<float> limits(static_cast<std::size_t>(width) * height, -infinity);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (rectangle.Holds(x, y))
        limits[static_cast<std::size_t>(y) * width + x] = infinity;
  const mote::SeenView view = {
    width, height, this->SamplesPerPixel, limits.data(), this->NumberOfThreads};
  mote::SeenParticles seen;
  const mote::Camera camera = mote::cameraOf(renderer, double(width) / height, width, height);
  mote::findSeenParticles(scene, camera, view, seen);
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
  {
    const std::int32_t id = scene.surfaces[k].id;
    const auto* particles = std::get_if<mote::ParticleSurface>(&scene.surfaces[k].surface);
    if (!particles)
      continue;
    // The images of a periodic prop follow one another.
    for (; k + 1 < scene.surfaces.size() && scene.surfaces[k + 1].id == id; ++k)
      std::transform(
        seen[k].begin(), seen[k].end(), seen[k + 1].begin(), seen[k + 1].begin(), std::bit_or<>());
    this->Add(props[static_cast<std::size_t>(id)]->prop(), idsOf(*particles, seen[k]), false);
  }
  if (this->PickCells || this->PickValues)
    this->LookAtPixels(rectangle, scene, camera, props);
}

/// Finds cells and values where the rays of the pixels' centres end.
void vtkMoteAreaPicker::LookAtPixels(const Rectangle& rectangle, const mote::Scene& scene,
  const mote::Camera& camera, const mote::MoteProps& props)
{
  const mote::CameraRays rays(camera, rectangle.width, rectangle.height);
  mote::Scene looked = scene;
  for (mote::CloudObject& cloud : looked.clouds)
    if (!cloud.structure)
      cloud.structure = structureOf(cloud);
  const mote::PixelPicker picker(looked, rays, true);
  // What each thread found: by the prop's number.
  struct Seen
  {
    std::vector<std::vector<vtkIdType>> cells;
    double low = HUGE_VAL, high = -HUGE_VAL;
  };
  tbb::enumerable_thread_specific<Seen> found(
    [&] { return Seen{decltype(Seen::cells)(props.size())}; });
  const auto add = [&](std::int32_t prop, std::uint64_t cell, bool isCell, double value)
  {
    Seen& seen = found.local();
    seen.low = std::min(seen.low, std::isfinite(value) ? value : seen.low);
    seen.high = std::max(seen.high, std::isfinite(value) ? value : seen.high);
    std::vector<vtkIdType>& cells = seen.cells[static_cast<std::size_t>(prop)];
    if (isCell && (cells.empty() || cells.back() != static_cast<vtkIdType>(cell)))
      cells.push_back(static_cast<vtkIdType>(cell));
  };
  using Wanted = mote::CloudPicker::Wanted;
  const Wanted wanted = this->PickValues ? Wanted::All : Wanted::Cell;
  const auto look = [&](int x, int y)
  {
    const auto [surface, cell] = picker.at(x + 0.5, y + 0.5, wanted);
    if (cell)
      return add(cell->object, cell->cell, this->PickCells, cell->value);
    if (!surface)
      return;
    const mote::MoteProp& prop = *props[static_cast<std::size_t>(surface->object)];
    add(surface->object, surface->id, this->PickCells && prop.picksCells(),
      this->PickValues ? prop.pickedValue(*surface) : 0.0);
  };
  const auto inside = [](double at, int size)
  { return static_cast<int>(std::clamp(at, 0.0, double(size))); };
  const int left = inside(std::ceil(rectangle.x0), rectangle.width);
  const int right = inside(std::floor(rectangle.x1) + 1.0, rectangle.width);
  const int lower = inside(std::ceil(rectangle.y0), rectangle.height);
  const int upper = inside(std::floor(rectangle.y1) + 1.0, rectangle.height);
  tbb::task_arena arena(
    this->NumberOfThreads > 0 ? this->NumberOfThreads : tbb::task_arena::automatic);
  arena.execute(
    [&]
    {
      tbb::parallel_for(tbb::blocked_range2d<int>(
                          lower, std::max(lower, upper), 16, left, std::max(left, right), 16),
        [&](const tbb::blocked_range2d<int>& range)
        {
          for (int y = range.rows().begin(); y != range.rows().end(); ++y)
            for (int x = range.cols().begin(); x != range.cols().end(); ++x)
              look(x, y);
        });
    });
  for (std::size_t k = 0; k < props.size(); ++k)
  {
    std::vector<vtkIdType> all;
    for (const Seen& seen : found)
      all.insert(all.end(), seen.cells[k].begin(), seen.cells[k].end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    this->Add(props[k]->prop(), all, true);
  }
  if (!this->PickValues)
    return;
  Seen all;
  for (const Seen& seen : found)
  {
    all.low = std::min(all.low, seen.low);
    all.high = std::max(all.high, seen.high);
  }
  if (all.low <= all.high)
  {
    this->ValueRange[0] = all.low;
    this->ValueRange[1] = all.high;
  }
}

void vtkMoteAreaPicker::FindAll(const Rectangle& rectangle, vtkRenderer* renderer)
{
  const double aspect = double(rectangle.width) / rectangle.height;
  vtkMatrix4x4* view =
    renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  for (const auto& prop : mote::pickableProps(renderer->GetViewProps()))
  {
    auto* actor = vtkActor::SafeDownCast(prop->prop());
    auto* mapper = actor ? vtkMoteParticleMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    if (!mapper)
      continue;
    mapper->Update();
    vtkPointSet* points = mapper->GetInput();
    const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
    std::vector<unsigned char> marks(static_cast<std::size_t>(count));
    mapper->GetModel().markVisible(marks.data());
    vtkNew<vtkMatrix4x4> toView;
    vtkMatrix4x4::Multiply4x4(view, actor->GetMatrix(), toView);
    const std::vector<mote::Vec3d> images =
      mote::imageOffsets(mapper->GetReplication(), mapper->GetReplicationVectors());
    const auto isInside = [&](const double* at)
    {
      return std::any_of(images.begin(), images.end(),
        [&](const mote::Vec3d& image)
        {
          const double place[4] = {at[0] + image.x, at[1] + image.y, at[2] + image.z, 1.0};
          double seen[4];
          toView->MultiplyPoint(place, seen);
          // A pixel's number is that of its lower left corner.
          const double x = 0.5 * (seen[0] / seen[3] + 1.0) * rectangle.width - 0.5;
          const double y = 0.5 * (seen[1] / seen[3] + 1.0) * rectangle.height - 0.5;
          return seen[3] > 0.0 && rectangle.Holds(x, y);
        });
    };
    tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, 1 << 14),
      [&](const tbb::blocked_range<vtkIdType>& range)
      {
        for (vtkIdType i = range.begin(); i != range.end(); ++i)
          if (unsigned char& mark = marks[static_cast<std::size_t>(i)])
          {
            double place[3];
            points->GetPoint(i, place);
            mark = isInside(place) ? 1 : 0;
          }
      });
    std::vector<vtkIdType> found;
    for (vtkIdType i = 0; i < count; ++i)
      if (marks[static_cast<std::size_t>(i)])
        found.push_back(i);
    this->Add(actor, found, false);
  }
}

void vtkMoteAreaPicker::Add(vtkProp3D* prop, const std::vector<vtkIdType>& ids, bool areCells)
{
  if (ids.empty())
    return;
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  this->All.push_back({prop, array, areCells});
}

int vtkMoteAreaPicker::GetNumberOfProps()
{
  return static_cast<int>(this->All.size());
}

vtkProp3D* vtkMoteAreaPicker::GetProp(int i)
{
  const bool isThere = i >= 0 && i < this->GetNumberOfProps();
  return isThere ? this->All[static_cast<std::size_t>(i)].Prop.Get() : nullptr;
}

vtkIdTypeArray* vtkMoteAreaPicker::GetParticles(int i)
{
  const bool isThere = i >= 0 && i < this->GetNumberOfProps();
  return isThere && !this->All[static_cast<std::size_t>(i)].AreCells
           ? this->All[static_cast<std::size_t>(i)].Ids.Get()
           : nullptr;
}

vtkIdTypeArray* vtkMoteAreaPicker::GetCells(int i)
{
  const bool isThere = i >= 0 && i < this->GetNumberOfProps();
  return isThere && this->All[static_cast<std::size_t>(i)].AreCells
           ? this->All[static_cast<std::size_t>(i)].Ids.Get()
           : nullptr;
}

void vtkMoteAreaPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Through: " << (this->Through ? "On\n" : "Off\n");
  os << indent << "PickCells: " << (this->PickCells ? "On\n" : "Off\n");
  os << indent << "PickValues: " << (this->PickValues ? "On\n" : "Off\n");
  os << indent << "ValueRange: " << this->ValueRange[0] << " " << this->ValueRange[1] << "\n";
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Props: " << this->All.size() << "\n";
}
