#include "vtkMoteCylindricalLocator.h"

#include "LocatorQueries.h"
#include "LocatorStructure.h"

#include "kernels/core/Error.h"

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkMoteCylindricalLocator);

vtkMoteCylindricalLocator::vtkMoteCylindricalLocator()
  : Shared(std::make_shared<mote::SharedStructures>())
{
}

vtkMoteCylindricalLocator::~vtkMoteCylindricalLocator() = default;

vtkObjectBase* vtkMoteCylindricalLocator::NewInstanceInternal() const
{
  vtkMoteCylindricalLocator* made = vtkMoteCylindricalLocator::New();
  made->StructureName = this->StructureName;
  made->FindAxis = this->FindAxis;
  std::copy_n(this->Origin, 3, made->Origin);
  std::copy_n(this->Axis, 3, made->Axis);
  made->Lazy = this->Lazy;
  made->UseExistingSearchStructure = this->UseExistingSearchStructure;
  made->Shared = this->Shared;
  return made;
}

void vtkMoteCylindricalLocator::SetDataSet(vtkDataSet* data)
{
  if (data != this->DataSet)
    this->Structure.reset();
  this->Superclass::SetDataSet(data);
}

void vtkMoteCylindricalLocator::BuildLocator()
{
  if (!this->DataSet)
  {
    vtkErrorMacro("A locator needs a data set before it is built.");
    return;
  }
  if (this->Structure && this->UseExistingSearchStructure)
    return;
  this->Structure.reset();
  try
  {
    mote::HexStructureOptions options;
    options.kind = mote::structureKindNamed(this->StructureName);
    if (!this->FindAxis)
      options.axis = mote::CylinderAxis{{this->Origin[0], this->Origin[1], this->Origin[2]},
        {this->Axis[0], this->Axis[1], this->Axis[2]}};
    this->Structure = this->Shared->get(this->DataSet, options);
    // What a data set makes when it is first asked for a cell is made now, before there are
    // threads.
    if (this->DataSet->GetNumberOfCells() > 0)
      this->DataSet->GetCell(0, this->GenericCell);
    this->BuildTime.Modified();
  }
  catch (const mote::Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

bool vtkMoteCylindricalLocator::IsBuilt()
{
  if (!this->Structure && this->Lazy)
    this->BuildLocator();
  return this->Structure != nullptr;
}

void vtkMoteCylindricalLocator::FreeSearchStructure()
{
  this->Shared->drop(this->Structure.get());
  this->Structure.reset();
}

vtkMTimeType vtkMoteCylindricalLocator::GetStructureTime()
{
  return this->Structure ? this->Structure->built.GetMTime() : 0;
}

vtkIdType vtkMoteCylindricalLocator::GetNumberOfCells()
{
  return this->Structure ? static_cast<vtkIdType>(this->Structure->mesh->report().kept) : 0;
}

unsigned long vtkMoteCylindricalLocator::GetActualMemorySize()
{
  if (!this->Structure)
    return 0;
  const std::size_t bytes =
    mote::withStructure(*this->Structure->structure, [](const auto& s) { return s.bytes(); });
  return static_cast<unsigned long>((bytes + this->Structure->mesh->bytes()) / 1024);
}

vtkIdType vtkMoteCylindricalLocator::FindCell(
  double x[3], double, vtkGenericCell* cell, double pcoords[3], double* weights)
{
  if (!this->IsBuilt())
    return -1;
  const mote::Vec3d p(x[0], x[1], x[2]);
  const std::uint32_t found = this->Structure->cellAt(p);
  if (found == mote::HexMesh::noCell)
    return -1;
  const auto id = static_cast<vtkIdType>(this->Structure->mesh->inputCell(found));
  mote::UsedCell used(cell);
  this->DataSet->GetCell(id, used.cell);
  double unused[3];
  mote::evaluate(*this->Structure->mesh, found, used.cell, p, pcoords ? pcoords : unused, weights);
  return id;
}

vtkIdType vtkMoteCylindricalLocator::FindCell(
  double x[3], double tol2, vtkGenericCell* cell, int& subId, double pcoords[3], double* weights)
{
  subId = 0;
  return this->FindCell(x, tol2, cell, pcoords, weights);
}

vtkIdType vtkMoteCylindricalLocator::FindCell(double x[3])
{
  const std::uint32_t found =
    this->IsBuilt() ? this->Structure->cellAt({x[0], x[1], x[2]}) : mote::HexMesh::noCell;
  return found == mote::HexMesh::noCell
           ? -1
           : static_cast<vtkIdType>(this->Structure->mesh->inputCell(found));
}

bool vtkMoteCylindricalLocator::InsideCellBounds(double x[3], vtkIdType cellId)
{
  return this->DataSet && cellId >= 0 && cellId < this->DataSet->GetNumberOfCells() &&
         this->Superclass::InsideCellBounds(x, cellId);
}

void vtkMoteCylindricalLocator::FindCellsWithinBounds(double* bbox, vtkIdList* cells)
{
  cells->Reset();
  if (!this->IsBuilt())
    return;
  const mote::Box box{{bbox[0], bbox[2], bbox[4]}, {bbox[1], bbox[3], bbox[5]}};
  vtkIdType last = -1; // parts of one cell follow one another
  for (const std::uint32_t c : mote::cellsWithin(*this->Structure->structure, box))
    if (const auto id = static_cast<vtkIdType>(this->Structure->mesh->inputCell(c)); id != last)
      cells->InsertNextId(last = id);
}

void vtkMoteCylindricalLocator::FindCellsAlongLine(
  const double p1[3], const double p2[3], double, vtkIdList* cells)
{
  cells->Reset();
  if (!this->IsBuilt())
    return;
  for (const vtkIdType id :
    mote::cellsAlong(*this->Structure, {p1[0], p1[1], p1[2]}, {p2[0], p2[1], p2[2]}))
    cells->InsertNextId(id);
}

int vtkMoteCylindricalLocator::IntersectWithLine(const double p1[3], const double p2[3], double,
  double& t, double x[3], double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell)
{
  subId = 0;
  cellId = -1;
  if (!this->IsBuilt())
    return 0;
  const mote::Vec3d from(p1[0], p1[1], p1[2]), to(p2[0], p2[1], p2[2]);
  const mote::FaceHit hit = mote::firstFace(*this->Structure, from, to);
  if (hit.cell == mote::HexMesh::noCell)
    return 0;
  t = hit.t;
  const mote::Vec3d p = from + hit.t * (to - from);
  std::copy_n(&p.x, 3, x);
  cellId = static_cast<vtkIdType>(this->Structure->mesh->inputCell(hit.cell));
  mote::UsedCell used(cell);
  this->DataSet->GetCell(cellId, used.cell);
  mote::evaluate(*this->Structure->mesh, hit.cell, used.cell, p, pcoords, nullptr);
  return 1;
}

void vtkMoteCylindricalLocator::FindClosestPoint(const double x[3], double closestPoint[3],
  vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2)
{
  double p[3] = {x[0], x[1], x[2]};
  int inside = 0;
  this->FindClosestPointWithinRadius(
    p, std::numeric_limits<double>::infinity(), closestPoint, cell, cellId, subId, dist2, inside);
}

vtkIdType vtkMoteCylindricalLocator::FindClosestPointWithinRadius(double x[3], double radius,
  double closestPoint[3], vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2,
  int& inside)
{
  cellId = -1;
  subId = 0;
  inside = 0;
  if (!this->IsBuilt())
    return 0;
  mote::UsedCell used(cell);
  const mote::ClosestCell closest =
    mote::closestCell(*this->Structure, this->DataSet, {x[0], x[1], x[2]}, radius, used.cell);
  if (closest.cell < 0)
    return 0;
  cellId = closest.cell;
  std::copy_n(&closest.point.x, 3, closestPoint);
  subId = closest.subId;
  dist2 = closest.distance2;
  inside = closest.inside;
  this->DataSet->GetCell(cellId, used.cell);
  return 1;
}

void vtkMoteCylindricalLocator::GenerateRepresentation(int, vtkPolyData* pd)
{
  if (!pd)
    return;
  pd->Initialize();
  if (this->IsBuilt())
    mote::outline(*this->Structure, pd);
}

void vtkMoteCylindricalLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StructureName: " << this->StructureName << "\n"
     << indent << "FindAxis: " << this->FindAxis << "\n"
     << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n"
     << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2] << "\n"
     << indent << "StructureTime: " << this->GetStructureTime() << "\n";
}
