#include "vtkMoteParticleFilePoints.h"

#include "Bounds.h"
#include "DataArrayView.h"
#include "ForeignMemory.h"

#include "kernels/particles/PkdTreeFile.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

namespace
{

using FilePointer = std::shared_ptr<const mote::PkdTreeFile>;

int dataTypeOf(mote::ArrayView::Type type)
{
  for (const int vtkType : {VTK_FLOAT, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG})
    if (mote::viewTypeOf(vtkType) == type)
      return vtkType;
  return VTK_DOUBLE;
}

/// Tells an array what it would else look through all its values for.
void setRanges(vtkDataArray* array, const mote::PkdTreeFile::Array& from)
{
  const int components = array->GetNumberOfComponents();
  const auto set = [&](vtkInformationInformationVectorKey* each, vtkInformationDoubleVectorKey* all)
  {
    vtkNew<vtkInformationVector> ranges;
    ranges->SetNumberOfInformationObjects(components);
    for (int k = 0; k < components; ++k)
      ranges->GetInformationObject(k)->Set(
        vtkDataArray::COMPONENT_RANGE(), from.ranges[static_cast<std::size_t>(k)].data(), 2);
    array->GetInformation()->Set(each, ranges);
    array->GetInformation()->Set(all, from.ranges.back().data(), 2);
  };
  set(vtkAbstractArray::PER_FINITE_COMPONENT(), vtkDataArray::L2_NORM_FINITE_RANGE());
  if (from.finite)
    set(vtkAbstractArray::PER_COMPONENT(), vtkDataArray::L2_NORM_RANGE());
}

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
  const mote::PkdTreeFile::Array& from = (ofWhole ? file->facts() : file->arrays())[index];
  const mote::ArrayView& values = from.values;
  vtkDataArray* array = vtkDataArray::CreateDataArray(dataTypeOf(values.type()));
  array->SetName(from.name.c_str());
  array->SetNumberOfComponents(values.components());
  for (std::size_t k = 0; k < from.components.size(); ++k)
    array->SetComponentName(static_cast<vtkIdType>(k), from.components[k].c_str());
  if (values.count() > 0)
    mote::viewMemory(array, const_cast<void*>(values.data()),
      static_cast<vtkIdType>(values.count()) * values.components(), file);
  setRanges(array, from);
  return array;
}

void vtkMoteParticleFilePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "File: " << (this->GetFile() ? this->File->name() : "(none)") << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Form: " << this->GetForm() << "\n";
  os << indent << "PositionError: " << this->GetPositionError() << "\n";
}
