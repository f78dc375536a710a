#include "FlowFinder.h"

#include "HiddenParts.h"
#include "SliceLattice.h"
#include "Slices.h"
#include "base/Failure.h"
#include "base/Messages.h"

#include <vtkAppendPolyData.h>
#include <vtkArrowSource.h>
#include <vtkBoundingBox.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkGlyph3D.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkMoteLineTubes.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

bool isOnSlices(const FlowSettings& flow)
{
  return flow.arrows > 0 && flow.arrowsOn == "slices";
}

bool isShown(const Part& part)
{
  return part.kind() == Part::Kind::Volume && !part.isHidden();
}

/// The part's data as vtkMoteStreamlines takes them: what hides cells, and where they stand.
vtkSmartPointer<vtkDataSet> flowDataOf(const Part& part, vtkTransform* placed)
{
  const auto data = vtk::TakeSmartPointer(part.data()->NewInstance());
  data->ShallowCopy(part.data());
  if (vtkUnsignedCharArray* isVisible = part.cells().mask())
  {
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfValues(isVisible->GetNumberOfValues());
    for (vtkIdType i = 0; i < isVisible->GetNumberOfValues(); ++i)
      marks->SetValue(i, isVisible->GetValue(i) == 0 ? vtkDataSetAttributes::HIDDENCELL : 0);
    data->GetCellData()->AddArray(marks);
  }
  if (placed->GetMatrix()->IsIdentity())
    return data;
  vtkNew<vtkDoubleArray> placement;
  placement->SetName("Placement");
  for (int k = 0; k < 16; ++k)
    placement->InsertNextValue(placed->GetMatrix()->GetElement(k / 4, k % 4));
  data->GetFieldData()->AddArray(placement);
  return data;
}

/// The places with the vectors once more, which glyphs take away.
void addArrows(vtkPolyData* places)
{
  vtkDataArray* vectors = places->GetPointData()->GetVectors();
  if (!vectors)
    return;
  const auto arrows = vtk::TakeSmartPointer(vectors->NewInstance());
  arrows->DeepCopy(vectors);
  arrows->SetName("arrow");
  places->GetPointData()->AddArray(arrows);
  places->GetPointData()->SetActiveVectors("arrow");
}

double meanLength(vtkDataArray* vectors)
{
  double sum = 0.0;
  vtkIdType count = 0;
  for (vtkIdType i = 0; vectors && i < vectors->GetNumberOfTuples(); ++i)
  {
    double v[3];
    vectors->GetTuple(i, v);
    if (const double length = std::hypot(v[0], v[1], v[2]); std::isfinite(length))
      sum += length, ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// Takes away from the vectors "arrow" what stands across the slice.
void makeTangential(vtkPolyData* places, const SliceLattice& lattice)
{
  vtkDataArray* arrows = places->GetPointData()->GetArray("arrow");
  for (vtkIdType i = 0; arrows && i < arrows->GetNumberOfTuples(); ++i)
  {
    std::array<double, 3> place{}, v{};
    places->GetPoint(i, place.data());
    arrows->GetTuple(i, v.data());
    const std::array<double, 3> normal = lattice.normalAt(place);
    const double across = vtkMath::Dot(v.data(), normal.data());
    for (std::size_t k = 0; k < 3; ++k)
      v[k] -= across * normal[k];
    arrows->SetTuple(i, v.data());
  }
}

vtkSmartPointer<vtkPolyData> glyphsOf(vtkPolyData* places, double factor)
{
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(12);
  arrow->SetShaftResolution(8);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetSourceConnection(arrow->GetOutputPort());
  glyphs->SetVectorModeToUseVector();
  glyphs->SetScaleModeToScaleByVector();
  glyphs->SetScaleFactor(factor);
  glyphs->SetInputData(places);
  glyphs->Update();
  return glyphs->GetOutput();
}

} // namespace

void prepareFlow(const std::vector<std::unique_ptr<Part>>& parts,
  const std::vector<NamedData>& data, const Settings& settings, const ArrayChoice& colored)
{
  const std::vector<bool> isHidden = hiddenParts(data, settings.selection);
  for (std::size_t i = 0; i < parts.size() && i < isHidden.size(); ++i)
  {
    parts[i]->setHidden(isHidden[i]);
    if (parts[i]->kind() == Part::Kind::Volume)
      parts[i]->limitCells(cellLimitsOf(parts[i]->data(), settings.selection, colored));
  }
}

FlowKey FlowKey::of(const std::vector<std::unique_ptr<Part>>& parts, const Settings& settings)
{
  FlowKey key;
  key.flow = settings.flow;
  if (isOnSlices(key.flow))
  {
    key.slices = settings.volume.slices.value_or(std::vector<ShowRange>());
    key.axis = settings.cuts.axis;
    key.repetitions = settings.volume.repeatAround;
  }
  for (const auto& part : parts)
  {
    if (!isShown(*part) || (key.flow.lines == 0 && key.flow.arrows == 0))
      continue;
    Volume volume{{}, part->cells().limits(), part->turn()};
    const auto add = [&](vtkObject* object)
    { volume.objects.emplace_back(object, object->GetMTime()); };
    if (auto* points = vtkPointSet::SafeDownCast(part->data()); points && points->GetPoints())
      add(points->GetPoints());
    for (vtkDataSetAttributes* arrays :
      {static_cast<vtkDataSetAttributes*>(part->data()->GetPointData()),
        static_cast<vtkDataSetAttributes*>(part->data()->GetCellData())})
      for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
        add(arrays->GetAbstractArray(i));
    key.volumes.push_back(std::move(volume));
  }
  return key;
}

/// What flows, and how large it is.
struct FlowFinder::Volumes
{
  vtkNew<vtkMultiBlockDataSet> blocks, copies; ///< each once; and all repetitions of each
  vtkBoundingBox bounds, ofCopies;

  explicit Volumes(const std::vector<std::unique_ptr<Part>>& parts)
  {
    for (const auto& part : parts)
    {
      if (!isShown(*part))
        continue;
      bool isFirst = true;
      for (const auto& placed : part->placements())
      {
        const auto data = flowDataOf(*part, placed);
        double box[6];
        data->GetBounds(box);
        moveBounds(placed, box);
        if (isFirst)
        {
          blocks->SetBlock(blocks->GetNumberOfBlocks(), data);
          bounds.AddBounds(box);
        }
        copies->SetBlock(copies->GetNumberOfBlocks(), data);
        ofCopies.AddBounds(box);
        isFirst = false;
      }
    }
  }
};

void FlowFinder::run(const Runner& runner)
{
  Messages::takeError();
  runner("Finding streamlines", streamlines_, [&] { streamlines_->Update(); });
  Messages::throwError("--streamlines, --arrows: ");
}

BuiltFlow FlowFinder::find(
  const std::vector<std::unique_ptr<Part>>& parts, const Settings& settings, const Runner& runner)
{
  BuiltFlow found;
  found.key = FlowKey::of(parts, settings);
  if (found.key.isEmpty())
    return found;
  const FlowSettings& flow = found.key.flow;
  const Volumes volumes(parts);
  streamlines_->SetInputDataObject(volumes.blocks);
  streamlines_->SetSeedsOnLine(flow.from.size() == 6);
  if (flow.from.size() == 6)
  {
    streamlines_->SetPoint1(flow.from.data());
    streamlines_->SetPoint2(flow.from.data() + 3);
  }
  streamlines_->SetMaximumLength(flow.length.value_or(volumes.bounds.GetDiagonalLength()));
  if (flow.array.empty())
    streamlines_->GetInformation()->Remove(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  else
    streamlines_->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, flow.array.c_str());
  if (flow.lines > 0)
    this->findLines(found, volumes, runner);
  if (flow.arrows > 0)
    this->findArrows(found, volumes, settings, runner);
  // The data are not kept alive.
  streamlines_->SetInputDataObject(nullptr);
  return found;
}

void FlowFinder::findLines(BuiltFlow& found, const Volumes& volumes, const Runner& runner)
{
  const FlowSettings& flow = found.key.flow;
  streamlines_->SetComputeLines(true);
  streamlines_->SetNumberOfSeeds(flow.lines);
  this->run(runner);
  found.numberOfLines = streamlines_->GetOutput(1)->GetNumberOfPoints();
  found.tubeRadius = 0.5 * flow.width.value_or(0.003 * volumes.bounds.GetDiagonalLength());
  vtkNew<vtkMoteLineTubes> tubes;
  tubes->SetInputData(streamlines_->GetOutput(0));
  tubes->SetRadius(found.tubeRadius);
  tubes->Update();
  found.lines = tubes->GetOutput();
}

void FlowFinder::findArrows(
  BuiltFlow& found, const Volumes& volumes, const Settings& settings, const Runner& runner)
{
  const FlowSettings& flow = found.key.flow;
  const vtkBoundingBox& box = volumes.bounds;
  double apart = std::cbrt(box.GetLength(0) * box.GetLength(1) * box.GetLength(2) / flow.arrows);
  streamlines_->SetComputeLines(false);
  streamlines_->SetNumberOfSeeds(flow.arrows);
  if (isOnSlices(flow))
    found.places = this->placesOnSlices(found.key, volumes, settings, runner, apart);
  else
  {
    this->run(runner);
    found.places = vtkSmartPointer<vtkPolyData>::New();
    found.places->ShallowCopy(streamlines_->GetOutput(1));
    addArrows(found.places);
  }
  const double mean = meanLength(found.places->GetPointData()->GetVectors());
  found.arrowFactor = mean > 0.0 ? flow.arrowScale * apart / mean : 0.0;
  found.arrows = glyphsOf(found.places, found.arrowFactor);
}

/// Places on all slices, and how far they lie apart. A coarse lattice tells how much of the slices
/// lies in cells, and with that how fine it must be.
vtkSmartPointer<vtkPolyData> FlowFinder::placesOnSlices(const FlowKey& key, const Volumes& volumes,
  const Settings& settings, const Runner& runner, double& apart)
{
  double box[6];
  volumes.ofCopies.GetBounds(box);
  const auto slices = slicesOf(settings, volumes.ofCopies.GetDiagonalLength());
  std::vector<SliceLattice> lattices;
  for (const auto& slice : slices)
    if (slice->GetShape() != vtkMoteSlice::UNROLLED_CYLINDER)
      lattices.emplace_back(slice, box);
  double area = 0.0;
  for (const SliceLattice& lattice : lattices)
    area += lattice.area();
  streamlines_->SetInputDataObject(volumes.copies);
  auto all = vtkSmartPointer<vtkPolyData>::New();
  for (const bool isCoarse : {true, false})
  {
    const double each = area / (isCoarse ? std::max(1000, 4 * key.flow.arrows) : key.flow.arrows);
    vtkNew<vtkAppendPolyData> together;
    together->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    vtkIdType count = 0;
    for (const SliceLattice& lattice : lattices)
    {
      streamlines_->SetSeedPlaces(lattice.places(each));
      this->run(runner);
      vtkNew<vtkPolyData> own;
      own->ShallowCopy(streamlines_->GetOutput(1));
      addArrows(own);
      if (key.flow.arrowVectors == "tangential")
        makeTangential(own, lattice);
      count += own->GetNumberOfPoints();
      if (own->GetNumberOfPoints() > 0)
        together->AddInputData(own);
    }
    area = each * static_cast<double>(count);
    apart = std::sqrt(each);
    if (count == 0 || isCoarse)
      continue;
    together->Update();
    all->ShallowCopy(together->GetOutput());
    all->GetPointData()->SetActiveVectors("arrow");
  }
  streamlines_->SetSeedPlaces(nullptr);
  return all;
}

} // namespace mote::app
