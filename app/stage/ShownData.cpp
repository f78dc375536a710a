#include "ShownData.h"

#include "Calculated.h"
#include "PlaceMath.h"
#include "base/OutputFile.h"

#include <CellCorners.h>
#include <DataParts.h>
#include <ParticleModel.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkMoteDataWriter.h>
#include <vtkMoteParticleMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace mote::app
{

namespace
{

Vec middleOf(CellCorners& corners, vtkDataSet* data, vtkIdType cell)
{
  Vec middle{};
  vtkIdList* points = corners.of(cell);
  const vtkIdType count = points->GetNumberOfIds();
  for (vtkIdType i = 0; i < count; ++i)
  {
    Vec place{};
    data->GetPoint(points->GetId(i), place.data());
    middle = sum(middle, 1.0 / static_cast<double>(count), place);
  }
  return middle;
}

/// Takes the marks of what is cut away.
void dropCut(const Part& part, const CutSettings& settings, std::vector<unsigned char>& marks)
{
  Cuts cuts;
  cuts.follow(settings);
  vtkDataSet* data = part.data();
  CellCorners corners(data);
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i] != 0)
    {
      const auto id = static_cast<vtkIdType>(i);
      Vec place{};
      if (part.particles())
        data->GetPoint(id, place.data());
      else
        place = middleOf(corners, data, id);
      marks[i] = cuts.contains(place) ? 1 : 0;
    }
}

/// What goes along with any data: facts about the whole, and the time.
void copyFacts(vtkDataSet* from, vtkDataSet* to)
{
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
  if (from->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    to->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      from->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
}

void addRadii(const ParticleSet& set, vtkIdList* ids, vtkPointData* arrays)
{
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius");
  radii->SetNumberOfTuples(ids->GetNumberOfIds());
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    radii->SetValue(i, set.radiusOf(static_cast<std::size_t>(ids->GetId(i))));
  arrays->AddArray(radii);
}

/// Particles by their numbers, each a cell of its own.
vtkSmartPointer<vtkPolyData> particlesOf(vtkDataSet* data, vtkIdList* ids)
{
  auto particles = pointsOf(data, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
    vertices->InsertNextCell(1, &i);
  particles->SetVerts(vertices);
  return particles;
}

} // namespace

std::vector<unsigned char> shownMarks(const Part& part, const Settings& settings)
{
  vtkDataSet* data = part.data();
  const bool areParticles = part.particles() != nullptr;
  const vtkIdType count = areParticles ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  const bool hides = hidesAny(settings);
  std::vector<unsigned char> marks(static_cast<std::size_t>(count), areParticles && hides ? 0 : 1);
  if (areParticles && hides)
    part.particles()->GetModel().markVisible(marks.data());
  else if (!areParticles)
    part.cells().dropHidden(marks, true);
  if (!settings.cuts.ranges.empty())
    dropCut(part, settings.cuts, marks);
  return marks;
}

vtkSmartPointer<vtkDataSet> markedData(
  const Part& part, const std::vector<unsigned char>& marks, bool withRadii)
{
  vtkDataSet* data = part.data();
  vtkNew<vtkIdList> ids;
  ids->Allocate(static_cast<vtkIdType>(std::count(marks.begin(), marks.end(), 1)));
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i] != 0)
      ids->InsertNextId(static_cast<vtkIdType>(i));
  vtkSmartPointer<vtkDataSet> shown;
  if (part.particles())
  {
    const vtkSmartPointer<vtkPolyData> particles = particlesOf(data, ids);
    if (withRadii && !particles->GetPointData()->HasArray("radius"))
      addRadii(part.particles()->GetModel().particles().set, ids, particles->GetPointData());
    shown = particles;
  }
  else if (static_cast<std::size_t>(ids->GetNumberOfIds()) < marks.size())
    shown = cellsOf(data, ids);
  else
  {
    shown.TakeReference(data->NewInstance());
    shown->ShallowCopy(data);
  }
  copyFacts(data, shown);
  shown->GetPointData()->RemoveArray(whereArray.c_str());
  shown->GetCellData()->RemoveArray(whereArray.c_str());
  return shown;
}

bool givesRadii(const ParticleSettings& settings)
{
  return (settings.radius != "auto" && settings.radius != "spacing") ||
         !settings.typeRadius.empty() || settings.radiusScale != 1.0;
}

bool hidesAny(const Settings& settings)
{
  return isLimited(settings.selection) || !settings.selection.ranges.empty() ||
         !settings.selection.range.empty() || !settings.cuts.ranges.empty();
}

void writeData(
  vtkDataSet* data, const std::string& file, ProgressRelay& progress, const std::string& which)
{
  vtkNew<vtkMoteDataWriter> writer;
  writer->SetInputData(data);
  writeFile(writer, file, progress, which);
}

} // namespace mote::app
