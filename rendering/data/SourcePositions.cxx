#include "SourcePositions.h"

#include "vtkObjectFactory.h"

namespace mote
{

vtkStandardNewMacro(SourcePositions);

void SourcePositions::SetSource(std::shared_ptr<const ParticleSource> source)
{
  this->Source = std::move(source);
  this->Size = this->Source ? static_cast<vtkIdType>(3 * this->Source->count()) : 0;
  this->MaxId = this->Size - 1;
  this->Modified();
}

void* SourcePositions::GetVoidPointer(vtkIdType i)
{
  std::call_once(this->Copied,
    [this]
    {
      this->Copy.resize(static_cast<std::size_t>(this->Size));
      for (vtkIdType k = 0; k < this->GetNumberOfTuples(); ++k)
        this->GetTypedTuple(k, &this->Copy[static_cast<std::size_t>(3 * k)]);
    });
  return this->Copy.data() + i;
}

} // namespace mote
