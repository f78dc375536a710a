#include "vtkMoteParticleFilePoints.h"

#include "Bounds.h"
#include "FileArrays.h"

#include "kernels/particles/PkdTreeFile.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"

namespace
{

using FilePointer = std::shared_ptr<const mote::PkdTreeFile>;

} // namespace

vtkStandardNewMacro(vtkMoteParticleFilePoints);

vtkMoteParticleFilePoints::vtkMoteParticleFilePoints() = default;
vtkMoteParticleFilePoints::~vtkMoteParticleFilePoints() = default;

void vtkMoteParticleFilePoints::SetFile(FilePointer file)
{
  this->File = std::move(file);
  this->SetSource(this->File ? this->File->particles() : nullptr);
}

FilePointer vtkMoteParticleFilePoints::GetFile() const
{
  return this->GetSource() ? this->File : nullptr;
}

double vtkMoteParticleFilePoints::GetSpacing()
{
  const FilePointer file = this->GetFile();
  return file ? file->spacing() : 0.0;
}

std::string vtkMoteParticleFilePoints::GetForm()
{
  const FilePointer file = this->GetFile();
  return file ? mote::pkdTreeFormNames()[static_cast<std::size_t>(file->tree().form())] : "";
}

double vtkMoteParticleFilePoints::GetPositionError()
{
  const FilePointer file = this->GetFile();
  return file ? file->tree().positionError() : 0.0;
}

void vtkMoteParticleFilePoints::ComputeBounds()
{
  const FilePointer file = this->GetFile();
  if (!file || file->size() == 0)
  {
    this->Superclass::ComputeBounds();
    return;
  }
  mote::copyBounds(file->statistics().centers, this->Bounds);
}

vtkDataArray* vtkMoteParticleFilePoints::NewArray(
  const FilePointer& file, std::size_t index, bool ofWhole)
{
  return mote::newArrayOf((ofWhole ? file->facts() : file->arrays())[index], file);
}

void vtkMoteParticleFilePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "File: " << (this->GetFile() ? this->File->name() : "(none)") << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Form: " << this->GetForm() << "\n";
  os << indent << "PositionError: " << this->GetPositionError() << "\n";
}
