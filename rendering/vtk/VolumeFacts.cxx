// What a vtkMoteVolumeMapper is told and tells, other than to build and to draw.
#include "VolumeMapperInternals.h"

#include "Bounds.h"
#include "RotatedCopies.h"

#include "kernels/hexahedra/SliceSurface.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>

void vtkMoteVolumeMapper::SetVisibleCells(vtkUnsignedCharArray* isVisible)
{
  if (this->Impl->visible.set(isVisible))
    this->Modified();
}

vtkUnsignedCharArray* vtkMoteVolumeMapper::GetVisibleCells()
{
  return this->Impl->visible.get();
}

void vtkMoteVolumeMapper::SetClipCylinder(vtkMoteClipCylinder* cylinder)
{
  if (this->Impl->clip.set(cylinder))
    this->Modified();
}

vtkMoteClipCylinder* vtkMoteVolumeMapper::GetClipCylinder()
{
  return this->Impl->clip.cylinder();
}

void vtkMoteVolumeMapper::AddSlice(vtkMoteSlice* slice)
{
  this->Impl->slices.add(slice);
}

void vtkMoteVolumeMapper::RemoveAllSlices()
{
  this->Impl->slices.clear();
}

void vtkMoteVolumeMapper::AddSliceRange(double low, double high)
{
  this->Impl->slices.addRange(low, high);
}

void vtkMoteVolumeMapper::RemoveAllSliceRanges()
{
  this->Impl->slices.clearRanges();
}

int vtkMoteVolumeMapper::GetNumberOfSliceRanges()
{
  return static_cast<int>(this->Impl->slices.ranges().size());
}

void vtkMoteVolumeMapper::GetSliceRange(int number, double range[2])
{
  const bool isThere = number >= 0 && number < this->GetNumberOfSliceRanges();
  range[0] = isThere ? this->Impl->slices.ranges()[static_cast<std::size_t>(number)][0] : 1.0;
  range[1] = isThere ? this->Impl->slices.ranges()[static_cast<std::size_t>(number)][1] : 0.0;
}

int vtkMoteVolumeMapper::GetNumberOfSlices()
{
  return this->Impl->slices.count();
}

vtkMoteSlice* vtkMoteVolumeMapper::GetSlice(int number)
{
  return this->Impl->slices.slice(number);
}

void vtkMoteVolumeMapper::GetSliceBounds(double bounds[6])
{
  const auto& structure = this->Impl->geometry.structure();
  mote::Box box;
  if (structure && this->Impl->slices.count() > 0)
    box =
      mote::SliceSurface(structure, this->Impl->field, this->Impl->slices.shapes()).tightBounds();
  mote::copyBounds(box, bounds);
}

double* vtkMoteVolumeMapper::GetBounds()
{
  this->Update();
  const auto& mesh = this->Impl->geometry.mesh();
  mote::copyBounds(mote::withRotatedCopies(mesh ? mesh->bounds() : mote::Box(), this->Repetitions,
                     this->RepetitionCenter, this->RepetitionAxis),
    this->Bounds);
  return this->Bounds;
}

vtkIdType vtkMoteVolumeMapper::GetNumberOfCells()
{
  const auto& mesh = this->Impl->geometry.mesh();
  return mesh ? static_cast<vtkIdType>(mesh->report().kept) : 0;
}

vtkIdType vtkMoteVolumeMapper::GetNumberOfCellsLeftOut(int reason)
{
  const auto& mesh = this->Impl->geometry.mesh();
  if (!mesh)
    return 0;
  const mote::HexMeshReport& r = mesh->report();
  switch (reason)
  {
  case ANY_REASON:
    return static_cast<vtkIdType>(r.cells - r.kept);
  case OTHER_TYPE:
    return static_cast<vtkIdType>(r.otherTypes);
  case FLAT:
    return static_cast<vtkIdType>(r.flat);
  case UNFIT_POLYHEDRON:
    return static_cast<vtkIdType>(r.unfit);
  case NOT_FINITE:
    return static_cast<vtkIdType>(r.nonFinite);
  case TOO_FAR:
    return static_cast<vtkIdType>(r.tooFar);
  case NO_VOLUME:
    return static_cast<vtkIdType>(r.zeroVolume);
  default:
    return 0;
  }
}

std::string vtkMoteVolumeMapper::GetReport()
{
  const auto& mesh = this->Impl->geometry.mesh();
  return mesh ? mesh->report().sentence() : std::string();
}

vtkTypeInt64 vtkMoteVolumeMapper::GetStructureBytes()
{
  std::size_t bytes = 0;
  for (const auto& piece : this->GetMemory())
    bytes += piece.second;
  return static_cast<vtkTypeInt64>(bytes);
}

std::vector<std::pair<const void*, std::size_t>> vtkMoteVolumeMapper::GetMemory()
{
  return this->Impl->memory();
}

double vtkMoteVolumeMapper::GetBuildTime()
{
  return this->Impl->buildTime;
}

int vtkMoteVolumeMapper::GetNumberOfBuilds()
{
  return this->Impl->builds;
}

int vtkMoteVolumeMapper::GetNumberOfFieldUpdates()
{
  return this->Impl->fieldUpdates;
}

double* vtkMoteVolumeMapper::GetScalarRange()
{
  const auto& field = this->Impl->field;
  const bool any = field && field->lower() <= field->upper();
  this->ScalarRange[0] = any ? field->lower() : 1.0;
  this->ScalarRange[1] = any ? field->upper() : 0.0;
  return this->ScalarRange;
}

void vtkMoteVolumeMapper::GetScalarRange(double range[2])
{
  std::copy_n(this->GetScalarRange(), 2, range);
}

void vtkMoteVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto text = [](const char* s) { return s ? s : "(none)"; };
  const auto three = [](const double* v)
  { return std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]); };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VectorMode: " << (this->VectorMode == MAGNITUDE ? "Magnitude" : "Component")
     << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "StructureName: " << text(this->StructureName) << "\n";
  os << indent << "AxisOrigin: " << three(this->AxisOrigin) << "\n";
  os << indent << "AxisDirection: " << three(this->AxisDirection) << "\n";
  os << indent << "IntegratorName: " << text(this->IntegratorName) << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "CloudTolerance: " << this->CloudTolerance << "\n";
  os << indent << "Saturation: " << this->Saturation << "\n";
  os << indent << "ShowCloud: " << (this->ShowCloud ? "On" : "Off") << "\n";
  os << indent << "IsoArray: " << (this->IsoArrayName.empty() ? "(none)" : this->IsoArrayName)
     << "\n";
  os << indent << "ShowIsoSurfaces: " << (this->ShowIsoSurfaces ? "On" : "Off") << "\n";
  os << indent << "NumberOfSlices: " << this->GetNumberOfSlices() << "\n";
  os << indent << "EdgeWidth: " << this->EdgeWidth << "\n";
  os << indent << "EdgeColor: " << three(this->EdgeColor) << "\n";
  os << indent << "Repetitions: " << this->Repetitions << "\n";
  os << indent << "CastsShadows: " << (this->CastsShadows ? "On" : "Off") << "\n";
  os << indent << "NanColor: " << three(this->NanColor) << "\n";
  os << indent << "NanOpacity: " << this->NanOpacity << "\n";
  os << indent << "NumberOfCells: " << this->GetNumberOfCells() << "\n";
  os << indent << "NumberOfBuilds: " << this->GetNumberOfBuilds() << "\n";
  os << indent << "NumberOfFieldUpdates: " << this->GetNumberOfFieldUpdates() << "\n";
  os << indent << "StructureBytes: " << this->GetStructureBytes() << "\n";
}
