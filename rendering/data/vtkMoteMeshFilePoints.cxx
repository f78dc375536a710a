#include "vtkMoteMeshFilePoints.h"

#include "Bounds.h"
#include "FileArrays.h"

#include "kernels/meshes/RlodTreeFile.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

vtkStandardNewMacro(vtkMoteMeshFilePoints);

vtkMoteMeshFilePoints::vtkMoteMeshFilePoints() = default;
vtkMoteMeshFilePoints::~vtkMoteMeshFilePoints() = default;

void vtkMoteMeshFilePoints::SetFile(std::shared_ptr<const mote::RlodTreeFile> file)
{
  this->File = std::move(file);
  if (this->File)
    this->SetData(
      vtkSmartPointer<vtkDataArray>::Take(mote::newArrayOf(this->File->places(), this->File)));
  this->Modified();
}

std::shared_ptr<const mote::RlodTreeFile> vtkMoteMeshFilePoints::GetFile() const
{
  const bool isOfFile =
    this->File && this->Data && this->Data->HasStandardMemoryLayout() &&
    this->Data->GetNumberOfTuples() == static_cast<vtkIdType>(this->File->pointCount()) &&
    this->Data->GetVoidPointer(0) == this->File->places().data();
  return isOfFile ? this->File : nullptr;
}

std::shared_ptr<const mote::RlodTreeFile> vtkMoteMeshFilePoints::FileOf(vtkPointSet* data)
{
  auto* surface = vtkPolyData::SafeDownCast(data);
  auto* points = vtkMoteMeshFilePoints::SafeDownCast(data ? data->GetPoints() : nullptr);
  const auto file = points ? points->GetFile() : nullptr;
  if (!file || !surface || surface->GetNumberOfCells() != surface->GetNumberOfPolys() ||
      surface->GetNumberOfPolys() != static_cast<vtkIdType>(file->size()) ||
      surface->GetCellGhostArray())
    return nullptr;
  vtkDataArray* corners = surface->GetPolys()->GetConnectivityArray();
  return corners->GetVoidPointer(0) == file->corners()->data() ? file : nullptr;
}

void vtkMoteMeshFilePoints::ComputeBounds()
{
  if (const auto file = this->GetFile())
    mote::copyBounds(file->bounds(), this->Bounds);
  else
    this->Superclass::ComputeBounds();
}

void vtkMoteMeshFilePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "File: " << (this->GetFile() ? this->File->name() : "(none)") << "\n";
}
